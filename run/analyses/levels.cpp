#include "run/analyses/levels.hpp"

#include "lab/signals/peaks.hpp"
#include "run/stages.hpp"
#include "solve/backbone.hpp"
#include "solve/joint_time_integration.hpp"
#include "solve/parallel.hpp"
#include "solve/stopwatch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace plica {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::numbers::pi;

// Of a maximum that counts as a peak: friction rounds a resonance until steps of its law would pass
// for peaks.
constexpr double least_prominence = 0.03;
// Of the highest of a channel at that level: lower ones may be superharmonics.
constexpr double least_height = 0.2;

// Acceleration of the channels over the level in harmonic number k of a point.
VectorXcd acceleration(const ExcitedPart& part, const std::vector<int>& orders,
                       const PeriodicPoint& point, std::size_t k) {
  const double W = orders[k] * point.omega;
  VectorXcd a = -W * W / point.level * (part.output * point.modes.row(Index(k)).transpose());
  if (orders[k] == 1) a += part.rigid;
  return a;
}

// Height by which a maximum stands above the higher of the two valleys beside it, over its own
// height.
double prominence(const VectorXd& magnitude, Index top) {
  return 1 - higher_valley(magnitude, top) / magnitude[top];
}

struct LevelSweep {
  Branch branch;
  LevelCurve curve;
};

// The top of a peak near a point of the branch: parabolas through three solutions, each round four
// times as narrow as the last. The parabola of the curve itself where one is not found.
Peak refined(const ExcitedPart& part, const Branch& branch, const HarmonicSettings& settings,
             std::size_t near, int channel, double width, const Peak& rough) {
  const PeriodicPoint& guess = branch.points[near];
  const Index first = first_harmonic(branch.orders);
  const auto height = [&](double hertz) {
    const PeriodicSolution s =
        periodic_response(part.structure, 2 * pi * hertz, guess.level, settings, guess.joints);
    if (!s.converged) return std::numeric_limits<double>::quiet_NaN();
    return std::abs(acceleration(part, branch.orders, s.point, std::size_t(first))[channel]);
  };
  Peak top = rough;
  double h = width / 2;
  for (int round = 0; round < 4; ++round, h /= 4) {
    const double a = height(top.frequency - h), b = height(top.frequency),
                 c = height(top.frequency + h);
    const double bend = a - 2 * b + c;
    if (!(bend < 0)) return rough;
    top.frequency += std::clamp(h * (a - c) / (2 * bend), -h, h);
    top.height = std::max({a, b, c});
  }
  return std::abs(top.frequency - rough.frequency) < 2 * width ? top : rough;
}

std::vector<LevelPeak> peaks_of(const LevelSweep& s, const ExcitedPart& part,
                                const std::vector<int>& points, const HarmonicSettings& settings) {
  std::vector<LevelPeak> peaks;
  const auto count = Index(points.size());
  if (count < 3) return peaks;
  std::vector<int> order = points; // by frequency
  if (s.curve.hertz[order.front()] > s.curve.hertz[order.back()])
    std::reverse(order.begin(), order.end());
  VectorXd hertz(count);
  for (Index i = 0; i < count; ++i) hertz[i] = s.curve.hertz[order[std::size_t(i)]];
  const MatrixXd size = s.curve.first.cwiseAbs();
  for (Index c = 0; c < size.cols(); ++c) {
    VectorXd magnitude(count);
    for (Index i = 0; i < count; ++i) magnitude[i] = size(order[std::size_t(i)], c);
    if (magnitude.maxCoeff() < 1e-3 * size.maxCoeff()) continue;
    for (const Peak& p : find_peaks(hertz, magnitude, least_height)) {
      const auto above = std::lower_bound(hertz.begin(), hertz.end(), p.frequency);
      Index i = std::clamp<Index>(above - hertz.begin(), 1, count - 1);
      if (magnitude[i - 1] > magnitude[i]) --i;
      if (prominence(magnitude, i) < least_prominence || i == 0 || i + 1 == count) continue;
      const auto near = std::size_t(order[std::size_t(i)]);
      const Peak top = refined(part, s.branch, settings, near, int(c),
                               std::max(hertz[i + 1] - hertz[i], hertz[i] - hertz[i - 1]), p);
      peaks.push_back({.channel = int(c),
                       .frequency = top.frequency,
                       .amplitude = top.height,
                       .damping = p.damping,
                       .energy_damping =
                           energy_damping(part.structure, s.branch.points[near], s.branch.orders)});
    }
  }
  return peaks;
}

