#include "io/tables/text.hpp"

#include "lab/measured/measured_words.hpp"
#include "run/results/computed_numbers.hpp"
#include "run/results/number_keys.hpp"
#include "words/mode_kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace plica {

std::string mode_label(const ModeResult& mode) {
  const std::string place = mode.place.empty() ? "" : " (" + mode.place + ")";
  if (mode.shape == mode_kind::shell) {
    std::string label = mode_kind::shell;
    if (mode.harmonic >= 0) label += fmt::format(" n={}", mode.harmonic);
    if (mode.order > 0) label += fmt::format(" m={}", mode.order);
    return label + place;
  }
  std::string label = mode.shape.empty() ? mode_kind::unnamed : mode.shape;
  if (mode.order > 0) label += fmt::format(" {}", mode.order);
  const bool direction_is_plain =
      mode.shape == mode_kind::axial || mode.shape == mode_kind::torsion;
  if (!mode.direction.empty() && !direction_is_plain) label += " in " + mode.direction;
  return label + place;
}

int decimals_for(double value, int digits) {
  if (!std::isfinite(value) || value == 0) return digits - 1;
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
  return std::max(0, digits - 1 - exponent);
}

std::string significant(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  if (value == 0) return "0";
  const double size = std::abs(value);
  if (size < 1e-4 || size >= 1e7) return fmt::format("{:.{}e}", value, digits - 1);
  return fmt::format("{:.{}f}", value, decimals_for(value, digits));
}

double rounded(double value, int digits) {
  if (!std::isfinite(value) || value == 0) return value;
  const double step = std::pow(10, std::floor(std::log10(std::abs(value))) - digits + 1);
  return std::round(value / step) * step;
}

std::string with_sign(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  if (std::abs(value) < 0.5 * std::pow(10, -decimals)) return fmt::format("{:.{}f}", 0.0, decimals);
  return fmt::format("{:+.{}f}", value, decimals);
}

std::string grouped(long long value, const std::string& separator) {
  std::string text = std::to_string(value);
  const int first = value < 0 ? 1 : 0;
  for (int place = static_cast<int>(text.size()) - 3; place > first; place -= 3) {
    text.insert(static_cast<std::size_t>(place), separator);
  }
  return text;
}

std::string shares_text(const ErrorBars& errors, const ErrorBar& bar) {
  std::vector<std::size_t> order(bar.shares.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return bar.shares[a] > bar.shares[b]; });
  std::string text;
  for (const std::size_t i : order)
    if (bar.shares[i] >= 0.01)
      text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", errors.tolerances[i],
                          100 * bar.shares[i]);
  return text;
}

std::string response_name(const ResponseResult& r) {
  constexpr std::array prefixes{"", "motion_of_", "force_", "together_"};
  return prefixes[std::size_t(r.source)] + r.excitation;
}

std::string response_title(const ResponseResult& r) {
  constexpr std::array words{"Base moved in ", "Ends moved: ", "Force ", "Together: "};
  return words[std::size_t(r.source)] + r.excitation;
}

std::string response_unit(const ResponseResult& r, const std::string& of) {
  return r.unit.empty() ? of : of + " per " + r.unit;
}

void require_one_row_per_node(const Results& results) {
  const auto nodes = static_cast<Eigen::Index>(results.mesh.nodes.size());
  for (std::size_t mode = 0; mode < results.shapes.size(); ++mode) {
    const Eigen::MatrixXd& shape = results.shapes[mode];
    if (shape.rows() == nodes && shape.cols() >= 3) continue;
    throw std::invalid_argument(fmt::format("mode shape {} is {} x {}, the mesh has {} nodes",
                                            mode + 1, shape.rows(), shape.cols(), nodes));
  }
}

ProofWords proof_words(const Verification& v, std::string (*number)(double, int)) {
  if (!v.made) return {"Not proved", ": the proof that no mode is missing was not asked for."};
  const std::string counts = fmt::format(
      "inertia counts {} {} below {} Hz and {} {} found (largest residual {}, orthogonality {}, "
      "rounding {})",
      v.inertia_count, v.inertia_count == 1 ? "mode" : "modes", number(v.sigma_frequency, 4),
      v.found, v.found == 1 ? "was" : "were", number(v.max_residual, 2), number(v.orthogonality, 2),
      number(v.rounding, 2));
  if (v.passed)
    return {"Proved", ", no mode " + (v.of.empty() ? "" : "of " + v.of + " ") +
                          "is missing: " + counts + "."};
  return {"Not proved",
          ", the check failed: " + counts + (v.reason.empty() ? "." : ": " + v.reason)};
}

