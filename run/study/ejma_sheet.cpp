#include "run/study/ejma_sheet.hpp"

#include "life/miner.hpp"
#include "model/description/place_keys.hpp"
#include "model/description/profile.hpp"
#include "run/study/bellows_shells.hpp"
#include "words/units.hpp"

#include <numbers>
#include <stdexcept>

namespace plica {
namespace {

struct ShellNumbers {
  StaticStiffness stiffness;
  MeridionalStress stress;
  FirstModes modes;
};

FatigueCurve curve_of(const EjmaRequest& request) {
  return {.name = "as-formed bellows",
          .source = "ASME VIII-2 table 4.19.5",
          .law = BellowsCurve{.Kg = request.Kg}};
}

class SheetWriter {
public:
  SheetWriter(EjmaSheet& sheet, const EjmaRequest& request, const ShellNumbers* shells)
      : sheet_(sheet), request_(request), shells_(shells) {}

  // `bellows` none: the formulas do not apply, what the shells have is listed alone.
  void write(const EjmaBellows* bellows, double mass) {
    if (bellows) {
      bellows_ = *bellows;
      factors_ = ejma_factors(bellows_);
      K_ = ejma_convolution_stiffness(bellows_, factors_) / bellows_.convolutions;
      geometry();
    }
    stiffness();
    stress();
    if (bellows) squirm();
    frequencies(mass);
  }

private:
  void add(const char* group, const char* key, const char* text, const char* unit,
           std::optional<double> formula, std::optional<double> shells = std::nullopt) {
    if (sheet_.refused.empty() || shells)
      sheet_.lines.push_back(
          {group, key, text, unit, sheet_.refused.empty() ? formula : std::nullopt, shells});
  }

  void geometry() {
    const EjmaBellows& b = bellows_;
    add("geometry", "Db", "inside diameter of the root", "m", b.inner_diameter);
    add("geometry", "Dm", "mean diameter", "m", ejma_mean_diameter(b));
    add("geometry", "w", "depth of a convolution", "m", b.depth);
    add("geometry", "q", "pitch", "m", b.pitch);
    add("geometry", "rm", "mean radius of the arcs", "m", b.torus_radius);
    add("geometry", "t", "ply", "m", b.thickness);
    add("geometry", "tp", "ply, thinned by forming", "m", ejma_ply(b));
    add("geometry", "n", "plies", "", b.plies);
    add("geometry", "N", "convolutions", "", b.convolutions);
    add("geometry", "Ac", "metal area of a convolution", "m2", ejma_metal_area(b));
    add("geometry", "Eb", "modulus", "Pa", b.E);
    add("coefficients", "C1", "2 rm / w", "", factors_.C1);
    add("coefficients", "C2", "1.82 rm / sqrt(Dm tp)", "", factors_.C2);
    add("coefficients", "Cp", "of stress by pressure", "", factors_.Cp);
    add("coefficients", "Cf", "of stiffness", "", factors_.Cf);
    add("coefficients", "Cd", "of stress by movement", "", factors_.Cd);
  }

  template <class F> std::optional<double> of_shells(F&& number) const {
    if (!shells_) return std::nullopt;
    return number(*shells_);
  }

  void stiffness() {
    const EjmaBellows& b = bellows_;
    const double Dm = ejma_mean_diameter(b), L = ejma_length(b);
    const bool formulas = sheet_.refused.empty();
    if (formulas) add("stiffness", "f_iu", "axial, one convolution", "N/m", K_ * b.convolutions);
    add("stiffness", "k_axial", "axial", "N/m", K_,
        of_shells([](const auto& s) { return s.stiffness.k_axial; }));
    add("stiffness", "k_lateral", "lateral, ends parallel", "N/m",
        formulas ? ejma_lateral_stiffness(K_, Dm, L) : 0,
        of_shells([](const auto& s) { return s.stiffness.k_transverse_x; }));
    add("stiffness", "k_angular", "angular, end free to follow", "Nm/rad",
        formulas ? ejma_angular_stiffness(K_, Dm) : 0,
        of_shells([](const auto& s) { return s.stiffness.k_bending_z; }));
    add("stiffness", "k_torsion", "torsion", "Nm/rad", formulas ? ejma_torsion_stiffness(b) : 0,
        of_shells([](const auto& s) { return s.stiffness.k_torsion; }));
  }

