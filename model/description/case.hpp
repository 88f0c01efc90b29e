// A case: what is drawn, how it is held, where it is watched, and what is asked of it.
//
// Plain data in SI units (m, kg, s, N, Pa, rad; frequencies in Hz; ratios as numbers, 1 % = 0.01).
// Part frame: y along the pipe, x transverse, z vertical. Lengths of a wall are mid-surface
// lengths. The YAML keys, their units, bounds and meaning are described once, in case_fields.hpp.
#pragma once

#include "elements/membrane_strain.hpp"
#include "mesh/shell_surface.hpp"
#include "model/description/fit_request.hpp"
#include "model/description/friction.hpp"
#include "solve/joint_method.hpp"

#include <array>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace plica {

using Triple = std::array<double, 3>;
using Sextuple = std::array<double, 6>;

struct Material {
  double E = 0;   // Young's modulus, Pa
  double nu = 0;  // Poisson's ratio
  double rho = 0; // density, kg/m3
};

enum class SectionShape { cuff, u, omega, disc, points };
enum class Interpolation { straight, smooth };

// One stretch of a meridian, read from left (small y) to right.
struct MeridianSection {
  SectionShape shape = SectionShape::u;
  int count = 1;              // convolutions (u, omega, disc, points)
  double length = 0;          // cuff: its length
  int elements = 0;           // cuff: elements along it, 0 = from the density
  double height = 0;          // u, omega, disc: root to crown, mid-surface to mid-surface
  double pitch = 0;           // u, omega, disc: axial length of one convolution
  double root_arc_radius = 0; // u, omega: mid-surface; 0 = pitch/4
  double crown_arc_radius = 0;
  double end_radius = 0;                     // cuff: radius at its right end, 0 = cylinder
  std::vector<std::array<double, 2>> points; // [y, r] of one convolution, y from 0 to the pitch
  Interpolation interpolation = Interpolation::smooth;
};

enum class Thinning { none, uniform, local };

struct Wall {
  std::vector<double> plies; // thickness of each ply, m
  double bond = 1;           // 0 plies slip, 1 one solid wall
  Thinning thinning = Thinning::none;
  double thinning_exponent = 0.5; // local: t(r) = t (r_root / r)^p
  std::optional<PlySlip> slip = {};
};

// How finely a shell of revolution is meshed: counts, or one target accuracy.
struct MeshDensity {
  int around = 0;      // elements around the circumference; 0 = from accuracy
  int arc = 0;         // elements per quarter of a circular arc
  int wall = 0;        // elements per straight wall or cuff
  double accuracy = 0; // relative error aimed at in stiffness; 0 = counts given
};

using Membrane = MembraneStrain;

// A dent of the wall (mesh/dent.hpp).
struct DentSpot {
  Triple at{}; // on the wall or near it
  double depth = 0, radius = 0;
};

struct Bellows {
  std::string material;
  double root_radius = 0; // mid-surface radius at the left end
  double start = 0;       // y of the left end
  std::vector<MeridianSection> profile;
  Wall wall;
  std::vector<DentSpot> dents;
  MeshDensity mesh;
  Membrane membrane = Membrane::incompatible;
};

enum class BeamShape { pipe, solid, rectangle, general };

// Stiffness given as numbers (general), or a section and a material.
struct BeamSection {
  BeamShape shape = BeamShape::pipe;
  std::string material;
  double radius = 0;           // thin pipe: mid-surface radius; solid: radius
  double thickness = 0;        // thin pipe: wall; 0 = solid round
  double width = 0, depth = 0; // solid rectangle: width along the local y, depth along local z
  std::optional<double> EA, EI, GJ, GA; // general; GA absent = rigid in shear
  double mass_per_length = 0;
  double rotary_inertia_per_length = 0; // about each transverse axis, kg m
  double polar_inertia_per_length = 0;
};

enum class Attachment { caps, stations, synchronous };

// The strip-wound liner: a beam on the axis of a bellows.
struct Interlock {
  std::string along; // name of the bellows
  Attachment attachment = Attachment::caps;
  int stations = 0; // attachment: stations
  double EA = 0, EI = 0, GJ = 0;
  double mass = 0;   // total, kg
  double radius = 0; // of the mass, for rotary inertia
  std::optional<InterlockFriction> friction = {};
};

