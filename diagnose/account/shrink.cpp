#include "diagnose/account/shrink.hpp"

#include "compare/search/search.hpp"
#include "diagnose/effects/beam_stiffness.hpp"
#include "diagnose/judge/thresholds.hpp"
#include "diagnose/weigh/blocks.hpp"
#include "diagnose/weigh/scatter.hpp"
#include "lab/measured/measured_words.hpp"
#include "run/results/normal_distribution.hpp"
#include "solve/parallel.hpp"
#include "words/sample_ranks.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <random>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int bootstraps = 400;

std::array<double, 2> interval_of(const std::vector<double>& values) {
  if (values.empty()) return {};
  return {quantile(values, 0.05), quantile(values, 0.95)};
}

double rms(const VectorXd& e) {
  return e.size() > 0 ? std::sqrt(e.squaredNorm() / double(e.size())) : 0;
}

GapShrink with_interval(const VectorXd& before, const std::vector<VectorXd>& after) {
  GapShrink g{.before = rms(before),
              .after = rms(after.front()),
              .interval = {},
              .readings = int(before.size())};
  std::mt19937_64 random(1);
  std::vector<double> shrinks;
  for (int i = 0; i < bootstraps; ++i) {
    const VectorXd& own = after[std::size_t(i) % after.size()];
    double b = 0, a = 0;
    for (Index k = 0; k < before.size(); ++k) {
      const auto row = Index(random() % std::uint64_t(before.size()));
      b += before[row] * before[row];
      a += own[row] * own[row];
    }
    if (b > 0) shrinks.push_back(1 - std::sqrt(a / b));
  }
  g.interval = interval_of(shrinks);
  return g;
}

} // namespace

GapShrink gap_shrink(const FitContext& context, const Whitening& white,
                     const HypothesisFit& nominal, const HypothesisFit& best) {
  const VectorXd before = white(nominal.deviation);
  std::vector<VectorXd> after{white(best.deviation)};
  if (best.draws.cols() > 0) {
    const Deviation deviation(context, best.together);
    constexpr Index used = 40;
    const Index step = std::max<Index>(1, best.draws.cols() / used);
    for (Index k = 0; k < best.draws.cols(); k += step)
      if (const auto d = deviation.at(best.draws.col(k))) after.push_back(white(*d));
  }
  return with_interval(before, after);
}

namespace {

constexpr Index singly = 24, most_groups = 12;

// Fitted readings in groups that are foretold together: each by itself, or neighbours, which are of
// one run.
std::vector<std::vector<Index>> groups_of(Index readings) {
  const Index count = readings <= singly ? readings : most_groups;
  std::vector<std::vector<Index>> all(static_cast<std::size_t>(count));
  for (Index i = 0; i < readings; ++i) all[std::size_t(i * count / readings)].push_back(i);
  return all;
}

} // namespace

GapShrink in_turn(const FitContext& context, const HypothesisFit& nominal,
                  const HypothesisFit& best) {
  const std::vector<Index>& rows = context.fitted.rows();
  const MatrixXd total = context.uncertainty.total()(rows, rows);
  const auto n = Index(rows.size());
  VectorXd before(n), after(n);
  const Deviation deviation(context, best.together);
  const std::vector<std::vector<Index>> groups = groups_of(n);
  in_parallel(int(groups.size()), [&](int g) {
    const std::vector<Index>& own = groups[std::size_t(g)];
    std::vector<Index> others;
    for (Index j = 0; j < n; ++j)
      if (std::find(own.begin(), own.end(), j) == own.end()) others.push_back(j);
    const auto rest = Index(others.size());
    const Eigen::LLT<MatrixXd> root(MatrixXd(total(others, others)));
    const MatrixXd gain = root.solve(MatrixXd(total(others, own))).transpose(); // own x others
    const Eigen::LLT<MatrixXd> left(
        MatrixXd(MatrixXd(total(own, own)) - gain * MatrixXd(total(others, own))));
    const auto predicted = [&](const VectorXd& d) -> VectorXd {
      const VectorXd fitted = d(rows);
      return left.matrixL().solve(
          VectorXd(VectorXd(fitted(own)) - gain * VectorXd(fitted(others))));
    };
    before(own) = predicted(nominal.deviation);
    const Index p = best.z.size();
    const ResidualModel residuals = [&](const VectorXd& z) -> std::optional<VectorXd> {
      const auto d = deviation.at(z, Predictor::Which::fitted);
      VectorXd r(rest + p);
      r.tail(p) = z;
      if (d) {
        const VectorXd fitted = (*d)(rows);
        r.head(rest) = root.matrixL().solve(VectorXd(fitted(others)));
      } else {
        r.head(rest).setConstant(1e6);
      }
      return r;
    };
    const LocalSearch found = search_freely(residuals, best.z, 15);
    const auto d = deviation.at(found.best, Predictor::Which::fitted);
    after(own) = d ? predicted(*d) : VectorXd(before(own));
  });
  return with_interval(before, {after});
}

