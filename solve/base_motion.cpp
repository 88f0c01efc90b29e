#include "solve/base_motion.hpp"

namespace plica {

BaseMotion base_motion(const Model& model, const System& system, const std::vector<int>& free,
                       const Eigen::Vector3d& about) {
  BaseMotion base{.r = rigid_body_motions(model, system.map, about), .force = {}};
  const Eigen::MatrixXd whole = symmetric_product(system.M, base.r);
  base.force = -whole(free, Eigen::all);
  return base;
}

} // namespace plica
