#include "io/lab_files/channels.hpp"
#include "io/lab_files/csv_table.hpp"
#include "words/did_you_mean.hpp"

#include <numbers>

namespace plica {
namespace {

using Eigen::VectorXcd;

// "mid y" -> "mid.y"
std::string channel_of(std::string name) {
  const auto blank = name.rfind(' ');
  if (blank != std::string::npos && name.find('.') == std::string::npos) name[blank] = '.';
  return name;
}

bool take_ending(std::string& name, std::initializer_list<const char*> endings) {
  for (const std::string ending : endings)
    if (name.size() > ending.size() && name.ends_with(ending)) {
      name.resize(name.size() - ending.size());
      return true;
    }
  return false;
}

bool is_decibel(const std::string& unit) {
  return unit == "dB" || unit == "db" || unit == "DB";
}

InputProblem at_header(const CsvTable& table, const ChannelRequest& r, std::size_t column) {
  return {r.path.string(), table.header_line, "column " + std::to_string(column + 1), "", ""};
}

// Brings the numbers to SI; a warning where the unit leaves something open.
void take_unit(ChannelColumn& column, const CsvTable& table, std::size_t c, const ChannelRequest& r,
               std::vector<std::string>& warnings) {
  const std::string& written = table.columns[c].unit;
  const bool decibel = is_decibel(written);
  ColumnUnit unit = column_unit(decibel ? "" : written, r, at_header(table, r, c));
  if (decibel) unit.note = "decibels are taken as relative to 1 in SI units";
  column.values *= unit.factor;
  column.factor = unit.factor;
  column.powers = unit.powers;
  column.quantity = unit.quantity;
  column.problem = std::move(unit.problem);
  if (!unit.note.empty())
    warnings.push_back(r.path.string() + ":" + std::to_string(table.header_line) + ": column " +
                       std::to_string(c + 1) + ": " + unit.note);
}

// "mid y" of "mid y magnitude [dB]" with "mid y phase [deg]" to its right; empty: it is no such
// pair.
std::string stem_of_polar(const CsvTable& table, std::size_t c) {
  if (!table.header || c + 1 >= table.columns.size()) return "";
  std::string magnitude = table.columns[c].name, phase = table.columns[c + 1].name;
  const bool is_pair = take_ending(magnitude, {" magnitude", " Magnitude", " mag", " Mag",
                                               " amplitude", " Amplitude", " abs", " Abs"}) &&
                       take_ending(phase, {" phase", " Phase", " phi", " angle", " Angle"}) &&
                       magnitude == phase;
  return is_pair ? magnitude : "";
}

// Of a magnitude, plain or in decibels, and a phase in degrees or radians.
VectorXcd polar(const CsvTable& table, std::size_t c, const ChannelRequest& r) {
  const CsvColumn &magnitude = table.columns[c], &phase = table.columns[c + 1];
  Eigen::ArrayXd size = magnitude.real.array();
  if (is_decibel(magnitude.unit)) size = Eigen::pow(10., size / 20);
  double turn = 1;
  if (phase.unit == "deg" || phase.unit == "degree" || phase.unit == "degrees" ||
      phase.unit == "\u00b0") {
    turn = std::numbers::pi / 180;
  } else if (phase.unit != "rad") {
    InputProblem problem = at_header(table, r, c + 1);
    problem.wrong =
        phase.unit.empty() ? "a phase without a unit" : "a phase in '" + shown(phase.unit) + "'";
    problem.allowed = "[deg] or [rad]";
    throw InputError({problem});
  }
  VectorXcd values(size.size());
  for (Eigen::Index i = 0; i < size.size(); ++i)
    values[i] =
        std::polar(std::abs(size[i]), turn * phase.real[i] + (size[i] < 0 ? std::numbers::pi : 0));
  return values;
}

// Complex columns, pairs of real and imaginary ones, and pairs of magnitude and phase.
std::vector<ChannelColumn> columns_of(const CsvTable& table, const ChannelRequest& r,
                                      std::vector<std::string>& warnings) {
  std::vector<ChannelColumn> columns;
  const std::size_t rest = table.columns.size() - 1;
  const bool by_name = table.header && r.channels.empty();
  const bool pairs = !r.time && (by_name || rest == 2 * r.channels.size());
  for (std::size_t c = 1; c <= rest; ++c) {
    const std::size_t first = c;
    const CsvColumn& source = table.columns[c];
    ChannelColumn column;
    column.name = by_name ? source.name : "column " + std::to_string(c + 1);
    column.values = source.real.cast<std::complex<double>>();
    if (const std::string stem = stem_of_polar(table, c); !r.time && !stem.empty()) {
      column.name = by_name ? stem : column.name;
      column.values = polar(table, c++, r);
      column.name = channel_of(column.name);
      take_unit(column, table, first, r, warnings);
      columns.push_back(std::move(column));
      continue;
    }
    if (source.imaginary.size() > 0) {
      column.values.imag() = source.imaginary;
    } else if (by_name && column.name.ends_with(" sum")) {
      continue; // of the three axes, beside them
    } else if (pairs) {
      const bool named_real = take_ending(column.name, {" real", " re", "_re", " Re"});
      if ((by_name && named_real) || (!by_name && c < rest)) {
        if (c == rest || table.columns[c + 1].imaginary.size() > 0)
          bad_channels(r, "channels",
                       "column " + std::to_string(c + 1) + " has no imaginary part beside it",
                       "a real and an imaginary column per channel, or complex cells");
        column.values.imag() = table.columns[++c].real;
      }
    }
    column.name = channel_of(column.name);
    take_unit(column, table, first, r, warnings);
    if (table.columns[c].unit != source.unit && !column.problem) {
      column.problem = at_header(table, r, c);
      column.problem->wrong = "the unit '" + shown(table.columns[c].unit) +
                              "' is not that of the real part, '" + shown(source.unit) + "'";
      column.problem->allowed = "one unit for both parts";
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

} // namespace

ChannelTable csv_channels(const ChannelRequest& r) {
  CsvTable table = read_csv(r.path);
  const std::string& first = table.columns[0].name;
  const bool has_times = first == "t" || first.starts_with("time") || first.starts_with("Time") ||
                         (!r.channels.empty() && table.columns.size() == r.channels.size() + 1);
  if (r.rate > 0 && !has_times) {
    CsvColumn time{.name = "time",
                   .unit = "s",
                   .real = times_at(r.rate, table.columns[0].real.size()),
                   .imaginary = {}};
    table.columns.insert(table.columns.begin(), std::move(time));
  }
  if (table.columns.size() < 2)
    bad_channels(r, "file", "has a single column", "the abscissa and at least one channel");
  const double factor = abscissa_unit(table.columns[0].unit, r, at_header(table, r, 0));
  std::vector<std::string> warnings;
  std::vector<ChannelColumn> columns = columns_of(table, r, warnings);
  ChannelTable result = assembled(factor * table.columns[0].real, std::move(columns), r);
  result.warnings = std::move(warnings);
  return result;
}

} // namespace plica