struct Plate {
  std::string material;
  std::array<Triple, 4> corners{}; // in order round the plate
  double thickness = 0;
  std::array<int, 2> elements{}; // along 1-2 and along 2-3
  Membrane membrane = Membrane::displacement;
};

// Nodes of a surface near a point, as a set of their own.
struct SurfacePlace {
  std::string name;
  Triple at{};
  double within = 0;
};

// A thin-walled part on the faces of a CAD file or of a triangulated surface.
struct SurfacePart {
  std::string material;
  std::string file;                // from the folder of the case
  std::optional<double> unit = {}; // m per unit of the file, where the format has none
  double thickness = 0;
  WallSide given = WallSide::middle; // where the surface lies in the wall
  double size = 0;                   // of elements; 0 = the triangles of the file
  double turn = std::numbers::pi / 8;
  double weld = 1e-6; // vertices of a triangulated surface that are one
  Triple rotate{};    // about x, then y, then z
  Triple move{};
  std::vector<SurfacePlace> places = {};
  Membrane membrane = Membrane::displacement;
};

struct DeckModel; // model/description/deck_model.hpp

// Cards that are not known: an error each, or a list of what is left out.
enum class UnknownCards { error, list };

// A model from a deck of Abaqus or Nastran.
struct DeckPart {
  std::string file; // from the folder of the case
  double length_unit = 1, mass_unit = 1;
  UnknownCards unknown_cards = UnknownCards::error;
  bool held = true; // by what the deck holds
  Triple rotate{};  // about x, then y, then z
  Triple move{};
  std::vector<SurfacePlace> places = {};
  Membrane membrane = Membrane::incompatible;
  std::shared_ptr<const DeckModel> content = {}; // read with the case
};

struct BeamPart {
  std::vector<Triple> points; // the axis, straight between points
  int elements = 1;           // per stretch
  Triple up{0, 0, 1};         // local z lies in the plane of the axis and this vector
  BeamSection section;
};

bool is_on_axis(const BeamPart& beam); // all its points are

// Stiffness of a layer of an equivalent pipe, between its ends.
struct PipeLayer {
  double radius = 0;
  double wall = 0; // of the outer layer, whose mass it gives: s_p
  double mass = 0; // of the inner layer
  double axial = 0, torsion = 0;
  std::optional<double> mass_radius = {}; // of gyration about the axis; none = the mean radius
};

enum class PipeLength { whole, convoluted };
enum class PipeShear { rigid, elastic };

// Equivalent thin-walled pipe of a flexible pipe: a beam per layer on common nodes, straight ends,
// a lumped cap in the middle of each end (model/description/pipe_model.hpp).
struct EquivalentPipe {
  std::string material; // of the ends; its density also of the outer layer
  double start = 0, length = 0;
  double convoluted = 0; // length between the straight ends
  PipeLayer outer;
  std::optional<PipeLayer> inner;
  double end_radius = 0, end_wall = 0, end_cap = 0;
  PipeLength modulus_over = PipeLength::convoluted; // length that makes moduli of the stiffnesses
  PipeShear shear = PipeShear::rigid;
  bool rotary_inertia = true;
  int elements = 40;
};

// One spring of a chain: a Cartesian and rotational connector element.
struct ConnectorSpring {
  double axial = 0, transverse = 0, bending = 0, torsion = 0;
  // In place of axial and transverse: [displacement, force], straight between points and beyond.
  std::vector<std::array<double, 2>> axial_curve = {}, transverse_curve = {};
  // In place of these the full law with its coupling terms, ux uy uz rx ry rz, SI; acts midway
  // between the nodes.
  std::vector<Sextuple> matrix = {};
};

// Chain of connector elements with lumped masses between them, rigid arms (spiders) at both ends.
struct ConnectorChain {
  double start = 0, length = 0;
  double arms = 0; // length of each arm
  int count = 20;
  ConnectorSpring spring;
  std::optional<ConnectorSpring> end_spring; // of the first and the last
  double mass = 0;     // between the arms: of each element, half on either node
  double radius = 0;   // of that mass, for rotary inertia; 0 = none
  double arm_mass = 0; // of each arm, in its middle
  std::optional<SlenderFriction> friction = {}; // of each element
};

