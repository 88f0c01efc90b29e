#include "io/results_csv.hpp"

#include "io/results_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace plica {
namespace {

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

std::string line(const std::vector<std::string>& cells) {
  std::string text;
  for (const std::string& cell : cells) {
    if (&cell != &cells.front()) text += ',';
    text += csv_cell(cell);
  }
  return text + "\n";
}

} // namespace

std::string csv_cell(const std::string& text) {
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
            "effective inertia z [kg m2]", "residual"});
  int count = 0;
  for (const ModeResult& mode : results.modes) {
    std::vector<std::string> cells{std::to_string(++count),
                                   number(mode.frequency),
                                   number(mode.damping),
                                   mode_label(mode),
                                   mode.shape,
                                   mode.direction,
                                   mode.order > 0 ? std::to_string(mode.order) : "",
                                   mode.harmonic >= 0 ? std::to_string(mode.harmonic) : ""};
    for (const double mass : mode.effective_mass) cells.push_back(number(mass));
    cells.push_back(number(mode.residual));
    text += line(cells);
  }
  return text;
}

std::string response_csv(const ResponseResult& response) {
  std::vector<std::string> head{"frequency [Hz]"};
  for (const auto& [sensor, direction] : response.channels)
    for (const char* part : {"real", "imaginary"})
      head.push_back(fmt::format("{} {} {}", sensor, direction, part));
  std::string text = line(head);
  for (Eigen::Index i = 0; i < response.hertz.size(); ++i) {
    std::vector<std::string> cells{number(response.hertz[i])};
    for (const std::complex<double> value : response.transmissibility.row(i)) {
      cells.push_back(number(value.real()));
      cells.push_back(number(value.imag()));
    }
    text += line(cells);
  }
  return text;
}

std::string static_csv(const Results& results) {
  std::string text = line({"axial [N/m]", "transverse x [N/m]", "transverse z [N/m]",
                           "bending x [Nm/rad]", "bending z [Nm/rad]", "torsion [Nm/rad]"});
  if (!results.statics) return text;
  const StaticStiffness& k = *results.statics;
  return text + line({number(k.k_axial), number(k.k_transverse_x), number(k.k_transverse_z),
                      number(k.k_bending_x), number(k.k_bending_z), number(k.k_torsion)});
}

std::string comparison_csv(const Results& results) {
  std::string text = line(
      {"quantity", "unit", "measured", "sigma", "computed", "deviation [%]", "deviation [sigma]"});
  for (const MeasuredComparison& row : results.comparison) {
    text += line({row.quantity, row.unit, number(row.measured),
                  row.sigma > 0 ? number(row.sigma) : "", number(row.computed),
                  number(100 * relative_deviation(row)), number(sigma_deviation(row))});
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
      cells.push_back(value == values.end() ? "" : number(value->second));
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
