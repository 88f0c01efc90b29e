#include "diagnose/predict/state_answers.hpp"

#include "diagnose/predict/peak_choice.hpp"
#include "diagnose/predict/rig_stiffness.hpp"
#include "diagnose/predict/sensor_axes.hpp"
#include "diagnose/readings/response_peaks.hpp"
#include "lab/measured/slope_at.hpp"
#include "words/directions.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::RowVectorXcd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Complex = std::complex<double>;

constexpr int half_steps = 4; // of what is near a peak: from -2 to 2 damping ratios off

// Whether measured peaks choose among a model's in the same way, nearly.
bool same_order(const TestRun& a, const TestRun& b) {
  if (a.peaks.size() != b.peaks.size()) return false;
  for (std::size_t i = 0; i < a.peaks.size(); ++i)
    if (a.peaks[i] > 0 && std::abs(std::log(a.peaks[i] / b.peaks[i])) > 0.02) return false;
  return true;
}

// What was looked at in a run. Where the test does not say: nobody who lists peaks leaves out
// stronger ones far above them.
std::array<double, 2> band_of(const TestRun& run) {
  constexpr double reach = 3; // a model may be that far off
  if (run.band[1] > run.band[0] || run.planned() || run.peaks.empty()) return run.band;
  return {run.first ? 0 : run.peaks.front() / reach, run.peaks.back() * reach};
}

} // namespace

std::optional<double> StateAnswers::answer(const Reading& reading) {
  const double y = reading.kind == ReadingKind::mass        ? std::log(mass())
                   : reading.kind == ReadingKind::stiffness ? static_stiffness(reading)
                   : is_of_rig(reading)                     ? rig_answer(reading)
                                                            : dynamic(reading);
  return std::isnan(y) ? std::nullopt : std::optional(y);
}

int StateAnswers::nominal_mode(const Reading& reading) {
  if (reading.run < 0) return -1;
  const AffineModes* m = linear_modes();
  const TestRun& run = test_.runs[std::size_t(reading.run)];
  if (!m || (run.input.any() && !answers_to(run))) return -1;
  const Index own =
      run.input.any() ? peak_modes(*m, run)[std::size_t(reading.peak)] : labelled_mode(*m, reading);
  return own < 0 ? -1 : m->nominal(own);
}

std::optional<Eigen::VectorXcd> StateAnswers::response(const TestRun& run, const VectorXd& hertz) {
  const AffineModes* m = linear_modes();
  const int sensor = own_.nominal->number_of(run.sensor);
  if (!m || sensor < 0 || !answers_to(run)) return std::nullopt;
  std::vector<double> omega;
  for (double f : hertz) omega.push_back(2 * std::numbers::pi * f);
  const MatrixXcd moved = motion(*m, m->zeta, run, omega);
  return Eigen::VectorXcd(reading_of(moved, sensor, run.axis).transpose());
}

const AffineModes* StateAnswers::linear_modes() {
  if (!linear_) {
    linear_ = acting_.given ? std::optional(*acting_.given) : own_.free.modes(acting_.all);
    if (*linear_) (*linear_)->zeta *= acting_.setup.damping;
    stable_ = stable_ && *linear_;
  }
  return *linear_ ? &**linear_ : nullptr;
}

VectorXd StateAnswers::damping_of(const AffineModes& linear) const {
  if (acting_.mode_damping.size() == 0) return linear.zeta;
  return linear.zeta.cwiseProduct(acting_.mode_damping);
}

double StateAnswers::mass() const {
  return own_.whole.weight(acting_.rig);
}

std::optional<double> StateAnswers::stiffness_at(StaticDirection direction, double kept) {
  const auto known = rig_.find(kept);
  const auto& ends =
      known == rig_.end() ? rig_.emplace(kept, ends_at(kept)).first->second : known->second;
  return ends ? std::optional(along(*ends, direction)) : std::nullopt;
}

std::optional<EndStiffness> StateAnswers::ends_at(double kept) const {
  VectorXd c = acting_.rig;
  if (acting_.group) {
    double& group = c[acting_.group->change];
    group = (group + acting_.group->present) * kept - acting_.group->present;
  }
  return rig_stiffness(*own_.nominal, own_.whole.stiffness(c));
}