struct PointMass {
  std::string at;  // set of one or more nodes (the mass is rigidly tied when more than one)
  Triple offset{}; // from that node to the centre of mass
  double mass = 0;
  Sextuple inertia{}; // about the centre of mass: xx yy zz xy yz zx, kg m2
};

struct Part {
  std::string name;
  std::variant<Bellows, Interlock, Plate, BeamPart, PointMass, EquivalentPipe, ConnectorChain,
               SurfacePart, DeckPart>
      body;
};

// Rigid end cap or flange: reference node in the middle of an end circle, tied to it. On the ends
// of several parts it joins them, a clamp.
struct Cap {
  std::string name;
  std::vector<std::string> of = {}; // sets it closes, e.g. "bellows.left"
  std::optional<Sextuple> stiffness =
      {}; // springs between the first end and the others; none = rigid
  std::optional<JointFriction> friction = {}; // beside these springs
  double mass = 0;
  Sextuple inertia{}; // about its centre of mass, kg m2
  Triple offset{};    // reference node to centre of mass
};

enum class MountKind { free, rigid, springs };

struct Mount {
  std::string cap;
  MountKind kind = MountKind::rigid;
  Sextuple stiffness{};                       // springs: N/m, N/m, N/m, Nm/rad, Nm/rad, Nm/rad
  std::optional<JointFriction> friction = {}; // beside these springs
};

// Degrees of freedom of a set held to zero.
struct Support {
  std::string set;
  std::vector<int> dofs; // 0..5 = ux uy uz rx ry rz
};

struct Sensor {
  std::string name;
  Triple at{};                    // sits on the nearest node; one farther than `reach` is an error
  std::vector<int> axes{1, 2, 3}; // its own three axes: 1 x, 2 y, 3 z, negative = reversed
  double mass = 0;                // rides on that node
  double reach = 5e-3;            // m, how far the nearest node may be
};

struct Modes {
  int count = 0;                // number of modes, or
  std::array<double, 2> band{}; // all modes in a band, Hz
  bool proof = true;
};

struct DampingRange {
  std::array<double, 2> band{}; // Hz
  double ratio = 0;
};
struct ModeDamping {
  int mode = 0; // counted from 1
  double ratio = 0;
};
struct LossFactor {
  std::string of; // a part, or "mount.<cap>" of a spring mount
  double value = 0;
};

// Fractions of critical, the narrower statement before the wider: a mode by its number, a band,
// all. Loss factors come on top, weighted by the strain energy of their component.
struct Damping {
  double modal = 0;
  std::vector<DampingRange> ranges = {};
  std::vector<ModeDamping> modes = {};
  std::vector<LossFactor> loss_factors = {};
};

// One-sided spectral density of an input, (unit)^2/Hz: a constant level, or a table of [Hz,
// density] joined by straight lines in a log-log plot.
struct Noise {
  double level = 0;
  std::vector<std::array<double, 2>> table;
};
struct BaseNoise : Noise {};  // (m/s2)2/Hz; (rad/s2)2/Hz for a rotation
struct ForceNoise : Noise {}; // N2/Hz; (Nm)2/Hz for a moment

struct Force {
  std::string name;
  std::string at;       // set, the force spread evenly over its nodes
  int direction = 1;    // 0..5 = x y z rx ry rz
  double amplitude = 1; // N or Nm, for stresses and motion in absolute numbers
  std::optional<ForceNoise> random;
};

struct CrossPair { // two channels, "sensor.direction"
  std::string a, b;
};

// Response of the sensors to motion of the base and to forces, each direction and force on its own.
struct Response {
  std::vector<int> bases; // 0..5 = x y z rx ry rz; rotations about the origin
  double level = 1;       // amplitude of the base, m/s2 or rad/s2
  std::optional<BaseNoise> random = {};
  std::vector<Force> forces = {};
  std::array<double, 2> band{10, 500}; // Hz
  int points = 491; // even steps; eigenfrequencies and clusters round them besides
  std::vector<std::array<double, 2>> rms_bands = {}; // Hz; beside the whole band
  std::vector<CrossPair> cross = {};                 // cross densities of a random response
};

