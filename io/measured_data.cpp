#include "io/measured_data.hpp"

#include "io/csv_table.hpp"
#include "io/matlab_file.hpp"
#include "io/universal/reader.hpp"
#include "model/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace plica {
namespace {

namespace fs = std::filesystem;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// What of a file is wanted, and how errors name it.
struct Request {
  fs::path path;
  std::string key; // "frf[2]", or empty
  std::vector<std::string> channels;
  MatlabVariables variables;
  bool time = false;
  double rate = 0; // of a file without times, Hz
};

[[noreturn]] void bad(const Request& r, const std::string& sub, const std::string& wrong,
                      const std::string& allowed) {
  throw InputError({{.file = r.path.string(),
                     .line = 0,
                     .key = r.key.empty() || sub.empty() ? r.key : r.key + "." + sub,
                     .wrong = wrong,
                     .allowed = allowed}});
}

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

struct Column {
  std::string name;
  VectorXcd values;
};

// Complex columns, and pairs of real and imaginary ones.
std::vector<Column> columns_of(const CsvTable& table, const Request& r) {
  std::vector<Column> columns;
  const std::size_t rest = table.columns.size() - 1;
  const bool by_name = table.header && r.channels.empty();
  const bool pairs = !r.time && (by_name || rest == 2 * r.channels.size());
  for (std::size_t c = 1; c <= rest; ++c) {
    const CsvColumn& column = table.columns[c];
    std::string name = by_name ? column.name : "column " + std::to_string(c + 1);
    VectorXcd values = column.real.cast<std::complex<double>>();
    if (column.imaginary.size() > 0) {
      values.imag() = column.imaginary;
    } else if (by_name && name.ends_with(" sum")) {
      continue; // of the three axes, beside them
    } else if (pairs) {
      const bool named_real = take_ending(name, {" real", " re", "_re", " Re"});
      if ((by_name && named_real) || (!by_name && c < rest)) {
        if (c == rest || table.columns[c + 1].imaginary.size() > 0)
          bad(r, "channels", "column " + std::to_string(c + 1) + " has no imaginary part beside it",
              "a real and an imaginary column per channel, or complex cells");
        values.imag() = table.columns[++c].real;
      }
    }
    columns.push_back({channel_of(name), std::move(values)});
  }
  return columns;
}

ChannelTable assembled(const VectorXd& abscissa, std::vector<Column> columns, const Request& r) {
  if (!r.channels.empty() && columns.size() != r.channels.size())
    bad(r, "channels",
        "names " + std::to_string(r.channels.size()) + " channels, the file has " +
            std::to_string(columns.size()),
        "one name a channel, - for those to leave out");
  ChannelTable table{
      .abscissa = abscissa, .channels = {}, .values = {}, .warnings = {}, .quantity = {}};
  table.values.resize(abscissa.size(), Index(columns.size()));
  Index kept = 0;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const std::string name = r.channels.empty() ? columns[c].name : r.channels[c];
    if (name == "-") continue;
    if (std::find(table.channels.begin(), table.channels.end(), name) != table.channels.end())
      bad(r, "channels", "channel " + name + " is there twice", "each channel once");
    table.channels.push_back(name);
    table.values.col(kept++) = columns[c].values;
  }
  if (kept == 0) bad(r, "channels", "leave nothing", "at least one channel");
  if (!r.time && table.values.leftCols(kept).imag().isZero(0))
    bad(r, "channels", "no response has an imaginary part",
        "complex cells, or a real and an imaginary column per channel with the channels named; "
        "magnitudes alone, or with phases, are not read");
  table.values.conservativeResize(Eigen::NoChange, kept);
  for (Index i = 1; i < abscissa.size(); ++i)
    if (!(abscissa[i] > abscissa[i - 1]))
      bad(r, "file",
          std::string(r.time ? "the times" : "the frequencies") + " do not increase at row " +
              std::to_string(i + 1),
          "increasing ones, each once");
  return table;
}

// Times of samples without any.
VectorXd times_at(double rate, Index count) {
  return VectorXd::LinSpaced(count, 0, double(count - 1) / rate);
}

