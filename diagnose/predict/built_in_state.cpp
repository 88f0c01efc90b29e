#include "diagnose/predict/built_in_state.hpp"

#include "run/routes/operating_state.hpp"
#include "solve/state_elements.hpp"

namespace plica {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

// What an element has of stiffness and bears along its axes.
struct BorneByBeam {
  double stiffness = 0, force = 0;
};
struct BorneBySpring {
  Matrix6 law = Matrix6::Zero();
  Vector6 force = Vector6::Zero();
};
struct Borne {
  std::vector<BorneByBeam> beams;
  std::vector<BorneBySpring> springs;
};

Vector6 force_of(const Model& model, const BushingElement& b) {
  return b.bushing.law * state_motion(model, b).value + b.bushing.preload;
}

Borne borne_by(const Model& model) {
  Borne borne;
  for (const BeamElement& b : model.beams)
    borne.beams.push_back(
        {b.section.EA, b.section.EA * (axial_strain(model, b) - b.section.thermal_strain)});
  for (const BushingElement& b : model.bushings)
    borne.springs.push_back({b.bushing.law, force_of(model, b)});
  return borne;
}

void bear(const Borne& before, Model& model) {
  for (std::size_t i = 0; i < before.beams.size(); ++i) {
    BeamElement& b = model.beams[i];
    if (b.section.EA > 0 && b.section.EA != before.beams[i].stiffness)
      b.section.thermal_strain = axial_strain(model, b) - before.beams[i].force / b.section.EA;
  }
  for (std::size_t i = 0; i < model.bushings.size(); ++i) {
    BushingElement& b = model.bushings[i];
    const BorneBySpring bore = i < before.springs.size() ? before.springs[i] : BorneBySpring();
    if (b.bushing.law != bore.law) b.bushing.preload += bore.force - force_of(model, b);
  }
}

} // namespace

Model model_in_state(const Case& data, BuiltCase built) {
  if (data.state && acts(*data.state)) {
    std::map<std::string, double> timing;
    move_into_state(
        data, built, [](const std::string&) {}, timing);
  }
  return std::move(built.model);
}

std::function<void(Model&)> around_state(std::function<void(Model&)> change) {
  return [change = std::move(change)](Model& model) {
    if (!model.rest) return change(model);
    const Borne before = borne_by(model);
    change(model);
    bear(before, model);
  };
}

} // namespace plica