std::string how_in_turn(std::size_t readings) {
  return Index(readings) <= singly ? "each reading in turn, the others fitted"
                                   : "twelve groups of readings in turn, the others fitted";
}

namespace {

// The parameter that says how large the only effect of a fit is, by some of the readings alone.
class ParameterByPart {
public:
  ParameterByPart(const FitContext& context, const HypothesisFit& fit)
      : rows_(context.fitted.rows()), total_(context.uncertainty.total()), fit_(fit),
        size_(fit.together[0]->size), parameter_(fit.together[0]->parameters[size_]) {
    if (fit.further.size() > 0) total_ += fit.further; // as the fit weighed them
    const Eigen::LLT<MatrixXd> root(MatrixXd(total_(rows_, rows_)));
    raw_ = root.matrixL() * fit.J;
  }

  // `parts`: numbers among the fitted readings. None: fewer than two of them say anything of it.
  std::optional<ParameterDrift> over(const std::string& by,
                                     const std::map<std::string, std::vector<Index>>& parts) const {
    const Prior& prior = parameter_.prior;
    const double at = fit_.z[Index(size_)];
    ParameterDrift drift{.parameter = parameter_.name, .by = by, .parts = {}};
    double w = 0, wx = 0, wxx = 0;
    int counted = 0;
    for (const auto& [name, own] : parts) {
      std::vector<Index> global;
      for (Index i : own) global.push_back(rows_[std::size_t(i)]);
      const Eigen::LLT<MatrixXd> part(MatrixXd(total_(global, global)));
      const VectorXd j = part.matrixL().solve(VectorXd(raw_(own, Index(size_))));
      const VectorXd e = part.matrixL().solve(VectorXd(fit_.deviation(global)));
      const double information = j.squaredNorm();
      if (information < 0.25) continue; // this part says nothing of it
      const double x = -j.dot(e) / information;
      const double value = value_of(prior, std::clamp(at + x, -6., 6.));
      const double slope = (value_of(prior, at + 0.01) - value_of(prior, at)) / 0.01;
      drift.parts.push_back({name, {value, std::abs(slope) / std::sqrt(information)}});
      w += information;
      wx += information * x;
      wxx += information * x * x;
      ++counted;
    }
    if (counted < 2) return std::nullopt;
    const double chi2 = wxx - wx * wx / w, k = counted - 1, v = 2 / (9 * k);
    drift.p = 1 - normal_share((std::cbrt(chi2 / k) - (1 - v)) / std::sqrt(v));
    return drift;
  }

private:
  const std::vector<Index>& rows_;
  MatrixXd total_;
  const HypothesisFit& fit_;
  const std::size_t size_;
  const EffectParameter& parameter_;
  MatrixXd raw_; // d(deviation)/dz
};

} // namespace

std::vector<ParameterDrift> drifts(const FitContext& context, const HypothesisFit& fit) {
  std::vector<ParameterDrift> found;
  if (fit.together.size() != 1 || fit.together[0]->softening) return found;
  const std::vector<Index>& rows = context.fitted.rows();
  const ParameterByPart parameter(context, fit);
  const auto add = [&](const std::string& by, auto key) {
    std::map<std::string, std::vector<Index>> parts;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (const std::string k = key(context.test.readings[std::size_t(rows[i])]); !k.empty())
        parts[k].push_back(Index(i));
    if (parts.size() < 2) return;
    if (auto drift = parameter.over(by, parts)) found.push_back(std::move(*drift));
  };
  const auto run_of = [&](const Reading& r) -> const TestRun* {
    return r.run < 0 ? nullptr : &context.test.runs[std::size_t(r.run)];
  };
  add("level", [&](const Reading& r) {
    const TestRun* run = run_of(r);
    if (!run || !(run->level > 0)) return std::string();
    return fmt::format("{:g} {}", run->level, run->by_force ? "N" : "m/s2");
  });
  add("direction", [&](const Reading& r) {
    const TestRun* run = run_of(r);
    return run ? word_of(run->input) : std::string();
  });
  add("band", [&](const Reading& r) {
    return r.run >= 0 ? "peak " + std::to_string(r.peak + 1) : "static and mass";
  });
  return found;
}

