#include "io/tables/summary.hpp"

#include "io/tables/farthest.hpp"
#include "io/tables/levels_csv.hpp"
#include "io/tables/life_words.hpp"
#include "io/tables/state_words.hpp"
#include "io/tables/text.hpp"
#include "io/tables/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace plica {
namespace {

std::string comparison_table(const Results& results) {
  TextRows rows{{"", "unit", "measured", "+/-", "computed", "deviation %", "in sigma"}};
  for (const MeasuredComparison& row : results.comparison) {
    const ShownUnit shown = shown_unit(row.measured, row.unit);
    const int decimals = decimals_of(row, shown.factor);
    const auto fixed = [&](double x) { return fmt::format("{:.{}f}", x * shown.factor, decimals); };
    rows.push_back({row.quantity, shown.unit, fixed(row.measured),
                    row.sigma > 0 ? fixed(row.sigma) : "-", fixed(row.computed),
                    with_sign(100 * relative_deviation(row), 1),
                    with_sign(sigma_deviation(row), 1)});
  }
  return "\nComputed beside measured\n" + text_table(rows, "<<>>>>>");
}

// The largest deviation that is not what the case was given, in one line.
std::string farthest_line(const Results& results) {
  const FarthestOff found = farthest_off(results);
  const MeasuredComparison* row = found.row;
  if (!row) return "";
  const ShownUnit shown = shown_unit(row->measured, row->unit);
  const int decimals = decimals_of(*row, shown.factor);
  return fmt::format("\nFarthest from the test: {}, {:.{}f} {} computed, {:.{}f} measured "
                     "({} %{}); {}\n",
                     row->quantity, row->computed * shown.factor, decimals, shown.unit,
                     row->measured * shown.factor, decimals,
                     with_sign(100 * relative_deviation(*row), 1),
                     row->sigma > 0 ? ", " + with_sign(sigma_deviation(*row), 1) + " sigma" : "",
                     within_words(found, "sigma"));
}

// What the variants make of the compared quantities.
std::string spread_table(const Results& results) {
  if (results.variants.empty() || results.comparison.empty()) return "";
  TextRows rows{{"", "unit", "measured", "computed", "lowest", "highest"}};
  for (const MeasuredComparison& row : results.comparison) {
    const ShownUnit shown = shown_unit(row.measured, row.unit);
    const int decimals = decimals_of(row, shown.factor);
    const auto fixed = [&](double x) { return fmt::format("{:.{}f}", x * shown.factor, decimals); };
    const auto [low, high] = spread_over_variants(results, row);
    rows.push_back({row.quantity, shown.unit, fixed(row.measured), fixed(row.computed), fixed(low),
                    fixed(high)});
  }
  return "\nOver the variants\n" + text_table(rows, "<<>>>>");
}

std::string headline_table(const Results& results) {
  const std::map<std::string, double> numbers = headline(results);
  TextRows rows;
  for (const HeadlineQuantity& quantity : headline_quantities(results)) {
    const auto value = numbers.find(quantity.key);
    if (value == numbers.end()) continue;
    const auto [factor, unit] = shown_unit(value->second, quantity.unit);
    rows.push_back({quantity.name, significant(value->second * factor, 4), unit});
  }
  return "\nComputed\n" + text_table(rows, "<><");
}

// The state, and what it makes of the headline of the part at rest.
std::string state_table(const Results& results) {
  if (!results.state) return "";
  std::string text =
      "\nThe state" + (results.state->name.empty() ? "" : " " + results.state->name) + "\n";
  for (const auto& sentences :
       {state_sentences(*results.state), buckling_sentences(*results.state)})
    for (const std::string& sentence : sentences) text += "  " + sentence + "\n";
  const std::map<std::string, double> numbers = headline(results), rest = headline_at_rest(results);
  TextRows rows{{"", "unit", "at rest", "in the state", "change %"}};
  for (const HeadlineQuantity& quantity : headline_quantities(results)) {
    const auto now = numbers.find(quantity.key), before = rest.find(quantity.key);
    if (now == numbers.end() || before == rest.end()) continue;
    const auto [factor, unit] = shown_unit(before->second, quantity.unit);
    rows.push_back({quantity.name, unit, significant(before->second * factor, 5),
                    significant(now->second * factor, 5),
                    with_sign(100 * (now->second / before->second - 1), 2)});
  }
  return rows.size() == 1 ? text : text + text_table(rows, "<<>>>");
}

// The named states of the case beside one another.
std::string states_table(const Results& results) {
  const std::map<std::string, double> rest = headline_at_rest(results);
  TextRows rows{{""}};
  std::string align = "<";
  std::vector<HeadlineQuantity> shown;
  for (const HeadlineQuantity& quantity : headline_quantities(results))
    if (const auto at_rest = rest.find(quantity.key); at_rest != rest.end()) {
      shown.push_back(quantity);
      rows[0].push_back(quantity.name + ", " + shown_unit(at_rest->second, quantity.unit).unit);
      rows[0].push_back("change %");
      align += ">>";
    }
  const auto add = [&](const std::string& name, const std::map<std::string, double>& numbers) {
    rows.push_back({name});
    for (const HeadlineQuantity& quantity : shown) {
      const auto now = numbers.find(quantity.key);
      const double before = rest.at(quantity.key),
                   factor = shown_unit(before, quantity.unit).factor;
      const bool known = now != numbers.end();
      rows.back().push_back(known ? significant(now->second * factor, 5) : "-");
      rows.back().push_back(known ? with_sign(100 * (now->second / before - 1), 2) : "-");
    }
  };
  add(variant_at_rest, rest);
  for (const VariantResult& variant : results.variants)
    if (variant.state) add(variant.name, variant.headline);
  if (rows.size() == 2) return "";
  std::string text = "\nStates, their change against the part at rest\n" + text_table(rows, align);
  for (const VariantResult& variant : results.variants) {
    if (!variant.state) continue;
    text += "  " + variant.name + "\n";
    for (const auto& sentences :
         {state_sentences(*variant.state), buckling_sentences(*variant.state)})
      for (const std::string& sentence : sentences) text += "    " + sentence + "\n";
  }
  return text;
}

std::string error_table(const Results& results) {
  const ErrorBars& errors = results.error_bars;
  if (errors.bars.empty()) return "";
  TextRows rows{{"", "unit", "computed", "mesh along %", "around %"}};
  const bool reduced = results.reduced.has_value();
  if (reduced) rows[0].push_back("cut-off %");
  rows[0].insert(rows[0].end(), {"90 % interval", ""});
  for (const HeadlineQuantity& quantity : headline_quantities(results))
    for (const ErrorBar& bar : errors.bars) {
      if (bar.key != quantity.key) continue;
      const auto [factor, unit] = shown_unit(bar.value, quantity.unit);
      const auto fixed = [&, f = factor](double x) { return significant(x * f, 4); };
      rows.push_back({quantity.name, unit, fixed(bar.value),
                      errors.along ? with_sign(100 * bar.mesh.along / bar.value, 2) : "-",
                      errors.around ? with_sign(100 * bar.mesh.around / bar.value, 2) : "-"});
      if (reduced) rows.back().push_back(with_sign(100 * bar.mesh.cutoff / bar.value, 2));
      rows.back().push_back(
          bar.interval ? fixed((*bar.interval)[0]) + " to " + fixed((*bar.interval)[1]) : "-");
      rows.back().push_back(shares_text(errors, bar));
    }
  return "\nError bars: still missing for want of mesh; from the tolerances of the case\n" +
         text_table(rows, reduced ? "<<>>>>><" : "<<>>>><") +
         (errors.interaction > 0
              ? fmt::format("  all tolerances at once: {} % off the sum of their effects\n",
                            significant(100 * errors.interaction, 2))
              : "");
}

std::string statics_table(const Results& results) {
  if (!results.statics) return "";
  const std::vector<MeshError>& errors = results.error_bars.statics;
  TextRows rows{{"", "", "unit"}};
  if (!errors.empty()) rows[0].push_back("mesh %");
  for (std::size_t i = 0; i < stiffness_names.size(); ++i) {
    const double value = results.statics->all()[i];
    const auto [factor, unit] = shown_unit(value, stiffness_unit(i));
    rows.push_back({stiffness_names[i], significant(value * factor, 4), unit});
    if (!errors.empty()) rows.back().push_back(mesh_error_percent(value, errors[i]));
  }
  return "\nStatic stiffness\n" + text_table(rows, errors.empty() ? "<><" : "<><>");
}

std::string peaks_table(const Results& results) {
  TextRows rows{{"", "sensor", "Hz", "amplitude", "phase deg", "damping %"}};
  for (const ResponseResult& r : results.responses)
    for (const ResponsePeak& p : r.peaks)
      rows.push_back({response_title(r),
                      r.channels[p.channel].first + " " + r.channels[p.channel].second,
                      fmt::format("{:.1f}", p.frequency), significant(p.amplitude, 3),
                      fmt::format("{:.0f}", p.phase * 180 / std::numbers::pi),
                      significant(100 * p.damping, 3)});
  return rows.size() == 1 ? "" : "\nPeaks of the response\n" + text_table(rows, "<<>>>>");
}

// The channel that a random input moves most, with its 3 sigma.
std::string random_table(const Results& results) {
  TextRows rows{{"", "sensor", "RMS m/s2", "3 sigma"}};
  for (const ResponseResult& r : results.responses) {
    if (!r.random || r.channels.empty()) continue;
    Eigen::Index c = 0;
    const double rms = r.random->bands[0].rms.maxCoeff(&c);
    const auto& [sensor, axis] = r.channels[std::size_t(c)];
    rows.push_back(
        {response_title(r), sensor + " " + axis, significant(rms, 3), significant(3 * rms, 3)});
  }
  return rows.size() == 1 ? "" : "\nLargest random motion\n" + text_table(rows, "<<>>");
}

// The largest difference of each response from its direct solution.
std::string direct_text(const Results& results) {
  std::string text;
  for (const ResponseResult& r : results.responses) {
    if (r.direct.empty()) continue;
    const DirectCheck worst = farthest(r.direct);
    text += fmt::format("{}{}: {} % at {:.1f} Hz, of {} frequencies\n", text.empty() ? "" : "  ",
                        response_title(r), significant(100 * worst.difference, 2), worst.frequency,
                        r.direct.size());
  }
  return text.empty() ? "" : "\nLargest difference from the direct solution\n  " + text;
}

std::string transients_table(const Results& results) {
  TextRows rows{{"", "input", "sensor", "peak m/s2", "at ms", "RMS m/s2"}};
  for (const TransientResult& t : results.transients)
    for (int c : t.shown) {
      const auto& [sensor, axis] = t.channels[std::size_t(c)];
      const Extreme& peak = t.extremes[std::size_t(c)];
      rows.push_back({t.name, t.input_title, sensor + " " + axis, significant(peak.value, 4),
                      significant(1e3 * peak.time, 4), significant(t.rms[c], 3)});
    }
  return rows.size() == 1 ? "" : "\nTransients\n" + text_table(rows, "<<<>>>");
}

std::string crossings_table(const Results& results) {
  TextRows rows{{"", "rpm", "order", "mode", "Hz", "sensor", "m/s2"}};
  const bool in_time = std::any_of(results.run_ups.begin(), results.run_ups.end(),
                                   [](const RunUpResult& r) { return r.sweeps.has_value(); });
  if (in_time) rows[0].push_back("in time");
  for (const RunUpResult& r : results.run_ups)
    for (const OrderCrossing& c : r.crossings) {
      const auto& [sensor, axis] = r.channels[std::size_t(c.channel)];
      rows.push_back({r.name, fmt::format("{:.0f}", 60 * c.speed), significant(c.order, 3),
                      mode_label(results.modes[std::size_t(c.mode)]),
                      fmt::format("{:.1f}", c.frequency), sensor + " " + axis,
                      significant(c.amplitude, 3)});
      if (in_time) rows.back().push_back(c.reached ? significant(*c.reached, 3) : "-");
    }
  return rows.size() == 1
             ? ""
             : "\nOrders through modes\n" + text_table(rows, in_time ? "<>><><>>" : "<>><><>");
}

std::string levels_table(const Results& results) {
  std::string text;
  for (const LevelResponses& responses : results.level_responses) {
    const auto& [sensor, axis] = responses.channels[std::size_t(responses.strongest)];
    TextRows rows{{responses.unit, "up Hz", "down Hz", "amplitude", "half power %", "by energy %"}};
    const auto first = [&](const std::vector<LevelPeak>& peaks) {
      return std::find_if(peaks.begin(), peaks.end(),
                          [&](const LevelPeak& p) { return p.channel == responses.strongest; });
    };
    for (const LevelCurve& c : responses.curves) {
      const auto up = first(c.peaks_up), down = first(c.peaks_down);
      if (up == c.peaks_up.end()) continue;
      rows.push_back({significant(c.level, 4), fmt::format("{:.1f}", up->frequency),
                      down == c.peaks_down.end() ? "-" : fmt::format("{:.1f}", down->frequency),
                      significant(up->amplitude, 3), significant(100 * up->damping, 3),
                      significant(100 * up->energy_damping, 3)});
    }
    text += fmt::format("\n{}: first peak of {} {} over the level\n", levels_title(responses),
                        sensor, axis) +
            text_table(rows, ">>>>>>");
  }
  return text;
}

std::string modes_table(const Results& results) {
  const ProofWords words = proof_words(results.verification);
  const std::string proof = "\n" + words.verdict + words.rest + "\n";
  if (results.modes.empty())
    return results.verification.made ? "\nModes\n  none in the band asked for\n" + proof : "";
  TextRows rows{{"", "Hz", "shape", "mass x %", "y %", "z %", "residual"}};
  const std::vector<MeshError>& errors = results.error_bars.modes;
  if (!errors.empty()) rows[0].push_back("mesh %");
  int count = 0;
  for (const ModeResult& mode : results.modes) {
    std::vector<std::string> row{std::to_string(++count), fmt::format("{:.2f}", mode.frequency),
                                 mode_label(mode)};
    for (std::size_t i = 0; i < 3; ++i) {
      const double share = mode.effective_mass[i] / results.free_mass[i];
      row.push_back(std::isfinite(share) ? fmt::format("{:.1f}", 100 * share) : "-");
    }
    row.push_back(significant(mode.residual, 2));
    if (!errors.empty()) row.push_back(mesh_error_percent(mode, errors[rows.size() - 1]));
    rows.push_back(std::move(row));
  }
  return "\nModes\n" + text_table(rows, errors.empty() ? ">><>>>>" : ">><>>>>>") + proof;
}

} // namespace

