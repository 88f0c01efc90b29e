#include "app/command_line.hpp"
#include "app/finish.hpp"
#include "app/interrupt.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "io/input/measured_file.hpp"
#include "io/lab_files/measured_data.hpp"
#include "io/lab_files/time_runs.hpp"
#include "io/write/simulated_yaml.hpp"
#include "io/write/write_identification.hpp"
#include "lab/identification/identified_measured.hpp"
#include "lab/identification/linearity.hpp"
#include "lab/measured/entries.hpp"
#include "lab/signals/frf_of_signals.hpp"

#include <fmt/core.h>

namespace plica {
namespace {

struct IdentifyOptions {
  std::vector<std::string> files; // one measured.yaml, or files of frequency responses
  Output out;
  IdentifySettings settings;
  std::optional<FrfQuantity> quantity; // of bare files; none = as they say, or accelerance
  WelchSettings welch{.block = 0};     // by the length of the record
  FrfEstimator estimator = FrfEstimator::H1;
  SineTracking tracking;
};

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
  SignalFrf frf;               // of a file: the set alone
  std::optional<TimeRun> time; // in place of it
  std::string state;
};

struct Tasks {
  std::vector<fs::path> inputs;
  MeasuredFile test; // of bare files its specimen alone
  std::vector<Task> list;
  std::vector<LevelVerdict> levels;
  std::vector<Homogeneity> homogeneity;
};

Task of_file(std::string title, const FrfSet& set) {
  Task task{.title = std::move(title), .frf = {}, .time = {}, .state = {}};
  task.frf.set = set;
  return task;
}

TestOnFile on_file(const MeasuredFile& file) {
  return {.data = file.data, .path = file.path, .lines = file.lines};
}

// A name as measured.yaml takes it.
std::string plain_name(const std::string& text) {
  std::string name;
  for (const char c : text)
    name += std::isalnum(static_cast<unsigned char>(c)) || c == '-' ? c : '_';
  return name.empty() || !std::isalpha(static_cast<unsigned char>(name[0])) ? "test_" + name : name;
}

std::string in_state(const std::string& title, const std::string& state) {
  return state.empty() ? title : title + ", " + state;
}

// Of the responses, each once, in their order.
std::vector<std::string> states_of(const Measured& measured) {
  std::vector<std::string> states;
  for (const MeasuredFrf& f : measured.frf)
    if (std::find(states.begin(), states.end(), f.state) == states.end()) states.push_back(f.state);
  return states;
}

std::string title_of(const std::string& specimen, const FrfSet& set) {
  std::string title = specimen;
  for (const std::string& r : set.references) title += ", " + r;
  if (set.level) title += fmt::format(" at {:g}", *set.level);
  return title;
}

Tasks tasks_of(const std::string& path, const IdentifyOptions& options) {
  const MeasuredFile file = read_measured_file(path);
  const Measured& measured = file.data;
  const fs::path folder = fs::path(path).parent_path();
  Tasks tasks{.inputs = files_of(file), .test = file, .list = {}, .levels = {}, .homogeneity = {}};
  std::vector<FrfSet> sets;
  for (const std::string& state : states_of(measured)) {
    for (FrfSet& set : load_frfs(measured, folder, state)) {
      tasks.list.push_back(of_file(in_state(title_of(measured.specimen, set), state), set));
      tasks.list.back().state = state;
      sets.push_back(std::move(set));
    }
  }
  for (std::size_t i = 0; i < measured.signals.size(); ++i) {
    const MeasuredSignals& entry = measured.signals[i];
    if (!has_input(entry.excitation)) continue;
    const std::string key = entry_name("signals", i);
    const SignalSet signals = load_signals(entry, measured, folder, key);
    const FrfQuantity quantity = entry.quantity.value_or(entry.base ? FrfQuantity::transmissibility
                                                                    : FrfQuantity::accelerance);
    SignalFrf frf = told(path, key, [&] {
      return entry.excitation == SignalKind::sine
                 ? frf_of_sine(signals.samples, signals.rate, signals.channels, entry.reference,
                               quantity, options.tracking)
                 : frf_of_noise(signals.samples, signals.rate, signals.channels, entry.reference,
                                quantity, options.welch, options.estimator);
    });
    frf.set.level = entry.level;
    frf.set.warnings = signals.warnings;
    if (!entry.force.empty()) frf.set.references = {entry.force};
    sets.push_back(frf.set);
    std::string title = in_state(title_of(measured.specimen, frf.set), entry.state);
    tasks.list.push_back(
        {.title = std::move(title), .frf = std::move(frf), .time = {}, .state = entry.state});
  }
  for (TimeRun& time : time_runs(on_file(file))) {
    std::string title = measured.specimen + ", " + time.records[0].name;
    if (time.records.size() > 1) title += fmt::format(" and {} more", time.records.size() - 1);
    if (time.level) title += fmt::format(" at {:g}", *time.level);
    tasks.list.push_back(
        {.title = in_state(title, time.state), .frf = {}, .time = time, .state = time.state});
  }
  tasks.levels = level_verdicts(measured, sets);
  tasks.homogeneity = homogeneity(sets);
  if (tasks.list.empty() && tasks.levels.empty())
    throw InputError({{.file = path,
                       .line = 0,
                       .key = "frf",
                       .wrong = "names no frequency responses, no signals and no peaks over levels",
                       .allowed = "entries of frf, signals or peaks"}});
  return tasks;
}

Tasks tasks_of(const IdentifyOptions& options) {
  const fs::path first = options.files.front();
  if (first.extension() != ".yaml" && first.extension() != ".yml") {
    Tasks tasks{.inputs = {options.files.begin(), options.files.end()},
                .test = {},
                .list = {},
                .levels = {},
                .homogeneity = {}};
    const FrfSet set = load_frf_files(tasks.inputs, options.quantity);
    tasks.list.push_back(of_file(first.stem().string(), set));
    tasks.test.data.specimen = plain_name(first.stem().string());
    return tasks;
  }
  if (options.files.size() > 1)
    throw InputError({{.file = first.string(),
                       .line = 0,
                       .key = "",
                       .wrong = "stands beside other files",
                       .allowed = "one measured.yaml, or files of frequency responses"}});
  return tasks_of(first.string(), options);
}

// Where the files of a task go: a folder each where there are several.
std::string below(const Tasks& tasks, std::size_t i) {
  return tasks.list.size() == 1 ? "" : std::to_string(i + 1) + "/";
}

std::vector<std::string> names_of(const Tasks& tasks) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < tasks.list.size(); ++i)
    for (const std::string& name :
         identification_files(tasks.list[i].frf.density.size() > 0, tasks.list[i].time.has_value()))
      names.push_back(below(tasks, i) + name);
  if (!tasks.list.empty()) names.emplace_back(identified_file);
  if (!tasks.levels.empty()) names.emplace_back(levels_file);
  return names;
}

