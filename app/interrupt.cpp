#include "app/interrupt.hpp"

#include "app/terminal.hpp"

#include <csignal>
#include <string_view>
#include <unistd.h>

namespace plica {
namespace {

volatile std::sig_atomic_t asked = 0, once = 0, last = SIGINT;

void on_interrupt(int signal) {
  if (once != 0) { // the second one kills
    std::signal(signal, SIG_DFL);
    raise(signal);
    return;
  }
  asked = 1;
  once = 1;
  last = signal;
  stop_workers();
  constexpr std::string_view words =
                                 "\nplica: stopping after this stage; Ctrl-C again stops at once\n",
                             json = "{\"kind\":\"note\",\"text\":\"stopping after this stage; "
                                    "Ctrl-C again stops at once\"}\n";
  const std::string_view text = speaks_json() ? json : words;
  [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
}

volatile std::sig_atomic_t ended = 0;

void end_search(int signal) {
  last = signal;
  if (ended != 0)
    for (const int other : {SIGINT, SIGTERM}) std::signal(other, SIG_DFL);
  ended = 1;
}

// Not of a signal that whoever started us has us ignore (nohup, a background job).
void handle(void (*handler)(int), int flags) {
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction now {};
    sigaction(signal, nullptr, &now);
    if (now.sa_handler == SIG_IGN) continue;
    struct sigaction own {};
    own.sa_handler = handler;
    own.sa_flags = flags;
    sigaction(signal, &own, nullptr);
  }
}

} // namespace

void let_searches_end() {
  handle(end_search, 0);
}

bool search_is_ended() {
  return ended != 0;
}

void watch_interrupts() {
  once = 0;
  handle(on_interrupt, SA_RESTART);
}

bool is_interrupted() {
  return asked != 0;
}

void forget_interrupt() {
  asked = 0;
  allow_workers();
}

std::string interrupted_by() {
  return last == SIGTERM ? "SIGTERM" : "Ctrl-C";
}

int interrupted_exit() {
  return 128 + last;
}

} // namespace plica
