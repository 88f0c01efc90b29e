// plica_sealed: makes specimens with known causes, has them diagnosed, and scores the verdicts.
//   plica_sealed make  --data D --truth T --seed S [--cases smoke|all|beams|mounted|strangers]
//                      [--first N]
//   plica_sealed run   --data D --plica build/app/plica --out O [--ablate form]
//   plica_sealed score --data D --truth T --out O [--require]
//   plica_sealed check --work W
//   plica_sealed make-changes  --data D --truth T --seed S [--rounds N] [--thresholds]
//   plica_sealed score-changes --truth T --out O
//   plica_sealed make-sets    --data D --truth T --seed S [--rounds 20]
//   plica_sealed suppose-sets --data D --truth T --plica build/app/plica --out O
//   plica_sealed score-sets   --truth T --out O
//   plica_sealed specimen --structure bolted_lap --effect damping --strength weak --out FOLDER
#include "changes/changes.hpp"
#include "files.hpp"
#include "sets/sets.hpp"
#include "solve/blas_kernels.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <memory>

namespace {

// A word of the command line and what it has done.
struct Command {
  CLI::App* words = nullptr;
  std::function<int()> work; // its exit code
};

int two_unless(bool good) {
  return good ? 0 : 2;
}

struct MakeRequest {
  std::string data, truth, cases = "all";
  std::uint64_t seed = 1;
  int jobs = 2, first = 0;
};

int make_cases(const MakeRequest& r) {
  auto suite = r.cases == "mounted"     ? sealed::plan_mounted(r.seed)
               : r.cases == "strangers" ? sealed::plan_sixty_strangers(r.seed)
                                        : sealed::plan_suite(r.seed, r.cases == "smoke");
  if (r.cases == "beams") sealed::keep_beams(suite);
  if (r.first > 0) sealed::keep_first(suite, r.first);
  std::printf("%s\n", sealed::make_suite(suite, r.data, r.truth, r.jobs).c_str());
  return 0;
}

Command make_command(CLI::App& app) {
  const auto r = std::make_shared<MakeRequest>();
  CLI::App* make = app.add_subcommand("make", "write specimens to one place, the truth to another");
  make->add_option("--data", r->data, "folder of the data")->required();
  make->add_option("--truth", r->truth, "folder of the truth")->required();
  make->add_option("--seed", r->seed, "of all chance");
  make->add_option("--cases", r->cases,
                   "smoke; all; beams: those of all that need no wall; mounted: on springs, with "
                   "sensors on the ends and between the axes, a level in turn held out; strangers: "
                   "sixty of what the library does not know")
      ->check(CLI::IsMember({"smoke", "all", "beams", "mounted", "strangers"}));
  make->add_option("--jobs", r->jobs, "specimens at once");
  make->add_option("--first", r->first, "only so many of them; their order is random");
  return {make, [r] { return make_cases(*r); }};
}

Command run_command(CLI::App& app) {
  const auto r = std::make_shared<sealed::RunRequest>();
  CLI::App* run = app.add_subcommand("run", "diagnose every specimen");
  run->add_option("--data", r->data, "folder of the data")->required();
  run->add_option("--plica", r->plica, "the program plica")->required();
  run->add_option("--out", r->out, "folder of the diagnoses")->required();
  run->add_option("--jobs", r->jobs, "diagnoses at once");
  run->add_option("--ablate", r->ablate, "passed on as --without");
  run->add_option("--only", r->only, "one specimen");
  return {run, [r] {
            sealed::run_suite(*r);
            return 0;
          }};
}

Command score_command(CLI::App& app) {
  const auto r = std::make_shared<sealed::ScoreRequest>();
  CLI::App* score = app.add_subcommand("score", "compare the diagnoses with the truth");
  score->add_option("--data", r->data, "folder of the data")->required();
  score->add_option("--truth", r->truth, "folder of the truth")->required();
  score->add_option("--out", r->out, "folder of the diagnoses")->required();
  score->add_option("--ablation", r->ablations, "NAME=FOLDER of a run with --ablate");
  score->add_flag("--require", r->require,
                  "fail unless every diagnosis is there and no metric "
                  "that forbids a release is missed");
  return {score, [r] { return two_unless(sealed::score_suite(*r)); }};
}

Command check_command(CLI::App& app) {
  const auto work = std::make_shared<std::string>();
  CLI::App* check = app.add_subcommand("check", "compare both roads to matrices");
  check->add_option("--work", *work, "folder for matrices")->required();
  return {check, [work] {
            sealed::check_roads(*work);
            return 0;
          }};
}

Command specimen_command(CLI::App& app) {
  const auto r = std::make_shared<sealed::SingleRequest>();
  CLI::App* one = app.add_subcommand("specimen", "one specimen of a chosen effect");
  one->add_option("--structure", r->structure, "case it belongs to")->required();
  one->add_option("--effect", r->effect, "effect, or none")->required();
  one->add_option("--strength", r->strength, "weak, medium, strong");
  one->add_option("--variant", r->variant, "which of its places and signs");
  one->add_option("--seed", r->seed, "of all chance");
  one->add_option("--out", r->out, "folder of measured.yaml")->required();
  return {one, [r] {
            sealed::make_single(*r);
            return 0;
          }};
}

template <class Plan> struct Planned {
  Plan plan;
  std::string data, truth;
  int jobs = 2;
};

Command make_changes_command(CLI::App& app) {
  const auto r = std::make_shared<Planned<sealed::ChangesPlan>>();
  CLI::App* make = app.add_subcommand("make-changes", "write specimens before and after");
  make->add_option("--data", r->data, "folder of the data")->required();
  make->add_option("--truth", r->truth, "folder of the truth")->required();
  make->add_option("--seed", r->plan.seed, "of all chance");
  make->add_option("--rounds", r->plan.rounds, "specimens of each structure and mechanism");
  make->add_flag("--thresholds", r->plan.thresholds,
                 "of the mechanisms that choose thresholds, not of the others");
  return {make, [r] {
            std::printf("%s\n", sealed::make_changes(r->plan, r->data, r->truth).c_str());
            return 0;
          }};
}

Command make_sets_command(CLI::App& app) {
  const auto r = std::make_shared<Planned<sealed::SetsPlan>>();
  CLI::App* make = app.add_subcommand("make-sets", "write specimens of several effects");
  make->add_option("--data", r->data, "folder of the data")->required();
  make->add_option("--truth", r->truth, "folder of the truth")->required();
  make->add_option("--seed", r->plan.seed, "of all chance");
  make->add_option("--rounds", r->plan.rounds, "of 15 specimens each")->check(CLI::PositiveNumber);
  make->add_option("--jobs", r->jobs, "specimens at once");
  return {make, [r] {
            const auto suite = sealed::plan_sets(r->plan);
            std::printf("%s\n", sealed::make_suite(suite, r->data, r->truth, r->jobs).c_str());
            return 0;
          }};
}

Command suppose_sets_command(CLI::App& app) {
  const auto r = std::make_shared<sealed::SupposeRequest>();
  CLI::App* suppose = app.add_subcommand("suppose-sets", "what the true effects are worth");
  suppose->add_option("--data", r->data, "folder of the data")->required();
  suppose->add_option("--truth", r->truth, "folder of the truth")->required();
  suppose->add_option("--plica", r->plica, "the program plica")->required();
  suppose->add_option("--out", r->out, "folder of the diagnoses")->required();
  suppose->add_option("--jobs", r->jobs, "specimens at once");
  return {suppose, [r] { return two_unless(sealed::suppose_sets(*r)); }};
}

// Of a suite that needs its truth and its diagnoses alone.
Command score_of_truth_command(CLI::App& app, const std::string& name,
                               bool (*score)(const std::filesystem::path& truth,
                                             const std::filesystem::path& out)) {
  struct Folders {
    std::filesystem::path truth, out;
  };
  const auto r = std::make_shared<Folders>();
  CLI::App* mark = app.add_subcommand(name, "compare with the truth");
  mark->add_option("--truth", r->truth, "folder of the truth")->required();
  mark->add_option("--out", r->out, "folder of the diagnoses")->required();
  return {mark, [r, score] { return two_unless(score(r->truth, r->out)); }};
}

} // namespace

int main(int argc, char** argv) {
  plica::avoid_faulty_blas_kernels(argv);
  CLI::App app{"Sealed test of plica diagnose"};
  app.require_subcommand(1);
  const Command commands[] = {make_command(app),
                              run_command(app),
                              score_command(app),
                              check_command(app),
                              specimen_command(app),
                              make_changes_command(app),
                              score_of_truth_command(app, "score-changes", sealed::score_changes),
                              make_sets_command(app),
                              suppose_sets_command(app),
                              score_of_truth_command(app, "score-sets", sealed::score_sets)};
  CLI11_PARSE(app, argc, argv);
  try {
    for (const Command& command : commands)
      if (command.words->parsed()) return command.work();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "plica_sealed: %s\n", error.what());
    return 1;
  }
}
