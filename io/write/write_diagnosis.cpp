#include "io/write/write_diagnosis.hpp"

#include "diagnose/weigh/blocks.hpp"
#include "io/files/json_text.hpp"
#include "io/report/diagnosis.hpp"
#include "io/tables/csv.hpp"
#include "io/tables/diagnosis_words.hpp"
#include "io/tables/effect_words.hpp"
#include "io/tables/ledger_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
Json interval(const std::array<double, 2>& x) {
  return Json::array({json_number(x[0]), json_number(x[1])});
}

template <class List, class Row> Json list_of(const List& list, const Row& row) {
  Json json = Json::array();
  for (const auto& item : list) json.push_back(row(item));
  return json;
}

Json json_of(const NamedEffect& e) {
  Json json{{"name", e.name},
            {"place", e.place},
            {"way", e.way},
            {"value", Json::object()},
            {"interval", Json::object()}};
  for (const EstimatedParameter& p : e.parameters) {
    json["value"][p.name] = json_number(p.value);
    json["interval"][p.name] = interval(p.interval);
  }
  return json;
}

Json named_json(const NamedEffect& e) {
  Json json = json_of(e);
  json["probability"] = json_number(e.probability);
  json["anywhere"] = json_number(e.anywhere);
  json["other_places"] = e.other_places;
  if (e.along)
    json["along"] = {{"value", json_number(e.along->value)},
                     {"interval", interval(e.along->interval)}};
  if (e.within) json["within"] = json_number(*e.within);
  json["unit"] = json["z_of_prior"] = Json::object();
  for (const EstimatedParameter& p : e.parameters) {
    json["unit"][p.name] = p.unit;
    json["z_of_prior"][p.name] = json_number(p.z);
  }
  return json;
}

Json json_of(const Resonator& r) {
  Json json = named_json(r.found);
  for (const char* of_effects : {"probability", "anywhere", "other_places"}) json.erase(of_effects);
  json["what"] = r.words;
  json["gap"] = json_number(r.gap_after);
  json["far_ahead"] = r.is_ahead;
  return json;
}

Json json_of(const EffectInclusion& e) {
  return {{"effect", e.effect},
          {"probability", json_number(e.probability)},
          {"places", list_of(e.places, [](const auto& place) {
             return Json{{"place", place.first}, {"probability", json_number(place.second)}};
           })}};
}

Json json_of(const LedgerRow& row) {
  return {{"what", row_words(row)},
          {"left", row.left ? word_of(*row.left) : ""},
          {"effects", list_of(row.effects, [](const NamedEffect& e) { return named_json(e); })},
          {"share", json_number(row.share)},
          {"interval", interval(row.interval)},
          {"told_apart_by", row.told_apart_by}};
}

Json json_of(const Mimic& m) {
  return {{"a", m.a}, {"b", m.b}, {"cosine", json_number(m.cosine)}};
}

Json json_of(const SmallestDetectable& s) {
  return {{"name", s.name},
          {"place", s.place},
          {"way", s.way},
          {"parameter", s.parameter},
          {"unit", s.unit},
          {"value", json_number(s.at)},
          {"smallest", json_number(s.value)},
          {"noncentrality", json_number(s.noncentrality)}};
}

} // namespace

Json identifiability_json(const Diagnosis& d) {
  Json likeness = Json::array();
  for (Index i = 0; i < d.likeness.rows(); ++i) {
    Json row = Json::array();
    for (Index j = 0; j < d.likeness.cols(); ++j) row.push_back(json_number(d.likeness(i, j)));
    likeness.push_back(std::move(row));
  }
  return {{"effects", d.effect_names},
          {"likeness", likeness},
          {"mimics", list_of(d.mimics, [](const Mimic& m) { return json_of(m); })},
          {"detectable",
           list_of(d.detectable, [](const SmallestDetectable& s) { return json_of(s); })}};
}

