// Has every specimen diagnosed by the program itself, as any user would, where no truth is.
#include "files.hpp"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <mutex>
#include <sys/wait.h>
#include <thread>

namespace sealed {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// A truth file is JSON with a class; none may be reachable from the data.
void refuse_truth(const fs::path& data) {
  for (const auto& entry :
       fs::recursive_directory_iterator(data, fs::directory_options::follow_directory_symlink)) {
    if (entry.path().extension() == ".wall")
      throw std::runtime_error("a reduced wall is under the data: " + entry.path().string());
    if (entry.path().extension() != ".json") continue;
    std::ifstream in(entry.path());
    const json content = json::parse(in, nullptr, false);
    if (content.is_object() && content.contains("class") && content.contains("effects"))
      throw std::runtime_error("the truth is reachable from the data: " + entry.path().string());
  }
}

std::string specimen_of(const fs::path& measured) {
  std::ifstream in(measured);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("specimen: ")) return line.substr(10);
  throw std::runtime_error(measured.string() + " names no specimen");
}

std::string quoted(const fs::path& path) {
  return "'" + path.string() + "'";
}

} // namespace

void run_suite(const RunRequest& r) {
  refuse_truth(r.data);
  std::vector<std::string> ids;
  for (const auto& entry : fs::directory_iterator(r.data))
    if (fs::exists(entry.path() / "measured.yaml") &&
        (r.only.empty() || entry.path().filename() == r.only))
      ids.push_back(entry.path().filename().string());
  std::sort(ids.begin(), ids.end());
  fs::create_directories(r.out);
  std::atomic<std::size_t> next{0};
  std::mutex guard;
  json runs = json::object();
  const auto loop = [&] {
    for (std::size_t i = next++; i < ids.size(); i = next++) {
      const fs::path measured = r.data / ids[i], out = r.out / ids[i];
      fs::remove_all(out);
      fs::create_directories(out);
      std::string command =
          fmt::format("{} diagnose {} --measured {} --out {} --threads 1 --quiet",
                      quoted(fs::absolute(r.plica)),
                      quoted(r.data / (specimen_of(measured / "measured.yaml") + ".yaml")),
                      quoted(measured), quoted(out));
      if (!r.ablate.empty()) command += " --without " + r.ablate;
      command += " > " + quoted(out / "log") + " 2>&1";
      const auto start = std::chrono::steady_clock::now();
      const int status = std::system(command.c_str());
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
      const std::scoped_lock lock(guard);
      const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
      runs[ids[i]] = {{"exit", code}, {"seconds", seconds.count()}};
      fmt::print("{} {:.1f} s, exit {}\n", ids[i], seconds.count(), code);
      std::fflush(stdout);
    }
  };
  std::vector<std::thread> threads;
  for (int t = 1; t < r.jobs; ++t) threads.emplace_back(loop);
  loop();
  for (std::thread& t : threads) t.join();
  std::ofstream(r.out / "runs.json") << runs.dump(1) << '\n';
}

} // namespace sealed