ChannelTable csv_channels(const Request& r) {
  CsvTable table = read_csv(r.path);
  if (r.rate > 0) { // no column of times
    const std::string& first = table.columns[0].name;
    if (first == "t" || first.starts_with("time") || first.starts_with("Time") ||
        (!r.channels.empty() && table.columns.size() == r.channels.size() + 1))
      bad(r, "rate", "stands beside a column of times", "nothing, where the file has the time");
    CsvColumn time{.name = "time",
                   .unit = "s",
                   .real = times_at(r.rate, table.columns[0].real.size()),
                   .imaginary = {}};
    table.columns.insert(table.columns.begin(), std::move(time));
  }
  if (table.columns.size() < 2)
    bad(r, "file", "has a single column", "the abscissa and at least one channel");
  return assembled(table.columns[0].real, columns_of(table, r), r);
}

ChannelTable matlab_channels(const Request& r) {
  try {
    const MatlabReader file(r.path);
    const auto wanted = [&](const std::string& name, const char* key) {
      std::string all;
      for (const std::string& n : file.names()) all += (all.empty() ? "" : ", ") + n;
      if (name.empty())
        bad(r, std::string("variables.") + key, "is not given", "a variable of the file: " + all);
      return file.matrix(name);
    };
    MatrixXcd values = wanted(r.variables.values, "values");
    VectorXd abscissa;
    if (r.rate > 0) {
      if (values.cols() > values.rows()) values.transposeInPlace();
      abscissa = times_at(r.rate, values.rows());
    } else {
      const MatrixXcd x = wanted(r.variables.abscissa, "abscissa");
      abscissa = VectorXcd::Map(x.data(), x.size()).real();
    }
    if (values.rows() != abscissa.size() && values.cols() == abscissa.size())
      values.transposeInPlace();
    if (values.rows() != abscissa.size())
      bad(r, "variables.values",
          "has " + std::to_string(values.rows()) + " rows for an abscissa of " +
              std::to_string(abscissa.size()),
          "one row for each");
    if (!values.allFinite() || !abscissa.allFinite())
      bad(r, "variables", "hold numbers that are not finite", "finite numbers");
    std::vector<Column> columns;
    for (Index c = 0; c < values.cols(); ++c)
      columns.push_back({"column " + std::to_string(c + 1), values.col(c)});
    return assembled(abscissa, std::move(columns), r);
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& e) {
    bad(r, "", e.what(), "a MATLAB file that matio reads");
  }
}

// "mid.y" and the sign of its direction.
struct DofName {
  std::string channel;
  double sign = 1;
};

DofName dof_name(const UniversalDof& dof, const Measured* measured) {
  DofName name{.channel = dof.entity == "NONE" || dof.entity.empty()
                              ? "node" + std::to_string(dof.node)
                              : dof.entity};
  if (measured)
    for (const MeasuredSensor& s : measured->sensors)
      if (s.node > 0 && s.node == dof.node) name.channel = s.name;
  constexpr std::array axes{"", ".x", ".y", ".z", ".rx", ".ry", ".rz"};
  const int axis = std::abs(dof.direction);
  if (axis < int(axes.size())) name.channel += axes[axis];
  name.sign = dof.direction < 0 ? -1 : 1;
  return name;
}

// Functions of a universal file by their reference.
struct References {
  std::vector<std::string> order;
  std::map<std::string, std::vector<Column>> columns;
  VectorXd abscissa;
  std::vector<std::string> warnings;
  std::optional<FrfQuantity> quantity; // by the data types, where they say it
};

// What the axes of a response say it is.
std::optional<FrfQuantity> quantity_of(const UniversalFunction& f) {
  if (f.type == FunctionType::transmissibility) return FrfQuantity::transmissibility;
  if (f.denominator.data_type != 13) return std::nullopt; // not per force
  switch (f.numerator.data_type) {
  case 8:
    return FrfQuantity::receptance;
  case 11:
    return FrfQuantity::mobility;
  case 12:
    return FrfQuantity::accelerance;
  default:
    return std::nullopt;
  }
}

