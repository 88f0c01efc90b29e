#include "mesh/generation/worker.hpp"

#include "mesh/machine_memory.hpp"
#include "words/short_text.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <mutex>
#include <poll.h>
#include <spawn.h>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace plica {
namespace {

using Clock = std::chrono::steady_clock;

std::atomic<pid_t> running = 0;
std::atomic<bool> stopped = false;
static_assert(std::atomic<pid_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

double number_of(const char* variable, double otherwise) {
  const char* text = std::getenv(variable);
  if (!text) return otherwise;
  char* end = nullptr;
  const double value = std::strtod(text, &end);
  if (end == text || *end != '\0' || !std::isfinite(value) || !(value > 0))
    throw std::runtime_error(std::string(variable) + " is '" + text + "', no number above 0");
  return value;
}

double three_quarters_of_memory() {
  return 0.75 * memory_limit().bytes;
}

std::string failed(const std::string& subject, const std::string& what) {
  return subject + ": " + what + ": " + std::strerror(errno);
}

// Threads of libraries would only count against the limits.
std::vector<std::string> environment() {
  std::vector<std::string> own;
  for (char** entry = environ; *entry; ++entry) own.emplace_back(*entry);
  for (const std::string name : {"OMP_NUM_THREADS=", "OPENBLAS_NUM_THREADS="}) {
    std::erase_if(own, [&](const std::string& entry) { return entry.starts_with(name); });
    own.push_back(name + "1");
  }
  return own;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> list;
  for (std::string& word : words) list.push_back(word.data());
  list.push_back(nullptr);
  return list;
}

class Worker {
public:
  Worker(const std::string& program, std::vector<std::string> words, const std::string& subject) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error(failed(subject, "no pipe"));
    reply_ = ends[0];
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    constexpr int reply = 3;
    posix_spawn_file_actions_adddup2(&actions, ends[1], reply);
    for (int closed : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
      posix_spawn_file_actions_addopen(&actions, closed, "/dev/null", O_RDWR, 0);
    words.insert(words.begin(), program);
    std::vector<std::string> own = environment();
    errno = posix_spawn(&pid_, program.c_str(), &actions, nullptr, pointers(words).data(),
                        pointers(own).data());
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (errno != 0) {
      close(reply_);
      throw std::runtime_error(failed(subject, "cannot start " + program));
    }
    running = pid_;
    if (stopped) kill(pid_, SIGKILL); // asked between
  }
  ~Worker() {
    if (!ended_) {
      kill(pid_, SIGKILL);
      wait();
    }
    close(reply_);
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // Appends what is there; false at the end, or when time is out.
  bool read(std::string& text, Clock::time_point until) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    if (left <= 0) {
      out_of_time_ = true;
      return false;
    }
    pollfd descriptor{reply_, POLLIN, 0};
    constexpr long a_day = 86'400'000;
    if (poll(&descriptor, 1, int(std::min<long>(left, a_day))) <= 0) return true; // look again
    std::array<char, 1 << 16> part;
    const ssize_t count = ::read(reply_, part.data(), part.size());
    if (count < 0) return errno == EINTR;
    text.append(part.data(), std::size_t(count));
    return count > 0;
  }

  // After the end of its reply: its status of waitpid. Its number may belong to another then.
  int wait() {
    running = 0;
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    ended_ = true;
    return status;
  }
  bool out_of_time() const { return out_of_time_; }

private:
  pid_t pid_ = 0;
  int reply_ = -1;
  bool ended_ = false, out_of_time_ = false;
};

} // namespace

WorkerLimits worker_limits() {
  WorkerLimits limits;
  limits.seconds = number_of("PLICA_MESH_SECONDS", limits.seconds);
  limits.bytes = 1e9 * number_of("PLICA_MESH_MEMORY", 1e-9 * three_quarters_of_memory());
  return limits;
}

std::string run_worker(const std::string& program, const std::vector<std::string>& words,
                       const WorkerLimits& limits, const std::string& subject) {
  static std::mutex mutex;
  const std::lock_guard alone(mutex);
  if (stopped) throw Interrupted{subject};
  std::vector<std::string> all{short_text(limits.seconds, 17), short_text(limits.bytes, 17)};
  all.insert(all.end(), words.begin(), words.end());
  const auto until =
      Clock::now() + std::chrono::milliseconds(long(1e3 * std::min(limits.seconds, 1e9)));
  Worker worker(program, all, subject);
  std::string reply;
  while (worker.read(reply, until)) {
  }
  if (worker.out_of_time() && !stopped)
    throw std::runtime_error(subject + ": not meshed within " + short_text(limits.seconds, 6) +
                             " s; PLICA_MESH_SECONDS gives it more, a larger element_size or a "
                             "simpler surface needs less");
  if (stopped) throw Interrupted{subject};
  const int status = worker.wait();
  if (stopped) throw Interrupted{subject};
  if (WIFSIGNALED(status))
    throw std::runtime_error(subject + ": the mesher broke down on it (" +
                             strsignal(WTERMSIG(status)) +
                             "): the file is damaged, or more than its libraries can take; check "
                             "it in a CAD system and export it again");
  if (WEXITSTATUS(status) != 0)
    throw std::runtime_error(subject + ": the mesher " + program + " ended with " +
                             std::to_string(WEXITSTATUS(status)));
  return reply;
}

void stop_workers() noexcept {
  stopped = true;
  if (const pid_t pid = running; pid > 0) kill(pid, SIGKILL);
}

void allow_workers() noexcept {
  stopped = false;
}

void become_worker(const WorkerLimits& limits) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
  const auto limit = [](auto what, double value) {
    const rlimit own{rlim_t(value), rlim_t(value)};
    setrlimit(what, &own);
  };
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, std::ceil(std::min(limits.seconds, 1e9)) + 1);
#ifndef __SANITIZE_ADDRESS__ // which maps terabytes
  limit(RLIMIT_AS, std::min(limits.bytes, 1e18));
#endif
}

} // namespace plica
