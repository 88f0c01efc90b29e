// What is asked of a case (case.hpp): modes, damping, responses, levels, stress.
#pragma once

#include "model/description/life_request.hpp"
#include "model/description/time_analyses.hpp"
#include "solve/joint_method.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace plica {

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
// all. Loss factors come on top: weighted by the strain energy of their component in each mode, or,
// `coupled`, as complex stiffness in the responses, with what they couple.
struct Damping {
  double modal = 0;
  std::vector<DampingRange> ranges = {};
  std::vector<ModeDamping> modes = {};
  std::vector<LossFactor> loss_factors = {};
  bool coupled = false;
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

// Motion of some of the mounted caps, along or about an axis through each.
struct EndMotion {
  std::vector<std::string> move; // caps
  int direction = 1;             // 0..5 = x y z rx ry rz
  double amplitude = 1;          // times the level
  double phase = 0;              // rad, ahead of the input
};

// One input that moves chosen ends, the other ones at rest or with it.
struct Motion : EndMotion {
  std::string name;            // empty: of the first caps and the direction, "engine_y"
  std::vector<EndMotion> with; // move with it
  std::optional<BaseNoise> random;
};
std::string name_of(const Motion& motion);

// A sine that sweeps while the random input goes on.
struct Tone {
  std::string of;                            // a random input, by its name
  std::array<double, 2> band{};              // Hz
  std::optional<double> acceleration, force; // amplitude
};

// One of several inputs that act at once.
struct InputShare {
  std::string of;    // excitation by its name
  double factor = 1; // times its own amplitude or spectral density (squared)
  double phase = 0;  // rad, ahead of the others
};

// Of the random parts of several inputs.
enum class InputCorrelation { none, full };

struct InputCoherence { // of two inputs, in place of `correlation`
  std::string a, b;
  double magnitude = 1; // of the complex coherence: |S_ab| / sqrt(S_aa S_bb)
  double phase = 0;     // rad, of a ahead of b
};

// Cross-spectral matrix of the inputs in their order, row by row, (unit_a unit_b)/Hz.
struct SpectrumMatrix {
  double frequency = 0;
  std::vector<double> real, imaginary; // imaginary: empty = zero
};

struct Together {
  std::string name;
  std::vector<InputShare> inputs;
  InputCorrelation correlation = InputCorrelation::none;
  std::vector<InputCoherence> coherence;
  std::vector<SpectrumMatrix> spectra; // in place of the densities of the inputs
};

struct CrossPair { // two channels, "sensor.direction"
  std::string a, b;
};

// Response of the sensors to motion of the base, of chosen ends and to forces, each on its own.
struct Response {
  std::vector<int> bases;           // 0..5 = x y z rx ry rz; rotations about the origin
  std::vector<Motion> motions = {}; // of chosen ends
  double level = 1;                 // amplitude of the base, m/s2 or rad/s2
  std::optional<BaseNoise> random = {};
  std::vector<Force> forces = {};
  std::vector<Together> together = {};
  std::vector<Tone> tones = {};
  std::array<double, 2> band{10, 500}; // Hz
  int points = 491; // even steps; eigenfrequencies and clusters round them besides
  std::vector<std::array<double, 2>> rms_bands = {}; // Hz; beside the whole band
  std::vector<CrossPair> cross = {};                 // cross densities of a random response
  int referee = 0; // frequencies of a direct solution of the whole mesh
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
struct SuperelementsInRun {
  double cutoff =
      0; // of the modes with the caps held, Hz; 0 = twice the highest frequency asked for
};

struct Analyses {
  Symmetry symmetry = Symmetry::automatic;
  std::optional<SuperelementsInRun> reduction;
  std::optional<bool> statics; // end stiffness between two caps; none: where there are two
  bool deck_loads = false;     // what the loads of the decks among the parts do
  std::optional<Modes> modes;
  Damping damping;
  std::optional<Response> response;
  std::vector<Transient> transients = {};
  std::vector<RunUp> run_ups = {};
  std::optional<Levels> levels;
  std::optional<Stress> stress;
  std::optional<Life> life = {};
  bool error_bars = true; // discretisation and tolerances of the headline numbers
};

// Names of what excites each on its own: "y", "engine_y", "tap".
std::vector<std::string> excitation_names(const Response& response);

// Of response and modes, Hz; 0 when neither has a band.
double highest_frequency(const Analyses& analyses);

// Cut-off of a reduction, Hz: as asked, or twice the upper end of the bands of response and modes,
// or 1000 Hz where there is none.
double reduction_cutoff(const Analyses& analyses);

} // namespace plica
