#include "io/lab_files/universal_units.hpp"

#include "words/did_you_mean.hpp"
#include "words/units.hpp"

#include <array>
#include <cmath>

namespace plica {
namespace {

// Specific data types of axes: what they are, exponents of length and force.
struct AxisKind {
  int type;
  UnitPowers powers;
  int length, force;
  const char* unit; // that is taken where none is stated
};

constexpr std::array kinds{
    AxisKind{2, powers::pressure, -2, 1, "Pa"},   AxisKind{3, powers::none, 0, 0, "a ratio"},
    AxisKind{8, powers::displacement, 1, 0, "m"}, AxisKind{9, powers::force, 0, 1, "N"},
    AxisKind{11, powers::velocity, 1, 0, "m/s"},  AxisKind{12, powers::acceleration, 1, 0, "m/s2"},
    AxisKind{13, powers::force, 0, 1, "N"},       AxisKind{15, powers::pressure, -2, 1, "Pa"},
    AxisKind{17, powers::time, 0, 0, "s"},        AxisKind{18, powers::frequency, 0, 0, "Hz"},
    AxisKind{19, powers::frequency, 0, 0, "rpm"}, AxisKind{21, powers::pressure, -2, 1, "Pa"}};

const AxisKind* kind_of(int type) {
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const AxisKind& k) { return k.type == type; });
  return found == kinds.end() ? nullptr : found;
}

// The same about an axis: rotations and moments have the data types of displacements and forces.
UnitPowers turning(const UnitPowers& of) {
  if (of == powers::displacement) return powers::angle;
  if (of == powers::velocity) return powers::turning_speed;
  if (of == powers::acceleration) return powers::angular_acceleration;
  return of == powers::force ? powers::moment : of;
}

UnitPowers along(const UnitPowers& of) {
  for (const UnitPowers& straight :
       {powers::displacement, powers::velocity, powers::acceleration, powers::force})
    if (turning(straight) == of) return straight;
  return of;
}

// The unit of an axis; of one that names none the unit behind its label, "acc (g)".
std::string unit_text(const UniversalAxis& axis) {
  if (!states_no_unit(axis.unit)) return axis.unit;
  const std::string& label = axis.label;
  if (label.empty() || (label.back() != ')' && label.back() != ']')) return "";
  const auto open = label.find_last_of("([");
  if (open == std::string::npos) return "";
  const std::string unit = label.substr(open + 1, label.size() - open - 2);
  return lab_unit(unit) ? unit : "";
}

struct AxisUnit {
  std::string text; // empty: none is stated
  std::optional<LabUnit> stated;
  const AxisKind* kind = nullptr;
  double system = 1; // by data set 164
  std::optional<UnitPowers> powers;
  double factor = 1;
};

class FunctionReader {
public:
  FunctionReader(const UniversalFunction& f, const UniversalUnits* system, bool base,
                 std::string file)
      : f_(f), system_(system), file_(std::move(file)),
        ratio_(base || f.type == FunctionType::transmissibility) {}

  FunctionUnits read() {
    const bool time = f_.type == FunctionType::time_response;
    abscissa(time);
    if (found_.problem) return found_;
    if (time)
      signal();
    else
      response();
    return found_;
  }

private:
  void refuse(const UniversalAxis& axis, int record, const std::string& wrong,
              const std::string& allowed) {
    if (found_.problem) return;
    found_.problem = {file_, axis.line, "data set 58, record " + std::to_string(record), wrong,
                      allowed};
  }
  void warn(const UniversalAxis& axis, int record, const std::string& what) {
    found_.warnings.push_back({axis.line, "record " + std::to_string(record) + ": " + what, 0, 0});
  }

  double by_system(const UniversalAxis& axis, const AxisKind* kind, int direction) const {
    if (!system_) return 1;
    int length = axis.length, force = axis.force;
    if (length == 0 && force == 0 && kind) {
      length = kind->length;
      force = kind->force;
      if (std::abs(direction) > 3) length = kind->powers == powers::force ? 1 : 0;
    }
    return std::pow(system_->length, -length) * std::pow(system_->force, -force);
  }

  AxisUnit axis_unit(const UniversalAxis& axis, int direction) const {
    AxisUnit a;
    a.text = unit_text(axis);
    a.stated = lab_unit(a.text);
    a.kind = kind_of(axis.data_type);
    a.system = by_system(axis, a.kind, direction);
    if (a.stated)
      a.powers = a.stated->powers;
    else if (a.kind)
      a.powers = std::abs(direction) > 3 ? turning(a.kind->powers) : a.kind->powers;
    a.factor = a.stated ? a.stated->factor : a.system;
    return a;
  }

