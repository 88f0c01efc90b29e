// All that a case asks of one run of it, in the order in which it is made: the case itself, once
// more where its own modes need a finer mesh; the test beside it; error bars and intervals of
// lives; the case at rest where it has a state; its named states; its variants, each with the test
// beside its numbers.
//
//   WholeRun done = whole_run({.data = data, .variants = variants, .test = &test});
//   if (done.results.verification.passed) ...
#pragma once

#include "lab/measured/test_data.hpp"
#include "mesh/generation/worker.hpp"
#include "model/description/case.hpp"
#include "run/analyses/seen_enough.hpp"
#include "run/results/results.hpp"
#include "run/stages.hpp"

#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace plica {

struct WholeRunRequest {
  Case data;
  std::vector<Case> variants = {};           // data with what each of data.variants sets
  const TestData* test = nullptr;            // none: nothing was measured
  std::vector<std::string> assumptions = {}; // said behind those of the case
  bool error_bars = true;                    // where the case asks for them
  bool others = true;                        // the case at rest, named states, variants
  Shapes shapes = Shapes::kept;              // with error bars they are kept
  // What the warning of what is left out says of its error; throws nothing. Empty: its what().
  std::function<std::string(const std::exception_ptr&)> words = {};
};

// What begins: a stage, of which case, and the share of all the work that lies behind, 0 to 1.
struct RunStep {
  std::string of; // name of the case, with that of a variant "bellow_a2, height 7 mm"
  Stage stage;
  double done = 0;
};

struct WholeRun {
  Results results;
  bool states_found = true; // false: a named state has no equilibrium
  // Where it was stopped, once the case itself was finished: all that was finished before stands.
  std::optional<Interrupted> stopped = {};
  double done = 1; // share of the work: the rest is left for writing the results
};

// Throws what run() throws, of the case itself alone: what fails after it is left out, with a
// warning in the results. Throws std::invalid_argument where `variants` are not as many as those of
// the data. `step` may throw Interrupted, which ends the work (WholeRun::stopped); while the case
// itself runs it passes through.
WholeRun whole_run(
    WholeRunRequest request, const std::function<void(const RunStep&)>& step = [](const auto&) {});

} // namespace plica
