// What a nominal model may lack: an effect, at each place of the case where it may sit.
//
// An effect changes the model (stiffness and mass, linearly in finite changes of it), the test (how
// the table moves, what sensors read, what the scale sees), or a group of springs over the
// amplitude. One file per effect lists its hypotheses for a case; docs/diagnosis.md says how to add
// one. Nothing here knows of a specimen.
#pragma once

#include "diagnose/effects/spot.hpp"
#include "diagnose/effects/take_over.hpp"
#include "lab/measured/measured.hpp"
#include "model/shape/build.hpp"
#include "reduction/parametric_model.hpp"

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plica {

enum class PriorKind { normal, log_normal, uniform, towards_ends };

// What may be expected of a parameter before the test. Its coordinate z is N(0, 1).
//   normal: centre + width z;  log_normal: centre exp(width z);  uniform: between centre and width
//   towards_ends: between them, denser towards either, as 1 / sqrt(distance) (the arcsine law)
// Between `low` and `high`, where these bound it: z is that of the share of what lies between.
struct Prior {
  PriorKind kind = PriorKind::normal;
  double centre = 0, width = 1;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool lies_between() const { // centre and width
    return kind == PriorKind::uniform || kind == PriorKind::towards_ends;
  }
  bool bounded() const { return std::isfinite(low) || std::isfinite(high); }
};
double value_of(const Prior& prior, double z);

struct EffectParameter {
  std::string name, unit; // SI
  Prior prior;
};

// The test as the hypothesis sees it, beside the specimen's stiffness and mass.
struct TestSetup {
  double damping = 1;                               // factor of all damping ratios
  std::map<std::string, Eigen::Matrix3d> reading{}; // of a sensor: what it shows of its motion
  Eigen::Matrix3d& reading_of(const std::string& sensor) {
    return reading.try_emplace(sensor, Eigen::Matrix3d::Identity()).first->second;
  }
  std::map<std::string, Eigen::Vector3d> moved{}; // of a sensor: how far it sits off its place, m
  Eigen::Matrix3d base = Eigen::Matrix3d::Identity(); // column: motion when an axis is commanded
};

// A group of springs that slip: k(A) = stiffness (1 - share (1 - G(A))), G by Iwan's sliders after
// Segalman: the share of them that slips before a distance d grows as d^exponent up to `distance`.
struct Softening {
  double share = 0, distance = 0, exponent = 1; // distance in m
  double across = 1; // times the distance when the table moves across the pipe
  double loss = 1;   // times the damping of Masing's rule
};

// Tells a hypothesis from all others, also from a copy and from one that lies where it lay before.
class Identity {
public:
  Identity() : number_(next()) {}
  Identity(const Identity&) : Identity() {}
  Identity& operator=(const Identity&) {
    number_ = next();
    return *this;
  }
  ~Identity() = default;
  std::uint64_t number() const { return number_; }

private:
  static std::uint64_t next();
  std::uint64_t number_;
};

// An effect at a place; where it may act in several ways, one for each.
struct Hypothesis {
  std::string effect, place, way; // way: "x", "diagonal"; empty = there is but one
  std::vector<EffectParameter> parameters;
  std::size_t size = 0; // the parameter that says how large it is
  std::vector<ModelChange> changes = {};
  // In place of `changes`: of the case, which is built anew; small, or large for some case.
  std::vector<std::function<void(Case&)>> case_changes = {};
  bool large = false;
  // Of the changes, by the values of the parameters.
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> coefficients = {};
  bool at_rig = true; // acts on the static rig and the scale too, not on the shaker alone
  std::vector<int> released = {}; // held nodes that the table no longer holds
  std::function<void(TestSetup&, const Eigen::VectorXd&)> setup = {};
  // The first change adds `present` times less than the group has; it softens.
  std::function<Softening(const Eigen::VectorXd&)> softening = {};
  double group_stiffness = 0; // N/m: stretch of the group = sqrt(2 energy / this)
  // Of what the first change adds, how often the nominal model has it: 1, 0 = not at all, thousands
  // of times where it is drawn as rigid.
  double group_present = 1;
  double law_error = 0; // share of what slip changes that its law may be off
  // It says where, not why: it counts only where no other effect at the place closes half as much,
  // and never explains all.
  bool names_place_only = false;
  // It has a resonance of its own, for which another thing's may be taken.
  bool resonates = false;
  // Places of the same effect and way between which it lies: their signatures are its own, and it
  // is fitted where one of them comes near.
  PlaceShares between = {};
  // That say which of many spots `place` is: as many parameters that it has not (Spot).
  int free_numbers = 0;
  double weight = 1; // of the place, among those of the effect (Spot)
  // The parameters that say where on `place` it acts, m: one along a line, two on a plate.
  std::vector<std::size_t> along = {};
  // Of all parameters those that act in a state, where states differ (growth.hpp).
  std::function<Eigen::VectorXd(const Eigen::VectorXd&, const std::string& state)> values_in = {};
  // What a case says in place of the effect at these values, where it says that much already; none
  // of either: no key of a case says it.
  std::function<CaseEdits(const Case& now, const Eigen::VectorXd& values)> in_case = {};
  Identity identity = {};
};

// What effects look at to find their places.
struct Structure {
  const Case& data;
  const BuiltCase& built;
  const Measured& measured;
  // Scales of the priors: of the whole, and of its lowest mode.
  double stiffness = 0; // N/m
  double mass = 0;      // kg
  double length = 0;    // m
  double frequency = 0; // Hz, of the lowest four modes, their geometric mean
  // Places of clamps that the case draws as rigid and that stand on springs in `data`
  // (sprung_clamps.hpp).
  std::vector<std::string> rigid_clamps = {};
  bool reads_across = false; // the test reads motion along other axes than what moves the part
};

struct LookAlike {
  std::string effect, how;           // the measurement that tells them apart
  bool is_answered_by_scale = false; // no advice where every state of the test was weighed
};

struct Effect {
  std::string name; // of the contract: "ply_slip"
  // For whoever reads one line only: "{mass} that nobody weighed". A parameter in braces is its
  // value; {ratio%} in percent, {ratio+} in percent off 1.
  std::string plain;
  // In its place where the hypothesis has a parameter `stiffness`, since the case draws as rigid
  // what gives way; empty: no hypothesis has.
  std::string plain_of_rigid = {};
  std::string physics; // one sentence
  std::string signature;
  std::vector<LookAlike> look_alikes;
  std::string needs; // of a case, to have a place for it: "a joint"
  std::vector<Hypothesis> (*hypotheses)(const Structure&) = nullptr;
};

// Coefficients of changes made at `samples` of a scalar such that functions of it, zero for the
// nominal structure, are met: exact where stiffness and mass are linear in these functions.
// `functions` gives as many values as there are samples.
std::function<Eigen::VectorXd(double)>
coefficients_through(const std::function<Eigen::VectorXd(double)>& functions,
                     const std::vector<double>& samples);

// All effects, the library of the diagnosis.
const std::vector<Effect>& effects();
const Effect& effect_named(const std::string& name); // throws std::out_of_range

// Whether the case names the effect, among its effects or its priors.
bool asked_for(const Structure& s, const std::string& effect);

// One file each.
Effect ply_slip();
Effect joint_friction();
Effect joint_stiffness();
Effect fixture_flexibility();
Effect boundary_compliance();
Effect extra_support();
Effect added_mass();
Effect component_mass();
Effect component_stiffness();
Effect local_damage();
Effect forming_thinning();
Effect damping();
Effect cross_axis_base_motion();
Effect temperature();
Effect rotated_sensor();
Effect sensor_gain();
Effect unweighed_mass();
Effect installation_offset();
Effect pressure();

} // namespace plica
