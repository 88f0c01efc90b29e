#include "app/chosen_case.hpp"
#include "app/finish.hpp"
#include "app/interrupt.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "compare/compare.hpp"
#include "io/files/tree_path.hpp"
#include "io/input/measured_file.hpp"
#include "io/tables/json.hpp"
#include "io/tables/result_path.hpp"
#include "io/write/write_sweep.hpp"
#include "lab/measured/states.hpp"
#include "run/results/number_keys.hpp"
#include "run/study/variant_runs.hpp"
#include "solve/jobs.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <fmt/core.h>
#include <set>

namespace plica {
namespace {

struct SweepOptions {
  ChosenCase chosen;
  Output out;
  SweepRequest request;
  std::vector<std::string> results; // paths of results.json; none: the headline
  int jobs = 0;
  int shard = 1, shards = 1;
  bool collect = false; // run nothing: the table of what was run
};

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// What modes and static stiffness answer: all else is run as the case asks.
bool is_headline(const std::string& result) {
  static const std::set<std::string> sections{"headline", "static", "modes", "model",
                                              "verification"};
  static const std::set<std::string> beyond{"damping", "damped_frequency", "place", "label"};
  const std::vector<TreeStep> steps = steps_of(result);
  return !steps.empty() && sections.contains(steps.front().key) &&
         std::none_of(steps.begin(), steps.end(), [](const TreeStep& step) {
           return beyond.contains(step.key) ||
                  number_key::kind_of(step.key) == NumberKind::stress_range;
         });
}

// What was wrong, without the name of the file, which is the same in every row.
std::string reason_of(const std::exception& error) {
  const auto* input = dynamic_cast<const InputError*>(&error);
  if (!input) return error.what();
  std::string text;
  for (InputProblem p : input->problems()) {
    p.file.clear();
    p.line = 0;
    text += (text.empty() ? "" : "\n") + to_string(p);
  }
  return text;
}

class Sweep {
public:
  Sweep(const SweepOptions& options, const TestedCase& tested)
      : options_(options), file_(tested.file), plan_(sweep_plan(file_, options.request)),
        changed_(file_), measured_(tested.test),
        runs_(std::all_of(options.results.begin(), options.results.end(), is_headline)) {
    const CaseFile& file = file_;
    std::string same = std::string("plica ") + PLICA_VERSION + "\n" + file.text + file.data.model;
    std::vector<std::filesystem::path> inputs = files_of(file);
    if (measured_)
      for (std::filesystem::path& path : files_of(*measured_)) inputs.push_back(std::move(path));
    std::error_code none;
    for (const std::filesystem::path& input : inputs)
      same += "\n" + fingerprint_of(std::filesystem::canonical(input, none));
    for (const auto& [path, value] : file.set) same += "\n" + path + "=" + value;
    for (const std::string& result : options.results) same += "\n" + result;
    for (int i = 0; i < plan_.variants; ++i) {
      std::string own = same;
      for (const auto& [path, value] : changes_of(plan_, i)) own += "\n" + path + "=" + value;
      keys_.push_back(fingerprint(own));
    }
  }

  std::vector<std::filesystem::path> inputs() const { return files_of(file_); }

  // Variants of this shard that no record has.
  std::vector<int> left(const SweepRecords& known) const {
    std::vector<int> numbers;
    for (int i = options_.shard - 1; i < plan_.variants; i += options_.shards)
      if (!known.contains(keys_[std::size_t(i)])) numbers.push_back(i);
    return numbers;
  }

  void run(const std::vector<int>& numbers, SweepJournal& journal, Progress& progress) {
    const Clock::time_point start = Clock::now();
    Clock::time_point said = start;
    std::mutex mutex;
    int done = 0, failed = 0;
    progress.stage(fmt::format("{} of {} variants", numbers.size(), plan_.variants));
    in_jobs(static_cast<int>(numbers.size()), options_.jobs, [&](int k) {
      const int variant = numbers[std::size_t(k)];
      const SweepRecord record = one(variant);
      const std::lock_guard lock(mutex);
      journal.add(keys_[std::size_t(variant)], record);
      ++done;
      failed += record.failure.empty() ? 0 : 1;
      constexpr double between = 1;
      if (seconds_since(said) < between && done < static_cast<int>(numbers.size())) return;
      said = Clock::now();
      progress.share(double(done) / double(numbers.size()));
      progress.stage(fmt::format("{} of {} variants, {} failed", done, numbers.size(), failed));
    });
  }

