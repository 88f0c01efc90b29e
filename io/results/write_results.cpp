#include "io/results/write_results.hpp"

#include "diagnose/simulated.hpp"
#include "io/files.hpp"
#include "io/report/report.hpp"
#include "io/results/csv.hpp"
#include "io/results/json.hpp"
#include "io/results/levels_csv.hpp"
#include "io/results/simulated_yaml.hpp"
#include "io/results/text.hpp"
#include "io/results/vtu.hpp"
#include "io/universal/signals.hpp"
#include "io/universal/writer.hpp"

#include <string>
#include <system_error>
#include <vector>

namespace plica {
namespace {

namespace fs = std::filesystem;

// Files that some runs write and others do not.
bool is_optional_output(const std::string& name) {
  const auto named = [&](const char* prefix) {
    return name.starts_with(prefix) && name.ends_with(".csv");
  };
  return named("response_") || named("motion_") || named("random_") || named("level") ||
         name == "stress.csv" || name == "stress.vtu" || name == "error_bars.csv" ||
         name == "responses.uff";
}

std::string responses_uff(const Results& results) {
  std::string text;
  for (const FrfSet& set : responses_to_base(results))
    for (const UniversalFunction& f : universal_functions(set)) text += universal_text(f);
  return text;
}

void remove_stale(const fs::path& folder, const FileSet& written) {
  std::vector<fs::path> stale;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (is_optional_output(name) && !written.holds(name)) stale.push_back(entry.path());
  }
  std::error_code ignored;
  for (const fs::path& path : stale) fs::remove(path, ignored);
}

} // namespace

void write_results(const Results& results, const fs::path& out_dir) {
  FileSet files(out_dir);
  files.add("modes.csv", modes_csv(results));
  files.add("static.csv", static_csv(results));
  files.add("comparison.csv", comparison_csv(results));
  files.add("variants.csv", variants_csv(results));
  files.add("modes.vtu", modes_vtu(results));
  for (const ResponseResult& r : results.responses) {
    files.add("response_" + response_name(r) + ".csv", response_csv(r));
    files.add("motion_" + response_name(r) + ".csv", motion_csv(r));
    if (r.random) files.add("random_" + response_name(r) + ".csv", random_csv(r));
  }
  for (const LevelFamily& family : results.families)
    files.add(levels_name(family) + ".csv", levels_csv(family));
  if (!results.families.empty()) {
    files.add("level_peaks.csv", level_peaks_csv(results));
    files.add("level_joints.csv", level_joints_csv(results));
    files.add("level_backbones.csv", level_backbones_csv(results));
  }
  if (!results.stresses.empty()) {
    files.add("stress.csv", stress_csv(results));
    files.add("stress.vtu", stress_vtu(results));
  }
  if (!results.error_bars.bars.empty()) files.add("error_bars.csv", error_bars_csv(results));
  files.add("simulated.yaml", simulated_yaml(as_measured(results)));
  if (const std::string text = responses_uff(results); !text.empty())
    files.add("responses.uff", text);
  files.add("report.html", report_html(results));
  files.add("results.json", results_json(results));
  files.commit();
  remove_stale(out_dir, files);
}

} // namespace plica
