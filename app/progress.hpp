// Progress of a run: one changing line on a terminal, plain lines in a pipe, nothing when quiet.
//
//   [  12.3 s]  40 %, 18 s left  bellow_a2, height 7 mm: modes
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

  void stage(const std::string& name); // throws Interrupted after a Ctrl-C
  void share(double done);             // of all the work, 0..1, where it can be said
  // The same while a stage goes on, shown where a line changes or a program listens, some times a
  // second; from one thread at a time.
  void advance(double done);
  void title(const std::string& name); // of what the next stages belong to
  void finish();                       // clears the changing line

private:
  using Clock = std::chrono::steady_clock;
  void show();

  bool quiet_, terminal_;
  std::string title_, stage_;
  double share_ = 0;
  Clock::time_point start_ = Clock::now(), shown_ = start_;
};

} // namespace plica
