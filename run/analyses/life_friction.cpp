// Sweeps through the response of joints with friction.
#include "run/analyses/life.hpp"

#include "life/rainflow.hpp"
#include "life/spectral.hpp"
#include "run/analyses/jointed_model.hpp"
#include "run/analyses/levels.hpp"
#include "words/directions.hpp"
#include "words/input_error.hpp"

#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr int phases = 64; // of a period

Case at_one_level(Case data, const LifeSweep& asked) {
  Levels levels = data.analyses.levels.value_or(Levels{});
  levels.bases = {place_among(direction_names, asked.of)};
  levels.levels = {*asked.acceleration};
  levels.forces.clear();
  levels.band = asked.band;
  data.analyses.levels = levels;
  return data;
}

// Rows of coordinates over a period at a point of the branch: phases x modes.
MatrixXd over_a_period(const PeriodicPoint& point, const std::vector<int>& orders) {
  MatrixXd q = MatrixXd::Zero(phases, point.modes.cols());
  for (int i = 0; i < phases; ++i)
    for (std::size_t k = 0; k < orders.size(); ++k)
      q.row(i) +=
          (std::polar(1., 2 * pi * orders[k] * i / phases) * point.modes.row(Index(k))).real();
  return q;
}

// Cycles of a stress that repeats: from its highest value once round to it.
std::vector<RainflowCycle> cycles_of_period(const VectorXd& s) {
  Index top = 0;
  s.maxCoeff(&top);
  std::vector<double> once;
  for (Index i = 0; i <= s.size(); ++i) once.push_back(s[(top + i) % s.size()]);
  return rainflow(once);
}

} // namespace

void LifeCount::add_friction_sweeps(const BuiltCase& slipping, Route& route,
                                    const StageListener& stage) {
  for (const LifeSweep& asked : life_.sweeps)
    if (asked.friction) add_friction_sweep(asked, slipping, route, stage);
}

void LifeCount::add_friction_sweep(const LifeSweep& asked, const BuiltCase& slipping, Route& route,
                                   const StageListener& stage) {
  stage({stages::life, ", sweep " + asked.name});
  const Case data = at_one_level(case_, asked);
  const Levels& levels = *data.analyses.levels;
  const JointedModel jointed = jointed_model(data, slipping, route);
  const ExcitedPart part = excited_part(jointed, 0);
  const Branch branch =
      follow_frequency(part.structure, levels.levels[0], harmonic_settings(levels, levels.method));
  const std::string title = "base " + asked.of;
  DutyMap duty =
      new_duty(DutyKind::sweep, asked.name,
               sweep_words(asked, title, jointed.excitations[0].unit) + ", with friction",
               asked.count, "sweeps");
  if (!branch.complete)
    warnings_.push_back("life, sweep " + asked.name +
                        ": the response was not followed to the end " +
                        "of the band, what is above is not counted: " + branch.reason);
  const std::vector<std::size_t> points = sweep_over(branch, true).points;
  const auto count_of = int(points.size());
  if (count_of < 2) throw std::runtime_error("life, sweep " + asked.name + ": no response found");
  const MatrixXd plane =
      plane_of(recover_stress(slipping.model, jointed.shapes(Eigen::all, part.modes)));
  std::vector<MatrixXd> q;
  MatrixXd C = MatrixXd::Zero(plane.cols(), plane.cols());
  for (const std::size_t p : points) {
    q.push_back(over_a_period(branch.points[p], branch.orders));
    C += q.back().transpose() * q.back();
  }
  VectorXd hertz(count_of);
  for (int k = 0; k < count_of; ++k)
    hertz[k] = branch.points[points[std::size_t(k)]].omega / (2 * pi);
  const VectorXd cycles =
      moment_weights(hertz, 0) / (asked.octaves_per_minute / 60 * std::numbers::ln2);
  duty.counted = worst_sites(plane, C);
  const auto counted = int(duty.counted.size());
#pragma omp parallel for schedule(dynamic)
  for (int i = 0; i < counted; ++i) {
    const int site = duty.counted[std::size_t(i)];
    const MatrixXd own = plane.middleRows<3>(3 * Index(site));
    const Eigen::Vector3d rest = state_.segment<3>(3 * Index(site));
    for (int k = 0; k < count_of; ++k) {
      MatrixXd s = q[std::size_t(k)] * own.transpose(); // phases x 3
      s.rowwise() += rest.transpose();
      for (Index d = 0; d < directions_.rows(); ++d) {
        VectorXd one(phases);
        for (int j = 0; j < phases; ++j)
          one[j] = life_.measure == StressMeasure::signed_von_mises
                       ? signed_von_mises(s.row(j).transpose())
                       : directions_.row(d).dot(s.row(j));
        for (const RainflowCycle& c : cycles_of_period(one))
          count(duty, site, d, {c.range, c.mean}, asked.count * c.count * cycles[k]);
      }
    }
  }
  duty.head.cycles = cycles.sum();
  spread(duty);
  duties_.push_back(std::move(duty));
}

} // namespace plica
