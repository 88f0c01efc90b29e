// Palmgren (1924) and Miner (1945): D = sum n / N, failure at D = 1. The order of the cycles does
// not count, which is the known weakness of the rule.
#pragma once

#include "life/curves.hpp"
#include "life/rainflow.hpp"

namespace plica {

struct StressBlock {
  StressCycle cycle;
  double count = 0; // how often, >= 0
};

struct BlockDamage {
  CurveLife life;
  double damage = 0; // count / N
};

struct MinerSum {
  double damage = 0;               // infinite when a block is borne no single time
  bool at_most = false;            // some N is "at least": less damage than this
  bool at_least = false;           // some N is "at most": more damage than this
  std::vector<BlockDamage> blocks; // in the order given

  double repeats() const { return 1 / damage; } // of the whole until failure; infinite for D = 0
};

// Throws std::invalid_argument for a count or a cycle that is no number, or below zero.
MinerSum miner(const FatigueCurve& curve, const std::vector<StressBlock>& blocks);

// Ranges and means in Pa.
MinerSum miner(const FatigueCurve& curve, const std::vector<RainflowCycle>& cycles);

} // namespace plica
