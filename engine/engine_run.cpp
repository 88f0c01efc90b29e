#include "engine/engine_run.hpp"

#include "app/chosen_case.hpp"
#include "app/finish.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "engine/engine_route.hpp"
#include "engine/shared_direct.hpp"
#include "io/tables/summary.hpp"
#include "io/write/write_results.hpp"
#include "mesh/machine_memory.hpp"
#include "run/analyses/run_by_route.hpp"
#include "run/study/refine.hpp"

#include <fmt/core.h>

namespace plica {
namespace {

// What goes wrong on a rank, and what the program then returns.
struct Trouble {
  std::string text;
  std::function<void()> say;
  int exit_code = 0;
};

// Of work that ranks do each for itself.
template <class F> Trouble trouble_of(F&& work) {
  const auto failed = [](const std::string& text, int code) {
    return Trouble{text, [text] { say_failure("plica-mpi: " + text); }, code};
  };
  try {
    work();
  } catch (const InputError& error) {
    return {error.what(), [error] { say_problems(error); }, 1};
  } catch (const TooLarge& error) {
    return failed(error.what(), 4);
  } catch (const std::exception& error) {
    return failed(error.what(), 3);
  }
  return {};
}

// 0: every rank is well. Else the exit code, what is wrong being said once.
int agree(const Ranks& ranks, const Trouble& own) {
  const std::vector<std::string> all = ranks.everyones(own.text);
  std::vector<int> code{own.exit_code};
  if (ranks.first() && own.exit_code != 0) own.say();
  for (std::size_t r = 0; r < all.size(); ++r)
    if (!all[r].empty()) {
      if (all[0].empty()) end_all(fmt::format("rank {}: {}", r, all[r]), 1);
      break;
    }
  return ranks.broadcast(code).front();
}

// What the engine does not do is refused before anything is meshed.
void require_known(const Case& data) {
  std::vector<InputProblem> problems;
  const auto refuse = [&](bool asked, const std::string& key, const std::string& what,
                          const std::string& allowed) {
    if (asked)
      problems.push_back(
          {.file = "", .line = 0, .key = key, .wrong = "the engine " + what, .allowed = allowed});
  };
  const Analyses& a = data.analyses;
  refuse(data.state.has_value(), "state", "does not find states under load",
         "plica run, or a case at rest");
  refuse(has_friction(data), "parts", "has no joints with friction",
         "plica run, or joints without friction");
  refuse(a.levels && !(a.levels->bases.empty() && a.levels->forces.empty()), "analyses.levels",
         "has no responses at levels", "plica run");
  refuse(a.life.has_value(), "analyses.life", "counts no life", "plica run");
  refuse(a.symmetry == Symmetry::required && !a.reduction, "analyses.symmetry",
         "solves the full mesh and uses no symmetry", "automatic or off, or a reduction");
  if (!problems.empty()) throw InputError(problems);
}

// What a case asks for besides that the engine leaves to `plica run`.
std::vector<std::string> left_out(const Case& data) {
  std::vector<std::string> words;
  const auto leave = [&](bool asked, const std::string& what) {
    if (asked) words.push_back("the engine runs the case itself; left to plica run: " + what);
  };
  leave(!data.variants.empty(), "its variants");
  leave(!data.states.empty(), "its named states");
  leave(data.analyses.error_bars, "error bars");
  return words;
}

class EngineRun {
public:
  EngineRun(const EngineOptions& options, const Ranks& ranks) : options_(options), ranks_(ranks) {}

  int run() {
    if (const int code = agree(ranks_, trouble_of([&] { read(); }))) return code;
    return ranks_.first() ? lead() : follow();
  }

private:
  void read() {
    file_ = read_case(options_.chosen);
    located(file_, [&] { require_known(file_.data); });
    if (!ranks_.first()) return;
    out_.emplace(options_.out.folder, OutputWork{.command = "run",
                                                 .inputs = files_of(file_),
                                                 .names = result_files(file_.data),
                                                 .json_only = options_.out.json_only});
  }

