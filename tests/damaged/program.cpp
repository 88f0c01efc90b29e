#include "tests/damaged/program.hpp"

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iostream>
#include <sstream>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

int plica_main(int argc, char** argv); // app/main.cpp

namespace plica::test {
namespace {

constexpr int seconds_of_work = 30, seconds_at_most = 240; // of a busy machine
constexpr rlim_t most_memory = rlim_t(6) << 30;

void limit(int resource, rlim_t most) {
  const rlimit limits{most, most};
  setrlimit(resource, &limits);
}

[[noreturn]] void child(std::vector<std::string> arguments, const std::filesystem::path& folder) {
  setpgid(0, 0);
  const int output =
      open((folder / "output").c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_APPEND, 0644);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  if (chdir(folder.c_str()) != 0) _exit(99);
  limit(RLIMIT_CPU, seconds_of_work);
  limit(RLIMIT_AS, most_memory);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, rlim_t(1) << 28);
  std::signal(SIGXFSZ, SIG_IGN);
  arguments.insert(arguments.begin(), "plica");
  std::vector<char*> words;
  for (std::string& word : arguments) words.push_back(word.data());
  words.push_back(nullptr);
  const int code = plica_main(int(arguments.size()), words.data());
  std::cout.flush();
  std::fflush(nullptr);
  _exit(code);
}

} // namespace

Ended run_plica(const std::vector<std::string>& arguments, const std::filesystem::path& folder) {
  std::fflush(nullptr);
  const pid_t process = fork();
  if (process == 0) child(arguments, folder);
  Ended ended;
  const auto begin = std::chrono::steady_clock::now();
  int status = 0;
  while (waitpid(process, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() - begin > std::chrono::seconds(seconds_at_most)) {
      kill(-process, SIGKILL);
      waitpid(process, &status, 0);
      ended.how = "no end within " + std::to_string(seconds_at_most) + " s";
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (ended.how.empty() && WIFEXITED(status)) {
    ended.exit = WEXITSTATUS(status);
    ended.how = "exit " + std::to_string(ended.exit);
  } else if (ended.how.empty()) {
    const int signal = WTERMSIG(status);
    ended.how = signal == SIGXCPU || signal == SIGKILL
                    ? "no end within " + std::to_string(seconds_of_work) + " s of work"
                    : "signal " + std::to_string(signal);
  }
  std::ifstream stream(folder / "output", std::ios::binary);
  ended.output = (std::ostringstream() << stream.rdbuf()).str();
  return ended;
}

} // namespace plica::test