Identification identify_one(const Tasks& tasks, std::size_t i, const IdentifyOptions& options,
                            OutputFolder& out, Progress& progress) {
  const Task& task = tasks.list[i];
  progress.title(task.title);
  progress.stage("identification");
  Identification found = told(options.files.front(), task.time ? task.time->key : "", [&] {
    return task.time ? identified(*task.time, on_file(tasks.test), options.settings)
                     : identify(task.frf.set, options.settings);
  });
  const LinearityOfSet linearity{.reciprocity = reciprocity(task.frf.set),
                                 .coherence_drops =
                                     task.frf.coherence.size() > 0
                                         ? coherence_drops(task.frf.set, task.frf.coherence)
                                         : std::vector<CoherenceDrop>{},
                                 .distortion = distortions(task.frf.set, task.frf.distortion)};
  write_identification(found, linearity, task.title, out, below(tasks, i));
  if (task.frf.density.size() > 0) out.add(below(tasks, i) + "spectra.csv", spectra_csv(task.frf));
  out.commit();
  progress.finish();
  if (!options.out.quiet)
    print(fmt::format(
        "{}\nReport: {}\n{}", identification_text(found, linearity, task.title),
        out.shown(below(tasks, i) + "identification.html", below(tasks, i) + "identification.json")
            .string(),
        i + 1 < tasks.list.size() ? "\n" : ""));
  return found;
}