// A group that slips answers by what it keeps at the stroke; without one, by what is left when all
// slides. Its stretch follows from the energy it has of the whole: dk/d(kept) = u' K_group u.
double StateAnswers::static_stiffness(const Reading& reading) {
  const auto stuck = stiffness_at(reading.direction, 1);
  if (!stuck) return not_given;
  if (!acting_.group) return std::log(*stuck);
  constexpr double less = 0.9;
  const auto softer = stiffness_at(reading.direction, less);
  if (!softer) return not_given;
  const double stretch = reading.stroke * std::sqrt(std::max(0., (*stuck - *softer) / (1 - less)) /
                                                    acting_.group->stiffness);
  const double share = acting_.softening.share;
  const auto secant = [&](double of_stroke) -> double {
    const double kept =
        reading.stroke > 0
            ? 1 - share * (1 - Sliders(acting_.softening).kept(of_stroke * stretch).real())
            : 1 - share;
    return stiffness_at(reading.direction, kept).value_or(not_given);
  };
  if (!reading.tangent) return std::log(secant(1));
  return std::log(slope_at([&](double of_stroke) { return secant(of_stroke) * of_stroke; }, 1));
}

// The sensor at which a force drives; -1: none is called so.
int StateAnswers::driven_sensor(const TestRun& run) const {
  const std::string& channel = run.input.force;
  return own_.nominal->number_of(std::string(sensor_of_channel(channel)));
}

// Whether the model has what drives the run.
bool StateAnswers::answers_to(const TestRun& run) const {
  return run.input.base >= 0 || (run.input.any() && driven_sensor(run) >= 0);
}

// What drives each mode, less its sign for a force: accelerations over it are w2 times that of a
// table, which moves the other way.
VectorXd StateAnswers::input_of(const AffineModes& m, const TestRun& run) const {
  if (run.input.base >= 0) return m.gamma * base_of(run);
  VectorXd input(m.lambda.size());
  for (Index i = 0; i < input.size(); ++i)
    input[i] = -seen_at(m, i, driven_sensor(run), axis_of_channel(run.input.force));
  return input;
}

// Accelerations of the places seen per unit of the input as commanded, part axes: 3 rows each, a
// column per frequency.
MatrixXcd StateAnswers::motion(const AffineModes& m, const VectorXd& zeta, const TestRun& run,
                               const std::vector<double>& omega) const {
  const VectorXd gamma = input_of(m, run);
  MatrixXd real(m.lambda.size(), Index(omega.size())), imaginary = real;
  for (Index k = 0; k < real.cols(); ++k) {
    const double w = omega[std::size_t(k)], w2 = w * w;
    for (Index i = 0; i < real.rows(); ++i) {
      const double a = m.lambda[i] - w2, b = 2 * zeta[i] * m.omega(i) * w;
      const double factor = w2 * gamma[i] / (a * a + b * b);
      real(i, k) = factor * a;
      imaginary(i, k) = -factor * b;
    }
  }
  const auto& sensors = own_.nominal->observed;
  MatrixXd rows(3 * seen_, m.lambda.size());
  for (Index s = 0; s < seen_; ++s) {
    rows.middleRows<3>(3 * s) = m.marked.middleRows<3>(6 * s);
    const auto moved = acting_.setup.moved.find(sensors[std::size_t(s)].name);
    if (moved == acting_.setup.moved.end()) continue;
    for (Index i = 0; i < rows.cols(); ++i)
      rows.col(i).segment<3>(3 * s) +=
          Vector3d(m.marked.block<3, 1>(6 * s + 3, i)).cross(moved->second);
  }
  MatrixXcd u(rows.rows(), real.cols());
  u.real() = rows * real;
  u.imag() = rows * imaginary;
  if (run.input.base >= 0)
    for (Index s = 0; s < seen_; ++s)
      u.middleRows<3>(3 * s).colwise() += base_of(run).cast<Complex>();
  return u;
}

// One sensor's own axis of such motions.
RowVectorXcd StateAnswers::reading_of(const MatrixXcd& motion, int sensor, int axis) const {
  const BuiltSensor& own = own_.nominal->observed[std::size_t(sensor)];
  const auto turned = acting_.setup.reading.find(own.name);
  return seen_along(own_.nominal->axes[std::size_t(sensor)],
                    turned == acting_.setup.reading.end() ? nullptr : &turned->second, axis,
                    motion.middleRows<3>(3 * Index(sensor)));
}

// How high each mode stands in the channel of a run.
VectorXd StateAnswers::heights(const AffineModes& m, const VectorXd& zeta,
                               const TestRun& run) const {
  const int sensor = own_.nominal->number_of(run.sensor);
  const VectorXd in = run.seen_along() ? input_of(m, run) : VectorXd(m.gamma.col(run.axis));
  VectorXd height(m.lambda.size());
  for (Index i = 0; i < height.size(); ++i) {
    const double out = sensor < 0 || !run.seen_along() ? in[i] : seen_at(m, i, sensor, run.axis);
    height[i] = std::abs(in[i] * out) / zeta[i];
  }
  return height;
}