  SweepTable table(const SweepRecords& records) const {
    SweepTable table{
        .case_name = file_.data.name, .plan = plan_, .results = options_.results, .rows = {}};
    for (const std::string& key : keys_) {
      const auto found = records.find(key);
      table.rows.emplace_back();
      if (found != records.end()) table.rows.back() = found->second;
    }
    return table;
  }

private:
  SweepRecord one(int variant) {
    const Clock::time_point start = Clock::now();
    SweepRecord record;
    try {
      const Replacements changes = changes_of(plan_, variant);
      record.values =
          values_of(runs_.run(changed_.with(changes), changes, [](const std::string& s) {
            if (is_interrupted()) throw Interrupted{s};
          }));
    } catch (const std::exception& error) {
      record.failure = reason_of(error);
      if (record.failure.empty()) record.failure = "no reason is known";
    }
    record.seconds = seconds_since(start);
    return record;
  }

  std::vector<std::pair<std::string, double>> values_of(Results results) const {
    if (results.verification.made && !results.verification.passed)
      throw std::runtime_error("the proof failed: " + results.verification.reason);
    std::vector<std::pair<std::string, double>> values;
    if (options_.results.empty()) {
      for (const auto& [name, value] : headline(results)) values.emplace_back(name, value);
      return values;
    }
    const auto asks_for = [&](const char* section) {
      return std::any_of(options_.results.begin(), options_.results.end(),
                         [&](const std::string& path) { return path.starts_with(section); });
    };
    if (measured_ && asks_for("comparison"))
      results.comparison = compare(results, measured_as_drawn(measured_->data));
    const Json json = Json::parse(results_json(results));
    for (const std::string& path : options_.results)
      if (const auto value = number_in(json, path)) values.emplace_back(path, *value);
    return values;
  }