  // Unit known, of what the data type says, not against data set 164; what nobody states is said.
  void check(const UniversalAxis& axis, int record, const AxisUnit& a) {
    if (!a.text.empty() && !a.stated)
      return refuse(axis, record, "the unit '" + shown(a.text) + "' is not known",
                    known_lab_units());
    if (a.stated && a.kind && along(a.stated->powers) != along(a.kind->powers))
      return refuse(axis, record,
                    "the unit '" + shown(a.text) + "' is one of " + name_of(a.stated->powers) +
                        ", the data type " + std::to_string(axis.data_type) + " says " +
                        name_of(a.kind->powers),
                    "a unit of what the data type says");
    if (a.stated && system_ && std::abs(a.stated->factor / a.system - 1) > 1e-3 &&
        a.stated->powers.angle == 0)
      warn(axis, record,
           "the unit " + shown(a.text) + " contradicts data set 164 in line " +
               std::to_string(system_->line) + ", by which 1 is " + short_number(a.system) +
               " in SI; the unit of the axis is taken");
    if (a.text.empty() && !system_)
      warn(axis, record,
           std::string("no unit is stated, ") + (a.kind ? a.kind->unit : "SI") + " is taken");
  }

  void abscissa(bool time) {
    const UniversalAxis& axis = f_.abscissa_axis;
    AxisUnit a = axis_unit(axis, 0);
    const bool turning_speed = axis.data_type == 19;
    const UnitPowers wanted = time ? powers::time : powers::frequency;
    if ((a.kind && a.kind->powers != wanted) || (!a.kind && axis.data_type > 1))
      return refuse(axis, 8,
                    "the abscissa has data type " + std::to_string(axis.data_type) +
                        (a.kind ? ", " + name_of(a.kind->powers) : ""),
                    time ? "17, time" : "18, frequency");
    if (!a.text.empty() && !a.stated)
      return refuse(axis, 8, "the unit '" + shown(a.text) + "' is not known", known_lab_units());
    if (!a.stated) {
      found_.abscissa = turning_speed ? 1. / 60 : 1;
      return warn(axis, 8,
                  std::string("no unit is stated, ") +
                      (time            ? "s"
                       : turning_speed ? "rpm"
                                       : "Hz") +
                      " is taken");
    }
    const std::optional<double> hertz = hertz_of(*a.stated);
    if (time ? a.stated->powers != powers::time : !hertz)
      return refuse(axis, 8,
                    "the unit '" + shown(a.text) + "' is one of " + name_of(a.stated->powers),
                    time ? "s, ms, us" : "Hz, kHz, rad/s, rpm, krpm");
    found_.abscissa = time ? a.stated->factor : *hertz;
  }

  void signal() {
    const AxisUnit a = axis_unit(f_.numerator, f_.response.direction);
    check(f_.numerator, 9, a);
    found_.ordinate = a.factor;
    found_.powers = a.powers;
  }

  void response() {
    const AxisUnit over = axis_unit(f_.numerator, f_.response.direction),
                   under = axis_unit(f_.denominator, f_.reference.direction);
    if (like_by_name(over, under)) return;
    if (whole_in_numerator(over)) return;
    if (ratio_ && over.text.empty() && under.text.empty()) { // needs no units
      found_.quantity = FrfQuantity::transmissibility;
      found_.powers = powers::none;
      return;
    }
    check(f_.numerator, 9, over);
    check(f_.denominator, 10, under);
    found_.ordinate = over.factor / under.factor;
    if (over.powers && under.powers) {
      found_.powers = *over.powers - *under.powers;
      found_.quantity = quantity_of(*over.powers, *under.powers);
      if (!found_.quantity)
        refuse(f_.numerator, 9,
               name_of(*over.powers) + " over " + name_of(*under.powers) +
                   " is no response that is known",
               "displacement, velocity or acceleration per force, or like over like");
    }
    one_side_alone(over, under);
    if (ratio_ && found_.quantity && *found_.quantity != FrfQuantity::transmissibility)
      refuse(f_.numerator, 9,
             "a transmissibility in '" + shown(over.text) + "' over '" + shown(under.text) + "'",
             "the same quantity above and below");
  }

