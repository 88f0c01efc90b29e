// Displacements under the loads of a deck beside those that CalculiX prints of it.
#pragma once

#include "tests/calculix_steps.hpp"
#include "tests/deck_loads.hpp"

namespace plica::test {
namespace deck_loads {

// Within 1 % at every node that the deck prints, step by step.
inline void expect_displacements_of_calculix(const std::string& deck, std::size_t steps) {
  const auto theirs = calculix_steps(deck);
  ASSERT_EQ(theirs.size(), steps) << "CalculiX (ccx) is not there, or broke off";
  const Results ours = loads_of("model.inp", deck);
  ASSERT_EQ(ours.deck_loads.size(), steps);
  for (std::size_t step = 0; step < steps; ++step)
    for (const auto& [node, u] : theirs[step]) {
      const Eigen::Vector3d own = 1e3 * node_of(ours.deck_loads[step], node).displacement.head<3>();
      fmt::print("step {} node {}: {:.5f} {:.5f} {:.5f} mm, CalculiX {:.5f} {:.5f} {:.5f}\n",
                 step + 1, node, own[0], own[1], own[2], u[0], u[1], u[2]);
      EXPECT_LT((own - u).norm(), 0.01 * u.norm()) << "step " << step + 1 << " node " << node;
    }
}

} // namespace deck_loads
} // namespace plica::test