int identify_files(const IdentifyOptions& options) {
  const Tasks tasks = tasks_of(options);
  OutputFolder out(options.out.folder, {.command = "identify",
                                        .inputs = tasks.inputs,
                                        .names = names_of(tasks),
                                        .json_only = options.out.json_only});
  Progress progress(options.out.quiet);
  bool found_any = tasks.list.empty();
  std::vector<IdentifiedRun> runs;
  for (std::size_t i = 0; i < tasks.list.size(); ++i) {
    try {
      runs.push_back({.title = tasks.list[i].title,
                      .found = identify_one(tasks, i, options, out, progress),
                      .state = tasks.list[i].state});
      found_any = found_any || !runs.back().found.modes.empty();
    } catch (const Interrupted& stop) {
      if (i == 0) throw;
      say(fmt::format("plica: stopped before \"{}\"; {} of {} are written\n", stop.stage, i,
                      tasks.list.size()));
      return interrupted_exit();
    }
  }
  if (!runs.empty()) {
    Measured measured = identified_measured(tasks.test.data, runs);
    if (measured.source.empty()) measured.source = "plica identify";
    out.add(identified_file, simulated_yaml(measured));
    if (!options.out.quiet)
      print(fmt::format("\nModes for compare, fit and diagnose: {}\n",
                        (out.path() / identified_file).string()));
  }
  if (!tasks.levels.empty()) {
    write_levels(tasks.levels, tasks.homogeneity, out);
    if (!options.out.quiet) print(levels_text(tasks.levels, tasks.homogeneity));
  }
  hand_over(out);
  return found_any ? 0 : 2;
}

} // namespace

void add_identify_command(CommandLine& line) {
  const auto options = std::make_shared<IdentifyOptions>();
  CLI::App& command = line.add(
      "identify", "frequencies, damping and shapes from measured responses or time signals",
      [options] { return identify_files(*options); });
  command
      .add_option("FILES", options->files,
                  "a measured.yaml, or files of frequency responses (UFF, CSV), one per reference")
      ->required();
  add_output(command, options->out);
  command
      .add_option_function<std::array<double, 2>>(
          "--band",
          [options](const std::array<double, 2>& band) {
            options->settings.low = band[0];
            options->settings.high = band[1];
          },
          "lowest and highest frequency, Hz; left out: all lines")
      ->delimiter(',')
      ->type_name("HZ HZ");
  command
      .add_option("--order", options->settings.highest_order,
                  "highest order of the stabilisation diagram; left out: by the references")
      ->check(CLI::Range(2, 200));
  add_choice(command, "--quantity", options->quantity,
             {{"receptance", FrfQuantity::receptance},
              {"mobility", FrfQuantity::mobility},
              {"accelerance", FrfQuantity::accelerance},
              {"transmissibility", FrfQuantity::transmissibility}},
             "of bare files; left out: as they say, or accelerance");
  command
      .add_option("--block", options->welch.block,
                  "samples of a block (noise); left out: by the length")
      ->check(CLI::Range(8, 1 << 24));
  command.add_option("--overlap", options->welch.overlap, "of blocks, 0 to 0.95")
      ->check(CLI::Range(0., 0.95))
      ->capture_default_str();
  add_choice(command, "--window", options->welch.window,
             {{"rectangular", Window::rectangular},
              {"hann", Window::hann},
              {"hamming", Window::hamming},
              {"flat_top", Window::flat_top}},
             "of blocks; left out: hann");
  add_choice(command, "--estimator", options->estimator,
             {{"H1", FrfEstimator::H1}, {"H2", FrfEstimator::H2}, {"Hv", FrfEstimator::Hv}},
             "of the frequency responses of noise; left out: H1");
  command.add_option("--lines", options->tracking.lines, "frequencies of a sweep")
      ->check(CLI::Range(2, 100000))
      ->capture_default_str();
  command.add_option("--cycles", options->tracking.cycles, "periods in a window of a sweep")
      ->check(CLI::Range(1., 10000.))
      ->capture_default_str();
}

} // namespace plica
