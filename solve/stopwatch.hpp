// Seconds of named stages.
#pragma once

#include <chrono>
#include <map>
#include <string>

namespace plica {

class Stopwatch {
public:
  // Seconds since the last call or construction, added to the stage.
  double lap(std::map<std::string, double>& timing, const std::string& stage) {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    timing[stage] += seconds;
    return seconds;
  }

  // Seconds since the last lap or construction.
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - last_).count();
  }

private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

} // namespace plica
