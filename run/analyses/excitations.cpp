#include "run/analyses/excitations.hpp"

#include "model/description/place_keys.hpp"
#include "run/routes/moved_ends.hpp"
#include "solve/effective_mass.hpp"
#include "words/directions.hpp"
#include "words/input_error.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

SpectralDensity spectral_density(const Noise& noise, const std::array<double, 2>& band) {
  if (noise.table.empty()) return {{{band[0], noise.level}, {band[1], noise.level}}};
  return {noise.table};
}

// Over all DOFs, spread evenly over the nodes of the set.
VectorXd nodal_force(const Force& force, const std::string& key, const Model& model) {
  const auto set = model.mesh.sets.find(force.at);
  if (set == model.mesh.sets.end())
    input_error(key, "there is no set \"" + force.at + "\" on the mesh", "the sets of the parts");
  VectorXd F = VectorXd::Zero(dof_count(model));
  for (int node : set->second) F[6 * node + force.direction] += 1. / double(set->second.size());
  return F;
}

const char* acceleration_unit(int direction) {
  return direction < 3 ? "m/s2" : "rad/s2";
}

// Columns of loads, and which of them are an excitation.
class ExcitationList {
public:
  ExcitationList(const Response& asked, const BuiltCase& built)
      : asked_(asked), built_(built), model_(built.model) {}

  Excitations all() {
    for (int direction : asked_.bases) add_base(direction);
    for (const Motion& motion : asked_.motions) add_motion(motion);
    for (std::size_t i = 0; i < asked_.forces.size(); ++i)
      add_force(asked_.forces[i], "analyses.response.forces[" + std::to_string(i) + "].at");
    add_what_acts_ahead();
    for (std::size_t i = 0; i < asked_.together.size(); ++i)
      add_together(asked_.together[i], "analyses.response.together[" + std::to_string(i) + "]");
    const auto count = Index(columns_.size());
    all_.loads = {.base = {},
                  .force = MatrixXd(dof_count(model_), count),
                  .rigid = MatrixXd(dof_count(model_), count)};
    for (Index k = 0; k < count; ++k) {
      const Column& c = columns_[std::size_t(k)];
      all_.loads.base.push_back(c.base);
      all_.loads.force.col(k) = c.force;
      all_.loads.rigid.col(k) = c.moved;
    }
    all_.stretch = MatrixXd::Zero(Index(built_.dampers.size()), count);
    for (Index k = 0; k < count; ++k)
      if (columns_[std::size_t(k)].stretch.size() > 0)
        all_.stretch.col(k) = columns_[std::size_t(k)].stretch;
    return std::move(all_);
  }

private:
  struct Column {
    int base = -1;
    VectorXd force, moved; // all DOFs
    VectorXd stretch = {}; // of the dampers, where ends move
  };
  VectorXd none() const { return VectorXd::Zero(dof_count(model_)); }

  void add(Excitation excitation, const Noise* random, Column column) {
    excitation.parts = {{int(columns_.size()), 1}};
    if (random) excitation.random = one_input(spectral_density(*random, asked_.band));
    all_.list.push_back(std::move(excitation));
    columns_.push_back(std::move(column));
  }

  void add_base(int direction) {
    VectorXd moved = none();
    for (std::size_t node = 0; node < model_.mesh.nodes.size(); ++node) {
      auto u = moved.segment<6>(6 * Index(node));
      u[direction] = 1;
      if (direction >= 3)
        u.head<3>() = Vector3d(Vector3d::Unit(direction - 3)).cross(model_.mesh.nodes[node]);
    }
    add({.name = direction_names[std::size_t(direction)],
         .parts = {},
         .amplitude = asked_.level,
         .unit = acceleration_unit(direction),
         .random_inputs = {},
         .random = {}},
        asked_.random ? &*asked_.random : nullptr, {direction, none(), std::move(moved)});
  }

  // What the ends carry along and, ahead of it by a quarter of a period, what they carry then.
  void add_motion(const Motion& motion) {
    Column moved{-1, none(), none(), VectorXd::Zero(Index(built_.dampers.size()))};
    Column ahead = moved;
    const auto carry = [&](const EndMotion& m) {
      std::vector<MovedCap> caps;
      for (const std::string& cap : m.move) caps.push_back({cap, m.direction});
      const VectorXd field = fields_of_moved_caps(built_, caps).rowwise().sum();
      const VectorXd stretch = stretch_of(field, m);
      for (auto& [column, share] :
           {std::pair{&moved, std::cos(m.phase)}, {&ahead, std::sin(m.phase)}}) {
        column->moved += m.amplitude * share * field;
        column->stretch += m.amplitude * share * stretch;
      }
    };
    carry(motion);
    for (const EndMotion& m : motion.with) carry(m);
    if (ahead.moved.norm() > 1e-12 * moved.moved.norm())
      ahead_.emplace_back(all_.list.size(), followed(std::move(ahead)));
    const auto& random = motion.random ? motion.random : asked_.random;
    add({.name = name_of(motion),
         .source = Source::ends,
         .parts = {},
         .amplitude = asked_.level,
         .unit = acceleration_unit(motion.direction),
         .random_inputs = {},
         .random = {}},
        random ? &*random : nullptr, followed(std::move(moved)));
  }

