#include "diagnose/weigh/uncertainty.hpp"

#include "diagnose/readings/same_thing.hpp"
#include "diagnose/weigh/damping_weights.hpp"
#include "diagnose/weigh/level_errors.hpp"
#include "diagnose/weigh/normal_draws.hpp"
#include "diagnose/weigh/rig_errors.hpp"
#include "diagnose/weigh/scatter.hpp"
#include "run/analyses/run.hpp"
#include "run/study/error_bars.hpp"
#include "solve/parallel.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

bool same_mode(const TestReadings& test, const Reading& a, const Reading& b) {
  if (a.run < 0 || b.run < 0) return false;
  if (a.mode >= 0 || b.mode >= 0) return a.mode == b.mode;
  if (a.peak != b.peak) return false;
  const TestRun &r = test.runs[std::size_t(a.run)], &s = test.runs[std::size_t(b.run)];
  if (!r.input.any()) return !s.input.any() && a.entry == b.entry;
  return r.input == s.input && r.axis == s.axis;
}

// What one sensor shows along an axis when the table moves along another, at any level.
bool same_way(const TestReadings& test, const Reading& a, const Reading& b) {
  return a.sensor == b.sensor && a.axis == b.axis && a.state == b.state &&
         (a.at_run >= 0) == (b.at_run >= 0) && a.highest == b.highest &&
         test.runs[std::size_t(a.run)].input == test.runs[std::size_t(b.run)].input;
}

// Numbers of the series of readings that differ in nothing but the level, or of a rig the
// frequency.
std::vector<int> series_of(const TestReadings& test) {
  using Run = std::tuple<Input, int, bool, std::string>;
  std::map<std::tuple<ReadingKind, std::string, std::string, int, Run, bool, bool, int>, int> known;
  std::vector<int> series;
  for (const Reading& r : test.readings) {
    if (is_of_rig(r)) {
      const int next = int(known.size());
      series.push_back(
          known.try_emplace({r.kind, r.state, rig_motion(r), r.axis, Run(), false, false, 0}, next)
              .first->second);
      continue;
    }
    if (r.run < 0 || r.kind == ReadingKind::component ||
        (!test.runs[std::size_t(r.run)].input.any() && test.runs[std::size_t(r.run)].level == 0)) {
      series.push_back(-1 - int(series.size())); // alone
      continue;
    }
    const TestRun& run = test.runs[std::size_t(r.run)];
    const bool response = run.input.any();
    const Run of{run.input, run.axis, run.by_force, response ? "" : run.sensor};
    series.push_back(
        known
            .try_emplace({r.kind, r.state, response ? r.sensor : std::to_string(int(r.shape)),
                          r.axis, of, r.at_run >= 0, r.highest,
                          r.mode >= 0 ? r.mode
                          : response  ? r.peak
                                      : r.order},
                         int(known.size()))
            .first->second);
  }
  return series;
}

// Shifts of frequency that the readings of one mode share where `together` says so.
template <class Together>
MatrixXd shared_frequency(const TestReadings& test, double sigma, Together together) {
  const auto n = Index(test.readings.size());
  const auto is_frequency = [](const Reading& r) { return r.kind == ReadingKind::frequency; };
  MatrixXd S = MatrixXd::Zero(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      const Reading &a = test.readings[std::size_t(i)], &b = test.readings[std::size_t(j)];
      if (is_frequency(a) && is_frequency(b) && same_mode(test, a, b) && together(a, b))
        S(i, j) = sigma * sigma;
    }
  return S;
}

// Whether the input was the same, which all forces are for the damping of modes; a mode without
// excitation stands for itself.
bool same_input(const TestReadings& test, const Reading& a, const Reading& b) {
  if (a.run < 0 || b.run < 0) return false;
  const TestRun &r = test.runs[std::size_t(a.run)], &s = test.runs[std::size_t(b.run)];
  if (!r.input.force.empty() && !s.input.force.empty()) return true;
  return r.input == s.input && (r.input.any() || a.entry == b.entry);
}

