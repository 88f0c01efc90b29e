// Has every specimen diagnosed by the program itself, as any user would, where no truth is.
#include "files.hpp"

#include <chrono>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <mutex>
#include <sys/wait.h>

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

} // namespace

std::string quoted(const fs::path& path) {
  return "'" + path.string() + "'";
}

std::vector<std::string> specimens_in(const fs::path& data) {
  std::vector<std::string> ids;
  for (const auto& entry : fs::directory_iterator(data))
    if (fs::exists(entry.path() / "measured.yaml")) ids.push_back(entry.path().filename().string());
  std::sort(ids.begin(), ids.end());
  return ids;
}

int run_diagnosis(const fs::path& plica, const fs::path& data, const std::string& id,
                  const fs::path& out, const std::string& options) {
  const fs::path measured = data / id;
  fs::remove_all(out);
  fs::create_directories(out);
  const std::string command =
      fmt::format("{} diagnose {} --measured {} --out {} --threads 1 --quiet{} > {} 2>&1",
                  quoted(fs::absolute(plica)),
                  quoted(data / (specimen_of(measured / "measured.yaml") + ".yaml")),
                  quoted(measured), quoted(out), options, quoted(out / "log"));
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void run_suite(const RunRequest& r) {
  refuse_truth(r.data);
  std::vector<std::string> ids = specimens_in(r.data);
  if (!r.only.empty()) std::erase_if(ids, [&](const std::string& id) { return id != r.only; });
  fs::create_directories(r.out);
  std::mutex guard;
  json runs = json::object();
  in_parallel(ids.size(), r.jobs, [&](std::size_t i) {
    const auto start = std::chrono::steady_clock::now();
    const int code = run_diagnosis(r.plica, r.data, ids[i], r.out / ids[i],
                                   r.ablate.empty() ? "" : " --without " + r.ablate);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const std::scoped_lock lock(guard);
    runs[ids[i]] = {{"exit", code}, {"seconds", seconds.count()}};
    fmt::print("{} {:.1f} s, exit {}\n", ids[i], seconds.count(), code);
    std::fflush(stdout);
  });
  std::ofstream(r.out / "runs.json") << runs.dump(1) << '\n';
}

} // namespace sealed
