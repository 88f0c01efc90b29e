// A solution of F(x, p) = 0 followed over its parameter by arc length, round folds (Seydel,
// Practical Bifurcation and Stability Analysis, Springer 2010).
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace plica {

// F with its derivatives by x and p.
struct Residual {
  Eigen::VectorXd value;
  Eigen::MatrixXd by_motion;
  Eigen::VectorXd by_parameter;
};
using ResidualFunction = std::function<Residual(const Eigen::VectorXd& x, double p)>;

struct ContinuationSettings {
  double from = 0, to = 0;  // of p, upwards or downwards
  double largest_step = 0;  // of p; 0 = a hundredth of the way
  double smallest_step = 0; // of p; 0 = 1e-7 of the way
  double tolerance = 1e-8;  // of F, relative to x
  int newton_steps = 12;
  int most_points = 5000;
};

struct CurvePoint {
  Eigen::VectorXd x;
  double p = 0;
  int iterations = 0;
  // Sign of det dF/dx against that at the first point: it changes where the curve folds and where
  // another branch leaves it, and with it the number of unstable real multipliers.
  bool same_side = true;
};

struct Curve {
  std::vector<CurvePoint> points;
  bool complete = false; // p reached `to`
  std::string reason;    // why not
};

// Newton at a fixed parameter from a guess.
struct Solution {
  bool converged = false;
  int iterations = 0;
  double residual = 0; // relative
  Eigen::VectorXd x;
  Residual last; // F at x
};
Solution solve_at(const ResidualFunction& f, const Eigen::VectorXd& guess, double p,
                  const ContinuationSettings& settings);

// From a guess at `from`. One that could not be followed to its end holds what was reached.
Curve follow(const ResidualFunction& f, const Eigen::VectorXd& guess,
             const ContinuationSettings& settings);

} // namespace plica