  void stress() {
    const bool formulas = sheet_.refused.empty();
    EjmaEquivalent e;
    EjmaStress s;
    if (formulas) {
      e = ejma_equivalent(bellows_, request_.movement);
      s = ejma_stress(bellows_, factors_, request_.pressure, e.sum(), opened(e));
      add("movement", "e_x", "of one convolution by axial movement", "m", e.axial);
      add("movement", "e_y", "by lateral movement", "m", e.lateral);
      add("movement", "e_theta", "by angular movement", "m", e.angular);
      add("movement", "e", "their sum", "m", e.sum());
      if (bellows_.tangent > 0)
        add("stress", "S1", "circumferential membrane, straight end, by pressure", "Pa", s.S1);
      add("stress", "S2", "circumferential membrane, convolution, by pressure", "Pa", s.S2);
      add("stress", "S3", "meridional membrane by pressure", "Pa", s.S3);
      add("stress", "S4", "meridional bending by pressure", "Pa", s.S4);
    }
    add("stress", "S5", "meridional membrane by movement", "Pa", s.S5);
    add("stress", "S6", "meridional bending by movement", "Pa", s.S6,
        of_shells([](const auto& n) { return n.stress.bending; }));
    add("stress", "S5+S6", "meridional by movement", "Pa", s.S5 + s.S6,
        of_shells([](const auto& n) { return n.stress.face; }));
    if (formulas) life_of(s);
  }

  // Pitch opened by extension, and by bending on its outer side.
  double opened(const EjmaEquivalent& e) const {
    const double axial = request_.movement.axial > 0 ? e.axial : 0;
    return 1 + (axial + e.lateral + e.angular) / bellows_.pitch;
  }

  void life_of(const EjmaStress& s) {
    const double by_pressure = 0.7 * (s.S3 + s.S4);
    const auto total = of_shells([&](const auto& n) { return by_pressure + n.stress.face; });
    add("stress", "St", "total range 0.7 (S3 + S4) + S5 + S6", "Pa", s.St, total);
    const FatigueCurve curve = curve_of(request_);
    sheet_.curve = what_is_inside(curve);
    if (s.St == 0) return;
    sheet_.life = life(curve, {.range = s.St, .mean = 0});
    if (total) sheet_.shell_life = life(curve, {.range = *total, .mean = 0});
    const auto cycles = [](const std::optional<CurveLife>& l) {
      return l ? std::optional(l->cycles) : std::nullopt;
    };
    add("life", "N_allowed", "cycles allowed for St", "", cycles(sheet_.life),
        cycles(sheet_.shell_life));
    if (!request_.cycles) return;
    const auto damage = [&](double St) {
      return miner(curve, std::vector<StressBlock>{{{.range = St, .mean = 0}, *request_.cycles}})
          .damage;
    };
    add("life", "cycles", "cycles asked for", "", *request_.cycles);
    add("life", "damage", "their share of the life", "", damage(s.St),
        total ? std::optional(damage(*total)) : std::nullopt);
  }

  void squirm() {
    const double Kr = opened(ejma_equivalent(bellows_, request_.movement));
    add("squirm", "Psc", "limiting pressure, column", "Pa", ejma_column_squirm(bellows_, factors_));
    if (request_.yield)
      add("squirm", "Psi", "limiting pressure, in plane", "Pa",
          ejma_in_plane_squirm(bellows_, factors_, *request_.yield, Kr));
    else
      sheet_.remarks.push_back("in-plane squirm is left out: it needs the yield stress of the "
                               "formed wall (--yield)");
    if (request_.movement.angular != 0 || request_.movement.lateral != 0)
      sheet_.remarks.push_back("column squirm is that of the straight bellows (Ct = 1): ends that "
                               "are turned lower it");
  }

  void frequencies(double mass) {
    const bool formulas = sheet_.refused.empty();
    LateralFrequency lateral;
    if (formulas)
      lateral =
          ejma_lateral_frequency(1, ejma_mean_diameter(bellows_), ejma_length(bellows_), K_, mass);
    add("frequencies", "mass", "of the convolutions", "kg", mass);
    add("frequencies", "f_axial", "first axial mode, ends held", "Hz",
        formulas ? ejma_axial_frequency(1, bellows_.convolutions, K_, mass) : 0,
        of_shells([](const auto& s) { return s.modes.axial.value_or(std::nan("")); }));
    const auto transverse =
        of_shells([](const auto& s) { return s.modes.transverse.value_or(std::nan("")); });
    add("frequencies", "f_lateral", "first lateral mode, ends held", "Hz", lateral.ejma,
        transverse);
    if (formulas)
      add("frequencies", "f_lateral_rotary", "the same with rotary inertia", "Hz",
          lateral.with_rotary_inertia, transverse);
  }