std::string summary_text(const Results& results, const std::filesystem::path& report) {
  std::string text = results.case_name;
  if (!results.title.empty()) text += ": " + results.title;
  if (!results.modelled_as.empty()) text += " (as " + results.modelled_as + ")";
  text += fmt::format("\n{} elements, {} nodes, {} unknowns, {} kg\n",
                      grouped(results.model.elements, " "), grouped(results.model.nodes, " "),
                      grouped(results.model.dofs, " "), significant(results.model.mass, 4));
  if (!results.mesh_choice.empty()) text += "Mesh " + results.mesh_choice + "\n";
  if (!results.route.empty()) text += "Solved by " + results.route + "\n";
  text += results.comparison.empty() ? headline_table(results)
                                     : farthest_line(results) + comparison_table(results);
  text += state_table(results) + states_table(results) + spread_table(results) +
          error_table(results) + statics_table(results) + modes_table(results) +
          peaks_table(results) + direct_text(results) + random_table(results) +
          transients_table(results) + crossings_table(results) + levels_table(results) +
          stress_summary(results) + life_summary(results);
  for (const std::string& remark : results.unanswered) text += "\nNot in this model: " + remark;
  if (!results.unanswered.empty()) text += "\n";
  for (const std::string& warning : results.warnings) text += "\nWarning: " + warning;
  if (!results.warnings.empty()) text += "\n";
  if (!report.empty()) text += "\nReport: " + report.string() + "\n";
  return text;
}

} // namespace plica
