// What a run gives: plain data, SI units, frequencies in Hz. io/ writes it as JSON, CSV, VTU, HTML.
#pragma once

#include "mesh/mesh.hpp"
#include "model/description/connector_curve.hpp"
#include "model/shape/symbols.hpp"
#include "run/results/deck_load_results.hpp"
#include "run/results/level_results.hpp"
#include "run/results/life_results.hpp"
#include "run/results/state_results.hpp"
#include "run/results/time_results.hpp"

#include <Eigen/Core>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plica {

struct ModelSize {
  int nodes = 0, elements = 0;
  int dofs = 0;    // independent unknowns before the mount holds any
  double mass = 0; // kg
};

// Between the two end-cap reference nodes, one held: axial force/displacement; lateral
// force/displacement with the end kept parallel; moment/rotation of a free end; torque/twist.
struct StaticStiffness {
  double k_axial = 0, k_transverse_x = 0, k_transverse_z = 0; // N/m
  double k_bending_x = 0, k_bending_z = 0, k_torsion = 0;     // Nm/rad, about x, z and y
  Eigen::Matrix<double, 12, 12> end_stiffness; // both reference nodes, ux uy uz rx ry rz each

  // In the order of stiffness_names, and of StaticDirection.
  std::array<double, 6> all() const {
    return {k_axial, k_transverse_x, k_transverse_z, k_bending_x, k_bending_z, k_torsion};
  }
};
inline constexpr std::array stiffness_names{"axial",     "transverse x", "transverse z",
                                            "bending x", "bending z",    "torsion"};

struct ModeResult {
  double frequency = 0;
  double damping = 0;                     // fraction of critical
  std::array<double, 6> effective_mass{}; // x y z in kg; about x y z through the centre in kg m2
  std::string shape;                      // one of mode_kind (words/mode_kinds.hpp)
  std::string direction;                  // x, y, z or empty
  int order = 0;       // half waves along the axis, counted from 1; 0 = not counted
  int harmonic = -1;   // circumferential order; -1 = not a body of revolution
  std::string place;   // of most of its strain energy, where another mode is called the same
  double residual = 0; // ||K phi - w2 M phi|| / ||K phi||
  std::optional<double> damped_frequency = {}; // |s| / 2 pi of the complex mode, where there is one
};

// Modes with dampers and coupled loss factors: T(s) phi = 0, in the order of the real ones.
struct ComplexModesResult {
  bool complete = false; // as many as the real modes
  int oscillating = 0, overdamped = 0;
  std::string reason;                   // why not
  std::vector<Eigen::VectorXcd> shapes; // of the channels of the sensors, three per sensor
};

// Proof that no mode below `sigma` is missing.
struct Verification {
  bool made = false;          // the proof was asked for
  double sigma_frequency = 0; // the count is of the modes below it, Hz
  int inertia_count = 0;      // eigenvalues below sigma by inertia
  int found = 0;              // modes found below sigma
  double max_residual = 0;
  double orthogonality = 0; // max |Phi' M Phi - I|
  double rounding = 0;      // share by which rounding of K may move a lambda, at most
  bool passed = false;
  std::string reason; // why not passed
  std::string of;     // "the reduced model" where that was counted; empty = the model
};

enum class ComparedKind { mass, stiffness, frequency, damping, amplitude };

struct MeasuredComparison { // one measured number beside the computed one
  std::string quantity;     // "axial stiffness", "axial mode 1", ...
  std::string unit;
  double measured = 0, sigma = 0, computed = 0;
  std::string entry = {}; // of the measured data: "modes[0]"
  ComparedKind kind = ComparedKind::frequency;
  int static_test = -1;             // of a stiffness: its place in stiffness_names
  bool of_peak = false;             // of a peak of a response rather than of a mode
  bool over_stroke = false;         // a stiffness from a curve of the force
  std::optional<double> level = {}; // m/s2, of a peak over the level
};

// Name of the variant without the state of a case that has one.
inline constexpr const char* variant_at_rest = "at rest";

struct VariantResult { // headline numbers of a variant of the case
  std::string name;
  std::vector<std::pair<std::string, std::string>> set; // path, new value
  std::map<std::string, double> headline;     // same keys in every variant, see headline()
  std::vector<MeasuredComparison> comparison; // empty when nothing was measured
  std::optional<StateResult> state = {};      // of one of the states of the case
};

