#include "io/tables/json.hpp"

#include "io/files/json_text.hpp"
#include "io/files/manifest.hpp"
#include "io/tables/deck_load_tables.hpp"
#include "io/tables/levels_json.hpp"
#include "io/tables/life_json.hpp"
#include "io/tables/state_words.hpp"
#include "io/tables/text.hpp"
#include "io/tables/time_json.hpp"

#include <cmath>

namespace plica {
namespace {

template <class Numbers> Json numbers(const Numbers& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(json_number(value));
  return list;
}

Json named_numbers(const std::map<std::string, double>& values) {
  Json object = Json::object();
  for (const auto& [name, value] : values) object[name] = json_number(value);
  return object;
}

Json json_of(const StaticStiffness& k) {
  Json matrix = Json::array();
  for (int row = 0; row < 12; ++row) {
    Json entries = Json::array();
    for (int column = 0; column < 12; ++column) {
      entries.push_back(json_number(k.end_stiffness(row, column)));
    }
    matrix.push_back(std::move(entries));
  }
  return {{"k_axial", json_number(k.k_axial)},
          {"k_transverse",
           {{"x", json_number(k.k_transverse_x)}, {"z", json_number(k.k_transverse_z)}}},
          {"k_bending", {{"x", json_number(k.k_bending_x)}, {"z", json_number(k.k_bending_z)}}},
          {"k_torsion", json_number(k.k_torsion)},
          {"end_stiffness", std::move(matrix)}};
}

Json json_of(const ModeResult& mode) {
  return {{"frequency", json_number(mode.frequency)},
          {"damping", json_number(mode.damping)},
          {"damped_frequency",
           mode.damped_frequency ? json_number(*mode.damped_frequency) : Json(nullptr)},
          {"effective_mass", numbers(mode.effective_mass)},
          {"shape", mode.shape},
          {"direction", mode.direction},
          {"order", mode.order > 0 ? Json(mode.order) : Json(nullptr)},
          {"place", mode.place},
          {"harmonic", mode.harmonic >= 0 ? Json(mode.harmonic) : Json(nullptr)},
          {"label", mode_label(mode)},
          {"residual", json_number(mode.residual)}};
}

Json json_of(const Verification& v) {
  return {{"made", v.made},
          {"sigma_frequency", v.made ? json_number(v.sigma_frequency) : Json(nullptr)},
          {"inertia_count", v.made ? Json(v.inertia_count) : Json(nullptr)},
          {"found", v.found},
          {"max_residual", json_number(v.max_residual)},
          {"orthogonality", json_number(v.orthogonality)},
          {"rounding", json_number(v.rounding)},
          {"passed", v.passed},
          {"reason", v.reason}};
}

Json json_of(const MeasuredComparison& row) {
  return {{"quantity", row.quantity},
          {"unit", row.unit},
          {"measured", json_number(row.measured)},
          {"sigma", row.sigma > 0 ? json_number(row.sigma) : Json(nullptr)},
          {"computed", json_number(row.computed)},
          {"deviation", json_number(relative_deviation(row))},
          {"deviation_sigmas", json_number(sigma_deviation(row))}};
}

Json json_of(const VariantResult& variant) {
  Json set = Json::object();
  for (const auto& [path, value] : variant.set) set[path] = value;
  Json comparison = Json::array();
  for (const MeasuredComparison& row : variant.comparison) comparison.push_back(json_of(row));
  Json json{{"name", variant.name},
            {"set", std::move(set)},
            {"headline", named_numbers(variant.headline)},
            {"comparison", comparison}};
  if (variant.state) json["state"] = state_json(*variant.state);
  return json;
}

Json json_of(const SensorResult& sensor) {
  return {{"name", sensor.name}, {"node", sensor.node}, {"distance", json_number(sensor.distance)}};
}

Json json_of(const MeshQuality& quality) {
  return {{"max_warp", json_number(quality.max_warp)},
          {"max_aspect", json_number(quality.max_aspect)},
          {"mean_aspect", json_number(quality.mean_aspect)},
          {"min_jacobian", json_number(quality.min_jacobian)}};
}

Json json_of(const RandomResult& random, const ResponseResult& r) {
  Json bands = Json::array();
  for (const BandRms& b : random.bands) {
    Json rms = Json::array();
    for (std::size_t c = 0; c < r.channels.size(); ++c)
      rms.push_back({{"sensor", r.channels[c].first},
                     {"direction", r.channels[c].second},
                     {"value", json_number(b.rms[Eigen::Index(c)])}});
    bands.push_back({{"band", numbers(b.band)}, {"input", json_number(b.input)}, {"rms", rms}});
  }
  Json tones = Json::array();
  for (const ToneResult& t : random.tones) {
    Json channels = Json::array();
    for (std::size_t c = 0; c < r.channels.size(); ++c)
      channels.push_back({{"sensor", r.channels[c].first},
                          {"direction", r.channels[c].second},
                          {"frequency", json_number(t.frequency[Eigen::Index(c)])},
                          {"sine", json_number(t.sine[Eigen::Index(c)])},
                          {"rms", json_number(t.rms[Eigen::Index(c)])}});
    tones.push_back({{"band", numbers(t.band)},
                     {"amplitude", json_number(t.amplitude)},
                     {"channels", channels}});
  }
  return {{"file", "random_" + response_name(r) + ".csv"}, {"bands", bands}, {"tones", tones}};
}

Json json_of(const ResponseResult& r) {
  Json peaks = Json::array();
  for (const ResponsePeak& p : r.peaks)
    peaks.push_back({{"sensor", r.channels[p.channel].first},
                     {"direction", r.channels[p.channel].second},
                     {"frequency", json_number(p.frequency)},
                     {"amplitude", json_number(p.amplitude)},
                     {"phase", json_number(p.phase)},
                     {"damping", json_number(p.damping)}});
  Json direct = Json::array();
  for (const DirectCheck& check : r.direct)
    direct.push_back({{"frequency", json_number(check.frequency)},
                      {"difference", json_number(check.difference)}});
  const auto named = [&](Source source) {
    return r.source == source ? Json(r.excitation) : Json(nullptr);
  };
  return {{"base", named(Source::base)},
          {"motion", named(Source::ends)},
          {"force", named(Source::force)},
          {"together", named(Source::together)},
          {"level", json_number(r.level)},
          {"file", "response_" + response_name(r) + ".csv"},
          {"motion_file", "motion_" + response_name(r) + ".csv"},
          {"peaks", peaks},
          {"direct", direct},
          {"random", r.random ? json_of(*r.random, r) : Json(nullptr)}};
}

Json json_of(const StressResult& s) {
  return {{"kind", word_of(s.kind)},
          {"name", s.name},
          {"von_mises", json_number(s.largest)},
          {"at", s.face.empty() ? Json(nullptr) : numbers(s.at)},
          {"face", s.face},
          {"beam_axial", json_number(s.largest_beam)},
          {"beam_at", s.largest_beam > 0 ? numbers(s.beam_at) : Json(nullptr)}};
}

Json json_of(const Reduced& reduced) {
  Json list = Json::array();
  for (const SuperelementResult& s : reduced.superelements)
    list.push_back({{"parts", s.parts},
                    {"between", s.between},
                    {"boundary", s.boundary},
                    {"modes", s.modes},
                    {"unknowns", s.unknowns},
                    {"copy_of", s.copy_of > 0 ? Json(s.copy_of) : Json(nullptr)},
                    {"route", s.route},
                    {"proved", s.proved}});
  return {{"cutoff", json_number(reduced.cutoff)},
          {"unknowns", reduced.unknowns},
          {"superelements", list}};
}

Json json_of(const ErrorBars& errors) {
  Json list = Json::array();
  for (const ErrorBar& bar : errors.bars) {
    Json shares = Json::object();
    for (std::size_t i = 0; i < bar.shares.size(); ++i)
      shares[errors.tolerances[i]] = json_number(bar.shares[i]);
    list.push_back({{"quantity", bar.key},
                    {"value", json_number(bar.value)},
                    {"mesh_along", json_number(bar.mesh.along)},
                    {"mesh_around", json_number(bar.mesh.around)},
                    {"cutoff", json_number(bar.mesh.cutoff)},
                    {"interval_90", bar.interval ? numbers(*bar.interval) : Json(nullptr)},
                    {"shares", shares}});
  }
  return {{"quantities", list}, {"interaction", json_number(errors.interaction)}};
}

template <class Item> Json list_of(const std::vector<Item>& items) {
  Json list = Json::array();
  for (const Item& item : items) list.push_back(json_of(item));
  return list;
}

// In the unit of the number; null where it is not known.
Json json_of(const MeshError& error) {
  return {{"along", json_number(error.along)},
          {"around", json_number(error.around)},
          {"cutoff", json_number(error.cutoff)}};
}

void add_mesh_errors(Json& list, const std::vector<MeshError>& errors) {
  for (std::size_t i = 0; i < errors.size(); ++i) list[i]["mesh_error"] = json_of(errors[i]);
}

// In the order of StaticStiffness::all().
Json stiffness_errors(const std::vector<MeshError>& e) {
  return {{"k_axial", json_of(e[0])},
          {"k_transverse", {{"x", json_of(e[1])}, {"z", json_of(e[2])}}},
          {"k_bending", {{"x", json_of(e[3])}, {"z", json_of(e[4])}}},
          {"k_torsion", json_of(e[5])}};
}

// Paths from the folder of results; the case came first. What was taken of a binary file has no
// text, and so no fingerprint.
Json inputs_json(const Results& r) {
  const auto read = [](const InputFile& file) -> Json {
    return {{"file", file.name},
            {"fingerprint", file.text.empty() ? Json(nullptr) : Json(fingerprint(file.text))}};
  };
  return {{"case", r.inputs.empty() ? Json(nullptr) : read(r.inputs.front())},
          {"measured", r.inputs.size() < 2 ? Json(nullptr) : read(r.inputs[1])}};
}

} // namespace

// What tables of many runs take comes first, what grows with the mesh last: a reader may stop
// there.
std::string results_json(const Results& r) {
  Json json;
  json["case"] = r.case_name;
  json["title"] = r.title;
  json["modelled_as"] = r.modelled_as.empty() ? "parts" : r.modelled_as;
  json["plica_version"] = r.plica_version;
  json["model"] = {{"nodes", r.model.nodes},
                   {"elements", r.model.elements},
                   {"dofs", r.model.dofs},
                   {"mass", json_number(r.model.mass)},
                   {"mesh_choice", r.mesh_choice.empty() ? Json(nullptr) : Json(r.mesh_choice)}};
  json["route"] = r.route;
  json["headline"] = named_numbers(headline(r));
  json["modes"] = list_of(r.modes);
  add_mesh_errors(json["modes"], r.error_bars.modes);
  json["verification"] = json_of(r.verification);
  if (r.reduced) json["reduction"] = json_of(*r.reduced);
  if (r.state) json["state"] = state_json(*r.state);
  json["static"] = r.statics ? json_of(*r.statics) : Json(nullptr);
  if (r.statics && !r.error_bars.statics.empty())
    json["static"]["mesh_error"] = stiffness_errors(r.error_bars.statics);
  if (!r.deck_loads.empty()) json["deck_loads"] = deck_loads_json(r);
  for (const StrokeCurve& c : r.strokes) // [m, N]
    json["static_curves"].push_back({{"direction", c.direction}, {"points", c.points}});
  if (!r.complex_modes.shapes.empty() || !r.complex_modes.reason.empty())
    json["complex_modes"] = {
        {"complete", r.complex_modes.complete},
        {"oscillating", r.complex_modes.oscillating},
        {"overdamped", r.complex_modes.overdamped},
        {"reason", r.complex_modes.reason},
        {"file", r.complex_modes.shapes.empty() ? Json(nullptr) : Json("complex_modes.csv")}};
  json["responses"] = list_of(r.responses);
  if (!r.transients.empty()) json["transients"] = transients_json(r);
  if (!r.run_ups.empty()) json["run_ups"] = run_ups_json(r);
  if (r.slipping) json["slipping"] = slipping_json(*r.slipping);
  if (!r.level_responses.empty()) json["levels"] = levels_json(r);
  json["stresses"] = list_of(r.stresses);
  add_mesh_errors(json["stresses"], r.error_bars.stresses);
  json["error_bars"] = json_of(r.error_bars);
  json["comparison"] = list_of(r.comparison);
  json["unanswered"] = r.unanswered;
  json["inputs"] = inputs_json(r);
  json["variants"] = list_of(r.variants);
  json["free_mass"] = numbers(r.free_mass);
  json["effective_mass_sum"] = numbers(r.effective_mass_sum);
  json["sensors"] = list_of(r.sensors);
  json["mesh_quality"] = json_of(r.quality);
  json["assumptions"] = r.assumptions;
  json["warnings"] = r.warnings;
  json["timing"] = named_numbers(r.timing);
  json["peak_memory"] = json_number(r.peak_memory);
  if (!r.stress_tables.empty()) json["stress_places"] = stress_places_json(r);
  if (r.life) json["life"] = life_json(r);
  return json_text(json);
}

} // namespace plica
