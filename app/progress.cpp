#include "app/progress.hpp"

#include "app/interrupt.hpp"
#include "app/terminal.hpp"

#include <fmt/core.h>
#include <unistd.h>

namespace plica {

Progress::Progress(bool quiet)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0 && !speaks_json()) {}

Progress::~Progress() {
  finish();
}

void Progress::title(const std::string& name) {
  title_ = name;
}

void Progress::share(double done) {
  share_ = done;
}

void Progress::advance(double done) {
  constexpr std::chrono::milliseconds often(250);
  share_ = done;
  if ((terminal_ || speaks_json()) && Clock::now() - shown_ >= often) show();
}

void Progress::stage(const std::string& name) {
  if (is_interrupted()) throw Interrupted{title_ + ": " + name};
  stage_ = name;
  show();
}

void Progress::show() {
  shown_ = Clock::now();
  if (quiet_) return;
  const double seconds = std::chrono::duration<double>(shown_ - start_).count();
  if (speaks_json()) return say_progress(title_, stage_, seconds, share_);
  const std::string left = share_ > 0 ? fmt::format("{:3.0f} %, {:.0f} s left  ", 100 * share_,
                                                    seconds * (1 - share_) / share_)
                                      : "";
  const std::string line = fmt::format("[{:6.1f} s] {}{}: {}", seconds, left, title_, stage_);
  if (terminal_)
    say_raw("\r\033[K" + printable(line));
  else
    say(line + "\n");
}

void Progress::finish() {
  if (!quiet_ && terminal_) say_raw("\r\033[K");
}

} // namespace plica