  EngineSettings settings() {
    EngineSettings s;
    s.mumps.workspace = options_.workspace;
    s.mumps.megabytes = options_.megabytes;
    if (ranks_.first() && !options_.out.quiet)
      s.log = [](const std::string& words) { say("  " + words + "\n"); };
    return s;
  }

  int follow() {
    for (;;) {
      std::optional<BuiltCase> built;
      const Trouble trouble = trouble_of([&] { built.emplace(build(file_.data)); });
      if (!agree_on_model(ranks_, built ? &*built : nullptr, trouble.text))
        return ranks_.broadcast(std::vector<int>{}).front(); // of tell_next()
      serve(file_.data, *built, ranks_, settings());
      built.reset();
      // The exit code, or the waves around that a finer mesh is to resolve.
      const std::vector<int> next = ranks_.broadcast(std::vector<int>{});
      if (next[1] == 0) return next[0];
      file_.data = resolving(file_.data, next[1]);
    }
  }

  int lead() {
    Progress progress(options_.out.quiet);
    progress.title(file_.data.name);
    int code = 0;
    const Trouble trouble = trouble_of([&] {
      Results results = run_once(progress);
      if (const int waves = unresolved_waves(file_.data, results); waves > 0) {
        const int elements = results.model.elements;
        tell_next(0, waves);
        file_.data = resolving(file_.data, waves);
        results = run_once(progress);
        results.mesh_choice =
            fmt::format("refined around for modes of {} waves, from {} elements", waves, elements);
      }
      code = write(results, progress);
    });
    if (trouble.exit_code != 0) {
      progress.finish();
      trouble.say();
      code = trouble.exit_code;
      if (!agreed_) agree_on_model(ranks_, nullptr, trouble.text);
    }
    tell_next(code, 0);
    return code;
  }

  void tell_next(int code, int waves) { ranks_.broadcast(std::vector<int>{code, waves}); }

  Results run_once(Progress& progress) {
    agreed_ = false;
    const StageListener stage = [&](const std::string& s) { progress.stage(s); };
    const EngineSettings own = settings();
    return located(file_, [&] {
      const RouteChoice route = [&](const BuiltCase& built, const SeenCase* seen,
                                    const Analyses& analyses, const StageListener& listener,
                                    Timing& timing) {
        agreed_ = true;
        agree_on_model(ranks_, &built, "");
        return engine_route(built, seen, analyses, ranks_, own, listener, timing);
      };
      return run_by_route(file_.data, stage, {.route = route, .direct = direct_over_ranks(ranks_)},
                          options_.out.json_only ? Shapes::left_out : Shapes::kept);
    });
  }

  int write(Results& results, Progress& progress) {
    results.plica_version = PLICA_VERSION;
    results.versions = PLICA_ENGINE_LIBRARIES;
    results.inputs.push_back(
        {std::filesystem::proximate(file_.path, out_->path()).generic_string(), file_.text});
    for (std::string& words : left_out(file_.data)) results.warnings.push_back(std::move(words));
    for (std::string& words : set_by_hand(file_)) results.assumptions.push_back(std::move(words));
    progress.stage("writing " + options_.out.folder.string());
    write_results(results, *out_);
    hand_over(*out_);
    progress.finish();
    if (!options_.out.quiet)
      print(summary_text(results, out_->shown("report.html", "results.json")));
    if (results.verification.made && !results.verification.passed) {
      say_failure(fmt::format("plica-mpi: the proof failed: {}", results.verification.reason));
      return 2;
    }
    return 0;
  }

  const EngineOptions& options_;
  const Ranks& ranks_;
  CaseFile file_;
  std::optional<OutputFolder> out_;
  bool agreed_ = false;
};

} // namespace

int run_over_ranks(const EngineOptions& options, const Ranks& ranks) {
  return EngineRun(options, ranks).run();
}

} // namespace plica
