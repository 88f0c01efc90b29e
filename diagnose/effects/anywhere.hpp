// What acts anywhere on a part: a spring or a mass on a motion that moves with its place.
//
// Motion along a direction d at a place p of a part is h(p)' u, u the DOFs of its nodes. A spring k
// there adds k h h', a mass m the same for each axis: the square of sums whose coefficients are
// sqrt(k) h_i(p) (MotionTerm), without any sampling of the place.
#pragma once

#include "diagnose/effects/effect.hpp"

namespace plica {

struct MovingMotion {
  std::vector<ModelChange> terms; // one motion, a term for each DOF
  std::function<Eigen::VectorXd(const Eigen::VectorXd& place)> factors; // of the terms
};

// `place`: parameters that say where; `size`: N/m or kg.
Hypothesis anywhere(const std::string& part, const EffectParameter& size,
                    const std::vector<EffectParameter>& place, std::vector<MovingMotion> motions);

// Of places in increasing order: the nearest, and the two that one lies between, with its share of
// the way from the first.
std::size_t nearest_of(const std::vector<double>& places, double place);
struct Neighbours {
  std::size_t first;
  double share;
};
Neighbours neighbours_of(const std::vector<double>& places, double place);

// Of the way from one node to the next: no polynomial between them is zero there.
inline constexpr double somewhere = 1. / 3;

// The terms of a motion: of each node of a list its DOFs that take part.
class MotionTerms {
public:
  using Sample = std::function<void(std::size_t node, const Eigen::Vector<double, 6>& factors)>;
  // `samples` tells the six factors of nodes at a place between each of them and the next; what is
  // zero there has no part in the motion.
  MotionTerms(std::vector<int> nodes, const std::function<void(const Sample&)>& samples);
  // `follow`: of a DOF, 0 to 5.
  std::vector<ModelChange> changes(MotionTerm::Of of,
                                   const std::function<Follow(int)>& follow) const;
  Eigen::Index size() const { return count_; }
  // Adds the six factors of a node where they have terms.
  void add(std::size_t node, const Eigen::Vector<double, 6>& factors, Eigen::VectorXd& to) const;

private:
  std::vector<int> nodes_;
  std::vector<std::array<Eigen::Index, 6>> number_; // of a term; -1 = none
  Eigen::Index count_ = 0;
};

} // namespace plica
