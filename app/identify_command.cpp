#include "app/commands.hpp"

#include "app/progress.hpp"
#include "diagnose/frf_of_signals.hpp"
#include "io/measured_data.hpp"
#include "io/measured_file.hpp"
#include "io/write_identification.hpp"

#include <fmt/core.h>

namespace plica {
namespace {

namespace fs = std::filesystem;

// Numerical trouble with what the user gave is the user's to know.
template <class F> auto told(const std::string& file, const std::string& key, F&& work) {
  try {
    return work();
  } catch (const std::invalid_argument& error) {
    throw InputError({{.file = file,
                       .line = 0,
                       .key = key,
                       .wrong = error.what(),
                       .allowed = "data and options that allow it"}});
  }
}

struct Task {
  std::string title;
  FrfSet set;
};

std::string title_of(const std::string& specimen, const FrfSet& set) {
  std::string title = specimen;
  for (const std::string& r : set.references) title += ", " + r;
  if (set.level) title += fmt::format(" at {:g}", *set.level);
  return title;
}

std::vector<Task> tasks_of(const std::string& path, const IdentifyOptions& options) {
  const Measured measured = read_measured(path);
  const fs::path folder = fs::path(path).parent_path();
  std::vector<Task> tasks;
  for (FrfSet& set : load_frfs(measured, folder)) {
    std::string title = title_of(measured.specimen, set);
    tasks.push_back({std::move(title), std::move(set)});
  }
  for (std::size_t i = 0; i < measured.signals.size(); ++i) {
    const MeasuredSignals& entry = measured.signals[i];
    const std::string key = "signals[" + std::to_string(i) + "]";
    const SignalSet signals = load_signals(entry, measured, folder, key);
    const FrfQuantity quantity = entry.quantity.value_or(entry.base ? FrfQuantity::transmissibility
                                                                    : FrfQuantity::accelerance);
    SignalFrf frf = told(path, key, [&] {
      return entry.excitation == Excitation::sine
                 ? frf_of_sine(signals.samples, signals.rate, signals.channels, entry.reference,
                               quantity, options.tracking)
                 : frf_of_noise(signals.samples, signals.rate, signals.channels, entry.reference,
                                quantity, options.welch, options.estimator);
    });
    frf.set.level = entry.level;
    std::string title = title_of(measured.specimen, frf.set);
    tasks.push_back({std::move(title), std::move(frf.set)});
  }
  if (tasks.empty())
    throw InputError({{.file = path,
                       .line = 0,
                       .key = "frf",
                       .wrong = "names no frequency responses and no signals",
                       .allowed = "entries of frf or signals"}});
  return tasks;
}

} // namespace

int identify_command(const IdentifyOptions& options) {
  std::vector<Task> tasks;
  const fs::path first = options.files.front();
  if (first.extension() == ".yaml" || first.extension() == ".yml") {
    if (options.files.size() > 1)
      throw InputError({{.file = first.string(),
                         .line = 0,
                         .key = "",
                         .wrong = "stands beside other files",
                         .allowed = "one measured.yaml, or files of frequency responses"}});
    tasks = tasks_of(first.string(), options);
  } else {
    FrfSet set = load_frf_files({options.files.begin(), options.files.end()}, options.quantity);
    tasks.push_back({first.stem().string(), std::move(set)});
  }
  Progress progress(options.quiet);
  bool found_any = false;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    progress.title(tasks[i].title);
    progress.stage("identification");
    const Identification found =
        told(first.string(), "", [&] { return identify(tasks[i].set, options.settings); });
    const fs::path folder = tasks.size() == 1 ? options.out : options.out / std::to_string(i + 1);
    write_identification(found, tasks[i].title, folder);
    progress.finish();
    if (!options.quiet)
      fmt::print("{}\nReport: {}\n{}", identification_text(found, tasks[i].title),
                 (folder / "report.html").string(), i + 1 < tasks.size() ? "\n" : "");
    found_any = found_any || !found.modes.empty();
  }
  return found_any ? 0 : 2;
}

} // namespace plica
