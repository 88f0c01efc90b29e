#include "app/interrupt.hpp"

#include <csignal>
#include <unistd.h>

namespace plica {
namespace {

volatile std::sig_atomic_t asked = 0;

void on_interrupt(int) {
  asked = 1;
  constexpr char text[] = "\nplica: stopping after this stage; Ctrl-C again stops at once\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, text, sizeof text - 1);
}

} // namespace

void watch_interrupts() {
  struct sigaction now {};
  sigaction(SIGINT, nullptr, &now);
  if (now.sa_handler == SIG_IGN) return;
  struct sigaction own {};
  own.sa_handler = on_interrupt;
  own.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &own, nullptr);
}

bool is_interrupted() {
  return asked != 0;
}

void forget_interrupt() {
  asked = 0;
}

} // namespace plica
