#include "io/lab_files/channels.hpp"

#include "io/lab_files/universal_units.hpp"
#include "words/did_you_mean.hpp"

#include <algorithm>
#include <array>

namespace plica {

using Eigen::Index;
using Eigen::VectorXd;

void bad_channels(const ChannelRequest& r, const std::string& sub, const std::string& wrong,
                  const std::string& allowed) {
  throw InputError({{.file = r.path.string(),
                     .line = 0,
                     .key = r.key.empty() || sub.empty() ? r.key : r.key + "." + sub,
                     .wrong = wrong,
                     .allowed = allowed}});
}

VectorXd times_at(double rate, Index count) {
  return VectorXd::LinSpaced(count, 0, double(count - 1) / rate);
}

namespace {

// One quantity for all responses of a set.
void take_quantity(ChannelTable& table, const ChannelColumn& column, const ChannelRequest& r) {
  constexpr std::array names{"receptance", "mobility", "accelerance", "transmissibility"};
  if (!column.quantity) return;
  if (table.quantity && *table.quantity != *column.quantity)
    bad_channels(r, "channels",
                 "channel " + column.name + " is " + names[std::size_t(*column.quantity)] +
                     ", one before it " + names[std::size_t(*table.quantity)],
                 "responses of one quantity; - leaves a channel out");
  table.quantity = column.quantity;
}

} // namespace

ChannelTable assembled(const VectorXd& abscissa, std::vector<ChannelColumn> columns,
                       const ChannelRequest& r) {
  if (!r.channels.empty() && columns.size() != r.channels.size())
    bad_channels(r, "channels",
                 "names " + std::to_string(r.channels.size()) + " channels, the file has " +
                     std::to_string(columns.size()),
                 "one name a channel, - for those to leave out");
  ChannelTable table;
  table.abscissa = abscissa;
  table.values.resize(abscissa.size(), Index(columns.size()));
  Index kept = 0;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (!r.channels.empty()) columns[c].name = r.channels[c];
    const std::string& name = columns[c].name;
    if (name == "-") continue;
    if (std::find(table.channels.begin(), table.channels.end(), name) != table.channels.end())
      bad_channels(r, "channels", "channel " + shown(name) + " is there twice",
                   "each channel once");
    if (columns[c].problem) throw InputError({*columns[c].problem});
    take_quantity(table, columns[c], r);
    table.channels.push_back(name);
    table.powers.push_back(columns[c].powers);
    table.factors.push_back(columns[c].factor);
    table.values.col(kept++) = columns[c].values;
  }
  if (kept == 0) bad_channels(r, "channels", "leave nothing", "at least one channel");
  if (!r.time && table.values.leftCols(kept).imag().isZero(0))
    bad_channels(
        r, "channels", "no response has an imaginary part",
        "complex cells, a real and an imaginary column per channel with the channels named, "
        "or columns such as 'mid y magnitude [dB]' and 'mid y phase [deg]'");
  table.values.conservativeResize(Eigen::NoChange, kept);
  for (Index i = 1; i < abscissa.size(); ++i)
    if (!(abscissa[i] > abscissa[i - 1]))
      bad_channels(r, "file",
                   std::string(r.time ? "the times" : "the frequencies") +
                       " do not increase at row " + std::to_string(i + 1),
                   "increasing ones, each once");
  return table;
}

ColumnUnit column_unit(const std::string& text, const ChannelRequest& r, InputProblem where) {
  ColumnUnit column;
  if (states_no_unit(text)) return column;
  const auto refuse = [&](const std::string& wrong, const std::string& allowed) {
    where.wrong = wrong;
    where.allowed = allowed;
    column.problem = where;
  };
  const std::optional<LabUnit> unit = lab_unit(text);
  if (!unit) {
    refuse("the unit '" + shown(text) + "' is not known", known_lab_units());
    return column;
  }
  column.factor = unit->factor;
  column.powers = unit->powers;
  if (r.time) return column;
  const bool ratio = r.base || r.asked == FrfQuantity::transmissibility;
  for (const UnitPowers& motion : {powers::displacement, powers::velocity, powers::acceleration}) {
    if (unit->powers == motion - powers::force)
      column.quantity = quantity_of(motion, powers::force);
    if (unit->powers != motion || ratio) continue;
    column.quantity = quantity_of(motion, powers::force);
    column.note = "the unit '" + shown(text) + "' names no force, N is taken";
  }
  if (unit->powers == powers::none) column.quantity = FrfQuantity::transmissibility;
  if (ratio && unit->powers == powers::acceleration && unit->factor == 1) return column;
  if (!column.quantity || (ratio && column.quantity != FrfQuantity::transmissibility))
    refuse("a response in '" + shown(text) + "', " + name_of(unit->powers),
           ratio ? "a ratio of like quantities, such as [g/g], or no unit"
                 : "a motion per force, such as [m/s2/N] or [g/N]");
  return column;
}

double abscissa_unit(const std::string& text, const ChannelRequest& r, InputProblem where) {
  if (states_no_unit(text)) return 1;
  const std::optional<LabUnit> unit = lab_unit(text);
  where.wrong = "the unit '" + shown(text) + "' is none of " + (r.time ? "time" : "frequency");
  where.allowed = r.time ? "s, ms, us" : "Hz, kHz, rad/s, rpm, krpm";
  if (!unit) throw InputError({where});
  const std::optional<double> hertz = hertz_of(*unit);
  if (r.time ? unit->powers != powers::time : !hertz) throw InputError({where});
  return r.time ? unit->factor : *hertz;
}

} // namespace plica