// To SI: accelerations in g.
double unit_factor(const UniversalFunction& f) {
  const auto in_g = [](const UniversalAxis& axis) { return axis.unit == "g" || axis.unit == "G"; };
  constexpr double g = 9.80665;
  return (in_g(f.numerator) ? g : 1) / (in_g(f.denominator) ? g : 1);
}

References universal_references(const Request& r, const Measured* measured) {
  References found;
  UniversalReader reader(r.path);
  while (const auto set = reader.next()) {
    const auto* f = std::get_if<UniversalFunction>(&*set);
    if (!f) continue;
    const bool response =
        f->type == FunctionType::frequency_response || f->type == FunctionType::transmissibility;
    if (r.time != (f->type == FunctionType::time_response) || (!r.time && !response)) continue;
    for (const UniversalWarning& w : f->warnings)
      found.warnings.push_back(r.path.string() + ":" + std::to_string(w.line) + ": " + w.what);
    const VectorXd x = abscissa(*f);
    if (found.abscissa.size() == 0) found.abscissa = x;
    if (x.size() != found.abscissa.size() ||
        (x - found.abscissa).norm() > 1e-6 * found.abscissa.norm())
      throw InputError({{.file = r.path.string(),
                         .line = f->line,
                         .key = r.key,
                         .wrong = "a function has another abscissa than the first",
                         .allowed = "functions over the same lines; split the file otherwise"}});
    const DofName to = dof_name(f->response, measured);
    const DofName by = r.time ? DofName{} : dof_name(f->reference, measured);
    Column column{to.channel, f->real.cast<std::complex<double>>()};
    if (f->imaginary.size() > 0) column.values.imag() = f->imaginary;
    column.values *= to.sign * by.sign * (r.time ? 1 : unit_factor(*f));
    if (!found.quantity) found.quantity = quantity_of(*f);
    if (!found.columns.contains(by.channel)) found.order.push_back(by.channel);
    found.columns[by.channel].push_back(std::move(column));
  }
  if (found.order.empty())
    bad(r, "file", r.time ? "holds no time signal" : "holds no frequency response",
        r.time ? "functions of type 1 in sets 58" : "functions of type 4 or 5 in sets 58");
  return found;
}

