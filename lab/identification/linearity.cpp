#include "lab/identification/linearity.hpp"

#include "lab/identification/mode_correlation.hpp"
#include "lab/identification/peak_picking.hpp"
#include "lab/measured/measured_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// `relative`: standard deviation of one value, 0 = its scatter about the line.
LevelSlope slope_of(const std::vector<double>& level, const std::vector<double>& values,
                    double relative) {
  const auto n = double(level.size());
  double mx = 0, my = 0, xx = 0, xy = 0, rest = 0;
  for (std::size_t i = 0; i < level.size(); ++i) {
    mx += std::log(level[i]) / n;
    my += std::log(values[i]) / n;
  }
  for (std::size_t i = 0; i < level.size(); ++i) {
    const double x = std::log(level[i]) - mx;
    xx += x * x;
    xy += x * (std::log(values[i]) - my);
  }
  LevelSlope s;
  if (!(xx > 0)) return s;
  s.slope = xy / xx;
  for (std::size_t i = 0; i < level.size(); ++i)
    rest += std::pow(std::log(values[i]) - my - s.slope * (std::log(level[i]) - mx), 2);
  const double scatter = level.size() > 2 ? std::sqrt(rest / (n - 2)) : 0;
  s.sigma = (relative > 0 ? relative : scatter) / std::sqrt(xx);
  const auto [low, high] = std::minmax_element(level.begin(), level.end());
  s.change = values[high - level.begin()] / values[low - level.begin()] - 1;
  s.matters = std::abs(s.slope) > 3 * s.sigma && std::abs(s.change) > 0.01;
  return s;
}

bool all_positive(const std::vector<double>& list) {
  return std::all_of(list.begin(), list.end(), [](double x) { return x > 0 && std::isfinite(x); });
}

std::string words(const LevelVerdict& v) {
  const auto [low, high] = std::minmax_element(v.level.begin(), v.level.end());
  const std::string range = fmt::format("from {:g} to {:g}", *low, *high);
  if (v.linear) {
    const auto [f0, f1] = std::minmax_element(v.frequency.begin(), v.frequency.end());
    return fmt::format("linear within {:.2g} % ", 100 * (*f1 / *f0 - 1)) + range;
  }
  std::string s = "amplitude dependent: ";
  const LevelSlope& f = v.frequency_slope;
  if (f.matters)
    s += fmt::format("the frequency {} by {:.0f} % ", f.change < 0 ? "falls" : "rises",
                     100 * std::abs(f.change)) +
         range + fmt::format(" (like level^{:.2f})", f.slope);
  if (v.damping_slope && v.damping_slope->matters)
    s += fmt::format("{}damping {} by {:.0f} %", f.matters ? ", " : "",
                     v.damping_slope->change < 0 ? "falls" : "rises",
                     100 * std::abs(v.damping_slope->change));
  if (v.amplitude_slope && v.amplitude_slope->matters)
    s += fmt::format("{}the peak per unit of excitation {} by {:.0f} %",
                     f.matters || (v.damping_slope && v.damping_slope->matters) ? ", " : "",
                     v.amplitude_slope->change < 0 ? "falls" : "rises",
                     100 * std::abs(v.amplitude_slope->change));
  if (f.matters)
    s += f.change < 0 ? "; softening, as friction or slipping plies give"
                      : "; hardening, as a gap or large displacement gives";
  return s;
}

} // namespace

LevelVerdict level_verdict(const std::string& what, const std::vector<double>& level,
                           const std::vector<double>& frequency, double sigma,
                           const std::vector<double>& amplitude,
                           const std::vector<double>& damping) {
  LevelVerdict v;
  v.what = what;
  v.level = level;
  v.frequency = frequency;
  v.amplitude = amplitude;
  v.damping = damping;
  double mean = 0;
  for (double f : frequency) mean += f / double(frequency.size());
  v.frequency_slope = slope_of(level, frequency, sigma / mean);
  if (amplitude.size() == level.size() && all_positive(amplitude))
    v.amplitude_slope = slope_of(level, amplitude, 0);
  if (damping.size() == level.size() && all_positive(damping))
    v.damping_slope = slope_of(level, damping, 0);
  // Damping and height of a peak scatter more than its frequency: a tenth is no change.
  for (auto* s : {&v.amplitude_slope, &v.damping_slope})
    if (*s && std::abs((*s)->change) < 0.1) (*s)->matters = false;
  v.linear = !v.frequency_slope.matters && !(v.amplitude_slope && v.amplitude_slope->matters) &&
             !(v.damping_slope && v.damping_slope->matters);
  v.verdict = words(v);
  return v;
}