std::string mesh_error_percent(double value, const MeshError& error) {
  const double share = error.total() / value;
  return std::isfinite(share) ? with_sign(100 * share, 2) : "-";
}

std::string mesh_error_percent(const ModeResult& mode, const MeshError& error) {
  return mode.shape == mode_kind::rigid ? "-" : mesh_error_percent(mode.frequency, error);
}

std::string stiffness_unit(std::size_t which) {
  return stiffness_unit(static_cast<StaticDirection>(which));
}

ShownUnit shown_unit(double value, const std::string& unit) {
  const bool is_stiffness = unit == "N/m" || unit == "Nm/rad";
  if (is_stiffness && std::abs(value) >= 1e4) return {1e-3, "k" + unit};
  if (unit == "Pa") return {1e-6, "MPa"};
  return {1, unit};
}

namespace {

HeadlineQuantity quantity_of(const std::string& key) {
  const std::string own(number_key::rest_of(key));
  std::string words = own;
  std::replace(words.begin(), words.end(), '_', ' ');
  const NumberKind kind = number_key::kind_of(key);
  const std::string name = kind == NumberKind::stiffness      ? words + " stiffness"
                           : kind == NumberKind::frequency    ? "first " + words + " mode"
                           : kind == NumberKind::stress_range ? "stress range, " + own
                                                              : key;
  return {key, name, unit_of_result(key)};
}

int rank(const std::string& key) {
  static const std::map<std::string, int> ranks{
      {"k_axial", 0}, {"f_axial", 1}, {"f_transverse", 2}, {"f_torsion", 3}, {"mass", 5}};
  if (number_key::kind_of(key) == NumberKind::stress_range) return 6;
  const auto known = ranks.find(key);
  return known == ranks.end() ? 4 : known->second;
}

} // namespace

std::vector<HeadlineQuantity> headline_quantities(const Results& results) {
  std::map<std::pair<int, std::string>, HeadlineQuantity> sorted;
  const auto add = [&](const std::map<std::string, double>& numbers) {
    for (const auto& [key, value] : numbers) sorted[{rank(key), key}] = quantity_of(key);
  };
  add(headline(results));
  for (const VariantResult& variant : results.variants) add(variant.headline);
  std::vector<HeadlineQuantity> quantities;
  quantities.reserve(sorted.size());
  for (auto& [place, quantity] : sorted) quantities.push_back(std::move(quantity));
  return quantities;
}

std::map<std::string, double> headline_at_rest(const Results& results) {
  if (!results.state) return headline(results);
  for (const VariantResult& variant : results.variants)
    if (variant.name == variant_at_rest) return variant.headline;
  return {};
}

int decimals_of(const MeasuredComparison& row, double factor) {
  const int decimals = decimals_for(row.measured * factor, 4);
  return row.sigma > 0 ? std::max(decimals, decimals_for(row.sigma * factor, 1)) : decimals;
}

double relative_deviation(const MeasuredComparison& row) {
  if (row.measured == 0) return std::numeric_limits<double>::quiet_NaN();
  return row.computed / row.measured - 1;
}

double sigma_deviation(const MeasuredComparison& row) {
  if (!(row.sigma > 0)) return std::numeric_limits<double>::quiet_NaN();
  return (row.computed - row.measured) / row.sigma;
}

std::array<double, 2> spread_over_variants(const Results& results, const MeasuredComparison& row) {
  std::array<double, 2> range{row.computed, row.computed};
  for (const VariantResult& variant : results.variants)
    for (const MeasuredComparison& other : variant.comparison)
      if (!variant.state && other.quantity == row.quantity && other.measured == row.measured) {
        range[0] = std::min(range[0], other.computed);
        range[1] = std::max(range[1], other.computed);
      }
  return range;
}

} // namespace plica
