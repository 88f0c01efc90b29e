#include "io/report/report.hpp"

#include "io/report/deck_loads.hpp"
#include "io/report/levels.hpp"
#include "io/report/markup.hpp"
#include "io/report/page.hpp"
#include "io/report/picture.hpp"
#include "io/report/profile.hpp"
#include "io/report/response.hpp"
#include "io/report/state.hpp"
#include "io/report/stress.hpp"
#include "io/report/superelements.hpp"
#include "io/report/tables.hpp"
#include "io/report/time_histories.hpp"
#include "io/report/viewer.hpp"
#include "io/tables/farthest.hpp"
#include "io/tables/text.hpp"

#include <filesystem>
#include <fmt/format.h>

namespace plica {
namespace {

std::string head_html(const Results& results) {
  const std::string title = results.title.empty() ? results.case_name : results.title;
  std::string html =
      fmt::format("<h1>{}</h1>\n<p class=\"case\">Case <code>{}</code>, "
                  "Plica {}</p>\n",
                  html_escape(title),
                  html_escape(results.case_name +
                              (results.modelled_as.empty() ? "" : ", " + results.modelled_as)),
                  html_escape(results.plica_version));
  html += farthest_html(results);
  if (!results.modes.empty()) {
    Verification verification = results.verification;
    verification.reason = html_escape(verification.reason);
    const ProofWords proof = proof_words(verification, html_number);
    const bool is_good = verification.made && verification.passed;
    html += fmt::format("<p class=\"verdict{}\"><b>{}&nbsp;{}</b>{}</p>\n", is_good ? "" : " open",
                        is_good ? "✓" : "!", proof.verdict, proof.rest);
  }
  return html;
}

// The mode that shows what is farthest from the test.
std::optional<std::size_t> farthest_mode(const Results& results) {
  const FarthestOff found = farthest_off(results);
  return found.row ? mode_that_shows(results, *found.row) : std::nullopt;
}

// What is seen without scrolling: the verdicts above, the part in the mode that shows what is
// farthest from the test, its numbers and the warnings.
std::string first_screen_html(const Results& results) {
  std::string words = numbers_html(results);
  if (!results.warnings.empty())
    words += "<div class=\"warnings\"><b>Warnings</b>\n" + html_list(results.warnings) + "</div>\n";
  const std::string picture = part_viewer(results, part_picture(results), farthest_mode(results));
  if (picture.empty()) return words;
  return "<div class=\"answer first\">\n<div>" + picture + "</div>\n<div>" + words +
         "</div>\n</div>\n";
}

// The files as they were read, folded.
std::string inputs_html(const Results& results) {
  std::string html;
  for (const InputFile& file : results.inputs)
    html += fmt::format("<details><summary>{}</summary>\n<pre>{}</pre></details>\n",
                        html_escape(std::filesystem::path(file.name).filename().string()),
                        html_escape(file.text));
  return html;
}

} // namespace

std::string report_html(const Results& results) {
  const std::string title = results.title.empty() ? results.case_name : results.title;
  std::string html =
      html_section("comparison", "Computed beside measured", comparison_html(results));
  html += html_section("state", results.state ? "The state" : "States", state_html(results));
  html += html_section("errors", "Error bars", error_bars_html(results));
  html += html_section("statics", "Static stiffness", statics_html(results));
  html += html_section("deck_loads", "Loads of the deck", deck_loads_html(results));
  html += html_section("part", "The profile", profile_drawing(results));
  html += html_section("superelements", "Superelements", superelements_html(results));
  html += html_section("modes", "Modes", modes_html(results) + mode_pictures(results));
  html += html_section("response", "Response", responses_html(results));
  html += html_section("transients", "Transients", transients_html(results));
  html += html_section("run_ups", "Orders of the engine", run_ups_html(results));
  html += html_section("levels", "Response over the level", levels_html(results));
  html += html_section("stress", "Stress", stresses_html(results));
  html += html_section("life", "Life", life_html(results));
  html += html_section("variants", "What the assumed quantities do",
                       variants_html(results) + variants_comparison_html(results));
  html += html_section("assumptions", "Assumptions", html_list(results.assumptions));
  html += html_section("inputs", "Inputs", inputs_html(results));
  html += "<div class=\"pair\">\n" + html_section("model", "Model and mesh", model_html(results));
  html += html_section("timing", "Time and memory", timing_html(results)) + "</div>\n";
  html += fmt::format("<footer>Plica {}{}. SI units unless a column says otherwise; y along the "
                      "pipe, x transverse, z vertical.</footer>\n",
                      html_escape(results.plica_version),
                      results.versions.empty() ? "" : " with " + html_escape(results.versions));
  return html_page(title + ": Plica report", head_html(results) + first_screen_html(results), html);
}

} // namespace plica
