// Search in a box for the design with the least sum of squares: locally by Levenberg-Marquardt
// (Ceres), globally by several strategies on islands that exchange their best (pagmo).
//
// Unknowns are scaled to [0, 1] by the caller. The model is called from several threads at once.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace plica {

// Residuals of a design, always as many; none where the model has no result.
using ResidualModel = std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd& design)>;

// Half the sum of squares; 1e30 where there is no result. The last `limits` count where they are
// above zero.
double cost_of(const std::optional<Eigen::VectorXd>& residuals, Eigen::Index limits = 0);

// Derivatives of the residuals by central differences within the box, residuals x unknowns. None
// where the model has no result at one of the points.
std::optional<Eigen::MatrixXd> residual_jacobian(const ResidualModel& model,
                                                 const Eigen::VectorXd& design);

struct LocalSearch {
  Eigen::VectorXd best;
  double cost = 0;
  bool converged = false;
  bool stopped = false;
  std::string reason; // Ceres's own words
};

struct LocalSettings {
  int steps = 200;
  std::function<bool()> stop = [] { return false; }; // asked before every evaluation
  std::function<void(int step, double cost)> step = [](int, double) {}; // after each
};

// From `start`, at most so many steps. The start must have a result: std::invalid_argument. One
// that is stopped has the best design of all that were evaluated.
LocalSearch search_locally(const ResidualModel& model, const Eigen::VectorXd& start,
                           const LocalSettings& settings = {});

// The same under limits: of the rows of the model the last `limits` are those by which limits are
// broken, below zero how far they are from it; kept ones cost nothing. A limit is known on both of
// its sides, so that a step ends on it: least squares of the linearised rows within a box that
// shrinks where they mislead (Fletcher, Practical Methods of Optimization, 2nd ed., 14.4), with
// second-order correction.
LocalSearch search_within(const ResidualModel& model, Eigen::Index limits,
                          const Eigen::VectorXd& start, const LocalSettings& settings = {});

// As search_locally, without a box: unknowns of about unit size, and residuals that hold them back
// themselves. Cheaper, as no step has to be shortened.
LocalSearch search_freely(const ResidualModel& model, const Eigen::VectorXd& start, int steps);
std::optional<Eigen::MatrixXd> free_jacobian(const ResidualModel& model,
                                             const Eigen::VectorXd& design);

struct GlobalSettings {
  int evaluations = 10000;             // spent at most, to one round of the islands
  int population = 20;                 // designs of an island
  unsigned seed = 1;                   // equal seeds give equal results, whatever the threads
  double good_enough = 0;              // cost below which to stop
  std::vector<Eigen::VectorXd> starts; // put into the first populations
  std::function<void(int evaluations, double cost)> progress = [](int, double) {};
  std::function<bool()> stop = [] { return false; }; // asked between rounds
};

struct Island {
  std::string strategy;
  double cost = 0;      // its best
  int improvements = 0; // rounds in which it found a better design than all islands before
};

struct GlobalSearch {
  Eigen::VectorXd best;
  double cost = 0;
  int evaluations = 0;
  std::vector<Island> islands;
};

// Least value of an objective over the unit box of so many unknowns.
GlobalSearch search_globally(const std::function<double(const Eigen::VectorXd&)>& objective,
                             int unknowns, const GlobalSettings& settings);

} // namespace plica
