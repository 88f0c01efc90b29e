#include "io/tables/csv.hpp"

#include "io/tables/text.hpp"
#include "words/directions.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace plica {
namespace {

std::string line(const std::vector<std::string>& cells) {
  std::string text;
  for (const std::string& cell : cells) {
    if (&cell != &cells.front()) text += ',';
    text += csv_cell(cell);
  }
  return text + "\n";
}

// What a spreadsheet would take for a formula, and execute: a text with such a beginning that is no
// number.
bool is_formula(const std::string& text) {
  if (text.size() < 2 || std::string("=+-@\t\r").find(text[0]) == std::string::npos) return false;
  double number = 0;
  const char* end = text.data() + text.size();
  const char* begin = text.data() + (text[0] == '+' ? 1 : 0);
  const auto [stop, status] = std::from_chars(begin, end, number);
  return status != std::errc() || stop != end;
}

} // namespace

std::string csv_number(const std::optional<double>& x) {
  return x && std::isfinite(*x) ? fmt::format("{}", *x) : "";
}

std::string csv_cell(const std::string& given) {
  const std::string text = is_formula(given) ? "'" + given : given;
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '"') quoted += '"';
    quoted += letter;
  }
  return quoted + '"';
}

std::string modes_csv(const Results& results) {
  std::string text =
      line({"mode", "frequency [Hz]", "damping [fraction of critical]", "label", "shape",
            "direction", "order", "harmonic", "effective mass x [kg]", "effective mass y [kg]",
            "effective mass z [kg]", "effective inertia x [kg m2]", "effective inertia y [kg m2]",
            "effective inertia z [kg m2]", "residual", "mesh error [Hz]"});
  int count = 0;
  for (const ModeResult& mode : results.modes) {
    std::vector<std::string> cells{std::to_string(++count),
                                   csv_number(mode.frequency),
                                   csv_number(mode.damping),
                                   mode_label(mode),
                                   mode.shape,
                                   mode.direction,
                                   mode.order > 0 ? std::to_string(mode.order) : "",
                                   mode.harmonic >= 0 ? std::to_string(mode.harmonic) : ""};
    for (const double mass : mode.effective_mass) cells.push_back(csv_number(mass));
    cells.push_back(csv_number(mode.residual));
    const std::vector<MeshError>& errors = results.error_bars.modes;
    cells.push_back(errors.empty() ? "" : csv_number(errors[std::size_t(count - 1)].total()));
    text += line(cells);
  }
  return text;
}

namespace {

std::vector<std::string> channel_heads(const ResponseResult& r,
                                       const std::vector<std::string>& parts) {
  std::vector<std::string> heads;
  for (const auto& [sensor, direction] : r.channels)
    for (const std::string& part : parts)
      heads.push_back(fmt::format("{} {} {}", sensor, direction, part));
  return heads;
}

std::vector<std::string> with_frequency(std::vector<std::string> heads) {
  heads.insert(heads.begin(), "frequency [Hz]");
  return heads;
}

void add_complex(std::vector<std::string>& cells, std::complex<double> value) {
  cells.push_back(csv_number(value.real()));
  cells.push_back(csv_number(value.imag()));
}

} // namespace

std::string complex_modes_csv(const Results& results) {
  std::vector<std::string> head{"mode", "frequency [Hz]", "damping [fraction of critical]"};
  for (const SensorResult& s : results.sensors)
    for (const char* direction : axis_names)
      for (const char* part : {"real", "imaginary"})
        head.push_back(fmt::format("{} {} {} [1/sqrt(kg)]", s.name, direction, part));
  std::string text = line(head);
  for (std::size_t j = 0; j < results.complex_modes.shapes.size(); ++j) {
    const ModeResult& mode = results.modes[j];
    std::vector<std::string> cells{std::to_string(j + 1), csv_number(mode.damped_frequency),
                                   csv_number(mode.damping)};
    for (const std::complex<double> u : results.complex_modes.shapes[j]) add_complex(cells, u);
    text += line(cells);
  }
  return text;
}

std::string response_csv(const ResponseResult& r) {
  const std::string per = "[" + response_unit(r, "m/s2") + "]";
  std::vector<std::string> head =
      with_frequency(channel_heads(r, {"real " + per, "imaginary " + per}));
  for (std::size_t c = 0; c < r.channels.size(); c += 3)
    head.push_back(r.channels[c].first + " sum " + per);
  std::string text = line(head);
  const Eigen::MatrixXd sums = vector_sum(r);
  for (Eigen::Index i = 0; i < r.hertz.size(); ++i) {
    std::vector<std::string> cells{csv_number(r.hertz[i])};
    for (const std::complex<double> value : r.acceleration.row(i)) add_complex(cells, value);
    for (const double value : sums.row(i)) cells.push_back(csv_number(value));
    text += line(cells);
  }
  return text;
}

std::string motion_csv(const ResponseResult& r) {
  std::string text = line(with_frequency(
      channel_heads(r, {"acceleration [m/s2]", "velocity [m/s]", "displacement [m]"})));
  for (Eigen::Index i = 0; i < r.hertz.size(); ++i) {
    std::vector<std::string> cells{csv_number(r.hertz[i])};
    const double omega = 2 * std::numbers::pi * r.hertz[i];
    for (const std::complex<double> value : r.acceleration.row(i))
      for (const double divisor : {1., omega, omega * omega})
        cells.push_back(csv_number(r.level * std::abs(value) / divisor));
    text += line(cells);
  }
  return text;
}

