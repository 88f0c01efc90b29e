#include "io/lab_files/channels.hpp"
#include "io/lab_files/universal_units.hpp"
#include "io/universal/reader.hpp"
#include "words/directions.hpp"

#include <cstdlib>

namespace plica {
namespace {

using Eigen::VectorXd;

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
  constexpr int last = direction_names.size(); // counted from 1; 0 = none
  if (dof.direction != 0 && dof.direction >= -last && dof.direction <= last)
    name.channel += std::string(".") + direction_names[std::size_t(std::abs(dof.direction) - 1)];
  name.sign = dof.direction < 0 ? -1 : 1;
  return name;
}

// What is said of a file, each thing once with its first line and how often it holds.
class FileWarnings {
public:
  void add(const UniversalWarning& w) {
    for (Entry& e : entries_)
      if (e.what == w.what) return void(++e.count);
    entries_.push_back({w.line, w.what, 1});
  }
  std::vector<std::string> texts(const std::filesystem::path& file) const {
    std::vector<std::string> all;
    for (const Entry& e : entries_)
      all.push_back(file.string() + ":" + std::to_string(e.line) + ": " + e.what +
                    (e.count > 1 ? " (and " + std::to_string(e.count - 1) + " more)" : ""));
    return all;
  }

private:
  struct Entry {
    int line = 0;
    std::string what;
    int count = 0;
  };
  std::vector<Entry> entries_;
};

class ReferenceReader {
public:
  ReferenceReader(const ChannelRequest& r, const Measured* measured)
      : r_(r), measured_(measured), reader_(r.path) {}

  UniversalReferences read() {
    while (const auto set = reader_.next()) {
      if (const auto* u = std::get_if<UniversalUnits>(&*set)) take(*u);
      if (const auto* f = std::get_if<UniversalFunction>(&*set); f && is_wanted(*f)) take(*f);
    }
    if (found_.order.empty())
      bad_channels(r_, "file", r_.time ? "holds no time signal" : "holds no frequency response",
                   r_.time ? "functions of type 1 in sets 58"
                           : "functions of type 4 or 5 in sets 58");
    found_.warnings = warnings_.texts(r_.path);
    return std::move(found_);
  }

private:
  bool is_wanted(const UniversalFunction& f) const {
    const bool response =
        f.type == FunctionType::frequency_response || f.type == FunctionType::transmissibility;
    return r_.time ? f.type == FunctionType::time_response : response;
  }

  // It holds for what follows; what came before without units was taken as SI.
  void take(const UniversalUnits& u) {
    if (const auto doubt = doubt_of(u, r_.path)) warnings_.add(*doubt);
    if (!found_.order.empty() && !system_ && (u.length != 1 || u.force != 1))
      throw InputError({{.file = r_.path.string(),
                         .line = u.line,
                         .key = "data set 164",
                         .wrong = "gives units behind functions that stand before it",
                         .allowed = "the units before the functions"}});
    system_ = u;
  }

  void take(const UniversalFunction& f) {
    for (const UniversalWarning& w : f.warnings) warnings_.add(w);
    FunctionUnits units = function_units(f, system_ ? &*system_ : nullptr, r_.base, r_.path);
    for (const UniversalWarning& w : units.warnings) warnings_.add(w);
    if (units.problem && !r_.key.empty()) units.problem->key = r_.key + ": " + units.problem->key;
    const VectorXd x = units.abscissa * abscissa(f);
    if (found_.abscissa.size() == 0) found_.abscissa = x;
    if (x.size() != found_.abscissa.size() ||
        (x - found_.abscissa).norm() > 1e-6 * found_.abscissa.norm())
      throw InputError({{.file = r_.path.string(),
                         .line = f.line,
                         .key = r_.key,
                         .wrong = "a function has another abscissa than the first",
                         .allowed = "functions over the same lines; split the file otherwise"}});
    const DofName to = dof_name(f.response, measured_);
    const DofName by = r_.time ? DofName{} : dof_name(f.reference, measured_);
    ChannelColumn column{to.channel,     f.real.cast<std::complex<double>>(),
                         units.ordinate, units.powers,
                         units.quantity, std::move(units.problem)};
    if (f.imaginary.size() > 0) column.values.imag() = f.imaginary;
    column.values *= to.sign * by.sign * units.ordinate;
    if (!found_.columns.contains(by.channel)) found_.order.push_back(by.channel);
    found_.columns[by.channel].push_back(std::move(column));
  }

  const ChannelRequest& r_;
  const Measured* measured_;
  UniversalReader reader_;
  std::optional<UniversalUnits> system_;
  UniversalReferences found_;
  FileWarnings warnings_;
};

} // namespace

UniversalReferences universal_references(const ChannelRequest& r, const Measured* measured) {
  return ReferenceReader(r, measured).read();
}

} // namespace plica
