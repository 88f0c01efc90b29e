// The response analyses of a run: motion of the mount in the directions asked for.
#pragma once

#include "model/build.hpp"
#include "model/results.hpp"
#include "solve/base_motion.hpp"
#include "solve/modes.hpp"
#include "solve/static_correction.hpp"

namespace plica {

// What must be solved before the modes are, while the factor is that of K.
struct ResponseLoads {
  BaseMotion base;
  Eigen::MatrixXd force;            // free DOFs x directions asked for
  Eigen::MatrixXd static_solutions; // K^-1 force
};

// Throws InputError when the factor is shifted: a free part has no static solution.
ResponseLoads response_loads(const Response& asked, const BuiltCase& built, const System& system,
                             const std::vector<int>& free, const BaseFactor& factor);

// One response per direction. `set` holds the modes found, over the free DOFs.
std::vector<ResponseResult> base_responses(const Response& asked, double damping,
                                           const BuiltCase& built, const System& system,
                                           const std::vector<int>& free, const SparseMatrix& K,
                                           const SparseMatrix& M, const ModeSet& set,
                                           const ResponseLoads& loads);

} // namespace plica
