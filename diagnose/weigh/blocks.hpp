// Readings by direction, band, level and kind, and how far each block is from admissible specimens.
#pragma once

#include "diagnose/results/diagnosis.hpp"
#include "diagnose/weigh/uncertainty.hpp"

#include <Eigen/Cholesky>

namespace plica {

struct Block {
  LocatedGap label;
  std::vector<Eigen::Index> rows;
};

std::vector<Block> blocks_of(const TestReadings& test);

// Standard score of a block's deviations: their chi-square against that of the healthy specimens,
// whose mean it is scaled by (Wilson and Hilferty, PNAS 17 (1931) 684). Unsigned.
class BlockScores {
public:
  BlockScores(const TestReadings& test, const Uncertainty& u);
  const std::vector<Block>& blocks() const { return blocks_; }
  // `further`: covariance beside that of the test; none = empty.
  double score(std::size_t block, const Eigen::VectorXd& deviation,
               const Eigen::MatrixXd& further = {}) const;
  // Largest over the blocks that are fitted.
  std::pair<double, std::string> worst(const Eigen::VectorXd& deviation,
                                       const Eigen::MatrixXd& further = {}) const;

  // Chi-square of the fitted readings' means over the levels: what levels have in common does not
  // hide behind how they may scatter.
  double of_means(const Eigen::VectorXd& deviation, const Eigen::MatrixXd& further = {}) const;

private:
  std::vector<Block> blocks_;
  Eigen::MatrixXd means_, total_; // series x readings; of the readings
  std::vector<Eigen::LLT<Eigen::MatrixXd>> root_;
  std::vector<double> healthy_mean_;
  std::vector<bool> fitted_;
};

// By their p-values, at 5 % after Holm's correction.
void mark_significant(std::vector<LocatedGap>& gaps, const std::vector<double>& p);

std::vector<LocatedGap> located(const BlockScores& scores, const Eigen::VectorXd& deviation);
std::vector<LevelTrend> level_trends(const TestReadings& test);
// A frequency or damping moves with the level by more than three of its standard deviations: what
// slips may be in it.
bool changes_with_level(const TestReadings& test);

std::string name_of(const LocatedGap& block);
// "frequency"; empty: of a component, by hypotheses there.
const char* kind_word(const LocatedGap& block);

} // namespace plica
