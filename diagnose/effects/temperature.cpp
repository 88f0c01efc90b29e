#include "diagnose/effects/beam_stiffness.hpp"
#include "diagnose/effects/in_state.hpp"
#include "model/description/place_keys.hpp"
#include "model/description/steels.hpp"

#include <algorithm>

namespace plica {
namespace {

constexpr double modulus_per_kelvin = -3.6e-4; // austenitic steel, room temperature to 300 C
constexpr double damping_per_kelvin = 5e-3;    // relative

// A laboratory's. A test that is hot or cold says so (`diagnose: priors` of the case).
constexpr double laboratory = 10; // K

double damping_at(double delta_T) {
  return std::max(0.1, 1 + damping_per_kelvin * delta_T);
}

Hypothesis warmer() {
  return {.effect = "temperature",
          .place = "all",
          .way = "",
          .parameters = {{"delta_T", "K", {PriorKind::normal, 0, 100, -laboratory, laboratory}}},
          .setup = [](TestSetup& setup, const Eigen::VectorXd& v) {
            setup.damping *= damping_at(v[0]);
          }};
}

// Young's modulus of all shells and beams, and damping.
Hypothesis softer() {
  Hypothesis h = warmer();
  h.changes = {{[](Model& model) {
                  for (ShellProperties& s : model.shells) s.section.E *= 0.9;
                  for (BeamElement& b : model.beams) scale_stiffness(b.section, 0.9);
                },
                Follow::series}};
  h.coefficients = [](const Eigen::VectorXd& v) {
    return Eigen::VectorXd(-modulus_per_kelvin / 0.1 * v);
  };
  h.in_case = [](const Case& now, const Eigen::VectorXd& v) {
    CaseEdits edits = with_damping(now, damping_at(v[0]));
    const double E = 1 + modulus_per_kelvin * v[0];
    for (const auto& [name, material] : now.materials)
      scale(edits, "materials." + name + ".E", material.E, E);
    for (const Part& part : now.parts)
      if (const auto* liner = std::get_if<Interlock>(&part.body))
        for (const auto& [key, value] :
             {std::pair{"EA", liner->EA}, std::pair{"EI", liner->EI}, std::pair{"GJ", liner->GJ}})
          scale(edits, part_key(part.name) + "." + key, value, E);
    return edits;
  };
  return h;
}

// Parts of one temperature in the case whose material has its modulus and its expansion over the
// temperature, and where they were free of stress.
struct Heated {
  std::vector<std::string> parts;
  double at = 20; // degC
};

Heated heated_parts(const Case& data) {
  Heated found;
  if (data.state) found.at = data.state->free_of_stress_at;
  for (const Part& part : data.parts) {
    const auto material = data.materials.find(material_of(part));
    if (material == data.materials.end() || material->second.E_over_temperature.empty() ||
        material->second.expansion.empty())
      continue;
    const auto given = [&](const PartTemperature& t) { return t.part == part.name; };
    if (data.state &&
        std::any_of(data.state->temperature.begin(), data.state->temperature.end(), given))
      continue;
    for (const auto* table : {&material->second.E_over_temperature, &material->second.expansion})
      found.at = std::max(found.at, table->front()[0]);
    found.parts.push_back(part.name);
  }
  return found;
}

// Those parts colder by `less` than where they were free of stress, what the tables begin at.
std::function<void(OperatingState&)> colder_by(double less, const Heated& heated) {
  return [less, heated](OperatingState& state) {
    for (const std::string& part : heated.parts)
      state.temperature.push_back({.part = part, .at = heated.at});
    state.free_of_stress_at = heated.at + less;
  };
}

// Of parts whose ends are held heat makes stress. Sampled where the part is colder than when it was
// mounted, as it may buckle where it is hotter.
Hypothesis in_thermal_state(const Heated& heated) {
  constexpr double sample = 10; // K
  const auto through = coefficients_through(
      [](double d) { return Eigen::VectorXd(Eigen::Vector2d(d, d * d)); }, {-sample, -2 * sample});
  Hypothesis h = warmer();
  h.case_changes = into_states({colder_by(sample, heated), colder_by(2 * sample, heated)});
  h.large = true;
  h.coefficients = [through](const Eigen::VectorXd& v) { return through(v[0]); };
  h.in_case = [heated](const Case& now, const Eigen::VectorXd& v) {
    CaseEdits edits = with_damping(now, damping_at(v[0]));
    for (const std::string& part : heated.parts)
      edits.push_back(
          {"state.temperature." + part, "{at: " + yaml_of(heated.at + std::max(0., v[0])) + "}"});
    edits.push_back({"state.free_of_stress_at", yaml_of(heated.at + std::max(0., -v[0]))});
    return edits;
  };
  return h;
}

std::vector<Hypothesis> temperature_hypotheses(const Structure& s) {
  const Heated heated = heated_parts(s.data);
  if (asked_for(s, "temperature") && !heated.parts.empty()) return {in_thermal_state(heated)};
  return {softer()};
}

} // namespace

Effect temperature() {
  return {.name = "temperature",
          .plain = "a temperature {delta_T} off that of the material data",
          .physics = "the specimen is warmer or colder than the material data; between held ends "
                     "it is stressed by it, where the case names the effect and the material has "
                     "tables over temperature",
          .signature = "frequencies, static stiffness and damping move together; between held ends "
                       "heat lowers transverse modes most",
          .look_alikes = {{"ply_slip", "a thermometer"},
                          {"damping", "repeat after a soak"},
                          {"installation_offset", "a thermometer, or loosen one end"}},
          .needs = "",
          .hypotheses = temperature_hypotheses};
}

} // namespace plica