  // What a field of moved ends, and of the ground behind their springs, stretches.
  VectorXd stretch_of(const VectorXd& field, const EndMotion& m) const {
    VectorXd stretch(Index(built_.dampers.size()));
    for (Index k = 0; k < stretch.size(); ++k) {
      const BuiltDamper& d = built_.dampers[std::size_t(k)];
      stretch[k] = unit_force(model_, d.node1, d.node2, d.dof).dot(field);
      for (const std::string& cap : m.move)
        stretch[k] -= d.place == mount_key(cap) && d.dof == m.direction;
    }
    return stretch;
  }

  // By inertia against it.
  Column followed(Column column) const {
    column.force = -mass_product(model_, column.moved);
    return column;
  }

  void add_force(const Force& force, const std::string& key) {
    add({.name = force.name,
         .source = Source::force,
         .direction = direction_names[std::size_t(force.direction)],
         .parts = {},
         .amplitude = force.amplitude,
         .unit = force.direction < 3 ? "N" : "Nm",
         .random_inputs = {},
         .random = {}},
        force.random ? &*force.random : nullptr, {-1, nodal_force(force, key, model_), none()});
  }

  void add_what_acts_ahead() {
    for (auto& [excitation, column] : ahead_) {
      all_.list[excitation].parts.push_back({int(columns_.size()), {0, 1}});
      columns_.push_back(std::move(column));
    }
    for (Excitation& e : all_.list)
      if (!e.random.densities.empty()) e.random_inputs = {e.parts};
  }

  // The harmonic parts at their amplitudes and phases; the random ones by their cross spectrum.
  void add_together(const Together& asked, const std::string& key) {
    Excitation sum{.name = asked.name,
                   .source = Source::together,
                   .parts = {},
                   .unit = "",
                   .random_inputs = {},
                   .random = {}};
    bool random = true;
    for (std::size_t i = 0; i < asked.inputs.size(); ++i) {
      const InputShare& input = asked.inputs[i];
      const Excitation& e =
          excitation_named(input.of, key + ".inputs[" + std::to_string(i) + "].of", all_);
      const std::complex<double> turned = std::polar(1., input.phase);
      for (const ExcitedColumn& p : e.parts)
        sum.parts.push_back({p.column, e.amplitude * input.factor * turned * p.factor});
      sum.random_inputs.push_back(e.parts);
      random = random && !e.random.densities.empty();
      if (!random) continue;
      SpectralDensity density = e.random.densities[0];
      for (auto& row : density.table) row[1] *= input.factor * input.factor;
      sum.random.densities.push_back(std::move(density));
    }
    if (!asked.spectra.empty()) {
      sum.random = {.densities = {}, .coherence = {}, .table = matrices(asked)};
    } else if (random) {
      sum.random.coherence = coherence(asked);
    } else {
      sum.random = {};
      sum.random_inputs.clear();
    }
    all_.list.push_back(std::move(sum));
  }

  static std::vector<std::pair<double, Eigen::MatrixXcd>> matrices(const Together& asked) {
    const auto n = Index(asked.inputs.size());
    std::vector<std::pair<double, Eigen::MatrixXcd>> table;
    for (const SpectrumMatrix& row : asked.spectra) {
      Eigen::MatrixXcd S = Eigen::MatrixXcd::Zero(n, n);
      for (Index a = 0; a < n; ++a)
        for (Index b = 0; b < n; ++b) {
          const auto at = std::size_t(a * n + b);
          S(a, b) = {row.real[at], row.imaginary.empty() ? 0 : row.imaginary[at]};
        }
      table.emplace_back(row.frequency, std::move(S));
    }
    return table;
  }

  static Eigen::MatrixXcd coherence(const Together& asked) {
    const auto n = Index(asked.inputs.size());
    Eigen::MatrixXcd gamma = Eigen::MatrixXcd::Identity(n, n);
    const auto phase = [&](Index k) { return asked.inputs[std::size_t(k)].phase; };
    if (asked.correlation == InputCorrelation::full)
      for (Index a = 0; a < n; ++a)
        for (Index b = 0; b < n; ++b) gamma(a, b) = std::polar(1., phase(a) - phase(b));
    const auto index = [&](const std::string& of) {
      Index k = 0;
      while (asked.inputs[std::size_t(k)].of != of) ++k;
      return k;
    };
    for (const InputCoherence& c : asked.coherence) {
      const Index a = index(c.a), b = index(c.b);
      gamma(a, b) = std::polar(c.magnitude, c.phase);
      gamma(b, a) = std::conj(gamma(a, b));
    }
    return gamma;
  }

  const Response& asked_;
  const BuiltCase& built_;
  const Model& model_;
  Excitations all_;
  std::vector<Column> columns_;
  std::vector<std::pair<std::size_t, Column>> ahead_; // of which excitation
};

} // namespace

std::string title_of(const Excitation& e) {
  constexpr std::array words{"base ", "motion ", "force ", "together "};
  return words[std::size_t(e.source)] + e.name;
}

Excitations excitations(const Response& asked, const BuiltCase& built) {
  return ExcitationList(asked, built).all();
}

const Excitation& excitation_named(const std::string& name, const std::string& key,
                                   const Excitations& excited) {
  for (const Excitation& e : excited.list)
    if (e.name == name && e.source != Source::together) return e;
  input_error(key, "there is no excitation \"" + name + "\"",
              "a direction of the base, a motion or a force of analyses.response");
}

} // namespace plica