// What the damping of every mode puts on the readings, by `weights` (damping_weights.hpp), where
// `together` says that it is one and the same shift.
template <class Together>
MatrixXd shared_damping(const TestReadings& test, const MatrixXd& weights, double sigma,
                        Together together) {
  MatrixXd S = sigma * sigma * weights * weights.transpose();
  for (Index i = 0; i < S.rows(); ++i)
    for (Index j = 0; j < S.cols(); ++j)
      if (!together(test.readings[std::size_t(i)], test.readings[std::size_t(j)])) S(i, j) = 0;
  return S;
}

// What the mesh of the case gives more than the coarse one: of frequencies by the name of their
// mode, of static and dynamic stiffnesses, of the mass. It is solved as `plica run` does, by
// symmetry where there is one.
VectorXd mesh_correction(const Case& data, const Nominal& nominal, const Measured& measured,
                         const TestReadings& test, const VectorXd& coarse,
                         std::vector<std::string>& refused) {
  Case plain = for_headline(data);
  plain.analyses.statics =
      std::any_of(test.readings.begin(), test.readings.end(),
                  [](const Reading& r) { return r.kind == ReadingKind::stiffness; });
  if (!plain.analyses.modes) plain.analyses.modes = Modes{.count = 10, .proof = false};
  const Results own = run(plain, [](const std::string&) {});
  const std::vector<int> modes = Predictor(nominal, test, {}).nominal_modes();
  RigMeshCorrection rig = rig_mesh_correction(plain, measured, test, coarse);
  VectorXd correction = std::move(rig.log);
  const auto any = [](const std::string& why) { return !why.empty(); };
  if (std::any_of(rig.refused.begin(), rig.refused.end(), any)) refused = std::move(rig.refused);
  for (Index i = 0; i < coarse.size(); ++i) {
    const Reading& r = test.readings[std::size_t(i)];
    if (r.kind == ReadingKind::mass)
      correction[i] = std::log(own.model.mass) - std::log(nominal.mass);
    if (r.kind == ReadingKind::stiffness && own.statics)
      correction[i] =
          std::log(own.statics->all()[static_cast<std::size_t>(r.direction)]) - coarse[i];
    if (r.kind != ReadingKind::frequency || modes[std::size_t(i)] < 0) continue;
    const NominalState& state = nominal.states.front();
    const auto j = std::size_t(modes[std::size_t(i)]);
    const auto place = [](const auto& list, std::size_t until, const auto& like) {
      int same = 0; // how many of its kind up to it
      for (std::size_t m = 0; m <= until; ++m)
        same += list[m].shape == like.shape && list[m].direction == like.direction;
      return same;
    };
    const int rank = place(state.labels, j, state.labels[j]);
    for (std::size_t m = 0; m < own.modes.size(); ++m)
      if (own.modes[m].shape == state.labels[j].shape &&
          own.modes[m].direction == state.labels[j].direction &&
          place(own.modes, m, state.labels[j]) == rank) {
        const double coarse_hertz = plica::frequency(state.model->lambda()[Index(j)]);
        const double ratio = std::log(own.modes[m].frequency / coarse_hertz);
        if (std::abs(ratio) < 0.2) correction[i] = ratio;
        break;
      }
  }
  return correction;
}

// What specimens add to the square of a reading along another axis; `shift`: of its logarithm.
double added_square(const Eigen::RowVectorXd& shift, double nominal) {
  double sum = 0;
  for (double x : shift)
    sum += std::pow(cross_value(nominal + x), 2) - std::pow(cross_value(nominal), 2);
  return std::max(0., sum / double(shift.size()));
}

// Mean square that the errors of any test add to a reading along another axis.
double by_errors_of_test(const Answered& answered, Index i) {
  const double turn = scatters::turn * std::numbers::pi / 180;
  return turn * turn * answered.across(i, 0) +
         scatters::other_axes * scatters::other_axes * answered.across(i, 1);
}

MatrixXd covariance(const MatrixXd& draws) {
  return draws * draws.transpose() / double(draws.cols() - 1);
}

