#include "life/miner.hpp"

#include "words/units.hpp"

#include <cmath>
#include <stdexcept>

namespace plica {

MinerSum miner(const FatigueCurve& curve, const std::vector<StressBlock>& blocks) {
  MinerSum sum;
  for (const StressBlock& block : blocks) {
    if (!(block.count >= 0) || !std::isfinite(block.count))
      throw std::invalid_argument("a block of " + short_number(block.count) +
                                  " cycles has no damage");
    BlockDamage part{.life = life(curve, block.cycle), .damage = 0};
    if (block.count > 0) {
      part.damage = block.count / part.life.cycles;
      sum.at_most = sum.at_most || part.life.bound == Bound::at_least;
      sum.at_least = sum.at_least || part.life.bound == Bound::at_most;
    }
    sum.damage += part.damage;
    sum.blocks.push_back(part);
  }
  return sum;
}

MinerSum miner(const FatigueCurve& curve, const std::vector<RainflowCycle>& cycles) {
  std::vector<StressBlock> blocks;
  blocks.reserve(cycles.size());
  for (const RainflowCycle& c : cycles) blocks.push_back({{c.range, c.mean}, c.count});
  return miner(curve, blocks);
}

} // namespace plica
