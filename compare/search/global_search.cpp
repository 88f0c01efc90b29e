#include "compare/search/search.hpp"

#include "solve/parallel.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/bee_colony.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/compass_search.hpp>
#include <pagmo/algorithms/de1220.hpp>
#include <pagmo/algorithms/mbh.hpp>
#include <pagmo/algorithms/pso.hpp>
#include <pagmo/algorithms/sade.hpp>
#include <pagmo/archipelago.hpp>
#include <pagmo/problem.hpp>

namespace plica {
namespace {

using Eigen::VectorXd;

using Objective = std::function<double(const VectorXd&)>;

struct Task {
  Objective objective;
  std::size_t unknowns = 0;
  std::atomic<int> evaluations{0};
};

// What pagmo wants of a problem.
struct BoxProblem {
  std::shared_ptr<Task> task;

  pagmo::vector_double fitness(const pagmo::vector_double& x) const {
    work_alone(); // islands are threads already
    ++task->evaluations;
    return {task->objective(Eigen::Map<const VectorXd>(x.data(), Eigen::Index(x.size())))};
  }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    return {pagmo::vector_double(task->unknowns, 0.), pagmo::vector_double(task->unknowns, 1.)};
  }
};

struct Strategy {
  const char* name;
  pagmo::algorithm algorithm;
};

std::vector<Strategy> strategies(int unknowns, unsigned seed) {
  constexpr unsigned generations = 5;
  std::vector<Strategy> all;
  all.push_back(
      {"self-adaptive differential evolution (de1220)",
       pagmo::algorithm(pagmo::de1220(generations, pagmo::de1220_statics<void>::allowed_variants,
                                      1u, 1e-12, 1e-12, true, seed))});
  all.push_back({"self-adaptive differential evolution (sade)",
                 pagmo::algorithm(pagmo::sade(generations, 2u, 1u, 1e-12, 1e-12, true, seed + 1))});
  all.push_back({"particle swarm", pagmo::algorithm(pagmo::pso(generations, 0.7298, 2.05, 2.05, 0.5,
                                                               5u, 2u, 4u, true, seed + 2))});
  all.push_back(
      {"bee colony", pagmo::algorithm(pagmo::bee_colony(generations / 2, 20u, seed + 3))});
  if (unknowns > 1) // needs a covariance
    all.push_back({"covariance matrix adaptation (cmaes)",
                   pagmo::algorithm(pagmo::cmaes(generations, -1, -1, -1, -1, 0.5, 1e-12, 1e-12,
                                                 true, true, seed + 4))});
  all.push_back({"basin hopping with compass search",
                 pagmo::algorithm(
                     pagmo::mbh(pagmo::compass_search(60u, 0.1, 1e-3, 0.5), 1u, 0.1, seed + 5))});
  return all;
}

// The best of every island replaces the worst of the next, in a ring.
void exchange(pagmo::archipelago& islands) {
  std::vector<pagmo::population> populations;
  for (const auto& island : islands) populations.push_back(island.get_population());
  for (std::size_t i = 0; i < populations.size(); ++i) {
    const auto& from = populations[i];
    pagmo::population to = islands[(i + 1) % populations.size()].get_population();
    const auto best = from.best_idx(), worst = to.worst_idx();
    if (from.get_f()[best][0] < to.get_f()[worst][0])
      to.set_xf(worst, from.get_x()[best], from.get_f()[best]);
    islands[(i + 1) % populations.size()].set_population(to);
  }
}

void take_best(const pagmo::archipelago& islands, GlobalSearch& found) {
  for (std::size_t i = 0; i < islands.size(); ++i) {
    const pagmo::population population = islands[i].get_population();
    found.islands[i].cost = population.champion_f()[0];
    if (!(found.islands[i].cost < found.cost)) continue;
    found.cost = found.islands[i].cost;
    const pagmo::vector_double x = population.champion_x();
    found.best = Eigen::Map<const VectorXd>(x.data(), Eigen::Index(x.size()));
    ++found.islands[i].improvements;
  }
}

} // namespace

GlobalSearch search_globally(const Objective& objective, int unknowns,
                             const GlobalSettings& settings) {
  const auto task = std::make_shared<Task>();
  task->objective = objective;
  task->unknowns = static_cast<std::size_t>(unknowns);
  const pagmo::problem problem{BoxProblem{task}};
  GlobalSearch found;
  found.cost = 1e300;
  pagmo::archipelago islands;
  std::vector<Strategy> all = strategies(unknowns, settings.seed);
  // A quarter of the budget for the first designs.
  const int affordable = settings.evaluations / (4 * static_cast<int>(all.size()));
  const auto size = static_cast<pagmo::population::size_type>(
      std::clamp(affordable, 8, std::max(8, settings.population)));
  std::size_t start = 0;
  for (const Strategy& s : all) {
    found.islands.push_back({.strategy = s.name});
    pagmo::population population(problem, 0u, settings.seed + 100 * unsigned(islands.size()));
    if (start < settings.starts.size()) {
      const VectorXd& x = settings.starts[start++];
      population.push_back(pagmo::vector_double(x.begin(), x.end()));
    }
    while (population.size() < size) population.push_back(population.random_decision_vector());
    islands.push_back(s.algorithm, population);
  }
  take_best(islands, found);
  while (task->evaluations < settings.evaluations && found.cost > settings.good_enough &&
         !settings.stop()) {
    islands.evolve(1);
    islands.wait_check();
    take_best(islands, found);
    exchange(islands);
    settings.progress(task->evaluations, found.cost);
  }
  found.evaluations = task->evaluations;
  return found;
}

} // namespace plica