// Whether readings share a shift: whatever was measured; of one specimen as it was mounted; of one
// run.
bool always(const Reading&, const Reading&) {
  return true;
}
bool as_mounted(const Reading& a, const Reading& b) {
  return a.state == b.state;
}
bool at_once(const Reading& a, const Reading& b) {
  return a.run == b.run;
}
auto by_input(const TestReadings& test, bool (*together)(const Reading&, const Reading&)) {
  return [&test, together](const Reading& a, const Reading& b) {
    return same_input(test, a, b) && together(a, b);
  };
}

MatrixXd measurement_of(const TestReadings& test, const std::vector<int>& series) {
  const auto n = Index(test.readings.size());
  MatrixXd S = MatrixXd::Zero(n, n);
  for (Index i = 0; i < n; ++i) S(i, i) = std::pow(test.readings[std::size_t(i)].sigma, 2);
  add_common_rig_error(test, S);
  add_error_of_levels(test, series, S);
  return S;
}

MatrixXd reassembly_of(const TestReadings& test, const MatrixXd& weights,
                       const Remounting& remounting) {
  using namespace test_sigma;
  return shared_frequency(test, remounting.frequency, as_mounted) +
         shared_damping(test, weights, remounting.damping, by_input(test, as_mounted)) +
         shared_frequency(test, run_frequency, at_once) +
         shared_damping(test, weights, run_damping, by_input(test, at_once)) +
         shared_rig_loss(test, remounting.damping);
}

// Whether mesh and reduction miss the same of both: of a thing in every state and at every level,
// of a rig at every stroke and frequency.
bool miss_the_same(const TestReadings& test, const Reading& a, const Reading& b) {
  if (a.kind != b.kind) return false;
  if (is_of_rig(a) && is_of_rig(b)) return a.axis == b.axis && rig_motion(a) == rig_motion(b);
  return same_thing(test, a, b) || (a.kind == ReadingKind::frequency && same_mode(test, a, b));
}

MatrixXd numeric_of(const TestReadings& test, const MatrixXd& weights,
                    const std::vector<CrossScatter>& cross, const VectorXd& correction) {
  using namespace test_sigma;
  MatrixXd S = shared_damping(test, weights, numeric_damping, by_input(test, always)) +
               shared_rig_loss(test, numeric_damping);
  for (const CrossScatter& a : cross)
    for (const CrossScatter& b : cross)
      if (same_way(test, test.readings[std::size_t(a.reading)],
                   test.readings[std::size_t(b.reading)]))
        S(a.reading, b.reading) += std::pow(numeric_cross, 2);
  const auto own = [](ReadingKind kind) {
    switch (kind) {
    case ReadingKind::frequency:
      return numeric_frequency;
    case ReadingKind::stiffness:
    case ReadingKind::dynamic_stiffness:
      return numeric_stiffness;
    case ReadingKind::component:
      return numeric_component;
    default:
      return 0.;
    }
  };
  const std::vector<int> thing =
      numbered(test, [&](const Reading& a, const Reading& b) { return miss_the_same(test, a, b); });
  for (Index i = 0; i < S.rows(); ++i)
    for (Index j = 0; j < S.cols(); ++j)
      if (thing[std::size_t(i)] == thing[std::size_t(j)])
        S(i, j) += std::pow(own(test.readings[std::size_t(i)].kind), 2) +
                   share_of_correction * share_of_correction * correction[i] * correction[j];
  return S;
}