  EjmaSheet& sheet_;
  const EjmaRequest& request_;
  const ShellNumbers* shells_;
  EjmaBellows bellows_;
  EjmaFactors factors_;
  double K_ = 0; // axial, N/m
};

// Of the convolutions, kg: all plies, at the mean diameter.
double convolution_mass(const EjmaBellows& b, double rho) {
  return rho * std::numbers::pi * ejma_mean_diameter(b) * ejma_metal_area(b) * b.convolutions;
}

bool has_convolutions(const Part& part) {
  const auto* bellows = std::get_if<Bellows>(&part.body);
  return bellows && convolutions(*bellows) > 0;
}

// Both ends held at the requested movement.
ShellNumbers shell_numbers(const Case& data, const Part& part, const EjmaRequest& request,
                           const StageListener& stage) {
  const Case alone = bellows_alone(data, part);
  stage({"statics of the shells of ", part.name});
  const StageListener silent = [](const std::string&) {};
  const BellowsStatics statics(alone, silent);
  stage({"modes of the shells of ", part.name});
  const EjmaMovement& m = request.movement;
  return {statics.stiffness(), statics.stress({m.axial, m.lateral, m.angular}),
          first_modes(alone, silent)};
}

void remark_on_wall(const Bellows& bellows, EjmaSheet& sheet) {
  if (bellows.wall.plies.size() > 1 && bellows.wall.slip)
    sheet.remarks.push_back("plies with friction are taken as free to slip");
  else if (bellows.wall.plies.size() > 1 && bellows.wall.bond > 0 && bellows.wall.bond < 1)
    sheet.remarks.push_back("the formulas take the plies as free to slip, the shells with the bond "
                            "of the case");
  if (bellows.wall.thinning == Thinning::none)
    sheet.remarks.push_back("the wall of the case is not thinned by forming: tp = t");
  if (!bellows.dents.empty()) sheet.remarks.push_back("the formulas know no dents");
}

// Of the coefficients; empty = within.
std::string out_of_range(const EjmaBellows& bellows) {
  try {
    ejma_factors(bellows);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

// All that is wrong with what is asked of these bellows.
void check_request(const Case& data, const EjmaRequest& request) {
  std::vector<InputProblem> problems;
  const auto add = [&](const std::string& key, const std::string& wrong,
                       const std::string& allowed) {
    problems.push_back({.file = "", .line = 0, .key = key, .wrong = wrong, .allowed = allowed});
  };
  for (const InputProblem& p : check(curve_of(request))) add(p.key, p.wrong, p.allowed);
  bool any = false;
  for (const Part& part : data.parts) {
    if (!has_convolutions(part)) continue;
    any = true;
    const auto& bellows = std::get<Bellows>(part.body);
    double straight = 0;
    for (const MeridianSection& s : bellows.profile)
      if (s.shape == SectionShape::cuff) straight += s.length;
    if (const double length = axial_length(bellows) - straight;
        length + request.movement.axial <= 0)
      add(part_key(part.name),
          "is pressed together by " + millimetres(-request.movement.axial) +
              ", more than its convolutions are long",
          "an axial movement of less than " + millimetres(length));
  }
  if (!any) add("parts", "hold no bellows with convolutions", "a part of type bellows, as shells");
  if (!problems.empty()) throw InputError(problems);
}

EjmaSheet sheet_of(const Case& data, const Part& part, const EjmaRequest& request,
                   const StageListener& stage) {
  const auto& bellows = std::get<Bellows>(part.body);
  const Material& material = data.materials.at(bellows.material);
  EjmaSheet sheet;
  sheet.bellows = part.name;
  auto taken = ejma_bellows(bellows, material);
  if (const auto* why = std::get_if<std::string>(&taken))
    sheet.refused = *why;
  else
    sheet.refused = out_of_range(std::get<EjmaBellows>(taken));
  std::optional<ShellNumbers> shells;
  if (request.shells) shells = shell_numbers(data, part, request, stage);
  const EjmaBellows* formulas = sheet.refused.empty() ? &std::get<EjmaBellows>(taken) : nullptr;
  SheetWriter(sheet, request, shells ? &*shells : nullptr)
      .write(formulas, formulas ? convolution_mass(*formulas, material.rho) : 0);
  remark_on_wall(bellows, sheet);
  return sheet;
}

} // namespace

std::vector<EjmaSheet> ejma_sheets(const Case& data, const EjmaRequest& request,
                                   const StageListener& stage) {
  check_request(data, request);
  std::vector<EjmaSheet> sheets;
  for (const Part& part : data.parts)
    if (has_convolutions(part)) sheets.push_back(sheet_of(data, part, request, stage));
  return sheets;
}

} // namespace plica