LevelSweep sweep(const ExcitedPart& part, double level, const HarmonicSettings& settings) {
  LevelSweep s;
  s.branch = follow_frequency(part.structure, level, settings);
  LevelCurve& curve = s.curve;
  const auto count = Index(s.branch.points.size());
  curve.level = level;
  curve.complete = s.branch.complete;
  curve.reason = s.branch.reason;
  curve.hertz.resize(count);
  curve.first.resize(count, part.output.rows());
  for (std::size_t k = 0; k < s.branch.orders.size(); ++k)
    if (s.branch.orders[k] > 1) {
      curve.orders.push_back(s.branch.orders[k]);
      curve.higher.emplace_back(count, part.output.rows());
    }
  for (Index i = 0; i < count; ++i) {
    const PeriodicPoint& p = s.branch.points[std::size_t(i)];
    curve.hertz[i] = p.omega / (2 * pi);
    curve.stable.push_back(p.stable);
    std::size_t higher = 0;
    for (std::size_t k = 0; k < s.branch.orders.size(); ++k) {
      if (s.branch.orders[k] == 0) continue;
      const VectorXcd a = acceleration(part, s.branch.orders, p, k);
      if (s.branch.orders[k] == 1)
        curve.first.row(i) = a.transpose();
      else
        curve.higher[higher++].row(i) = a.cwiseAbs().transpose();
    }
  }
  for (bool upwards : {true, false}) {
    const Sweep seen = sweep_over(s.branch, upwards);
    std::vector<int>& points = upwards ? curve.up : curve.down;
    points.assign(seen.points.begin(), seen.points.end());
    for (double omega : seen.jumps)
      (upwards ? curve.jumps_up : curve.jumps_down).push_back(omega / (2 * pi));
  }
  curve.peaks_up = curve.peaks_down = peaks_of(s, part, curve.up, settings);
  if (!curve.jumps_up.empty() || !curve.jumps_down.empty())
    curve.peaks_down = peaks_of(s, part, curve.down, settings);
  return s;
}

std::optional<LevelPeak> first_peak(const std::vector<LevelPeak>& peaks, int channel) {
  for (const LevelPeak& p : peaks)
    if (p.channel == channel) return p;
  return std::nullopt;
}

// The peak of the same channel nearest in frequency.
std::optional<LevelPeak> nearest_peak(const std::vector<LevelPeak>& peaks, const LevelPeak& to) {
  std::optional<LevelPeak> nearest;
  for (const LevelPeak& p : peaks)
    if (p.channel == to.channel && (!nearest || std::abs(p.frequency - to.frequency) <
                                                    std::abs(nearest->frequency - to.frequency)))
      nearest = p;
  return nearest;
}

// Place in the upward sweep of the highest response of a channel.
std::size_t highest(const LevelCurve& curve, int channel) {
  std::size_t top = 0;
  for (std::size_t i = 0; i < curve.up.size(); ++i)
    if (std::abs(curve.first(curve.up[i], channel)) > std::abs(curve.first(curve.up[top], channel)))
      top = i;
  return top;
}

class OneExcitation {
public:
  OneExcitation(const JointedModel& model, const Levels& levels, int excitation)
      : model_(model), levels_(levels), part_(excited_part(model, excitation)) {
    const Excitation& e = model.excitations[std::size_t(excitation)];
    result_.excitation = e.name;
    result_.is_force = e.source == Source::force;
    result_.unit = e.unit;
    result_.channels = model.channels;
    result_.joints = int(part_.joints.size());
    result_.modes = int(part_.structure.lambda.size());
    const bool balance = levels.method == JointMethod::harmonic_balance;
    result_.method = balance ? "harmonic balance" : "describing function";
    result_.harmonics = balance ? levels.harmonics : 1;
    const auto forces =
        std::size_t(excitation) - std::min(levels.bases.size(), std::size_t(excitation));
    values_ = e.source == Source::force ? levels.forces[forces].levels : levels.levels;
  }

