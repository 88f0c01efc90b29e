// Progress of a run: one changing line on a terminal, plain lines in a pipe, nothing when quiet.
#pragma once

#include <chrono>
#include <string>

namespace plica {

class Progress {
public:
  explicit Progress(bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void stage(const std::string& name);
  void title(const std::string& name); // of what the next stages belong to
  void finish();                       // clears the changing line

private:
  bool quiet_, terminal_;
  std::string title_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace plica