bool has_extension(const fs::path& path, std::initializer_list<const char*> endings) {
  std::string e = path.extension().string();
  std::transform(e.begin(), e.end(), e.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::find(endings.begin(), endings.end(), e) != endings.end();
}

ChannelTable channels_of(const Request& r, const Measured* measured, const std::string& reference) {
  if (has_extension(r.path, {".csv", ".txt"})) return csv_channels(r);
  if (has_extension(r.path, {".mat"})) return matlab_channels(r);
  References file = universal_references(r, measured);
  std::string chosen = file.order[0];
  if (file.order.size() > 1) {
    if (!file.columns.contains(reference))
      bad(r, "force",
          "the file has " + std::to_string(file.order.size()) + " references, and none is '" +
              reference + "'",
          "one of those of the file, such as " + file.order[0]);
    chosen = reference;
  }
  ChannelTable table = assembled(file.abscissa, std::move(file.columns[chosen]), r);
  table.warnings = std::move(file.warnings);
  table.quantity = file.quantity;
  return table;
}

MatrixXd sigma_of(const MatrixXcd& H, const FrfSigma& sigma) {
  return (sigma.relative * H.cwiseAbs()).cwiseMax(sigma.floor);
}

// `asked`: what the user says the responses are; the file must not say something else.
FrfQuantity agreed(const std::optional<FrfQuantity>& file, const std::optional<FrfQuantity>& asked,
                   FrfQuantity usual, const Request& r) {
  constexpr std::array names{"receptance", "mobility", "accelerance", "transmissibility"};
  if (file && asked && *file != *asked)
    bad(r, "quantity",
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

} // namespace

std::vector<FrfSet> load_frfs(const Measured& measured, const fs::path& folder) {
  std::vector<FrfSet> sets;
  for (std::size_t i = 0; i < measured.frf.size(); ++i) {
    const MeasuredFrf& entry = measured.frf[i];
    const std::string reference =
        entry.base ? std::string("base.") + "xyz"[static_cast<int>(*entry.base)] : entry.force;
    const Request request{.path = folder / entry.file,
                          .key = "frf[" + std::to_string(i) + "]",
                          .channels = entry.channels,
                          .variables = entry.variables};
    ChannelTable table = channels_of(request, &measured, reference);
    // Of a base the file may call it what it likes.
    const FrfQuantity quantity =
        entry.base ? FrfQuantity::transmissibility
                   : agreed(table.quantity, entry.quantity, FrfQuantity::accelerance, request);
    FrfSet set = frf_of(std::move(table), quantity, reference);
    set.level = entry.level;
    if (entry.sigma) set.sigma = {sigma_of(set.H[0], *entry.sigma)};
    const auto home = std::find_if(
        sets.begin(), sets.end(), [&](const FrfSet& other) { return belong_together(other, set); });
    if (home == sets.end()) {
      sets.push_back(std::move(set));
      continue;
    }
    home->references.push_back(reference);
    home->warnings.insert(home->warnings.end(), set.warnings.begin(), set.warnings.end());
    home->H.push_back(std::move(set.H[0]));
    if (!set.sigma.empty()) home->sigma.push_back(std::move(set.sigma[0]));
  }
  return sets;
}

SignalSet load_signals(const MeasuredSignals& entry, const Measured& measured,
                       const fs::path& folder, const std::string& key) {
  const Request request{.path = folder / entry.file,
                        .key = key,
                        .channels = entry.channels,
                        .variables = entry.variables,
                        .time = true,
                        .rate = entry.rate.value_or(0)};
  ChannelTable table = channels_of(request, &measured, "");
  SignalSet set{
      .rate = entry.rate.value_or(0), .channels = table.channels, .samples = table.values.real()};
  const Index n = table.abscissa.size();
  if (n < 2) bad(request, "file", "has fewer than two samples", "a record");
  const double step = (table.abscissa[n - 1] - table.abscissa[0]) / double(n - 1);
  for (Index i = 1; i < n; ++i)
    if (std::abs(table.abscissa[i] - table.abscissa[i - 1] - step) > 0.01 * step)
      bad(request, "file", "the samples are not evenly spaced at row " + std::to_string(i + 1),
          "one sampling rate");
  if (set.rate > 0 && std::abs(set.rate * step - 1) > 1e-3)
    bad(request, "rate",
        "is " + std::to_string(set.rate) + " Hz, the file has " + std::to_string(1 / step) + " Hz",
        "nothing, where the file has the time");
  if (set.rate == 0) set.rate = 1 / step;
  return set;
}

FrfSet load_frf_files(const std::vector<fs::path>& files, std::optional<FrfQuantity> asked) {
  FrfSet all;
  for (const fs::path& path : files) {
    const Request request{.path = path, .key = "", .channels = {}, .variables = {}};
    std::vector<FrfSet> sets;
    if (has_extension(path, {".csv", ".txt", ".mat"})) {
      sets.push_back(frf_of(channels_of(request, nullptr, ""),
                            asked.value_or(FrfQuantity::accelerance), path.stem().string()));
    } else {
      References file = universal_references(request, nullptr);
      const FrfQuantity quantity = agreed(file.quantity, asked, FrfQuantity::accelerance, request);
      for (const std::string& name : file.order) {
        sets.push_back(frf_of(assembled(file.abscissa, std::move(file.columns[name]), request),
                              quantity, name));
        if (sets.size() == 1) sets[0].warnings = file.warnings;
      }
    }
    for (FrfSet& set : sets) {
      if (all.H.empty()) {
        all = std::move(set);
      } else if (belong_together(all, set)) {
        all.references.push_back(set.references[0]);
        all.H.push_back(std::move(set.H[0]));
      } else {
        bad(request, "", "has other lines or channels than the first file, or the same reference",
            "files over the same lines and channels, one a reference");
      }
    }
  }
  return all;
}

} // namespace plica