  // Like over like by the names of their units, whatever these are.
  bool like_by_name(const AxisUnit& over, const AxisUnit& under) {
    const int above = f_.numerator.data_type, below = f_.denominator.data_type;
    const bool like = ratio_ || above == below || above <= 1 || below <= 1;
    if (over.text.empty() || over.text != under.text || !like) return false;
    found_.powers = powers::none;
    const bool motion = over.powers && quantity_of(*over.powers, powers::force);
    if (ratio_ || motion || (!over.stated && above == 12)) {
      found_.quantity = FrfQuantity::transmissibility;
      return true;
    }
    refuse(f_.numerator, 9, "'" + shown(over.text) + "' over itself is no response that is known",
           "displacement, velocity or acceleration per force, or like over like");
    return true;
  }

  // The numerator names the unit of the quotient: "g/N".
  bool whole_in_numerator(const AxisUnit& over) {
    if (!over.stated) return false;
    for (const UnitPowers& motion : {powers::displacement, powers::velocity, powers::acceleration})
      for (const auto& [above, below] : {std::pair(motion, powers::force),
                                         {turning(motion), powers::moment},
                                         {motion, powers::moment},
                                         {turning(motion), powers::force}}) {
        const AxisKind* kind = over.kind;
        if (over.stated->powers != above - below || ratio_) continue;
        if (kind && kind->powers != along(above)) continue;
        found_.ordinate = over.stated->factor;
        found_.powers = over.stated->powers;
        found_.quantity = quantity_of(above, below);
        return true;
      }
    if (!ratio_ || over.stated->powers != powers::none) return false;
    found_.ordinate = over.stated->factor;
    found_.powers = powers::none;
    found_.quantity = FrfQuantity::transmissibility;
    return true;
  }

  // g over nobody knows what.
  void one_side_alone(const AxisUnit& over, const AxisUnit& under) {
    const bool alone = over.text.empty() != under.text.empty();
    const bool like = ratio_ || found_.quantity == FrfQuantity::transmissibility;
    const bool above = !over.text.empty();
    if (!alone || !like || system_ || (above ? over : under).factor == 1) return;
    refuse(above ? f_.denominator : f_.numerator, above ? 10 : 9,
           "no unit is stated, the " + std::string(above ? "numerator" : "denominator") +
               " is in '" + shown(above ? over.text : under.text) + "'",
           "units on both sides of a transmissibility, or on none");
  }

  const UniversalFunction& f_;
  const UniversalUnits* system_;
  std::string file_;
  bool ratio_; // a transmissibility
  FunctionUnits found_;
};

} // namespace

std::optional<FrfQuantity> quantity_of(const UnitPowers& numerator, const UnitPowers& denominator) {
  const UnitPowers above = along(numerator), below = along(denominator);
  const std::array motions{powers::displacement, powers::velocity, powers::acceleration};
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (above != motions[i]) continue;
    if (below == powers::force) return static_cast<FrfQuantity>(i);
    if (below == above) return FrfQuantity::transmissibility;
  }
  return std::nullopt;
}

FunctionUnits function_units(const UniversalFunction& f, const UniversalUnits* system, bool base,
                             const std::filesystem::path& file) {
  return FunctionReader(f, system, base, file.string()).read();
}

std::optional<UniversalWarning> doubt_of(const UniversalUnits& u,
                                         const std::filesystem::path& file) {
  if (!(u.length > 0 && u.force > 0 && std::isfinite(u.length) && std::isfinite(u.force)))
    throw InputError({{.file = file.string(),
                       .line = u.line,
                       .key = "data set 164, record 2",
                       .wrong = "the factors of length and force are " + short_number(u.length) +
                                " and " + short_number(u.force),
                       .allowed = "numbers above 0"}});
  struct System {
    int code;
    double length, force;
  };
  constexpr double foot = 3.280839895, inch = 39.37007874, pound = 0.2248089431,
                   poundal = 7.233013851, kilopond = 0.1019716213;
  constexpr std::array systems{
      System{1, 1, 1},          System{2, foot, pound},   System{3, 1, kilopond},
      System{4, foot, poundal}, System{5, 1e3, 1e3},      System{6, 1e2, 1e2},
      System{7, inch, pound},   System{8, 1e3, kilopond}, System{10, 1e3, 1}};
  for (const System& s : systems)
    if (s.code == u.code &&
        (std::abs(u.length / s.length - 1) > 1e-3 || std::abs(u.force / s.force - 1) > 1e-3))
      return UniversalWarning{
          u.line,
          "data set 164: the factors of length and force are " + short_number(u.length) + " and " +
              short_number(u.force) + ", those of its code " + std::to_string(u.code) + " are " +
              short_number(s.length) + " and " + short_number(s.force) + "; the factors are taken",
          0, 0};
  return std::nullopt;
}

} // namespace plica
