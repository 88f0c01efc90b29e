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

int main(int argc, char** argv) {
  plica::avoid_faulty_blas_kernels(argv);
  CLI::App app{"Sealed test of plica diagnose"};
  app.require_subcommand(1);
  std::string data, truth, cases = "all", work, require;
  std::uint64_t seed = 1;
  int jobs = 2, first = 0;
  sealed::RunRequest run;
  sealed::ScoreRequest score;

  CLI::App* make = app.add_subcommand("make", "write specimens to one place, the truth to another");
  make->add_option("--data", data, "folder of the data")->required();
  make->add_option("--truth", truth, "folder of the truth")->required();
  make->add_option("--seed", seed, "of all chance");
  make->add_option("--cases", cases,
                   "smoke; all; beams: those of all that need no wall; mounted: on springs, with "
                   "sensors on the ends and between the axes, a level in turn held out; strangers: "
                   "sixty of what the library does not know")
      ->check(CLI::IsMember({"smoke", "all", "beams", "mounted", "strangers"}));
  make->add_option("--jobs", jobs, "specimens at once");
  make->add_option("--first", first, "only so many of them; their order is random");

  CLI::App* diagnose = app.add_subcommand("run", "diagnose every specimen");
  diagnose->add_option("--data", run.data, "folder of the data")->required();
  diagnose->add_option("--plica", run.plica, "the program plica")->required();
  diagnose->add_option("--out", run.out, "folder of the diagnoses")->required();
  diagnose->add_option("--jobs", run.jobs, "diagnoses at once");
  diagnose->add_option("--ablate", run.ablate, "passed on as --without");
  diagnose->add_option("--only", run.only, "one specimen");

  CLI::App* mark = app.add_subcommand("score", "compare the diagnoses with the truth");
  mark->add_option("--data", score.data, "folder of the data")->required();
  mark->add_option("--truth", score.truth, "folder of the truth")->required();
  mark->add_option("--out", score.out, "folder of the diagnoses")->required();
  mark->add_option("--ablation", score.ablations, "NAME=FOLDER of a run with --ablate");
  mark->add_flag("--require", score.require,
                 "fail unless every diagnosis is there and no metric "
                 "that forbids a release is missed");

  CLI::App* check = app.add_subcommand("check", "compare both roads to matrices");
  check->add_option("--work", work, "folder for matrices")->required();
  sealed::SingleRequest single;
  CLI::App* one = app.add_subcommand("specimen", "one specimen of a chosen effect");
  one->add_option("--structure", single.structure, "case it belongs to")->required();
  one->add_option("--effect", single.effect, "effect, or none")->required();
  one->add_option("--strength", single.strength, "weak, medium, strong");
  one->add_option("--variant", single.variant, "which of its places and signs");
  one->add_option("--seed", single.seed, "of all chance");
  one->add_option("--out", single.out, "folder of measured.yaml")->required();
  sealed::ChangesPlan plan;
  CLI::App* make_changes = app.add_subcommand("make-changes", "write specimens before and after");
  make_changes->add_option("--data", data, "folder of the data")->required();
  make_changes->add_option("--truth", truth, "folder of the truth")->required();
  make_changes->add_option("--seed", plan.seed, "of all chance");
  make_changes->add_option("--rounds", plan.rounds, "specimens of each structure and mechanism");
  make_changes->add_flag("--thresholds", plan.thresholds,
                         "of the mechanisms that choose thresholds, not of the others");
  CLI::App* mark_changes = app.add_subcommand("score-changes", "compare with the truth");
  mark_changes->add_option("--truth", truth, "folder of the truth")->required();
  mark_changes->add_option("--out", score.out, "folder of the diagnoses")->required();
  sealed::SetsPlan sets;
  CLI::App* make_sets = app.add_subcommand("make-sets", "write specimens of several effects");
  make_sets->add_option("--data", data, "folder of the data")->required();
  make_sets->add_option("--truth", truth, "folder of the truth")->required();
  make_sets->add_option("--seed", sets.seed, "of all chance");
  make_sets->add_option("--rounds", sets.rounds, "of 15 specimens each")
      ->check(CLI::PositiveNumber);
  make_sets->add_option("--jobs", jobs, "specimens at once");
  sealed::SupposeRequest suppose;
  CLI::App* suppose_sets = app.add_subcommand("suppose-sets", "what the true effects are worth");
  suppose_sets->add_option("--data", suppose.data, "folder of the data")->required();
  suppose_sets->add_option("--truth", suppose.truth, "folder of the truth")->required();
  suppose_sets->add_option("--plica", suppose.plica, "the program plica")->required();
  suppose_sets->add_option("--out", suppose.out, "folder of the diagnoses")->required();
  suppose_sets->add_option("--jobs", suppose.jobs, "specimens at once");
  CLI::App* mark_sets = app.add_subcommand("score-sets", "compare with the truth");
  mark_sets->add_option("--truth", truth, "folder of the truth")->required();
  mark_sets->add_option("--out", score.out, "folder of the diagnoses")->required();
  CLI11_PARSE(app, argc, argv);
  try {
    if (make->parsed()) {
      auto suite = cases == "mounted"     ? sealed::plan_mounted(seed)
                   : cases == "strangers" ? sealed::plan_sixty_strangers(seed)
                                          : sealed::plan_suite(seed, cases == "smoke");
      if (cases == "beams") sealed::keep_beams(suite);
      if (first > 0) sealed::keep_first(suite, first);
      std::printf("%s\n", sealed::make_suite(suite, data, truth, jobs).c_str());
    }
    if (one->parsed()) sealed::make_single(single);
    if (diagnose->parsed()) sealed::run_suite(run);
    if (check->parsed()) sealed::check_roads(work);
    if (make_changes->parsed())
      std::printf("%s\n", sealed::make_changes(plan, data, truth).c_str());
    if (mark_changes->parsed()) return sealed::score_changes(truth, score.out) ? 0 : 2;
    if (make_sets->parsed())
      std::printf("%s\n", sealed::make_suite(sealed::plan_sets(sets), data, truth, jobs).c_str());
    if (suppose_sets->parsed()) return sealed::suppose_sets(suppose) ? 0 : 2;
    if (mark_sets->parsed()) return sealed::score_sets(truth, score.out) ? 0 : 2;
    if (mark->parsed()) return sealed::score_suite(score) ? 0 : 2;
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "plica_sealed: %s\n", error.what());
    return 1;
  }
}
