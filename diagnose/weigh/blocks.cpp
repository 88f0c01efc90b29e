#include "diagnose/weigh/blocks.hpp"

#include "diagnose/weigh/weighted_line.hpp"

#include "lab/measured/measured_words.hpp"
#include "run/results/normal_distribution.hpp"
#include "words/directions.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numbers>
#include <numeric>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

LocatedGap label_of(const TestReadings& test, const Reading& r) {
  LocatedGap label;
  label.kind = r.kind;
  label.state = r.state;
  if (r.kind == ReadingKind::stiffness) {
    const int dof = dof_of_static_test[static_cast<std::size_t>(r.direction)];
    label.direction = direction_names[std::size_t(dof)];
  }
  if (is_of_rig(r)) {
    label.direction = direction_names[std::size_t(r.axis)];
    label.band = r.rig.driving_point ? "driving point" : "transfer";
    if (r.stroke > 0)
      label.band += fmt::format(", {:g} {}", r.stroke * (r.axis < 3 ? 1e3 : 180 / std::numbers::pi),
                                r.axis < 3 ? "mm" : "deg");
  }
  if (r.run < 0) return label;
  const TestRun& run = test.runs[std::size_t(r.run)];
  if (!run.input.any()) {
    label.band = mode_name(r);
    if (run.level > 0 && run.by_force) label.band += fmt::format(", {:g} N", run.level);
    if (run.level > 0 && !run.by_force) label.level = run.level;
    if (r.axis >= 0) label.direction = axis_word(r.axis);
    return label;
  }
  if (run.input.base >= 0) {
    label.direction = axis_word(run.input.base);
    if (r.axis != run.input.base) label.direction += std::string(" to ") + axis_word(r.axis);
  } else {
    label.direction = word_of(run.input);
  }
  label.band = "peak " + std::to_string(r.peak + 1);
  if (run.level > 0 && run.by_force) label.band += fmt::format(", {:g} N", run.level);
  if (run.level > 0 && !run.by_force) label.level = run.level;
  return label;
}

std::string key_of(const LocatedGap& l) {
  return l.state + "|" + l.direction + "|" + l.band + "|" + kind_word(l) + "|" +
         (l.level ? std::to_string(*l.level) : "");
}

// Standard score of a chi-square with k degrees of freedom.
double wilson_hilferty(double chi2, double k) {
  const double v = 2 / (9 * k);
  return (std::cbrt(chi2 / k) - (1 - v)) / std::sqrt(v);
}

} // namespace

const char* kind_word(const LocatedGap& b) {
  return b.kind ? word_of(*b.kind) : b.of_energy ? "residual energy" : "";
}

std::string name_of(const LocatedGap& b) {
  std::string name = kind_word(b);
  if (!b.component.empty())
    return name.empty() ? b.component : b.component + ": " + name + ", " + b.band;
  if (!b.direction.empty()) name += " in " + b.direction;
  if (!b.band.empty()) name += ", " + b.band;
  if (b.level) name += fmt::format(", {:g} m/s2", *b.level);
  return b.state.empty() ? name : name + ", " + b.state;
}

std::vector<Block> blocks_of(const TestReadings& test) {
  std::vector<Block> blocks;
  std::map<std::string, std::size_t> known;
  for (std::size_t i = 0; i < test.readings.size(); ++i) {
    const LocatedGap label = label_of(test, test.readings[i]);
    const auto [at, made] = known.try_emplace(key_of(label), blocks.size());
    if (made) blocks.push_back({label, {}});
    blocks[at->second].rows.push_back(Index(i));
  }
  return blocks;
}

