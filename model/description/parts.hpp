// The parts of a case, as they are drawn (case.hpp).
#pragma once

#include "elements/membrane_strain.hpp"
#include "mesh/shell_surface.hpp"
#include "model/description/friction.hpp"

#include <array>
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
  // [degC, Pa] and [degC, mean expansion per K from 20 degC to there]; nothing is extrapolated.
  std::vector<std::array<double, 2>> E_over_temperature = {}, expansion = {};
  // [degC, Poisson's ratio], empty: that above; [degC, W/(m K)].
  std::vector<std::array<double, 2>> nu_over_temperature = {}, conductivity = {};
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
  bool operator==(const MeridianSection&) const = default;
};

enum class Thinning { none, uniform, local };

struct Wall {
  std::vector<double> plies; // thickness of each ply, m
  double bond = 1;           // 0 plies slip, 1 one solid wall
  Thinning thinning = Thinning::none;
  double thinning_exponent = 0.5; // local: t(r) = t (r_root / r)^p
  std::optional<PlySlip> slip = {};
  // Standard deviation of a smooth field of thickness along the wall, over the thickness: how far
  // admissible walls differ. None = not known.
  std::optional<double> thickness_field = {};
  bool operator==(const Wall&) const = default;
};

// How finely a shell of revolution is meshed: counts, or one target accuracy.
struct MeshDensity {
  int around = 0;      // elements around the circumference; 0 = from accuracy
  int arc = 0;         // elements per quarter of a circular arc
  int wall = 0;        // elements per straight wall or cuff
  double accuracy = 0; // relative error aimed at (model/shape/mesh_choice.hpp); 0 = counts given
  int waves = 0;       // around, of the modes that keep the accuracy, too; 0 = as a run finds them
};

using Membrane = MembraneStrain;

// A dent of the wall (mesh/dent.hpp).
struct DentSpot {
  Triple at{}; // on the wall or near it
  double depth = 0, radius = 0;
};

// A node of a part where the case wants one, as the set "pipe.hanger": on the axis of a beam a node
// of the mesh, on a shell one that is tied by the shape functions of the element.
struct PartPlace {
  std::string name;
  Triple at{};
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
  std::vector<PartPlace> places = {};
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

// Springs by which a liner leans on the wall at each place where it is tied.
struct LinerContact {
  double axial = 0, lateral = 0;                // N/m
  double bending = 0, torsion = 0;              // Nm/rad
  std::optional<SlenderFriction> friction = {}; // beside each of them
};

// The strip-wound liner: a beam on the axis of a bellows.
struct Interlock {
  std::string along; // name of the bellows
  Attachment attachment = Attachment::caps;
  int stations = 0;                         // attachment: stations
  std::optional<LinerContact> contact = {}; // none: it moves with the circles it is tied to
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
  std::optional<double> thickness_field = {}; // as of a wall
  std::vector<PartPlace> places = {};
};

// Nodes of a surface near a point, as a set of their own; within 0: the point of the wall itself.
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
  std::optional<double> thickness_field = {}; // as of a wall
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
  std::optional<double> thickness_field = {};    // as of a wall; of its shells
  std::shared_ptr<const DeckModel> content = {}; // read with the case
};

struct BeamPart {
  std::vector<Triple> points; // the axis, straight between points
  int elements = 1;           // per stretch
  Triple up{0, 0, 1};         // local z lies in the plane of the axis and this vector
  BeamSection section;
  std::vector<PartPlace> places = {};
};

// Of what of the section lies farthest from the axis, m; 0 for stiffness given as numbers.
double outer_radius(const BeamSection& section);

// Where the axis of a beam comes nearest to a point: its stretch from 0, the share of it from its
// start, and the distance.
struct PlaceOnAxis {
  std::size_t stretch = 0;
  double share = 0, distance = 0;
};
PlaceOnAxis nearest_on_axis(const BeamPart& beam, const Triple& at);

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
  // Set of one or more nodes. Several are rigid with it, unless it is soft: then it moves with
  // their mean motion, and they are free to deform; without mass it is not there.
  std::string at;
  bool soft = false;
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

} // namespace plica