struct ResponsePeak {
  int channel = 0;
  double frequency = 0, amplitude = 0;
  double damping = 0; // half power; NaN where a neighbour covers a flank
  double phase = 0;   // rad, of the acceleration ahead of the excitation
};

struct BandRms {
  std::array<double, 2> band{}; // Hz
  double input = 0;             // of the base or the force
  Eigen::VectorXd rms;          // per channel, m/s2
};

struct CrossDensity {
  int a = 0, b = 0; // channels
  Eigen::VectorXcd density;
};

// A sine that sweeps beside a random input, at its worst frequency for each channel.
struct ToneResult {
  std::array<double, 2> band{};    // Hz
  double amplitude = 0;            // of the input
  Eigen::VectorXd frequency, sine; // per channel: Hz, amplitude in m/s2
  Eigen::VectorXd rms;             // of sine and random motion together, m/s2
};

// Stationary response to a random input; one-sided densities, (m/s2)^2/Hz per channel.
struct RandomResult {
  Eigen::VectorXd input;      // per frequency; empty for several inputs together
  Eigen::MatrixXd density;    // frequencies x channels
  std::vector<BandRms> bands; // the whole band first
  std::vector<CrossDensity> cross;
  std::vector<ToneResult> tones;
};

// A measured response of one channel, beside the computed one.
struct TestCurve {
  int channel = 0; // of the response
  Eigen::VectorXd hertz, magnitude;
  Eigen::VectorXd phase;       // rad; empty: the test has magnitudes alone
  std::optional<double> level; // of the excitation
};

// What excites: everything that is mounted, chosen ends of it, a force, or several of these.
enum class Source { base, ends, force, together };

// The response beside a direct solution of the whole mesh.
struct DirectCheck {
  double frequency = 0;  // Hz
  double difference = 0; // norm over the channels, over that of the direct solution
};

// Acceleration of the sensors in their own axes: absolute and per acceleration of the base or of
// the ends that move (transmissibility), or per N (Nm) of a force with the base at rest; under
// several inputs together as it is, in m/s2.
struct ResponseResult {
  std::string excitation; // base: x y z rx ry rz; or the name of the motion or force
  Source source = Source::base;
  std::string direction = {}; // of a force: x y z rx ry rz
  double level = 1;           // amplitude of the excitation
  std::string unit;           // of the excitation: m/s2 rad/s2 N Nm; empty for several together
  Eigen::VectorXd hertz;
  std::vector<std::pair<std::string, std::string>> channels; // sensor, axis: three per sensor
  Eigen::MatrixXcd acceleration;                             // frequencies x channels
  std::vector<int> shown; // channels that are more than a thousandth of the largest
  std::vector<ResponsePeak> peaks;
  std::optional<RandomResult> random;
  std::vector<TestCurve> test; // at the measured level that is nearest
  std::vector<DirectCheck> direct = {};
};

// The check that differs most, of at least one.
DirectCheck farthest(const std::vector<DirectCheck>& checks);

// Largest resultant of the three axes of each sensor, frequencies x sensors: root of the sum of the
// squared amplitudes.
Eigen::MatrixXd vector_sum(const ResponseResult& response);

// Von Mises stress of the shells on both faces and the axial stress of beams, with the places of
// the largest.
struct StressResult {
  StressKind kind = StressKind::statics;
  std::string name; // what it is the stress of, with its amplitude
  double largest = 0;
  std::array<double, 3> at{}; // m
  std::string face;           // below or above: against or along the director (inner, outer)
  double largest_beam = 0;    // magnitude of the axial stress of a fibre, Pa
  std::array<double, 3> beam_at{};
  Eigen::VectorXd below, above; // per node, Pa
};

// What a number misses of its converged value, estimated, signed, in its unit; not a number when a
// finer run did not meet it.
struct MeshError {
  double along = 0, around = 0; // for want of elements
  double cutoff = 0;            // for want of modes of the superelements

  double total() const { return along + around + cutoff; }
};

// A headline number with its errors. Interval: 5 % and 95 % points over the tolerances.
struct ErrorBar {
  std::string key; // as in headline()
  double value = 0;
  MeshError mesh;
  std::optional<std::array<double, 2>> interval;
  std::vector<double> shares; // of the variance, per tolerance
};