// Modes of a run's measured peaks, by how high each stands in the channel of the run.
std::vector<Index> StateAnswers::peak_modes(const AffineModes& m, const TestRun& run) const {
  VectorXd hertz(m.lambda.size());
  for (Index i = 0; i < hertz.size(); ++i) hertz[i] = m.hertz(i);
  const VectorXd height = heights(m, m.zeta, run);
  // Those that are the first of their channel, and those of a planned test, are strong ones.
  const double share = run.input.base < 0 ? strong_under_force : strong_on_table;
  const double least = run.first || run.planned() ? share : faint * share;
  const std::vector<Index> candidates = strong_peaks(hertz, m.zeta, height, band_of(run),
                                                     run.planned() ? 1 : run.peaks.size(), least);
  std::vector<double> model;
  for (Index i : candidates) model.push_back(hertz[i]);
  std::vector<Index> result;
  for (Index pair : paired(run.peaks, model, run.first, handicaps(height, candidates, share)))
    result.push_back(pair < 0 ? -1 : candidates[std::size_t(pair)]);
  return result;
}

// The peaks of a run. False: no stable structure. Runs that differ in nothing the model feels share
// them.
bool StateAnswers::predict_peaks(int number) {
  if (const auto known = peaks_.find(number); known != peaks_.end()) return true;
  const TestRun& run = test_.runs[std::size_t(number)];
  std::vector<Peak> found;
  if (acting_.group) {
    if (!predict_slipping_peaks(run, found)) return stable_ = false;
  } else {
    for (const auto& [other, peaks] : peaks_) { // the level is not felt
      const TestRun& like = test_.runs[std::size_t(other)];
      if (like.input == run.input && like.sensor == run.sensor && like.axis == run.axis &&
          like.first == run.first && same_order(like, run)) {
        found = peaks;
        peaks_[number] = std::move(found);
        return true;
      }
    }
    const AffineModes* m = linear_modes();
    if (!m) return false;
    for (Index i : peak_modes(*m, run)) found.push_back({m, damping_of(*m), i, {}, {}});
  }
  for (Peak& peak : found) respond(peak, run);
  peaks_[number] = std::move(found);
  return true;
}

double StateAnswers::dynamic(const Reading& reading) {
  const TestRun& run = test_.runs[std::size_t(reading.run)];
  if (!run.input.any()) return labelled(reading);
  if (!answers_to(run)) return not_given;
  if (!predict_peaks(reading.run)) return not_given;
  Peak& peak = peaks_.at(reading.run)[std::size_t(reading.peak)];
  if (peak.mode < 0) return not_given;
  if (reading.kind == ReadingKind::component) return component(*peak.modes, peak.mode, reading);
  if (reading.kind == ReadingKind::damping) return std::log(width(peak, run));
  const int sensor = own_.nominal->number_of(reading.sensor);
  if (reading.kind == ReadingKind::frequency)
    return std::log(sensor < 0 || !run.seen_along() ? peak.modes->hertz(peak.mode)
                                                    : summit(peak, sensor, reading.axis).first);
  if (sensor < 0) return not_given;
  if (reading.kind == ReadingKind::amplitude)
    return std::log(summit(peak, sensor, reading.axis).second);
  if (reading.at_run >= 0) return cross_resonance(reading, run, sensor);
  if (reading.highest)
    return std::log(highest(peak, run, sensor, reading.axis) /
                        highest(peak, run, sensor, run.input.base) +
                    cross_floor);
  if (run.input.base < 0) { // where the peak is: what it is over shows no other axis
    const int over = own_.nominal->number_of(run.sensor);
    if (over < 0) return not_given;
    return std::log(summit(peak, sensor, reading.axis).second /
                        summit(peak, over, run.axis).second +
                    cross_floor);
  }
  if (peak.around.size() == 0) respond_around(peak, run);
  const double main = summit(peak, sensor, run.input.base).second;
  const double cross = std::max(reading_of(peak.around, sensor, reading.axis).cwiseAbs().maxCoeff(),
                                reading_of(peak.near, sensor, reading.axis).cwiseAbs().maxCoeff());
  return std::log(cross / main + cross_floor);
}

