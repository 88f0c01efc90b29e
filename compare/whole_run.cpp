#include "compare/whole_run.hpp"

#include "compare/compare.hpp"
#include "lab/measured/states.hpp"
#include "run/analyses/run.hpp"
#include "run/study/error_bars.hpp"
#include "run/study/life_intervals.hpp"
#include "run/study/refine.hpp"
#include "run/study/run_shares.hpp"

#include <algorithm>
#include <fmt/core.h>
#include <stdexcept>

namespace plica {
namespace {

using Set = std::vector<std::pair<std::string, std::string>>; // path, new value

// Work of a stage of the error bars, in runs for the headline: finer meshes cost more, those of
// tolerances are coarse.
double work_of(const Stage& stage) {
  if (stage.kind == stages::finer_along) return 2;
  if (stage.kind == stages::finer_around) return 1.5;
  return stage.kind == stages::tolerance_of ? 0.6 : 0.3;
}

// What is run, and its work, counted in runs for the headline; the first does more.
struct Plan {
  explicit Plan(const WholeRunRequest& request)
      : bars(request.error_bars && request.data.analyses.error_bars),
        shapes(bars ? Shapes::kept : request.shapes), at_rest(request.others && request.data.state),
        states(request.others ? request.data.states.size() : 0),
        variants(request.others ? request.data.variants.size() : 0) {
    const double tolerances = double(request.data.tolerances.size());
    of_bars = bars ? 3.5 + (tolerances > 0 ? 0.6 + 0.6 * tolerances : 0) : 0;
    all = first + of_bars + double(variants + states) + (at_rest ? 1 : 0) + writing;
  }

  bool bars;
  Shapes shapes; // error bars find the modes of finer meshes by them
  bool at_rest;
  std::size_t states, variants;
  double first = 1.5, of_bars = 0, writing = 0.1, all = 0;
};

class Work {
public:
  Work(WholeRunRequest request, const std::function<void(const RunStep&)>& step)
      : request_(std::move(request)), step_(step), plan_(request_) {
    if (plan_.variants > 0 && request_.variants.size() != plan_.variants)
      throw std::invalid_argument(fmt::format("{} cases for the {} variants that '{}' names",
                                              request_.variants.size(), plan_.variants,
                                              request_.data.name));
  }

  WholeRun run_all() {
    WholeRun whole{.results = run_resolved()};
    whole.done = 1 - plan_.writing / plan_.all;
    for (const std::string& words : request_.assumptions)
      whole.results.assumptions.push_back(words);
    if (request_.test) add_test(whole.results);
    try {
      if (plan_.bars) add_error_bars(whole.results);
      add_life_intervals(request_.data, whole.results);
      add_others(whole);
    } catch (const Interrupted& stop) {
      whole.stopped = stop;
    }
    return whole;
  }

private:
  // The case on a mesh that resolves the waves around of its own modes, where one chosen by an
  // accuracy does not: once more, with its variants on the same.
  Results run_resolved() {
    Results results = run_itself(request_.data);
    const int waves = unresolved_waves(request_.data, results);
    if (waves == 0) return results;
    try {
      Case finer = resolving(request_.data, waves);
      const int elements = results.model.elements;
      results = run_itself(finer);
      results.mesh_choice =
          fmt::format("refined around for modes of {} waves, from {} elements", waves, elements);
      std::vector<Case> variants;
      for (const Case& variant : request_.variants) variants.push_back(resolving(variant, waves));
      request_.data = std::move(finer);
      request_.variants = std::move(variants);
    } catch (const std::exception& error) { // the first run is good
      results.warnings.push_back(fmt::format("not refined for modes of {} waves around, which miss "
                                             "the accuracy: {}",
                                             waves, words_of(error)));
    }
    return results;
  }

  Results run_itself(const Case& data) const {
    RunShares shares(data);
    return run(
        data,
        [&](const Stage& stage) {
          tell(data.name, stage, plan_.first / plan_.all * shares.at(stage));
        },
        nullptr, plan_.shapes);
  }

  void add_test(Results& results) const {
    const TestData& test = *request_.test;
    results.comparison = compare(results, test.data);
    results.unanswered = unanswered(results, test.data);
    add_test_curves(results, test);
    for (std::string& warning : warnings_of(test)) results.warnings.push_back(std::move(warning));
    for (const std::string& caveat : test.data.caveats)
      results.assumptions.push_back("Measurement: " + caveat);
  }

  void add_error_bars(Results& results) const {
    const Case& data = request_.data;
    double done = plan_.first;
    try {
      results.error_bars = error_bars(data, results, [&](const Stage& stage) {
        tell(data.name, stage, done / plan_.all);
        done += work_of(stage);
      });
      if (const std::string beyond = beyond_accuracy(data, results); !beyond.empty())
        results.warnings.push_back(beyond);
    } catch (const std::exception& error) { // the run itself is good
      results.warnings.push_back(std::string("error bars left out: ") + error.what());
    }
  }

  void add_others(WholeRun& whole) const {
    const Case& data = request_.data;
    double done = plan_.first + plan_.of_bars;
    const auto add = [&](const Case& changed, const std::string& name, Set set) {
      const double share = done / plan_.all;
      done += 1;
      try {
        whole.results.variants.push_back(run_variant(changed, name, std::move(set), share));
      } catch (const std::exception& error) {
        const bool is_state = changed.state && !changed.state->name.empty();
        whole.states_found = whole.states_found && !is_state;
        whole.results.warnings.push_back((is_state ? "state '" : "variant '") + name +
                                         "' left out: " + words_of(error));
      }
    };
    if (plan_.at_rest) {
      Case rest = data;
      rest.state.reset();
      rest.states.clear();
      add(rest, variant_at_rest, {{"state", "none"}});
    }
    for (std::size_t i = 0; i < plan_.states; ++i) {
      const std::string& name = data.states[i].name;
      add(in_state(data, name), name, {{"state", "states." + name}});
    }
    for (std::size_t i = 0; i < plan_.variants; ++i) {
      const Variant& variant = data.variants[i];
      add(request_.variants[i], variant.name, {variant.set.begin(), variant.set.end()});
    }
  }

  VariantResult run_variant(const Case& changed, const std::string& name, Set set,
                            double done) const {
    const std::string of = request_.data.name + ", " + name;
    const Results results = run(
        request_.test ? for_comparison(changed) : for_headline(changed),
        [&](const Stage& stage) { tell(of, stage, done); }, nullptr, Shapes::left_out);
    VariantResult result{
        .name = name, .set = std::move(set), .headline = headline(results), .comparison = {}};
    if (request_.test) result.comparison = compare(results, request_.test->data);
    if (results.state && !results.state->name.empty()) result.state = results.state;
    return result;
  }

  // Of an error that is being handled.
  std::string words_of(const std::exception& error) const {
    return request_.words ? request_.words(std::current_exception()) : error.what();
  }

  // A case that is run once more on a finer mesh does not begin anew.
  void tell(const std::string& of, const Stage& stage, double done) const {
    behind_ = std::max(behind_, done);
    step_({.of = of, .stage = stage, .done = behind_});
  }

  WholeRunRequest request_;
  const std::function<void(const RunStep&)>& step_;
  const Plan plan_;
  mutable double behind_ = 0; // largest share that was told
};

} // namespace

WholeRun whole_run(WholeRunRequest request, const std::function<void(const RunStep&)>& step) {
  return Work(std::move(request), step).run_all();
}

} // namespace plica
