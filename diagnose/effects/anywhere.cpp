#include "diagnose/effects/anywhere.hpp"

#include <algorithm>
#include <cmath>

namespace plica {

using Eigen::Index;
using Eigen::VectorXd;

Hypothesis anywhere(const std::string& part, const EffectParameter& size,
                    const std::vector<EffectParameter>& place, std::vector<MovingMotion> motions) {
  Hypothesis h{.effect = "", .place = part, .way = "", .parameters = {size}, .at_rig = false};
  for (const EffectParameter& p : place) {
    h.along.push_back(h.parameters.size());
    h.parameters.push_back(p);
  }
  std::vector<std::function<VectorXd(const VectorXd&)>> factors;
  for (MovingMotion& m : motions) {
    h.changes.insert(h.changes.end(), m.terms.begin(), m.terms.end());
    factors.push_back(std::move(m.factors));
  }
  h.coefficients = [factors = std::move(factors),
                    count = Index(h.changes.size())](const VectorXd& v) {
    VectorXd all(count);
    Index first = 0;
    for (const auto& of : factors) {
      const VectorXd own = of(v.tail(v.size() - 1));
      all.segment(first, own.size()) = std::sqrt(v[0]) * own;
      first += own.size();
    }
    return all;
  };
  return h;
}

std::size_t nearest_of(const std::vector<double>& places, double place) {
  const auto found = std::min_element(places.begin(), places.end(), [&](double a, double b) {
    return std::abs(a - place) < std::abs(b - place);
  });
  return std::size_t(found - places.begin());
}

Neighbours neighbours_of(const std::vector<double>& places, double place) {
  const auto next = std::upper_bound(places.begin() + 1, places.end() - 1, place);
  const auto i = std::size_t(next - places.begin() - 1);
  return {i, std::clamp((place - places[i]) / (places[i + 1] - places[i]), 0., 1.)};
}

MotionTerms::MotionTerms(std::vector<int> nodes, const std::function<void(const Sample&)>& samples)
    : nodes_(std::move(nodes)) {
  constexpr double nothing = 1e-12;
  Eigen::MatrixX<bool> takes_part = Eigen::MatrixX<bool>::Constant(Index(nodes_.size()), 6, false);
  samples([&](std::size_t node, const Eigen::Vector<double, 6>& factors) {
    for (int dof = 0; dof < 6; ++dof)
      if (std::abs(factors[dof]) > nothing) takes_part(Index(node), dof) = true;
  });
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    number_.emplace_back();
    for (int dof = 0; dof < 6; ++dof)
      number_.back()[std::size_t(dof)] = takes_part(Index(i), dof) ? count_++ : -1;
  }
}

std::vector<ModelChange> MotionTerms::changes(MotionTerm::Of of,
                                              const std::function<Follow(int)>& follow) const {
  std::vector<ModelChange> all;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    for (int dof = 0; dof < 6; ++dof)
      if (number_[i][std::size_t(dof)] >= 0)
        all.push_back({.apply = {},
                       .follow = follow(dof),
                       .term = MotionTerm{
                           .nodes = {nodes_[i]}, .dof = dof, .of = of, .begins = all.empty()}});
  return all;
}

void MotionTerms::add(std::size_t node, const Eigen::Vector<double, 6>& factors,
                      VectorXd& to) const {
  for (int dof = 0; dof < 6; ++dof)
    if (const Index k = number_[node][std::size_t(dof)]; k >= 0) to[k] += factors[dof];
}

} // namespace plica