struct ErrorBars {
  std::vector<ErrorBar> bars;
  std::vector<MeshError> statics; // in the order of StaticStiffness::all(); empty = not made
  std::vector<MeshError> modes, stresses; // Hz and Pa, as the results list them; empty = not made
  // Of the magnitude of von Mises stress of every row of the stress tables, Pa; empty = not made.
  std::vector<std::vector<MeshError>> places;
  bool along = false, around = false;  // the mesh could be refined that way
  std::vector<std::string> tolerances; // paths
  double interaction = 0; // largest deviation of a run with all tolerances drawn at random from the
                          // sum of the single effects, relative
};

struct SensorResult {
  std::string name;
  int node = 0;
  double distance = 0;              // from where the case puts it to the node, m
  std::array<int, 3> axes{1, 2, 3}; // its own in the part frame: 1 x, 2 y, 3 z, negative reversed
};

// A superelement in place of a part of the model.
struct SuperelementResult {
  std::string parts;                // names of what it holds: "bellows_left, interlock_left"
  std::vector<std::string> between; // caps it meets
  int boundary = 0, modes = 0;      // coordinates: of the boundary, modal
  int unknowns = 0;                 // it stands for
  int copy_of = 0;                  // number of the superelement whose reduction it shares, from 1
  std::string route;                // "rotational symmetry, 40 sectors" or "full mesh: ..."
  bool proved = false;              // no mode below the cut-off is missing
};

struct Reduced {
  double cutoff = 0; // Hz
  std::vector<SuperelementResult> superelements;
  int unknowns = 0; // of the reduced model
};

struct InputFile {
  std::string name, text;
};

struct Results {
  std::string case_name, title, plica_version;
  std::string modelled_as; // alternative model of the case; empty = its parts
  std::vector<std::string> assumptions;
  std::vector<std::string> warnings;
  std::vector<InputFile> inputs; // as they were read
  std::string versions;          // of the libraries
  ModelSize model;
  std::string route; // how it was solved: "rotational symmetry, 38 sectors" or "full mesh: ..."
  std::string mesh_choice; // why the mesh is finer than that of a first run; empty = it is not
  std::optional<Reduced> reduced;
  std::optional<StateResult> state;       // around which all the rest is; none: the part at rest
  std::optional<StaticStiffness> statics; // joints with friction slip, nonlinear springs at rest
  std::vector<StrokeCurve> strokes;
  std::vector<ModeResult> modes;
  std::vector<SensorResult> sensors;
  std::vector<ResponseResult> responses;
  ComplexModesResult complex_modes;
  std::vector<TransientResult> transients;
  std::vector<RunUpResult> run_ups;
  std::vector<LevelResponses> level_responses; // responses at several levels
  std::optional<SlippingLimit> slipping;       // where joints have friction
  std::vector<StressResult> stresses;
  std::vector<StressPlace> places;        // of the shells
  std::vector<StressTable> stress_tables; // of the stresses, in their order
  std::optional<LifeResult> life;
  ErrorBars error_bars;
  std::array<double, 6>
      free_mass{}; // r' M r over the free unknowns: what effective masses add up to
  std::array<double, 6> effective_mass_sum{};
  Verification verification;
  MeshQuality quality;
  std::vector<MeasuredComparison> comparison;
  std::vector<std::string> unanswered; // measured responses that this model has no path for
  std::vector<VariantResult> variants;
  std::map<std::string, double> timing; // stage: seconds
  double peak_memory = 0;               // bytes
  // For pictures: node coordinates, quads and lines in `mesh`; one 6-column displacement field per
  // mode (nodes x 6), thickness per quad in `mesh.quads`.
  Mesh mesh;
  std::vector<std::array<int, 2>> lines;
  std::vector<double> line_radii; // of each line, m; 0: no section to draw
  std::vector<Symbol> symbols;
  std::vector<Eigen::MatrixXd> shapes;
  std::vector<std::array<double, 2>> meridian; // [y, r] along the shells of revolution
  std::vector<DeckLoadResult> deck_loads;      // static analyses of the loads of decks
};

// Headline numbers by name: "k_axial", "f_axial", "f_transverse", "f_torsion", "mass"; "life_NAME",
// the largest stress range of a duty, Pa.
std::map<std::string, double> headline(const Results& results);

} // namespace plica
