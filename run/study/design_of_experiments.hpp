// Where to look when several numbers vary at once: points of a unit box.
//
// Latin hypercube (McKay, Beckman & Conover, Technometrics 21 (1979) 239): of `count` equal
// stretches of every side each holds one point, at a random place within it. Sobol (Joe & Kuo, ACM
// TOMS 29 (2003) 49, by Boost.Random): the sequence from its second point on, so that none lies in
// a corner; more points later continue it.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace plica {

// count x sides, each in [0, 1).
Eigen::MatrixXd latin_hypercube(int count, int sides, unsigned seed);
Eigen::MatrixXd sobol_points(int count, int sides); // at most 3667 sides

// All combinations of so many values each, the last side fastest: numbers from 0, a row each.
std::vector<std::vector<int>> combinations(const std::vector<int>& counts);

} // namespace plica
