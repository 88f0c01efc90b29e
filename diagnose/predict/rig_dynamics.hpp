// What a rig reads between two caps at a frequency: the reduced model under change, both ends held
// rigidly and one of their coordinates moved.
//
//   Z = D_bb - D_bi D_ii^-1 D_ib,   D = K - w^2 M + i w C + i f L(w)
//
// b: the twelve coordinates of the ends, i: all others. C: the ratios of the modes with both ends
// held, each that of the nominal modes it is like; L: rig_loss.hpp; f: factor of all damping. A
// group that slips has a complex stiffness there, by the stretch that the amplitude of the end
// gives it (slowly, the end moving by itself). Good up to about half of the last mode of the basis.
#pragma once

#include "diagnose/predict/slip_group.hpp"
#include "reduction/dynamic_stiffness.hpp"

#include <optional>

namespace plica {

struct StateModel;

class RigDynamics {
public:
  // `ends`: caps, which moves and which is held; none = the two of the case. `coefficients`: of the
  // changes that are no products. `group`: a change that may be complex, its coefficient at hand
  // that of the stuck group.
  RigDynamics(const StateModel& state, const std::vector<std::string>& ends,
              const Eigen::VectorXd& coefficients, double damping,
              const std::optional<SlipGroup>& group);

  // Coordinates 0..5 of the end that moves, 6..11 of the held one. `softer`: what the group has
  // less than when it is stuck, in terms of its own. None: there are no such caps, or the frequency
  // is beyond the basis.
  std::optional<Complex1212> at(double hertz, std::complex<double> softer = 0) const;

  // How far the group is stretched per unit motion of an end coordinate, `softer` as above, slowly.
  double stretch(int coordinate, double softer) const;

private:
  Eigen::MatrixXcd matrix_at(double omega, std::complex<double> softer) const;

  const StateModel& state_;
  double damping_ = 1, highest_ = 0; // highest: rad/s
  std::vector<int> ends_, others_;
  Eigen::MatrixXd K_, M_, C_, group_; // C: over the others; empty = none
  double group_stiffness_ = 1;
};

} // namespace plica
