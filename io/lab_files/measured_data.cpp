#include "io/lab_files/measured_data.hpp"

#include "io/lab_files/channels.hpp"
#include "io/lab_files/universal_units.hpp"
#include "lab/measured/entries.hpp"
#include "lab/measured/measured_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace plica {
namespace {

namespace fs = std::filesystem;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

bool has_extension(const fs::path& path, std::initializer_list<const char*> endings) {
  std::string e = path.extension().string();
  std::transform(e.begin(), e.end(), e.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::find(endings.begin(), endings.end(), e) != endings.end();
}

// What the channels are in must fit to each other and to what is wanted of them.
void check_units(const ChannelTable& table, const MeasuredSignals& entry, const ChannelRequest& r) {
  constexpr std::array names{"receptance", "mobility", "accelerance", "transmissibility"};
  const FrfQuantity wanted = entry.quantity.value_or(entry.base ? FrfQuantity::transmissibility
                                                                : FrfQuantity::accelerance);
  const auto at = std::find(table.channels.begin(), table.channels.end(), entry.reference);
  if (at == table.channels.end()) return; // said where the responses are made
  const auto reference = std::size_t(at - table.channels.begin());
  for (std::size_t c = 0; c < table.channels.size(); ++c) {
    if (c == reference) continue;
    const auto &over = table.powers[c], &under = table.powers[reference];
    if (over.has_value() != under.has_value() &&
        table.factors[over ? c : reference] != 1) // the one not known may be in anything
      bad_channels(r, "channels",
                   "no unit is stated of " + table.channels[over ? reference : c] + ", while " +
                       table.channels[over ? c : reference] + " is not in SI",
                   "units of all channels, or of none");
    if (!over || !under) continue;
    const auto is = quantity_of(*over, *under);
    if (!is || *is != wanted)
      bad_channels(r, "quantity",
                   std::string("is ") + names[std::size_t(wanted)] + ", but " + table.channels[c] +
                       " is " + name_of(*over) + " and " + entry.reference + " " + name_of(*under),
                   is ? std::string("quantity: ") + names[std::size_t(*is)]
                      : "motions over a force, or over a motion of the same kind");
  }
}

ChannelTable channels_of(const ChannelRequest& r, const Measured* measured,
                         const std::string& reference) {
  if (has_extension(r.path, {".csv", ".txt"})) return csv_channels(r);
  if (has_extension(r.path, {".mat"})) return matlab_channels(r);
  UniversalReferences file = universal_references(r, measured);
  std::string chosen = file.order[0];
  if (file.order.size() > 1) {
    if (!file.columns.contains(reference))
      bad_channels(r, "force",
                   "the file has " + std::to_string(file.order.size()) +
                       " references, and none is '" + reference + "'",
                   "one of those of the file, such as " + file.order[0]);
    chosen = reference;
  }
  ChannelTable table = assembled(file.abscissa, std::move(file.columns[chosen]), r);
  table.warnings = std::move(file.warnings);
  return table;
}

MatrixXd sigma_of(const MatrixXcd& H, const FrfSigma& sigma) {
  return (sigma.relative * H.cwiseAbs()).cwiseMax(sigma.floor);
}

// `asked`: what the user says the responses are; the file must not say something else.
FrfQuantity agreed(const std::optional<FrfQuantity>& file, const std::optional<FrfQuantity>& asked,
                   FrfQuantity usual, const ChannelRequest& r) {
  constexpr std::array names{"receptance", "mobility", "accelerance", "transmissibility"};
  if (file && asked && *file != *asked)
    bad_channels(r, "quantity",
                 std::string("is ") + names[static_cast<int>(*asked)] + ", the file says " +
                     names[static_cast<int>(*file)],
                 "what the data types of the file say, or nothing");
  return asked.value_or(file.value_or(usual));
}

FrfSet frf_of(ChannelTable table, FrfQuantity quantity, const std::string& reference) {
  FrfSet set;
  set.quantity = quantity;
  set.warnings = std::move(table.warnings);
  set.hertz = std::move(table.abscissa);
  set.responses = std::move(table.channels);
  set.references = {reference};
  set.H = {std::move(table.values)};
  return set;
}

bool belong_together(const FrfSet& a, const FrfSet& b) {
  return a.quantity == b.quantity && a.level == b.level && a.responses == b.responses &&
         a.hertz.size() == b.hertz.size() && (a.hertz - b.hertz).norm() <= 1e-9 * a.hertz.norm() &&
         a.sigma.empty() == b.sigma.empty() &&
         std::find(a.references.begin(), a.references.end(), b.references[0]) == a.references.end();
}

// One entry of `frf`: one reference.
FrfSet frf_of_entry(const Measured& measured, std::size_t i, const fs::path& folder) {
  const MeasuredFrf& entry = measured.frf[i];
  const std::string reference =
      entry.base ? std::string("base.") + word_of(*entry.base) : entry.force;
  const ChannelRequest request{.path = folder / entry.file,
                               .key = entry_name("frf", i),
                               .channels = entry.channels,
                               .variables = entry.variables,
                               .base = entry.base.has_value(),
                               .asked = entry.quantity};
  ChannelTable table = channels_of(request, &measured, reference);
  // Of a base the file may call it what it likes.
  const FrfQuantity quantity =
      entry.base ? FrfQuantity::transmissibility
                 : agreed(table.quantity, entry.quantity, FrfQuantity::accelerance, request);
  FrfSet set = frf_of(std::move(table), quantity, reference);
  set.level = entry.level;
  if (entry.sigma) set.sigma = {sigma_of(set.H[0], *entry.sigma)};
  return set;
}

} // namespace

std::vector<FrfSet> load_frfs(const Measured& measured, const fs::path& folder,
                              const std::optional<std::string>& state) {
  std::vector<FrfSet> sets;
  for (std::size_t i = 0; i < measured.frf.size(); ++i) {
    if (state && measured.frf[i].state != *state) continue;
    FrfSet set = frf_of_entry(measured, i, folder);
    const auto home = std::find_if(
        sets.begin(), sets.end(), [&](const FrfSet& other) { return belong_together(other, set); });
    if (home == sets.end()) {
      sets.push_back(std::move(set));
      continue;
    }
    home->references.push_back(set.references[0]);
    home->warnings.insert(home->warnings.end(), set.warnings.begin(), set.warnings.end());
    home->H.push_back(std::move(set.H[0]));
    if (!set.sigma.empty()) home->sigma.push_back(std::move(set.sigma[0]));
  }
  return sets;
}

std::vector<std::vector<FrfSet>> load_each_frf(const Measured& measured, const fs::path& folder) {
  std::vector<std::vector<FrfSet>> all;
  for (std::size_t i = 0; i < measured.frf.size(); ++i)
    all.push_back({frf_of_entry(measured, i, folder)});
  return all;
}

SignalSet load_signals(const MeasuredSignals& entry, const Measured& measured,
                       const fs::path& folder, const std::string& key) {
  const ChannelRequest request{.path = folder / entry.file,
                               .key = key,
                               .channels = entry.channels,
                               .variables = entry.variables,
                               .time = true,
                               .rate = entry.rate.value_or(0),
                               .base = entry.base.has_value(),
                               .asked = entry.quantity};
  ChannelTable table = channels_of(request, &measured, "");
  if (has_input(entry.excitation)) check_units(table, entry, request);
  SignalSet set{.rate = entry.rate.value_or(0),
                .channels = table.channels,
                .powers = table.powers,
                .samples = table.values.real(),
                .warnings = table.warnings};
  const Index n = table.abscissa.size();
  if (n < 2) bad_channels(request, "file", "has fewer than two samples", "a record");
  const double step = (table.abscissa[n - 1] - table.abscissa[0]) / double(n - 1);
  // Times are often written with six digits, by which late ones are off; a sample that is missing
  // is seen all the same, unless a step is no more than that and nobody states the rate.
  const double digits = 1.1e-5 * table.abscissa.cwiseAbs().maxCoeff();
  const double off = 0.01 * step + (digits < step / 4 || set.rate > 0 ? digits : 0);
  for (Index i = 1; i < n; ++i)
    if (std::abs(table.abscissa[i] - table.abscissa[0] - double(i) * step) > off)
      bad_channels(request, "file",
                   "the samples are not evenly spaced at row " + std::to_string(i + 1),
                   "one sampling rate");
  if (set.rate > 0 && std::abs(set.rate * step - 1) > 1e-3)
    bad_channels(request, "rate",
                 fmt::format("is {:g} Hz, the times of the file are {:g} Hz", set.rate, 1 / step),
                 "nothing, where the file has the time");
  if (set.rate == 0) set.rate = 1 / step;
  return set;
}

FrfSet load_frf_files(const std::vector<fs::path>& files, std::optional<FrfQuantity> asked) {
  FrfSet all;
  for (const fs::path& path : files) {
    ChannelRequest request;
    request.path = path;
    request.asked = asked;
    std::vector<FrfSet> sets;
    const auto add = [&](ChannelTable table, const std::string& reference) {
      const FrfQuantity quantity = agreed(table.quantity, asked, FrfQuantity::accelerance, request);
      sets.push_back(frf_of(std::move(table), quantity, reference));
    };
    if (has_extension(path, {".csv", ".txt", ".mat"})) {
      add(channels_of(request, nullptr, ""), path.stem().string());
    } else {
      UniversalReferences file = universal_references(request, nullptr);
      for (const std::string& name : file.order)
        add(assembled(file.abscissa, std::move(file.columns[name]), request), name);
      sets[0].warnings = std::move(file.warnings);
    }
    for (FrfSet& set : sets) {
      if (all.H.empty()) {
        all = std::move(set);
      } else if (belong_together(all, set)) {
        all.references.push_back(set.references[0]);
        all.H.push_back(std::move(set.H[0]));
        all.warnings.insert(all.warnings.end(), set.warnings.begin(), set.warnings.end());
      } else {
        bad_channels(request, "",
                     "has other lines or channels than the first file, or the same reference",
                     "files over the same lines and channels, one a reference");
      }
    }
  }
  return all;
}

} // namespace plica
