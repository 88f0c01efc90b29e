#include "diagnose/judge/identifiability.hpp"

#include "diagnose/weigh/spread_point.hpp"
#include "solve/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Points of |z| <= 1.5 at which an effect is looked at: along each parameter, and between.
std::vector<VectorXd> points(Index parameters) {
  std::vector<VectorXd> all;
  if (parameters == 1) {
    for (double z : {-1., 1.}) all.push_back(VectorXd::Constant(1, z));
    return all;
  }
  constexpr int count = 14;
  for (int i = 0; i < count; ++i) all.push_back(spread_point(i, parameters, 1.5));
  return all;
}

// Value of the parameter of its size at which the visible size reaches what is detectable, the
// others held; both ways from where the effect is least.
std::optional<double> smallest(const Signature& s,
                               const std::function<double(const VectorXd&)>& size) {
  const auto own = Index(s.hypothesis->size);
  const Prior& prior = s.hypothesis->parameters[s.hypothesis->size].prior;
  if (std::sqrt(s.noncentrality) < detectable_size) {
    VectorXd far = s.z;
    far[own] = far[own] < 0 ? -3 : 3;
    if (size(far) < detectable_size) return std::nullopt;
    return value_of(prior, far[own]);
  }
  // From the signature's place towards the end of the prior at which it vanishes.
  VectorXd near = s.z, away = s.z;
  double least = 1e300;
  for (double z : {-4., -3., -2., -1., 0., 1., 2., 3., 4.}) {
    VectorXd there = s.z;
    there[own] = z;
    if (const double seen = size(there); seen < least) {
      least = seen;
      near = there;
    }
  }
  if (least > detectable_size) return value_of(prior, near[own]);
  for (int i = 0; i < 8; ++i) {
    const VectorXd middle = (near + away) / 2;
    (size(middle) < detectable_size ? near : away) = middle;
  }
  return value_of(prior, away[own]);
}

// Of the fitted readings by a hypothesis.
struct Change {
  VectorXd whitened;        // by the covariance of the test
  double noncentrality = 0; // by that of the hypothesis, less what evidence pays for it
};

Change change(const FitContext& context, const Hypothesis& h, const VectorXd& z) {
  const Deviation deviation(context, {&h});
  const Predictor& predict = deviation.predictor();
  const Uncertainty& u = context.uncertainty;
  const VectorXd values = predict.values_of(z);
  const auto y = predict.answered(values, Predictor::Which::fitted);
  if (!y) return {.whitened = VectorXd::Zero(Index(context.fitted.rows().size()))};
  VectorXd d = u.expected(*y) - (u.nominal + u.bias);
  d = d.array().isFinite().select(d, 0).eval();
  const Whitening own =
      context.fitted.widened(deviation.further(values, *y, Predictor::Which::fitted));
  const double paid = 2 * (own.log_det() - context.fitted.log_det());
  return {.whitened = context.fitted(d),
          .noncentrality = std::max(0., own(d).squaredNorm() - paid)};
}

// What lies between others, which come before it, has the mean of their signatures.
void fill_those_between(std::vector<Signature>& all) {
  std::map<std::tuple<std::string, std::string, std::string>, const Signature*> known;
  for (Signature& s : all) {
    const Hypothesis& h = *s.hypothesis;
    for (const auto& [place, share] : h.between) {
      const Signature& beside = *known.at({h.effect, place, h.way});
      if (s.g.size() == 0) {
        s.g = VectorXd::Zero(beside.g.size());
        s.z = VectorXd::Zero(beside.z.size());
      }
      s.g += share * beside.g;
      s.z += share * beside.z;
      s.noncentrality += share * beside.noncentrality;
      s.at += share * beside.at;
    }
    known[{h.effect, h.place, h.way}] = &s;
  }
}

} // namespace

std::vector<const Hypothesis*> looked_at(const std::vector<Hypothesis>& all) {
  std::vector<const Hypothesis*> found;
  for (const Hypothesis& h : all)
    if (h.between.empty()) found.push_back(&h);
  return found;
}

void reduce_each(const FitContext& context, const std::vector<const Hypothesis*>& all,
                 const std::function<void()>& one_is_done) {
  constexpr std::size_t at_once = 4;
  std::vector<StateModels::Together> groups;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i % at_once == 0) groups.emplace_back();
    groups.back().push_back(all[i]);
  }
  StateModels& models = *context.predictors.models();
  for (std::size_t state : models.fitted_states(context.test))
    in_parallel(int(groups.size()), [&](int i) {
      const StateModels::Together& group = groups[std::size_t(i)];
      models.reduce(state, group);
      for (std::size_t k = 0; k < group.size(); ++k) one_is_done();
    });
}