  LevelResponses run(const StageListener& stage) {
    stage({stages::levels_of, result_.excitation});
    Stopwatch watch;
    const HarmonicSettings settings = harmonic_settings(levels_, levels_.method);
    std::vector<LevelSweep> sweeps(values_.size());
    in_parallel(int(values_.size()), [&](int i) {
      sweeps[std::size_t(i)] = sweep(part_, values_[std::size_t(i)], settings);
    });
    result_.seconds = watch.seconds();
    choose_channels(sweeps);
    for (LevelSweep& s : sweeps) add_joints(s);
    if (levels_.method == JointMethod::harmonic_balance) compare_linearised(sweeps);
    check_in_time(sweeps);
    follow_backbones(sweeps);
    for (LevelSweep& s : sweeps) result_.curves.push_back(std::move(s.curve));
    return std::move(result_);
  }

private:
  // Point of the branch with the highest stable response.
  std::size_t top_of(const LevelSweep& s) const {
    return std::size_t(s.curve.up[highest(s.curve, result_.strongest)]);
  }

  void choose_channels(const std::vector<LevelSweep>& sweeps) {
    VectorXd largest = VectorXd::Zero(part_.output.rows());
    for (const LevelSweep& s : sweeps)
      if (s.curve.first.rows() > 0)
        largest = largest.cwiseMax(s.curve.first.cwiseAbs().colwise().maxCoeff().transpose());
    largest.maxCoeff(&result_.strongest);
    for (Index c = 0; c < largest.size() && !(largest.maxCoeff() > 0); ++c) // nothing was found
      if (result_.channels[std::size_t(c)].second == result_.excitation) result_.strongest = int(c);
    for (Index c = 0; c < largest.size(); ++c)
      if (largest[c] > 1e-3 * largest.maxCoeff()) result_.shown.push_back(int(c));
  }

  void add_joints(LevelSweep& s) const {
    if (s.curve.up.empty()) return;
    const PeriodicPoint& p = s.branch.points[top_of(s)];
    const Index first = first_harmonic(s.branch.orders);
    const VectorXd energies = cycle_energies(part_.structure, p, s.branch.orders);
    for (std::size_t j = 0; j < part_.joints.size(); ++j)
      s.curve.joints.push_back(
          {.joint = model_.joints[std::size_t(part_.joints[j])],
           .motion = std::abs(p.joints(first, Index(j))),
           .mean = s.branch.orders.front() == 0 ? p.joints(0, Index(j)).real() : 0,
           .energy = energies[Index(j)]});
  }

  void compare_linearised(const std::vector<LevelSweep>& sweeps) {
    std::vector<LevelSweep> fast(sweeps.size());
    in_parallel(int(sweeps.size()), [&](int i) {
      fast[std::size_t(i)] = sweep(part_, values_[std::size_t(i)],
                                   harmonic_settings(levels_, JointMethod::describing_function));
    });
    for (std::size_t i = 0; i < sweeps.size(); ++i) {
      const auto full = first_peak(sweeps[i].curve.peaks_up, result_.strongest);
      const auto own = full ? nearest_peak(fast[i].curve.peaks_up, *full) : std::nullopt;
      if (full && own)
        result_.linearised.push_back({values_[i], own->frequency / full->frequency - 1,
                                      own->amplitude / full->amplitude - 1});
    }
  }

  // At the peaks of levels spread over the responses, and half way down their flanks.
  void check_in_time(const std::vector<LevelSweep>& sweeps) {
    if (sweeps.empty() || levels_.referee == 0) return;
    std::vector<std::pair<std::size_t, std::size_t>> places;
    for (int i = 0; i < levels_.referee; ++i) {
      const auto at = levels_.referee == 1
                          ? sweeps.size() - 1
                          : std::size_t(i) * (sweeps.size() - 1) / std::size_t(levels_.referee - 1);
      const LevelSweep& s = sweeps[at];
      if (s.curve.up.empty()) continue;
      const std::vector<int>& up = s.curve.up;
      const std::size_t top = highest(s.curve, result_.strongest);
      const std::size_t step =
          i % 2 == 0 ? 0 : std::size_t(levels_.points) / 20 + std::size_t(i) - 1;
      const std::pair place{at, std::size_t(up[std::min(top + step, up.size() - 1)])};
      if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
    }
    result_.referee.resize(places.size());
    in_parallel(int(places.size()), [&](int i) {
      const auto& [at, point] = places[std::size_t(i)];
      const Branch& branch = sweeps[at].branch;
      const PeriodicPoint& p = branch.points[point];
      const SteadyMotion m = integrate(part_.structure, p.omega, p.level, 1, {}, branch.orders, p);
      PeriodicPoint steady = p;
      steady.modes = m.modes.row(1);
      const VectorXcd in_time = acceleration(part_, {1}, steady, 0);
      const VectorXcd balanced = sweeps[at].curve.first.row(Index(point)).transpose();
      result_.referee[std::size_t(i)] = {p.level, p.omega / (2 * pi),
                                         (in_time - balanced).norm() / in_time.norm(), m.settled};
    });
  }

