#include "io/input/phases_alone.hpp"

namespace plica {

void refuse_phases_alone(ReadLog& log) {
  const std::string base = "analyses.response.base", phase = ".phase";
  for (auto key = log.lines.lower_bound(base); key != log.lines.end(); ++key) {
    if (!key->first.starts_with(base)) break;
    if (!key->first.ends_with(phase)) continue;
    const std::string end = key->first.substr(0, key->first.size() - phase.size());
    if (!log.lines.contains(end + ".amplitude"))
      log.add(key->second, key->first, "is of an end without amplitude",
              "amplitude: 1 beside it, times the level");
  }
}

} // namespace plica