std::vector<Signature> signatures(const FitContext& context, const std::vector<Hypothesis>& all,
                                  const std::function<void()>& one_is_done) {
  std::vector<Signature> found(all.size());
  in_parallel(int(all.size()), [&](int i) {
    Signature& s = found[std::size_t(i)];
    s.hypothesis = &all[std::size_t(i)];
    if (!s.hypothesis->between.empty()) return;
    double largest = -1;
    for (const VectorXd& z : points(Index(s.hypothesis->parameters.size()))) {
      Change own = change(context, *s.hypothesis, z);
      if (const double size = own.whitened.norm(); size > largest) {
        largest = size;
        s.g = std::move(own.whitened);
        s.noncentrality = own.noncentrality;
        s.z = z;
      }
    }
    const std::size_t own = s.hypothesis->size;
    s.at = value_of(s.hypothesis->parameters[own].prior, s.z[Index(own)]);
    one_is_done();
  });
  fill_those_between(found);
  return found;
}

void find_smallest(const FitContext& context, std::vector<Signature>& all) {
  std::map<std::string, Signature*> most;
  for (Signature& s : all) {
    if (!s.hypothesis->between.empty()) continue;
    Signature*& best = most[s.hypothesis->effect];
    if (!best || s.noncentrality > best->noncentrality) best = &s;
  }
  std::vector<Signature*> chosen;
  for (const auto& [effect, s] : most) chosen.push_back(s);
  in_parallel(int(chosen.size()), [&](int i) {
    Signature& s = *chosen[std::size_t(i)];
    s.smallest = smallest(s, [&](const VectorXd& z) {
      return std::sqrt(change(context, *s.hypothesis, z).noncentrality);
    });
  });
}

Likeness likeness(const std::vector<Signature>& all) {
  Likeness result;
  for (const Effect& e : effects())
    if (std::any_of(all.begin(), all.end(),
                    [&](const Signature& s) { return s.hypothesis->effect == e.name; }))
      result.effects.push_back(e.name);
  const auto n = Index(result.effects.size());
  result.cosine = MatrixXd::Zero(n, n);
  const auto number = [&](const Signature& s) {
    return std::find(result.effects.begin(), result.effects.end(), s.hypothesis->effect) -
           result.effects.begin();
  };
  constexpr double has_direction = 0.5; // |g|: of less, a cosine says what rounding makes of it
  for (const Signature& a : all)
    for (const Signature& b : all) {
      const double size = a.g.norm() * b.g.norm();
      if (!(a.g.norm() > has_direction && b.g.norm() > has_direction)) continue;
      double& cosine = result.cosine(number(a), number(b));
      cosine = std::max(cosine, std::abs(a.g.dot(b.g)) / size);
    }
  return result;
}

std::vector<Mimic> mimics(const Likeness& all) {
  std::vector<Mimic> found;
  for (Index i = 0; i < all.cosine.rows(); ++i)
    for (Index j = 0; j < i; ++j)
      if (all.cosine(i, j) >= hardly_told_apart)
        found.push_back(
            {all.effects[std::size_t(j)], all.effects[std::size_t(i)], all.cosine(i, j)});
  std::sort(found.begin(), found.end(),
            [](const Mimic& a, const Mimic& b) { return a.cosine > b.cosine; });
  return found;
}

std::vector<SmallestDetectable> detectable(const std::vector<Signature>& all) {
  std::vector<SmallestDetectable> found;
  for (const Signature& s : all) {
    const Hypothesis& h = *s.hypothesis;
    if (!h.between.empty()) continue;
    found.push_back({.name = h.effect,
                     .place = h.place,
                     .way = h.way,
                     .parameter = h.parameters[h.size].name,
                     .unit = h.parameters[h.size].unit,
                     .at = s.at,
                     .noncentrality = s.noncentrality,
                     .value = s.smallest});
  }
  return found;
}

double evidence_threshold(const FitContext& context, const std::vector<Signature>& all) {
  const MatrixXd& healthy = context.uncertainty.healthy;
  std::vector<double> best(std::size_t(healthy.cols()));
  std::map<std::string, double> weights;
  for (const Signature& s : all) weights[s.hypothesis->effect] += s.hypothesis->weight;
  in_parallel(int(healthy.cols()), [&](int k) {
    const VectorXd e = context.fitted(healthy.col(k));
    std::map<std::string, double> of_effect;
    for (const Signature& s : all) {
      const double g2 = s.g.squaredNorm();
      const double gain = std::pow(s.g.dot(e), 2) / (2 * (g2 + 1)) - std::log1p(g2) / 2;
      of_effect[s.hypothesis->effect] +=
          s.hypothesis->weight * std::exp(std::min(gain, 300.)) / weights.at(s.hypothesis->effect);
    }
    double most = 0;
    for (const auto& [name, bayes] : of_effect) most = std::max(most, std::log(bayes));
    best[std::size_t(k)] = most;
  });
  std::sort(best.begin(), best.end());
  return std::max(3., best[std::size_t(0.975 * double(best.size() - 1))]);
}

} // namespace plica