// Of admissible specimens, a column each: what they differ by from the nominal case, and what
// `random` errors add.
struct DrawnSpecimens {
  MatrixXd form, noise;
};
DrawnSpecimens draw_specimens(const Nominal& nominal, const TestReadings& test,
                              const std::vector<Hypothesis>& varied, const VectorXd& coarse,
                              const MatrixXd& random) {
  std::vector<const Hypothesis*> together;
  for (const Hypothesis& h : varied) together.push_back(&h);
  const Predictor predict(nominal, test, together);
  predict(predict.values_of(VectorXd::Zero(predict.parameters()))); // reduced once, on all cores
  const Index n = coarse.size();
  DrawnSpecimens drawn{.form = MatrixXd(n, specimens), .noise = MatrixXd(n, specimens)};
  const Eigen::LLT<MatrixXd> root(random);
  in_parallel(specimens, [&](int k) {
    NormalDraws draw(unsigned(k) + 1);
    VectorXd z(predict.parameters());
    for (double& x : z) x = draw();
    const auto y = predict(predict.values_of(z));
    drawn.form.col(k) =
        y ? VectorXd((*y - coarse).array().isFinite().select(*y - coarse, 0)) : VectorXd::Zero(n);
    VectorXd white(n);
    for (double& x : white) x = draw();
    drawn.noise.col(k) = root.matrixL() * white;
  });
  return drawn;
}

} // namespace

// Scatter acts on what the coarse mesh gives.
VectorXd Uncertainty::expected(const Answered& coarse) const {
  VectorXd y = coarse.log + correction + bias;
  for (const CrossScatter& c : cross) {
    const Index i = c.reading;
    y[i] = c.law.mean(coarse.log[i], c.times(by_errors_of_test(coarse, i)));
  }
  return y;
}

VectorXd Uncertainty::further_cross(const Answered& coarse) const {
  VectorXd sigma = VectorXd::Zero(coarse.log.size());
  for (const CrossScatter& c : cross) {
    const Index i = c.reading;
    sigma[i] = c.law.further_deviation(coarse.log[i], c.times(by_errors_of_test(coarse, i)));
  }
  return sigma;
}

void Uncertainty::settle_cross() {
  for (CrossScatter& c : cross)
    c.law = CrossLaw(c.power, nominal[c.reading], nominal[c.reading] + bias[c.reading]);
}

Uncertainty uncertainty_of(const Case& data, const Nominal& nominal, const TestReadings& test,
                           const Measured& measured, const Guards& without,
                           const Remounting& remounting) {
  const auto n = Index(test.readings.size());
  Uncertainty u;
  const Answered answered = *Predictor(nominal, test, {}).answered(VectorXd());
  const VectorXd& coarse = answered.log;
  u.correction = VectorXd::Zero(n);
  if (nominal.coarse && !has_friction(data))
    u.correction = mesh_correction(data, nominal, measured, test, coarse, u.refused);
  u.nominal = coarse + u.correction;
  for (Index i = 0; i < n; ++i)
    if (test.readings[std::size_t(i)].kind == ReadingKind::cross)
      u.cross.push_back({.reading = i, .by_test = by_errors_of_test(answered, i)});
  u.series = series_of(test);

  const MatrixXd weights = damping_weights(nominal, test);
  u.measurement = measurement_of(test, u.series);
  u.reassembly = reassembly_of(test, weights, remounting);
  if (without.contains(Guard::reassembly)) u.reassembly.setZero();
  u.numeric = numeric_of(test, weights, u.cross, u.correction);
  const MatrixXd own_damping = shared_damping(test, weights, scatters::mode_damping, always) +
                               shared_rig_loss(test, scatters::mode_damping);
  MatrixXd random = u.measurement + u.reassembly + u.numeric;
  if (!without.contains(Guard::form)) random += own_damping;

  std::vector<Hypothesis> varied = scatter(nominal.structure(measured));
  std::erase_if(varied, [&](const Hypothesis& h) {
    return without.contains(is_nuisance(h) ? Guard::nuisance : Guard::form);
  });
  auto [form, noise] = draw_specimens(nominal, test, varied, coarse, random);
  for (CrossScatter& c : u.cross) c.power = added_square(form.row(c.reading), coarse[c.reading]);
  u.bias = form.rowwise().mean();
  form.colwise() -= u.bias;
  u.settle_cross();
  u.form = covariance(form);
  if (!without.contains(Guard::form)) u.form += own_damping;
  u.healthy = form + noise;
  return u;
}

} // namespace plica
