#include "io/write/write_pretest.hpp"

#include "io/files/json_text.hpp"
#include "io/report/diagnosis_sections.hpp"
#include "io/report/markup.hpp"
#include "io/report/page.hpp"
#include "io/tables/text_table.hpp"
#include "io/write/write_diagnosis.hpp"

#include <fmt/format.h>

namespace plica {
namespace {

// The sections of a diagnosis that need no measurement.
Diagnosis as_diagnosis(const Pretest& p) {
  Diagnosis d;
  d.case_name = p.case_name;
  d.effect_names = p.effects;
  d.likeness = p.likeness;
  d.mimics = p.mimics;
  d.detectable = p.detectable;
  return d;
}

std::string pretest_json(const Pretest& p, const std::string& plica_version) {
  Json json{{"case", p.case_name}, {"plica_version", plica_version}, {"plan", p.plan}};
  json.update(identifiability_json(as_diagnosis(p)));
  json["additions"] = Json::array();
  for (const PlannedAddition& m : p.additions)
    json["additions"].push_back({{"what", m.what}, {"cost", m.cost}, {"gain", m.gain}});
  return json_text(json);
}

std::string additions_html(const Pretest& p) {
  std::vector<HtmlRow> rows;
  double most = 0;
  for (const PlannedAddition& a : p.additions) most = std::max(most, a.gain);
  for (const PlannedAddition& a : p.additions)
    rows.push_back({{html_escape(a.what), html_number(a.gain, 3),
                     bar_svg({.from = 0, .to = a.gain, .high = most}), html_number(a.cost, 2)},
                    ""});
  if (rows.empty()) return "<p>Nothing on the menu tells more apart.</p>\n";
  return html_table(
      "Gain: of how far apart the effects lie, beyond what stands above.",
      {{"measurement", "", false}, {"gain", ""}, {"", "", false}, {"cost", "hours at the rig"}},
      rows);
}

std::string html(const Pretest& p, const std::string& title) {
  const Diagnosis d = as_diagnosis(p);
  std::string sections = html_section("plan", "The planned test", html_list(p.plan));
  sections += html_section("likeness", "What this test could tell apart",
                           likeness_html(d) + detectable_html(d));
  sections += html_section("next", "What to add, in this order", additions_html(p));
  return report_page(title + ": planned test", html_escape(p.case_name), {}, sections);
}

} // namespace

std::string pretest_text(const Pretest& p) {
  std::string text = "Planned: ";
  for (const std::string& line : p.plan) text += (&line == &p.plan.front() ? "" : "; ") + line;
  text += "\n\nLook alike (largest cosine of their signatures; 1 = the same):\n";
  TextRows alike, smallest, additions;
  for (const Mimic& m : p.mimics)
    alike.push_back({fmt::format("{:.2f}", m.cosine), m.a + " and " + m.b});
  text += text_table(alike, "><");
  if (p.mimics.empty()) text += fmt::format("  none by {:g} or more\n", hardly_told_apart);
  text += "\nSmallest that would be found (95 % power), at the place where it shows most:\n";
  for (const std::string& effect : p.effects) {
    const SmallestDetectable* most = nullptr;
    for (const SmallestDetectable& s : p.detectable)
      if (s.name == effect && (!most || s.noncentrality > most->noncentrality)) most = &s;
    if (!most) continue;
    smallest.push_back({effect, most->place + (most->way.empty() ? "" : " (" + most->way + ")"),
                        most->value
                            ? fmt::format("{} {:.3g} {}", most->parameter, *most->value, most->unit)
                            : "not found within its prior"});
  }
  text += text_table(smallest, "<");
  text += "\nWhat to add, in this order:\n";
  for (const PlannedAddition& m : p.additions)
    additions.push_back(
        {m.what, fmt::format("cost {:.1f}", m.cost), fmt::format("gain {:.2f}", m.gain)});
  text += text_table(additions, "<>");
  if (p.additions.empty()) text += "  nothing on the menu tells more apart\n";
  return text;
}

std::vector<std::string> pretest_files() {
  return {"pretest.html", "pretest.json"};
}

void write_pretest(const Pretest& p, const std::string& title, const std::string& plica_version,
                   OutputFolder& out) {
  out.add("pretest.html", html(p, title));
  out.add("pretest.json", pretest_json(p, plica_version));
}

} // namespace plica
