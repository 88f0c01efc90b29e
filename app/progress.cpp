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

void Progress::stage(const std::string& name) {
  if (is_interrupted()) throw Interrupted{title_ + ": " + name};
  if (quiet_) return;
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  if (speaks_json()) return say_progress(title_, name, seconds, share_);
  const std::string left = share_ > 0 ? fmt::format("{:3.0f} %, {:.0f} s left  ", 100 * share_,
                                                    seconds * (1 - share_) / share_)
                                      : "";
  const std::string line = fmt::format("[{:6.1f} s] {}{}: {}", seconds, left, title_, name);
  if (terminal_)
    say_raw("\r\033[K" + printable(line));
  else
    say(line + "\n");
}

void Progress::finish() {
  if (!quiet_ && terminal_) say_raw("\r\033[K");
}

} // namespace plica