  // Of the stuck modes in the band that the excitation drives most.
  void follow_backbones(const std::vector<LevelSweep>& sweeps) {
    if (levels_.backbones == 0 || sweeps.empty() || part_.joints.empty()) return;
    const auto span = amplitudes(sweeps);
    if (!(span.second > span.first)) return;
    const StuckModes stuck = stuck_modes(part_.structure);
    const VectorXd drive = (stuck.shapes.transpose() * part_.structure.input).cwiseAbs();
    std::vector<int> modes;
    for (Index r = 0; r < drive.size(); ++r) {
      const double f = std::sqrt(stuck.lambda[r]) / (2 * pi);
      if (f > levels_.band[0] && f < 1.3 * levels_.band[1] && drive[r] > 0.1 * drive.maxCoeff())
        modes.push_back(int(r));
    }
    modes.resize(std::min(modes.size(), std::size_t(levels_.backbones)));
    result_.backbones.resize(modes.size());
    in_parallel(int(modes.size()), [&](int i) {
      const int mode = modes[std::size_t(i)];
      const Backbone b = backbone(part_.structure, mode,
                                  {.harmonics = result_.harmonics,
                                   .samples = levels_.samples,
                                   .from = span.first,
                                   .to = span.second,
                                   .tolerance = 1e-7});
      BackboneCurve& curve = result_.backbones[std::size_t(i)];
      curve.stuck_frequency = std::sqrt(stuck.lambda[mode]) / (2 * pi);
      curve.complete = b.complete;
      curve.reason = b.reason;
      const auto n = Index(b.points.size());
      curve.amplitude.resize(n);
      curve.frequency.resize(n);
      curve.damping.resize(n);
      const Index first = first_harmonic(b.orders);
      for (Index k = 0; k < n; ++k) {
        const BackbonePoint& p = b.points[std::size_t(k)];
        curve.frequency[k] = p.omega / (2 * pi);
        curve.damping[k] = p.zeta;
        curve.amplitude[k] =
            p.omega * p.omega *
            std::abs((part_.output.row(result_.strongest) * p.modes.row(first).transpose())(0));
      }
    });
  }

  // Range of the modal amplitude: from a tenth of the lowest peak to twice the highest.
  std::pair<double, double> amplitudes(const std::vector<LevelSweep>& sweeps) const {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (const LevelSweep& s : sweeps) {
      if (s.curve.up.empty()) continue;
      const PeriodicPoint& p = s.branch.points[top_of(s)];
      const Index first = first_harmonic(s.branch.orders);
      const double a = p.modes.row(first).norm();
      low = std::min(low, 0.1 * a);
      high = std::max(high, 2 * a);
    }
    return {low, high};
  }

  const JointedModel& model_;
  const Levels& levels_;
  ExcitedPart part_;
  std::vector<double> values_;
  LevelResponses result_;
};

} // namespace

HarmonicSettings harmonic_settings(const Levels& levels, JointMethod method) {
  return {.method = method,
          .harmonics = levels.harmonics,
          .samples = levels.samples,
          .tolerance = 1e-7,
          .from = 2 * pi * levels.band[0],
          .to = 2 * pi * levels.band[1],
          .largest_step = 2 * pi * (levels.band[1] - levels.band[0]) / levels.points,
          .most_points = 50 * levels.points};
}

std::vector<LevelResponses> level_responses(const JointedModel& model, const Levels& levels,
                                            const StageListener& stage) {
  std::vector<LevelResponses> level_responses;
  for (std::size_t k = 0; k < model.excitations.size(); ++k)
    level_responses.push_back(OneExcitation(model, levels, int(k)).run(stage));
  return level_responses;
}

} // namespace plica