std::string random_csv(const ResponseResult& r) {
  const RandomResult& random = *r.random;
  std::vector<std::string> head = with_frequency(channel_heads(r, {"[(m/s2)2/Hz]"}));
  const bool alone = random.input.size() > 0;
  if (alone) head.insert(head.begin() + 1, fmt::format("input [({})2/Hz]", r.unit));
  const auto name = [&](int c) { return r.channels[c].first + " " + r.channels[c].second; };
  for (const CrossDensity& cross : random.cross)
    for (const char* part : {"real", "imaginary"})
      head.push_back(fmt::format("{} with {} {} [(m/s2)2/Hz]", name(cross.a), name(cross.b), part));
  std::string text = line(head);
  for (Eigen::Index i = 0; i < r.hertz.size(); ++i) {
    std::vector<std::string> cells{csv_number(r.hertz[i])};
    if (alone) cells.push_back(csv_number(random.input[i]));
    for (const double value : random.density.row(i)) cells.push_back(csv_number(value));
    for (const CrossDensity& cross : random.cross) add_complex(cells, cross.density[i]);
    text += line(cells);
  }
  return text;
}

std::string stress_csv(const Results& results) {
  std::string text =
      line({"kind", "stress of", "von Mises [Pa]", "face", "x [m]", "y [m]", "z [m]",
            "beam axial [Pa]", "beam x [m]", "beam y [m]", "beam z [m]", "mesh error [Pa]"});
  std::size_t count = 0;
  for (const StressResult& s : results.stresses) {
    std::vector<std::string> cells{word_of(s.kind), s.name, csv_number(s.largest), s.face};
    for (const double x : s.at) cells.push_back(s.face.empty() ? "" : csv_number(x));
    const bool beam = s.largest_beam > 0;
    cells.push_back(beam ? csv_number(s.largest_beam) : "");
    for (const double x : s.beam_at) cells.push_back(beam ? csv_number(x) : "");
    const std::vector<MeshError>& errors = results.error_bars.stresses;
    cells.push_back(errors.empty() ? "" : csv_number(errors[count++].total()));
    text += line(cells);
  }
  return text;
}

std::string error_bars_csv(const Results& results) {
  const ErrorBars& errors = results.error_bars;
  std::vector<std::string> head{"quantity",    "unit",    "value", "mesh along",
                                "mesh around", "cut-off", "5 %",   "95 %"};
  for (const std::string& path : errors.tolerances) head.push_back("share of " + path);
  std::map<std::string, std::string> units;
  for (const HeadlineQuantity& quantity : headline_quantities(results))
    units[quantity.key] = quantity.unit;
  std::string text = line(head);
  for (const ErrorBar& bar : errors.bars) {
    std::vector<std::string> cells{bar.key,
                                   units[bar.key],
                                   csv_number(bar.value),
                                   csv_number(bar.mesh.along),
                                   csv_number(bar.mesh.around),
                                   results.reduced ? csv_number(bar.mesh.cutoff) : ""};
    for (std::size_t i : {0, 1})
      cells.push_back(bar.interval ? csv_number((*bar.interval)[i]) : "");
    for (std::size_t i = 0; i < errors.tolerances.size(); ++i)
      cells.push_back(i < bar.shares.size() ? csv_number(bar.shares[i]) : "");
    text += line(cells);
  }
  return text;
}

std::string static_csv(const Results& results) {
  const std::vector<MeshError>& errors = results.error_bars.statics;
  std::vector<std::string> head, values, missing;
  for (std::size_t i = 0; i < stiffness_names.size(); ++i) {
    const std::string unit = " [" + stiffness_unit(i) + "]";
    head.push_back(stiffness_names[i] + unit);
    missing.push_back(std::string("mesh error ") + stiffness_names[i] + unit);
    if (results.statics) values.push_back(csv_number(results.statics->all()[i]));
  }
  head.insert(head.end(), missing.begin(), missing.end());
  if (!results.statics) return line(head);
  for (std::size_t i = 0; i < stiffness_names.size(); ++i)
    values.push_back(errors.empty() ? "" : csv_number(errors[i].total()));
  return line(head) + line(values);
}

std::string comparison_csv(const Results& results) {
  std::string text = line(
      {"quantity", "unit", "measured", "sigma", "computed", "deviation [%]", "deviation [sigma]"});
  for (const MeasuredComparison& row : results.comparison) {
    text += line({row.quantity, row.unit, csv_number(row.measured),
                  row.sigma > 0 ? csv_number(row.sigma) : "", csv_number(row.computed),
                  csv_number(100 * relative_deviation(row)), csv_number(sigma_deviation(row))});
  }
  return text;
}

std::string variants_csv(const Results& results) {
  const std::vector<HeadlineQuantity> quantities = headline_quantities(results);
  std::vector<std::string> head{"variant", "set"};
  for (const HeadlineQuantity& quantity : quantities) {
    head.push_back(quantity.name + (quantity.unit.empty() ? "" : " [" + quantity.unit + "]"));
  }
  std::string text = line(head);
  const auto add = [&](const std::string& name, const std::string& set,
                       const std::map<std::string, double>& values) {
    std::vector<std::string> cells{name, set};
    for (const HeadlineQuantity& quantity : quantities) {
      const auto value = values.find(quantity.key);
      cells.push_back(value == values.end() ? "" : csv_number(value->second));
    }
    text += line(cells);
  };
  add("nominal", "", headline(results));
  for (const VariantResult& variant : results.variants) {
    std::string set;
    for (const auto& [path, value] : variant.set) {
      set += fmt::format("{}{} = {}", set.empty() ? "" : "; ", path, value);
    }
    add(variant.name, set, variant.headline);
  }
  return text;
}

} // namespace plica
