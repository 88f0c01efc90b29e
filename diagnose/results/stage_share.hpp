// How far a stage of a diagnosis is, while its pieces are worked on by several threads.
#pragma once

#include "diagnose/results/settings.hpp"

#include <algorithm>
#include <mutex>

namespace plica {

// Shares of the work that lie before the stages of a diagnosis, as cases that need sets of effects
// take them.
namespace share {

inline constexpr double specimens = 0.08, bases = 0.26, signatures = 0.46, fits = 0.53,
                        chains = 0.56, sets = 0.58, ledger = 0.90, report = 0.94,
                        next_measurement = 0.98;

} // namespace share

// Tells the share of all the work as pieces are done: `begins` before the first of them, `ends`
// after the last.
class StageShare {
public:
  StageShare(const DiagnosisSettings& settings, double begins, double ends, std::size_t pieces)
      : settings_(settings), begins_(begins), ends_(ends),
        pieces_(std::max<std::size_t>(1, pieces)) {}

  // From any thread.
  void one_is_done() {
    const std::scoped_lock lock(mutex_);
    ++done_;
    settings_.advance(begins_ + (ends_ - begins_) * double(done_) / double(pieces_));
  }

private:
  const DiagnosisSettings& settings_;
  double begins_, ends_;
  std::size_t pieces_, done_ = 0;
  std::mutex mutex_;
};

} // namespace plica
