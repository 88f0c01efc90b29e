#include "model/description/life_request.hpp"

#include "words/directions.hpp"

#include <algorithm>

namespace plica {

int end_shift_index(std::string_view name) {
  return place_among(end_shift_names, name);
}

bool moves_end(const LifeHistory& history) {
  return std::any_of(history.signals.begin(), history.signals.end(),
                     [](const LifeSignal& s) { return end_shift_index(s.of) >= 0; });
}

bool needs_statics(const Life& life) {
  return !life.strokes.empty() ||
         std::any_of(life.histories.begin(), life.histories.end(), moves_end);
}

bool needs_response(const Life& life) {
  return !life.random.empty() || !life.sweeps.empty() || !life.dwells.empty() ||
         std::any_of(life.histories.begin(), life.histories.end(),
                     [](const LifeHistory& h) { return !moves_end(h); });
}

} // namespace plica