namespace {

struct FactorOnAll {
  FreeFactor on;
  std::string name;
  double sigma; // of what scatters, relative
  Hypothesis hypothesis;
};

std::vector<FactorOnAll> factors_on_all(const Structure& structure) {
  const Prior free{PriorKind::log_normal, 1, 1.5};
  std::vector<FactorOnAll> all;
  const auto add = [&](FreeFactor on, const std::string& name, double sigma,
                       std::function<void(Model&)> doubled) {
    Hypothesis h{.effect = name,
                 .place = "all",
                 .way = "",
                 .parameters = {{"factor", "", free}},
                 .changes = {{std::move(doubled), Follow::series}},
                 .coefficients = [](const VectorXd& v) { return VectorXd(v.array() - 1); }};
    all.push_back({on, name, sigma, std::move(h)});
  };
  add(FreeFactor::modulus, "Young's modulus", scatters::modulus, [](Model& m) {
    for (ShellProperties& s : m.shells) s.section.E *= 2;
    for (BeamElement& b : m.beams) scale_stiffness(b.section, 2);
  });
  add(FreeFactor::density, "density", scatters::density, [](Model& m) {
    for (ShellProperties& s : m.shells) s.section.rho *= 2;
    for (BeamElement& b : m.beams)
      for (double* n :
           {&b.section.mass, &b.section.inertia_x, &b.section.inertia_y, &b.section.inertia_z})
        *n *= 2;
  });
  all.push_back({FreeFactor::damping, "all damping", scatters::all_damping_of(structure.data),
                 damping().hypotheses(structure).front()});
  all.back().hypothesis.parameters.front().prior = free;
  return all;
}

// A factor large enough takes one mode of the model for another's peak, which closes the gap for
// nothing: "frequency along z, peak 1, taken for another mode". Empty: all are what they were.
std::string paired_anew(const FitContext& context, const HypothesisFit& fit) {
  const std::vector<int> before = context.predictors.of({}).nominal_modes(),
                         after = context.predictors.of(fit.together).nominal_modes(fit.values);
  for (const Index i : context.fitted.rows()) {
    const Reading& r = context.test.readings[std::size_t(i)];
    if (r.kind == ReadingKind::frequency && before[std::size_t(i)] != after[std::size_t(i)])
      return r.name + ", taken for another mode";
  }
  return "";
}

void also(std::string& reasons, const std::string& reason) {
  if (!reason.empty()) reasons += (reasons.empty() ? "" : "; ") + reason;
}

} // namespace

std::vector<Compensator> compensators(const FitContext& context, const Whitening& held_out,
                                      const HypothesisFit& nominal, const Structure& structure) {
  const std::vector<FactorOnAll> candidates = factors_on_all(structure);
  const BlockScores scores(context.test, context.uncertainty);
  std::vector<std::optional<Compensator>> tried(candidates.size());
  in_parallel(int(candidates.size()), [&](int i) {
    const FactorOnAll& c = candidates[std::size_t(i)];
    HypothesisFit fit = fit_of(context, {&c.hypothesis});
    if (!fit.solved) return;
    complete(context, fit);
    const double factor = fit.values[0];
    Compensator row{.on = c.on,
                    .name = c.name,
                    .factor = factor,
                    .prior_sigmas = std::abs(std::log(factor)) / c.sigma,
                    .gap_after = rms(context.fitted(fit.deviation)),
                    .held_out_after = {},
                    .contradicted_by = ""};
    if (!held_out.rows().empty()) row.held_out_after = rms(held_out(fit.deviation));
    constexpr double contradicts = 3, by_chance = 0.01; // standard score of a block; probability
    const auto [z, block] = scores.worst(fit.deviation);
    if (z > contradicts) row.contradicted_by = block;
    for (const ParameterDrift& d : drifts(context, fit))
      if (d.p < by_chance)
        also(row.contradicted_by, std::string("another value for every ") + d.by);
    also(row.contradicted_by, paired_anew(context, fit));
    constexpr double worth_a_word = 0.85;
    if (row.gap_after < worth_a_word * rms(nominal.error) && row.prior_sigmas > threshold::absurd_z)
      tried[std::size_t(i)] = std::move(row);
  });
  std::vector<Compensator> found;
  for (auto& row : tried)
    if (row) found.push_back(std::move(*row));
  return found;
}

} // namespace plica
