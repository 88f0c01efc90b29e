#include "run/study/finer_run.hpp"

#include "run/analyses/stress.hpp"
#include "run/results/number_keys.hpp"
#include "run/study/match_modes.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace plica {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

using RowKey = std::tuple<std::string, std::string, bool, int>; // part, place, face, ply

RowKey key_of(const Results& results, const PlaceStress& row) {
  const StressPlace& place = results.places[std::size_t(row.place)];
  return {place.part, place.name, row.outer, row.ply};
}

std::vector<double> places_of(const Results& fine, const StressTable* table, const Results& nominal,
                              const StressTable& rows) {
  std::map<RowKey, double> found;
  if (table)
    for (const PlaceStress& row : table->rows) found[key_of(fine, row)] = std::abs(row.von_mises);
  std::vector<double> values;
  values.reserve(rows.rows.size());
  for (const PlaceStress& row : rows.rows) {
    const auto at = found.find(key_of(nominal, row));
    values.push_back(at == found.end() ? not_known : at->second);
  }
  return values;
}

} // namespace

std::map<std::string, double> numbers_with_errors(const Results& results) {
  std::map<std::string, double> numbers = headline(results);
  if (!results.life) return numbers;
  for (const DutyResult& duty : results.life->duties)
    if (duty.damage > 0) numbers[number_key::of(NumberKind::damage, duty.name)] = duty.damage;
  if (!results.life->spots.empty() && results.life->spots[0].damage > 0)
    numbers[number_key::damage] = results.life->spots[0].damage;
  return numbers;
}

double shown_stress(const StressResult& s) {
  return std::max(s.largest, s.largest_beam);
}

FinerRun not_met(const Results& nominal) {
  FinerRun run;
  run.statics.fill(not_known);
  run.modes.assign(nominal.modes.size(), not_known);
  run.stresses.assign(nominal.stresses.size(), not_known);
  for (const StressTable& t : nominal.stress_tables)
    run.places.emplace_back(t.rows.size(), not_known);
  return run;
}

FinerRun numbers_of(const Results& fine, const Results& nominal) {
  FinerRun run{.headline = numbers_with_errors(fine),
               .statics = {},
               .modes = {},
               .stresses = {},
               .places = {}};
  if (fine.statics) run.statics = fine.statics->all();
  const std::vector<SameMode> same = match_modes(nominal, fine);
  for (const SameMode& m : same) run.modes.push_back(m.index < 0 ? not_known : m.frequency);
  const auto name_in_fine = [&](StressKind kind, const std::string& name) -> std::string {
    for (std::size_t i = 0; i < same.size(); ++i) // of a mode by its number, which may be another
      if (kind == StressKind::mode && name == mode_stress_name(int(i)))
        return same[i].index < 0 ? "" : mode_stress_name(same[i].index);
    return name;
  };
  const auto met = [&](const auto& list, StressKind kind, const std::string& name) {
    const std::string there = name_in_fine(kind, name);
    const auto at = std::find_if(list.begin(), list.end(), [&](const auto& item) {
      return item.kind == kind && item.name == there;
    });
    return at == list.end() ? nullptr : &*at;
  };
  for (const StressResult& s : nominal.stresses) {
    const StressResult* there = met(fine.stresses, s.kind, s.name);
    run.stresses.push_back(there ? shown_stress(*there) : not_known);
  }
  for (const StressTable& t : nominal.stress_tables)
    run.places.push_back(places_of(fine, met(fine.stress_tables, t.kind, t.name), nominal, t));
  return run;
}

void prepare_mesh_errors(const Results& nominal, ErrorBars& all) {
  for (const auto& [key, value] : numbers_with_errors(nominal)) {
    all.bars.emplace_back();
    all.bars.back().key = key;
    all.bars.back().value = value;
  }
  if (nominal.statics) all.statics.resize(nominal.statics->all().size());
  all.modes.resize(nominal.modes.size());
  all.stresses.resize(nominal.stresses.size());
  for (const StressTable& t : nominal.stress_tables) all.places.emplace_back(t.rows.size());
}

void add_differences(ErrorBars& all, const Results& nominal, const FinerRun& fine,
                     double MeshError::*member, double share, double stress_share) {
  for (ErrorBar& bar : all.bars) {
    const auto found = fine.headline.find(bar.key);
    const double value = found == fine.headline.end() ? not_known : found->second;
    const NumberKind kind = number_key::kind_of(bar.key);
    const bool of_stress = kind == NumberKind::stress_range || kind == NumberKind::damage;
    bar.mesh.*member = (value - bar.value) / (of_stress ? stress_share : share);
  }
  for (std::size_t i = 0; i < all.statics.size(); ++i)
    all.statics[i].*member = (fine.statics[i] - nominal.statics->all()[i]) / share;
  for (std::size_t i = 0; i < all.modes.size(); ++i)
    all.modes[i].*member = (fine.modes[i] - nominal.modes[i].frequency) / share;
  for (std::size_t i = 0; i < all.stresses.size(); ++i)
    all.stresses[i].*member = (fine.stresses[i] - shown_stress(nominal.stresses[i])) / stress_share;
  for (std::size_t t = 0; t < all.places.size(); ++t)
    for (std::size_t i = 0; i < all.places[t].size(); ++i)
      all.places[t][i].*member =
          (fine.places[t][i] - std::abs(nominal.stress_tables[t].rows[i].von_mises)) / stress_share;
}

} // namespace plica