Json ledger_json(const Ledger& ledger) {
  return {{"gap", json_number(ledger.gap)},
          {"readings", ledger.readings},
          {"explained", json_number(ledger.explained)},
          {"explained_interval", interval(ledger.explained_interval)},
          {"rows", list_of(ledger.rows, [](const LedgerRow& row) { return json_of(row); })},
          {"left_in", list_of(ledger.left_in, [](const auto& reading) {
             return Json{{"reading", reading.first}, {"share", json_number(reading.second)}};
           })}};
}

namespace {

Json json_of(const LocatedGap& b) {
  Json json = Json::object();
  if (!b.component.empty()) {
    json["component"] = b.component;
    json["z"] = json_number(b.z);
    return json;
  }
  if (!b.direction.empty()) json["direction"] = b.direction;
  if (!b.band.empty()) json["band"] = b.band;
  if (b.level) json["level"] = json_number(b.level);
  json["kind"] = kind_word(b);
  if (!b.state.empty()) json["state"] = b.state;
  json["z"] = json_number(b.z);
  json["significant"] = b.significant;
  return json;
}

Json json_of(const ParameterDrift& d) {
  const auto part = [](const auto& p) {
    return Json{{"part", p.first},
                {"value", json_number(p.second[0])},
                {"sigma", json_number(p.second[1])}};
  };
  return {{"parameter", d.parameter},
          {"by", d.by},
          {"parts", list_of(d.parts, part)},
          {"p", json_number(d.p)}};
}

Json json_of(const GapShrink& g) {
  return {{"before", json_number(g.before)},
          {"after", json_number(g.after)},
          {"shrink", json_number(g.shrink())},
          {"interval", interval(g.interval)},
          {"readings", g.readings}};
}

Json json_of(const TriedHypothesis& h) {
  const bool nominal = h.effects.empty();
  return {{"effects", list_of(h.effects, [](const NamedEffect& e) { return json_of(e); })},
          {"name", nominal ? "none" : h.effects.front().name},
          {"place", nominal ? "" : h.effects.front().place},
          {"log_evidence", json_number(h.log_evidence)},
          {"sampled_log_evidence", json_number(h.sampled_log_evidence)},
          {"log_bayes_factor", json_number(h.log_bayes_factor)},
          {"half_width", json_number(h.half_width)},
          {"double_width", json_number(h.double_width)},
          {"chi2", json_number(h.chi2)},
          {"chi2_of_means", json_number(h.chi2_of_means)},
          {"adequate", h.adequate},
          {"p", json_number(h.share_of_healthy_worse)},
          {"worst_block", h.worst_block},
          {"worst_block_z", json_number(h.worst_block_z)},
          {"gap_after", json_number(h.gap_after)},
          {"heldout_after", json_number(h.held_out_after)},
          {"absurd", h.absurd},
          {"fails_heldout", h.fails_held_out},
          {"rejected", h.rejected},
          {"does_not_follow", h.aside}};
}

Json json_of(const ComparedReading& r) {
  return {{"name", r.name},
          {"unit", r.unit},
          {"measured", json_number(r.measured)},
          {"nominal", json_number(r.nominal)},
          {"best", json_number(r.best)},
          {"second", json_number(r.second)},
          {"sigma", json_number(r.sigma)},
          {"held_out", r.held_out}};
}

Json json_of(const Compensator& c) {
  return {{"name", c.name},
          {"factor", json_number(c.factor)},
          {"prior_sigmas", json_number(c.prior_sigmas)},
          {"gap_after", json_number(c.gap_after)},
          {"heldout_after", json_number(c.held_out_after)},
          {"contradicted_by", c.contradicted_by}};
}

Json json_of(const ProposedMeasurement& m) {
  return {{"what", m.what},
          {"cost", json_number(m.cost)},
          {"change", json_number(m.change)},
          {"about", m.about},
          {"separation", json_number(m.separation)},
          {"separates", m.separates},
          {"resolves", m.resolves}};
}

std::string readings_csv(const Diagnosis& d) {
  std::string text = "reading,unit,measured,nominal,best,second,relative sigma,held out\n";
  for (const ComparedReading& r : d.readings)
    text += fmt::format("{},{},{},{},{},{},{},{}\n", csv_cell(r.name), csv_cell(r.unit),
                        csv_number(r.measured), csv_number(r.nominal), csv_number(r.best),
                        csv_number(r.second), csv_number(r.sigma), r.held_out ? 1 : 0);
  return text;
}

std::string hypotheses_csv(const Diagnosis& d) {
  std::string text =
      "hypothesis,values (SI),ln evidence,sampled ln evidence,ln Bayes factor,with priors half as "
      "wide,with priors twice as wide,chi-square,adequate,p,worst block,its z,gap after,held-out "
      "gap "
      "after,absurd,fails held-out,rejected\n";
  for (const TriedHypothesis& h : d.tried) {
    std::string values;
    for (const NamedEffect& e : h.effects)
      for (const EstimatedParameter& p : e.parameters)
        values += fmt::format("{}{}.{} = {}", values.empty() ? "" : "; ", e.name, p.name, p.value);
    text += csv_cell(hypothesis_label(h)) + "," + csv_cell(values);
    for (const std::optional<double>& x :
         {std::optional(h.log_evidence), h.sampled_log_evidence, std::optional(h.log_bayes_factor),
          std::optional(h.half_width), std::optional(h.double_width), std::optional(h.chi2)})
      text += "," + csv_number(x);
    text += fmt::format(",{},{},{},{},{},{},{},{},{}\n", h.adequate ? 1 : 0,
                        csv_number(h.share_of_healthy_worse), csv_cell(h.worst_block),
                        csv_number(h.worst_block_z), csv_number(h.gap_after),
                        csv_number(h.held_out_after), h.absurd ? 1 : 0, h.fails_held_out ? 1 : 0,
                        csv_cell(h.rejected));
  }
  return text;
}

std::string parameter_cells(const NamedEffect& e, const EstimatedParameter& p) {
  const ShownEstimate shown = shown_estimate(p);
  return fmt::format("{},{},{},{},{},{},{}", csv_cell(e.name), csv_cell(e.place), csv_cell(p.name),
                     csv_number(shown.value), csv_number(shown.interval[0]),
                     csv_number(shown.interval[1]), csv_cell(shown.unit));
}

// A line for each row, so that the shares add up, and the numbers of its effects beside it; what
// does not fit beside it in lines below, without a share.
std::string ledger_csv(const Diagnosis& d) {
  std::string text = "what,share of the gap,share 90 % from,share 90 % to,probability,effect,place,"
                     "parameter,value,value 90 % from,value 90 % to,unit,share left in the "
                     "reading,told apart by\n";
  for (const LedgerRow& row : d.ledger.rows) {
    text += fmt::format("{},{},{},{},{},", csv_cell(row_words(row)), csv_number(row.share),
                        csv_number(row.interval[0]), csv_number(row.interval[1]),
                        row.effects.size() == 1 ? csv_number(row.effects[0].anywhere) : "");
    std::vector<std::string> beside;
    for (const NamedEffect& e : row.effects) {
      for (const EstimatedParameter& p : e.parameters) beside.push_back(parameter_cells(e, p));
      if (e.parameters.empty())
        beside.push_back(csv_cell(e.name) + "," + csv_cell(e.place) + ",,,,,");
    }
    if (beside.empty()) beside.emplace_back(",,,,,,");
    for (std::size_t i = 0; i < beside.size(); ++i)
      text += (i == 0 ? "" : ",,,,,") + beside[i] + ",," +
              (i == 0 ? csv_cell(row.told_apart_by) : "") + "\n";
  }
  for (const auto& [reading, share] : d.ledger.left_in)
    text += fmt::format("{},,,,,,,,,,,,{},\n", csv_cell("left in " + reading), csv_number(share));
  return text;
}

// A line for each effect wherever it sits, and one for each of its places.
std::string inclusion_csv(const Diagnosis& d) {
  std::string text = "effect,place,probability\n";
  for (const EffectInclusion& e : d.inclusion) {
    text += fmt::format("{},anywhere,{}\n", csv_cell(e.effect), csv_number(e.probability));
    for (const auto& [place, probability] : e.places)
      text +=
          fmt::format("{},{},{}\n", csv_cell(e.effect), csv_cell(place), csv_number(probability));
  }
  return text;
}

std::string where_csv(const Diagnosis& d) {
  std::string text = "component,direction,band,level [m/s2],kind,state,z,significant\n";
  for (const LocatedGap& b : d.where)
    text += fmt::format("{},{},{},{},{},{},{},{}\n", csv_cell(b.component), csv_cell(b.direction),
                        csv_cell(b.band), csv_number(b.level), kind_word(b), csv_cell(b.state),
                        csv_number(b.z), b.significant ? 1 : 0);
  return text;
}

} // namespace

