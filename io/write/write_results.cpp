#include "io/write/write_results.hpp"

#include "compare/simulated.hpp"
#include "io/report/report.hpp"
#include "io/tables/csv.hpp"
#include "io/tables/deck_load_tables.hpp"
#include "io/tables/json.hpp"
#include "io/tables/levels_csv.hpp"
#include "io/tables/life_csv.hpp"
#include "io/tables/text.hpp"
#include "io/tables/time_csv.hpp"
#include "io/universal/signals.hpp"
#include "io/universal/writer.hpp"
#include "io/write/simulated_yaml.hpp"
#include "io/write/vtu.hpp"
#include "words/directions.hpp"

#include <array>
#include <string>
#include <vector>

namespace plica {
namespace {

std::string responses_uff(const Results& results) {
  std::string text;
  std::vector<FrfSet> sets = responses_to_base(results);
  for (FrfSet& set : responses_to_forces(results)) sets.push_back(std::move(set));
  for (const FrfSet& set : sets)
    for (const UniversalFunction& f : universal_functions(set)) text += universal_text(f);
  return text;
}

void add_response(std::vector<std::string>& names, const std::string& of, bool random) {
  names.push_back("response_" + of + ".csv");
  names.push_back("motion_" + of + ".csv");
  if (random) names.push_back("random_" + of + ".csv");
}

void add_life(const Results& results, OutputFolder& out) {
  out.add("life.csv", life_csv(results));
  out.add("life_duties.csv", life_duties_csv(results));
  out.add("life_meridian.csv", life_meridian_csv(results));
  for (const DutyResult& duty : results.life->duties)
    if (duty.random) out.add(life_density_file(duty.name), life_density_csv(duty));
}

} // namespace

std::vector<std::string> result_files(const Case& data) {
  std::vector<std::string> names{"modes.csv", "static.csv",     "comparison.csv", "variants.csv",
                                 "modes.vtu", "simulated.yaml", "report.html",    "results.json"};
  if (const auto& response = data.analyses.response) {
    for (const int base : response->bases)
      add_response(names, direction_names[std::size_t(base)], response->random.has_value());
    for (const Motion& motion : response->motions)
      add_response(names, "motion_of_" + name_of(motion),
                   response->random.has_value() || motion.random.has_value());
    for (const Force& force : response->forces)
      add_response(names, "force_" + force.name, force.random.has_value());
    for (const Together& together : response->together)
      add_response(names, "together_" + together.name, true);
    if (!response->bases.empty() || !response->forces.empty()) names.emplace_back("responses.uff");
  }
  for (const Transient& transient : data.analyses.transients) {
    names.push_back(transient_file(transient.name));
    if (transient.spectrum) names.push_back(shock_file(transient.name));
  }
  for (const RunUp& run_up : data.analyses.run_ups) {
    names.push_back(run_up_file(run_up.name));
    if (!run_up.table.empty()) names.push_back(run_up_time_file(run_up.name));
  }
  if (!data.analyses.run_ups.empty()) names.emplace_back("crossings.csv");
  if (has_damped_springs(data) || data.analyses.damping.coupled)
    names.emplace_back("complex_modes.csv");
  if (const auto& levels = data.analyses.levels) {
    for (const int base : levels->bases)
      names.push_back(std::string("levels_") + direction_names[std::size_t(base)] + ".csv");
    for (const LevelForce& force : levels->forces)
      names.push_back("levels_force_" + force.name + ".csv");
    names.insert(names.end(), {"level_peaks.csv", "level_joints.csv", "level_backbones.csv"});
  }
  if (data.analyses.stress || (data.analyses.life && !data.analyses.life->strokes.empty()))
    names.insert(names.end(), {"stress.csv", "stress_places.csv", "stress_meridian.csv"});
  if (data.analyses.stress || data.analyses.life) names.emplace_back("stress.vtu");
  if (const auto& life = data.analyses.life) {
    names.insert(names.end(), {"life.csv", "life_duties.csv", "life_meridian.csv"});
    for (const LifeRandom& r : life->random) names.push_back(life_density_file(r.name));
  }
  if (data.analyses.deck_loads) names.emplace_back("deck_loads.csv");
  if (data.analyses.error_bars) names.emplace_back("error_bars.csv");
  return names;
}

void write_results(const Results& results, OutputFolder& out) {
  if (!out.wants("report.html")) return out.add("results.json", results_json(results));
  out.add("modes.csv", modes_csv(results));
  out.add("static.csv", static_csv(results));
  out.add("comparison.csv", comparison_csv(results));
  out.add("variants.csv", variants_csv(results));
  out.add("modes.vtu", modes_vtu(results));
  for (const ResponseResult& r : results.responses) {
    out.add("response_" + response_name(r) + ".csv", response_csv(r));
    out.add("motion_" + response_name(r) + ".csv", motion_csv(r));
    if (r.random) out.add("random_" + response_name(r) + ".csv", random_csv(r));
  }
  for (const TransientResult& t : results.transients) {
    out.add(transient_file(t.name), transient_csv(t));
    if (t.spectra) out.add(shock_file(t.name), shock_csv(t));
  }
  for (const RunUpResult& r : results.run_ups) {
    out.add(run_up_file(r.name), run_up_csv(r));
    if (r.sweeps) out.add(run_up_time_file(r.name), run_up_time_csv(r));
  }
  if (!results.run_ups.empty()) out.add("crossings.csv", crossings_csv(results));
  if (!results.complex_modes.shapes.empty())
    out.add("complex_modes.csv", complex_modes_csv(results));
  for (const LevelResponses& responses : results.level_responses)
    out.add(levels_name(responses) + ".csv", levels_csv(responses));
  if (!results.level_responses.empty()) {
    out.add("level_peaks.csv", level_peaks_csv(results));
    out.add("level_joints.csv", level_joints_csv(results));
    out.add("level_backbones.csv", level_backbones_csv(results));
  }
  if (!results.stresses.empty()) {
    out.add("stress.csv", stress_csv(results));
    out.add("stress_places.csv", stress_places_csv(results));
    out.add("stress_meridian.csv", stress_meridian_csv(results));
  }
  if (!results.stresses.empty() || results.life) out.add("stress.vtu", stress_vtu(results));
  if (results.life) add_life(results, out);
  if (!results.deck_loads.empty()) out.add("deck_loads.csv", deck_loads_csv(results));
  if (!results.error_bars.bars.empty()) out.add("error_bars.csv", error_bars_csv(results));
  out.add("simulated.yaml", simulated_yaml(as_measured(results)));
  if (const std::string text = responses_uff(results); !text.empty())
    out.add("responses.uff", text);
  out.add("report.html", report_html(results));
  out.add("results.json", results_json(results));
}

} // namespace plica
