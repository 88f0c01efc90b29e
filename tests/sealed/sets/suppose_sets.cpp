// Has the program say what each true effect is worth, by the numbers that it has.
#include "../files.hpp"
#include "sets.hpp"

#include <atomic>
#include <fmt/format.h>
#include <fstream>

namespace sealed {

namespace fs = std::filesystem;
using nlohmann::json;

bool suppose_sets(const SupposeRequest& r) {
  const std::vector<std::string> ids = specimens_in(r.data);
  std::atomic<int> cannot{0}, failed{0};
  in_parallel(ids.size(), r.jobs, [&](std::size_t i) {
    std::ifstream in(r.truth / (ids[i] + ".json"));
    const auto file = supposed(json::parse(in));
    if (!file) {
      ++cannot;
      return;
    }
    const fs::path own = r.out / ids[i], yaml = own / "supposed.yaml";
    fs::create_directories(own);
    std::ofstream(yaml) << file->dump(1) << '\n';
    const int code =
        run_diagnosis(r.plica, r.data, ids[i], own / "true", " --suppose " + quoted(yaml));
    const bool is_there = code == 0 && fs::exists(own / "true" / "supposed.json");
    failed += !is_there;
    fmt::print("{} {}\n", ids[i],
               is_there
                   ? "supposed"
                   : fmt::format("FAILED, exit {}: {}", code, (own / "true" / "log").string()));
    std::fflush(stdout);
  });
  fmt::print("{} specimens, {} with an effect that the library cannot state, {} failed\n",
             ids.size(), cannot.load(), failed.load());
  return failed == 0;
}

} // namespace sealed