double StateAnswers::cross_resonance(const Reading& reading, const TestRun& run, int sensor) {
  if (!predict_peaks(reading.at_run)) return not_given;
  const Peak& peak = peaks_.at(reading.at_run).front();
  if (peak.mode < 0) return not_given;
  std::vector<double> near;
  for (int i = -half_steps; i <= half_steps; ++i) {
    near.push_back(peak.omega() * (1 + peak.damping() * 0.5 * i));
    near.push_back(peak.omega() * (1 + resonance_window * i / half_steps));
  }
  const MatrixXcd own = motion(*peak.modes, peak.zeta, run, near);
  const double cross = reading_of(own, sensor, reading.axis).cwiseAbs().maxCoeff();
  return std::log(cross / summit(peak, sensor, reading.axis).second + cross_floor);
}

// Damping of a peak as it is read: that of its mode, or what the width says where another mode
// shows beside it.
double StateAnswers::width(const Peak& peak, const TestRun& run) const {
  const int sensor = own_.nominal->number_of(run.sensor);
  if (sensor < 0 || !run.seen_along()) return peak.damping();
  const AffineModes& m = *peak.modes;
  const VectorXd height = heights(m, peak.zeta, run);
  constexpr double shows = 0.05; // of the height of the peak
  bool alone = true;
  for (Index j = 0; j < m.lambda.size(); ++j)
    alone = alone && (j == peak.mode ||
                      std::abs(m.omega(j) / peak.omega() - 1) >
                          fitted_reach * peak.damping() + 2 * peak.zeta[j] ||
                      height[j] < shows * height[peak.mode]);
  if (alone) return peak.damping();
  constexpr int steps = 10; // to either side
  std::vector<double> omega;
  for (int i = -steps; i <= steps; ++i)
    omega.push_back(peak.omega() * (1 + fitted_reach * peak.damping() * i / steps));
  const VectorXd hertz = VectorXd::Map(omega.data(), Index(omega.size())) / (2 * std::numbers::pi);
  return apparent_damping(
      hertz, reading_of(motion(m, peak.zeta, run, omega), sensor, run.axis).transpose(),
      m.hertz(peak.mode), peak.damping());
}

// Of the resonances within the band, as they are at a peak.
double StateAnswers::highest(const Peak& peak, const TestRun& run, int sensor, int axis) const {
  std::vector<double> omega;
  for (Index j = 0; j < peak.modes->lambda.size(); ++j)
    if (const double f = peak.modes->hertz(j); f >= run.band[0] && f <= run.band[1])
      for (double x : {-1., -0.5, 0., 0.5, 1.})
        omega.push_back(peak.modes->omega(j) * (1 + x * peak.zeta[j]));
  if (omega.empty()) return not_given;
  return reading_of(motion(*peak.modes, peak.zeta, run, omega), sensor, axis).cwiseAbs().maxCoeff();
}

void StateAnswers::respond(Peak& peak, const TestRun& run) const {
  if (peak.mode < 0 || seen_ == 0) return;
  std::vector<double> near;
  for (int i = -half_steps; i <= half_steps; ++i)
    near.push_back(peak.omega() * (1 + peak.damping() * 0.5 * i));
  peak.near = motion(*peak.modes, peak.zeta, run, near);
}

void StateAnswers::respond_around(Peak& peak, const TestRun& run) const {
  std::vector<double> around;
  constexpr int steps = 8;
  for (int i = -steps; i <= steps; ++i)
    around.push_back(peak.omega() * (1 + cross_window * i / steps));
  for (Index j = 0; j < peak.modes->lambda.size(); ++j)
    if (const double w = peak.modes->omega(j); std::abs(w / peak.omega() - 1) <= cross_window)
      for (double x : {-1., 0., 1.}) around.push_back(w * (1 + x * peak.zeta[j]));
  peak.around = motion(*peak.modes, peak.zeta, run, around);
}

// Frequency in Hz and height of the peak of a channel near its mode: a parabola through
// 1 / height^2, exact for one mode.
std::pair<double, double> StateAnswers::summit(const Peak& peak, int sensor, int axis) const {
  const Eigen::RowVectorXd h = reading_of(peak.near, sensor, axis).cwiseAbs();
  Index best = 0;
  double height = h.maxCoeff(&best), x = 0.5 * double(best - half_steps);
  if (best > 0 && best < h.size() - 1) {
    const auto inverse = [&](Index i) { return 1 / (h[i] * h[i]); };
    const double a = inverse(best - 1), b = inverse(best), c = inverse(best + 1);
    if (const double curve = a - 2 * b + c; curve > 0) {
      x += 0.5 * (a - c) / (2 * curve);
      const double least = b - (a - c) * (a - c) / (8 * curve);
      if (least > 0) height = 1 / std::sqrt(least);
    }
  }
  return {peak.omega() * (1 + peak.damping() * x) / (2 * std::numbers::pi), height};
}

} // namespace plica