BlockScores::BlockScores(const TestReadings& test, const Uncertainty& u)
    : blocks_(blocks_of(test)), total_(u.total()) {
  const MatrixXd& total = total_;
  for (const Block& b : blocks_) {
    root_.emplace_back(total(b.rows, b.rows));
    const MatrixXd white = root_.back().matrixL().solve(MatrixXd(u.healthy(b.rows, Eigen::all)));
    healthy_mean_.push_back(white.colwise().squaredNorm().mean());
    fitted_.push_back(!test.readings[std::size_t(b.rows.front())].held_out);
  }
  std::map<int, std::vector<Index>> series;
  for (std::size_t i = 0; i < test.readings.size(); ++i)
    if (!test.readings[i].held_out) series[u.series[i]].push_back(Index(i));
  means_ = MatrixXd::Zero(Index(series.size()), total.cols());
  Index row = 0;
  for (const auto& [number, columns] : series) {
    for (Index i : columns) means_(row, i) = 1 / double(columns.size());
    ++row;
  }
}

double BlockScores::of_means(const VectorXd& deviation, const MatrixXd& further) const {
  const MatrixXd total = further.size() > 0 ? MatrixXd(total_ + further) : total_;
  const Eigen::LLT<MatrixXd> root(MatrixXd(means_ * total * means_.transpose()));
  return root.matrixL().solve(VectorXd(means_ * deviation)).squaredNorm();
}

double BlockScores::score(std::size_t i, const VectorXd& deviation, const MatrixXd& further) const {
  const std::vector<Index>& rows = blocks_[i].rows;
  const double k = double(rows.size());
  Eigen::LLT<MatrixXd> root = root_[i];
  if (further.size() > 0) {
    root.compute(root.reconstructedMatrix() + MatrixXd(further(rows, rows)));
  }
  const double chi2 = root.matrixL().solve(VectorXd(deviation(rows))).squaredNorm();
  return wilson_hilferty(chi2 * k / std::max(healthy_mean_[i], 0.2 * k), k);
}

std::pair<double, std::string> BlockScores::worst(const VectorXd& deviation,
                                                  const MatrixXd& further) const {
  std::pair<double, std::string> found{-40, ""};
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    if (const double z = fitted_[i] ? score(i, deviation, further) : -40; z > found.first)
      found = {z, name_of(blocks_[i].label)};
  return found;
}

// Holm: the k-th smallest p against 5 % / (n - k).
void mark_significant(std::vector<LocatedGap>& gaps, const std::vector<double>& p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return p[a] < p[b]; });
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (p[order[k]] > 0.05 / double(order.size() - k)) break;
    gaps[order[k]].significant = true;
  }
}

std::vector<LocatedGap> located(const BlockScores& scores, const VectorXd& deviation) {
  std::vector<LocatedGap> found;
  std::vector<double> p;
  for (std::size_t i = 0; i < scores.blocks().size(); ++i) {
    const Block& block = scores.blocks()[i];
    LocatedGap gap = block.label;
    const double z = std::max(0., scores.score(i, deviation));
    p.push_back(1 - normal_share(z));
    gap.z = deviation(block.rows).mean() < 0 ? -z : z;
    found.push_back(std::move(gap));
  }
  mark_significant(found, p);
  return found;
}

std::vector<LevelTrend> level_trends(const TestReadings& test) {
  std::map<std::string, WeightedLine> series;
  for (const Reading& r : test.readings) {
    if (r.run < 0 || (r.kind != ReadingKind::frequency && r.kind != ReadingKind::damping)) continue;
    const TestRun& run = test.runs[std::size_t(r.run)];
    if (!(run.level > 0)) continue;
    const std::string name =
        std::string(word_of(r.kind)) + " of " +
        (run.input.any() ? "peak " + std::to_string(r.peak + 1) + ", " + word_of(run.input)
                         : mode_name(r)) +
        (r.state.empty() ? "" : ", " + r.state);
    series[name].add(std::log(run.level), r.log_value, r.sigma);
  }
  std::vector<LevelTrend> trends;
  for (const auto& [name, line] : series)
    if (const auto slope = line.slope()) trends.push_back({name, slope->value, slope->sigma});
  return trends;
}

bool changes_with_level(const TestReadings& test) {
  constexpr double beyond = 3;
  const std::vector<LevelTrend> trends = level_trends(test);
  return std::any_of(trends.begin(), trends.end(),
                     [](const LevelTrend& t) { return std::abs(t.slope) > beyond * t.sigma; });
}

} // namespace plica
