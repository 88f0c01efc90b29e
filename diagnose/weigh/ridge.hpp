// The ridge on which the place of an effect lies with its other numbers: a soft support far out
// answers as a stiff one nearer to the clamp. It is far longer than wide, and bent, so that chains
// that begin at its top do not get to its ends.
#pragma once

#include "compare/search/search.hpp"
#include "diagnose/weigh/tempered_chains.hpp"

namespace plica {

// Points of the ridge over coordinate `row`, which holds the place, each with the Gaussian there,
// as long as to the neighbours at most; those far below its top are left out. `residuals`: with the
// prior's own, the coordinates themselves, among them. Begins at `top`, an optimum.
std::vector<ChainStart> ridge_from(const ResidualModel& residuals, const Eigen::VectorXd& top,
                                   Eigen::Index row);

} // namespace plica