std::string diagnosis_json(const Diagnosis& d, const std::string& plica_version) {
  const auto item = [](const auto& x) { return json_of(x); };
  constexpr int version = 2; // of these words: 2 has a ledger; "several" (before: "pair"), "mostly"
  Json json{{"case", d.case_name},
            {"plica_version", plica_version},
            {"version", version},
            {"verdict", verdict_name(d.verdict)},
            {"headline", d.headline}};
  json["effects"] = list_of(d.effects, [](const NamedEffect& e) { return named_json(e); });
  json["ledger"] = ledger_json(d.ledger);
  json["where"] = list_of(d.where, item);
  json["level_trends"] = list_of(d.trends, [](const LevelTrend& t) {
    return Json{{"quantity", t.quantity},
                {"slope", json_number(t.slope)},
                {"sigma", json_number(t.sigma)},
                {"best", json_number(t.best)}};
  });
  json["drifts"] = list_of(d.drifts, item);
  json["gap"] = json_of(d.gap);
  json["gap"]["heldout"] = d.held_out ? json_of(*d.held_out) : Json(nullptr);
  if (d.held_out) json["gap"]["heldout"]["how"] = d.held_out_how;
  json["next_measurement"] = list_of(d.next, item);
  json["advice"] = d.advice;
  json["hypotheses"] = list_of(d.tried, item);
  json["probabilities"] = Json::object();
  for (const auto& [effect, p] : d.probabilities) json["probabilities"][effect] = json_number(p);
  json["inclusion"] = list_of(d.inclusion, item);
  json["readings"] = list_of(d.readings, item);
  json["best"] = d.best ? Json(*d.best) : Json(nullptr); // of hypotheses
  json["resonator"] = d.resonator ? json_of(*d.resonator) : Json(nullptr);
  json["not_tried"] = list_of(d.not_tried, [](const EffectNotTried& e) {
    return Json{{"name", e.name}, {"needs", e.needs}};
  });
  json["baseline"] = {{"readings", list_of(d.baseline.readings, item)},
                      {"model_error", d.baseline.words}};
  json["compensators"] = list_of(d.compensators, item);
  json["identifiability"] = identifiability_json(d);
  json["assumptions"] = d.assumptions;
  json["warnings"] = d.warnings;
  json["basis_error"] = json_number(d.basis_error);
  json["tried"] = d.hypotheses;
  json["evaluations"] = d.evaluations;
  json["seconds"] = json_number(d.seconds);
  return json_text(json);
}

std::vector<std::string> diagnosis_files() {
  return {"diagnosis_ledger.csv",    "diagnosis_readings.csv", "diagnosis_hypotheses.csv",
          "diagnosis_inclusion.csv", "diagnosis_where.csv",    "diagnosis.html",
          "diagnosis.json"};
}

void write_diagnosis(const Diagnosis& d, const std::string& title, const std::string& plica_version,
                     OutputFolder& out) {
  out.add("diagnosis_ledger.csv", ledger_csv(d));
  out.add("diagnosis_readings.csv", readings_csv(d));
  out.add("diagnosis_hypotheses.csv", hypotheses_csv(d));
  out.add("diagnosis_inclusion.csv", inclusion_csv(d));
  out.add("diagnosis_where.csv", where_csv(d));
  out.add("diagnosis.html", diagnosis_html(d, title));
  out.add("diagnosis.json", diagnosis_json(d, plica_version));
}

} // namespace plica