  const SweepOptions& options_;
  const CaseFile& file_;
  SweepPlan plan_;
  ChangedCases changed_;
  std::optional<MeasuredFile> measured_;
  VariantRuns runs_;
  std::vector<std::string> keys_; // of a variant: all that its results depend on
};

void warn_of_gaps(const SweepTable& table) {
  for (const std::string& result : table.results) {
    std::size_t ok = 0, without = 0;
    for (const auto& row : table.rows) {
      if (!row || !row->failure.empty()) continue;
      ++ok;
      without += std::none_of(row->values.begin(), row->values.end(),
                              [&](const auto& value) { return value.first == result; });
    }
    if (without > 0)
      say_warning(fmt::format("{} of {} variants have no number at {} of their results", without,
                              ok, result));
  }
}

// Other shards may be writing theirs.
int write_table(const SweepOptions& options, const Sweep& sweep) {
  std::vector<std::string> damaged;
  constexpr std::chrono::milliseconds wait{200};
  for (int tries = 300; true; --tries) {
    try {
      OutputFolder out(options.out.folder,
                       {.command = "sweep", .inputs = sweep.inputs(), .names = sweep_files()});
      const SweepTable table = sweep.table(read_journals(options.out.folder, damaged));
      for (const std::string& name : damaged)
        say_warning(name + " has lines that cannot be read: their variants run again");
      write_sweep(table, out);
      hand_over(out);
      warn_of_gaps(table);
      const SweepCounts counts = counts_of(table);
      if (counts.missing > 0) say(sweep_text(table, options.shards));
      if (!options.out.quiet)
        print(fmt::format("{}Table: {}\n", sweep_text(table, options.shards),
                          (out.path() / "sweep.csv").string()));
      if (counts.ok > 0 || counts.failed == 0) return 0;
      const auto first = std::find_if(table.rows.begin(), table.rows.end(),
                                      [](const auto& row) { return row.has_value(); });
      say_failure("plica: every variant failed, the first for: " + (*first)->failure);
      return 1;
    } catch (const FolderInUse&) {
      if (tries == 0) throw;
      std::this_thread::sleep_for(wait);
    }
  }
}

int sweep_case(const SweepOptions& options) {
  const TestedCase tested = read_tested_case(options.chosen);
  Sweep sweep(options, tested);
  if (options.collect) return write_table(options, sweep);
  bool interrupted = false;
  {
    SweepJournal journal(options.out.folder, options.shard, options.shards);
    std::vector<std::string> damaged;
    const std::vector<int> left = sweep.left(read_journals(options.out.folder, damaged));
    Progress progress(options.out.quiet);
    progress.title(
        tested.file.data.name +
        (options.shards > 1 ? fmt::format(", shard {}/{}", options.shard, options.shards) : ""));
    try {
      if (!left.empty()) sweep.run(left, journal, progress);
    } catch (const Interrupted&) { // what was finished is in the journal
      interrupted = true;
      forget_interrupt();
    }
    progress.finish();
  }
  const int code = write_table(options, sweep);
  return interrupted ? interrupted_exit() : code;
}

void add_shard(CLI::App& command, SweepOptions& options) {
  const auto read = [](const std::string& text, int& shard, int& shards) {
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) return false;
    const char* end = text.data() + text.size();
    const auto [middle, first] = std::from_chars(text.data(), end, shard);
    if (first != std::errc() || middle != text.data() + slash) return false;
    const auto [last, second] = std::from_chars(middle + 1, end, shards);
    return second == std::errc() && last == end && shard >= 1 && shard <= shards;
  };
  command
      .add_option_function<std::string>(
          "--shard",
          [&options, read](const std::string& text) { read(text, options.shard, options.shards); },
          "run the i-th of n shares of the variants, as one of n processes or jobs that share "
          "--out")
      ->check(CLI::Validator(
          [read](std::string& text) -> std::string {
            int shard = 0, shards = 0;
            return read(text, shard, shards) ? "" : "'" + text + "' is no share such as 2/8";
          },
          ""))
      ->type_name("I/N");
}

} // namespace

void add_sweep_command(CommandLine& line) {
  const auto options = std::make_shared<SweepOptions>();
  CLI::App& command = line.add("sweep", "many variants of a case into one table",
                               [options] { return sweep_case(*options); });
  add_case(command, options->chosen);
  SweepRequest& request = options->request;
  command
      .add_option("--vary", request.vary,
                  "a number or value of the case: PATH=LOW:HIGH, of a grid PATH=LOW:HIGH:STEPS, "
                  "either with :log; PATH=A,B,C; again for more")
      ->allow_extra_args(false)
      ->type_name("PATH=VALUES");
  command
      .add_option("--table", request.table,
                  "CSV in place of --vary: a column a path, a row a variant")
      ->type_name("FILE");
  add_choice(
      command, "--design", request.design,
      {{"grid", SweepDesign::grid}, {"latin", SweepDesign::latin}, {"sobol", SweepDesign::sobol}},
      "all combinations (grid), a Latin hypercube or a Sobol sequence; left out: grid");
  command.add_option("--count", request.count, "variants of a Latin hypercube or Sobol sequence")
      ->check(CLI::Range(1, 1000000));
  command.add_option("--seed", request.seed, "of a Latin hypercube")->capture_default_str();
  command
      .add_option("--result", options->results,
                  "a number of results.json, e.g. modes[0].frequency or "
                  "responses[base=y].peaks[0].amplitude; again for more; left out: mass, axial "
                  "stiffness, first modes")
      ->allow_extra_args(false)
      ->check(CLI::Validator([](std::string& path) { return bad_result_path(path); }, ""))
      ->type_name("PATH");
  command
      .add_option("--jobs", options->jobs,
                  "variants at a time, each on one core, 0 = as many as cores; 1: one after the "
                  "other on all cores")
      ->check(CLI::Range(0, 1024));
  add_shard(command, *options);
  command.add_flag("--collect", options->collect,
                   "run nothing: write the table of what was run, and say what is missing");
  add_folder(command, options->out);
}

} // namespace plica