struct LevelForce {
  std::string name;
  std::string at;             // set, the force spread evenly over its nodes
  int direction = 1;          // 0..5 = x y z rx ry rz
  std::vector<double> levels; // N or Nm, increasing
};

// Response at several levels of excitation, with the friction of the joints.
struct Levels {
  std::vector<int> bases;     // 0..5 = x y z rx ry rz
  std::vector<double> levels; // of the base, m/s2 or rad/s2, increasing
  std::vector<LevelForce> forces;
  std::array<double, 2> band{}; // Hz
  int points = 200;
  JointMethod method = JointMethod::harmonic_balance;
  int harmonics = 5, samples = 256;
  int backbones = 1;
  int referee = 2;
};

// Stresses of shells and beams: static, of each mode, harmonic, RMS under a random input.
struct Stress {
  std::vector<double> frequencies; // harmonic at these, for every base direction and force, Hz
};

// Solve harmonic by harmonic where the part repeats around its axis: where possible, or an error
// when it is not, or never.
enum class Symmetry { automatic, required, off };

// Solve with a superelement in place of every part between caps.
struct ReductionRequest {
  double cutoff =
      0; // of the modes with the caps held, Hz; 0 = twice the highest frequency asked for
};

struct Analyses {
  Symmetry symmetry = Symmetry::automatic;
  std::optional<ReductionRequest> reduction;
  std::optional<bool> statics; // end stiffness between two caps; none: where there are two
  std::optional<Modes> modes;
  Damping damping;
  std::optional<Response> response;
  std::optional<Levels> levels;
  std::optional<Stress> stress;
  bool error_bars = true; // discretisation and tolerances of the headline numbers
};

// Of response and modes, Hz; 0 when neither has a band.
double highest_frequency(const Analyses& analyses);

// Cut-off of a reduction, Hz: as asked, or twice the upper end of the bands of response and modes,
// or 1000 Hz where there is none.
double reduction_cutoff(const Analyses& analyses);

// The same case with some numbers changed: shown beside the nominal results.
struct Variant {
  std::string name;
  std::map<std::string, std::string> set; // path of the case file: new value, as written there
};

// The same component by another kind of model: these sections replace those of the case; an empty
// one is kept as it is. After that, what `set` changes.
struct AlternativeModel {
  std::string name;                       // "pipe", "connector", "friction", ...
  std::map<std::string, std::string> set; // path of the case file: new value, as written there
  std::vector<std::string> assumptions;
  std::vector<Part> parts;
  std::vector<Cap> caps;
  std::vector<Mount> mount;
  std::vector<Sensor> sensors;
  std::vector<Variant> variants;
  std::optional<FitRequest> fit;
};

// A number known only within limits, from "8 mm +- 1 mm" (evenly within them) or
// "3 kN [0.3, 30]" (half of the probability on each side of the value, on a log scale when both
// limits are above zero). Values in SI.
struct Tolerance {
  std::string path; // of the number in the case file
  double value = 0, low = 0, high = 0;
  bool interval = false; // written as [low, high]
};

struct Case {
  std::string name;
  std::string model; // alternative model that it is; empty = as the parts of the case say
  std::string title;
  std::vector<std::string> assumptions; // in words, printed in the report
  std::map<std::string, Material> materials;
  std::vector<Part> parts;
  std::vector<Cap> caps;
  std::vector<Mount> mount;
  std::vector<Support> supports;
  std::vector<Sensor> sensors;
  Analyses analyses;
  std::vector<Variant> variants;
  std::optional<FitRequest> fit;
  std::vector<AlternativeModel> models;
  std::vector<Tolerance> tolerances;
  std::string measured; // path of measured.yaml beside the case file; empty = none
};

// True when a part, a joint, a mount or the plies of a wall have friction or a nonlinear spring.
bool has_friction(const Case& data);

// A deck that holds some of its nodes; one that could not be read may.
bool held_by_deck(const Case& data);

} // namespace plica