std::vector<LevelVerdict> level_verdicts(const Measured& measured,
                                         const std::vector<FrfSet>& frfs) {
  std::vector<LevelVerdict> verdicts;
  for (const MeasuredPeaks& p : measured.peaks)
    if (p.level.size() > 1 && p.frequency.size() == p.level.size())
      verdicts.push_back(level_verdict(
          std::string("base ") + word_of(p.base) + ", " + p.sensor + "." + word_of(p.direction),
          p.level, p.frequency, p.sigma.value_or(0), p.amplitude, p.damping));
  struct Series {
    std::vector<double> level, frequency, amplitude, damping;
  };
  std::map<std::string, Series> found;
  for (const FrfSet& set : frfs) {
    if (!set.level) continue;
    for (std::size_t i = 0; i < set.H.size(); ++i)
      for (std::size_t o = 0; o < set.responses.size(); ++o) {
        if (set.H[i].col(Index(o)).norm() <= 1e-6 * set.H[i].colwise().norm().maxCoeff()) continue;
        const std::vector<PickedPeak> peaks =
            pick_peaks(set.hertz, set.H[i].col(Index(o)).cwiseAbs());
        const auto highest = std::max_element(
            peaks.begin(), peaks.end(),
            [](const PickedPeak& a, const PickedPeak& b) { return a.amplitude < b.amplitude; });
        if (highest == peaks.end()) continue;
        Series& s = found[set.references[i] + ", " + set.responses[o]];
        s.level.push_back(*set.level);
        s.frequency.push_back(highest->frequency);
        s.amplitude.push_back(highest->amplitude);
        s.damping.push_back(highest->damping);
      }
  }
  for (const auto& [what, s] : found)
    if (s.level.size() > 1)
      verdicts.push_back(level_verdict(what, s.level, s.frequency, 0, s.amplitude, s.damping));
  return verdicts;
}

namespace {

double relative_difference(const VectorXcd& a, const VectorXcd& b) {
  const double size = std::sqrt((a.squaredNorm() + b.squaredNorm()) / 2);
  return size > 0 ? (a - b).norm() / size : 0;
}

} // namespace

std::vector<Reciprocity> reciprocity(const FrfSet& set) {
  std::vector<Reciprocity> pairs;
  const auto response = [&](const std::string& name) {
    return std::find(set.responses.begin(), set.responses.end(), name) - set.responses.begin();
  };
  for (std::size_t i = 0; i < set.references.size(); ++i)
    for (std::size_t j = i + 1; j < set.references.size(); ++j) {
      const auto at_i = response(set.references[i]), at_j = response(set.references[j]);
      if (at_i >= long(set.responses.size()) || at_j >= long(set.responses.size())) continue;
      const VectorXcd a = set.H[i].col(at_j), b = set.H[j].col(at_i);
      pairs.push_back({set.references[i], set.references[j], mac(a, b), relative_difference(a, b)});
    }
  return pairs;
}

std::vector<Homogeneity> homogeneity(const std::vector<FrfSet>& frfs) {
  std::vector<Homogeneity> list;
  for (std::size_t a = 0; a < frfs.size(); ++a)
    for (std::size_t b = a + 1; b < frfs.size(); ++b) {
      const FrfSet &s = frfs[a], &t = frfs[b];
      if (!s.level || !t.level || *s.level == *t.level || s.references != t.references ||
          s.responses != t.responses || s.hertz.size() != t.hertz.size() ||
          (s.hertz - t.hertz).norm() > 1e-9 * s.hertz.norm())
        continue;
      for (std::size_t i = 0; i < s.H.size(); ++i)
        for (std::size_t o = 0; o < s.responses.size(); ++o) {
          const VectorXcd x = s.H[i].col(Index(o)), y = t.H[i].col(Index(o));
          list.push_back({s.references[i], s.responses[o], *s.level, *t.level, mac(x, y),
                          relative_difference(x, y)});
        }
    }
  return list;
}

namespace {

// The four highest of a response, by frequency.
std::vector<PickedPeak> highest_peaks(const FrfSet& set, Index response) {
  std::vector<PickedPeak> peaks =
      pick_peaks(set.hertz, set.H[0].col(response).cwiseAbs(), 1.4, 0.05);
  std::sort(peaks.begin(), peaks.end(),
            [](const PickedPeak& a, const PickedPeak& b) { return a.amplitude > b.amplitude; });
  peaks.resize(std::min<std::size_t>(peaks.size(), 4));
  std::sort(peaks.begin(), peaks.end(),
            [](const PickedPeak& a, const PickedPeak& b) { return a.frequency < b.frequency; });
  return peaks;
}

} // namespace

std::vector<CoherenceDrop> coherence_drops(const FrfSet& set, const Eigen::MatrixXd& coherence,
                                           double below) {
  std::vector<CoherenceDrop> drops;
  for (std::size_t o = 0; o < set.responses.size(); ++o)
    for (const PickedPeak& p : highest_peaks(set, Index(o))) {
      Index at = 0;
      (set.hertz.array() - p.frequency).abs().minCoeff(&at);
      if (coherence(at, Index(o)) < below)
        drops.push_back({set.responses[o], p.frequency, coherence(at, Index(o))});
    }
  return drops;
}

std::vector<Distortion> distortions(const FrfSet& set, const Eigen::MatrixXd& distortion) {
  std::vector<Distortion> list;
  const Index edge = std::min<Index>(3, distortion.rows() / 4); // start and stop of the sweep
  for (Index o = 0; o < distortion.cols(); ++o) {
    Index at = 0;
    const double largest =
        distortion.col(o).segment(edge, distortion.rows() - 2 * edge).maxCoeff(&at);
    at += edge;
    list.push_back({set.responses[o], set.hertz[at], largest});
  }
  return list;
}

} // namespace plica
