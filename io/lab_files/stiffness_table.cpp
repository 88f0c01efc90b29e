#include "io/lab_files/stiffness_table.hpp"

#include "io/lab_files/csv_table.hpp"
#include "words/did_you_mean.hpp"
#include "words/directions.hpp"
#include "words/input_error.hpp"
#include "words/units.hpp"

#include <algorithm>
#include <optional>

namespace plica {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> quantity_words{"storage", "loss", "magnitude", "loss angle"};

struct Column {
  MeasuredStiffness as; // without its value
  double factor = 1;    // to SI
};

class StiffnessReader {
public:
  explicit StiffnessReader(const fs::path& path) : path_(path), table_(read_csv(path)) {}

  std::vector<MeasuredStiffness> all() {
    if (!table_.header)
      wrong("", "has no header line", "names of columns: frequency [Hz], y storage [N/mm], ...");
    const CsvColumn* hertz = nullptr;
    std::optional<double> amplitude_factor;
    const CsvColumn* amplitude = nullptr;
    std::vector<std::pair<const CsvColumn*, Column>> columns;
    bool angle = false;
    for (const CsvColumn& c : table_.columns) {
      if (c.imaginary.size() > 0) wrong(c.name, "holds complex numbers", "storage and loss apart");
      if (c.name == "frequency" || c.name == "f") {
        hertz = &c;
        hertz_factor_ = factor(c, "Hz", Dimension::frequency);
      } else if (c.name == "amplitude") {
        amplitude = &c;
        angle = c.unit == "rad" || c.unit == "deg";
        amplitude_factor = factor(c, "m", angle ? Dimension::angle : Dimension::length);
      } else {
        columns.emplace_back(&c, column(c));
      }
    }
    if (!hertz) wrong("", "has no column of frequencies", "frequency [Hz]");
    if (columns.empty()) wrong("", "has no column of stiffness", "y storage [N/mm], ...");
    std::vector<MeasuredStiffness> list;
    for (Eigen::Index row = 0; row < hertz->real.size(); ++row)
      for (const auto& [c, as] : columns) {
        MeasuredStiffness m = as.as;
        m.hertz = hertz->real[row] * hertz_factor_;
        m.value = c->real[row] * as.factor;
        if (amplitude && angle == (m.direction >= 3))
          m.amplitude = amplitude->real[row] * *amplitude_factor;
        if (m.hertz < 0 || m.amplitude < 0)
          wrong(c->name, "has a frequency or an amplitude below zero", "from zero on");
        list.push_back(m);
      }
    return list;
  }

private:
  [[noreturn]] void wrong(const std::string& key, const std::string& what,
                          const std::string& allowed) const {
    throw InputError({{path_.string(), table_.header_line, key, what, allowed}});
  }

  double factor(const CsvColumn& c, const std::string& if_none, Dimension dimension) const {
    const ParsedQuantity one =
        parse_quantity("1 " + (c.unit.empty() ? if_none : c.unit), dimension);
    if (!one.wrong.empty()) wrong(c.name, one.wrong, one.allowed);
    return one.value;
  }

  Column column(const CsvColumn& c) const {
    Column out;
    const auto blank = c.name.find(' ');
    const std::string direction = c.name.substr(0, blank);
    std::string rest = blank == std::string::npos ? "" : c.name.substr(blank + 1);
    out.as.direction = place_among(direction_names, direction);
    if (out.as.direction < 0)
      wrong(c.name, "begins with no direction", "x, y, z, rx, ry or rz, then the quantity");
    for (const auto& [word, kind] : {std::pair{"driving point ", StiffnessKind::driving_point},
                                     {"transfer ", StiffnessKind::transfer}})
      if (rest.starts_with(word)) {
        out.as.kind = kind;
        rest = rest.substr(std::string(word).size());
      }
    const auto quantity = std::find(quantity_words.begin(), quantity_words.end(), rest);
    if (quantity == quantity_words.end())
      wrong(c.name, "names no quantity", suggestion(rest, quantity_words));
    out.as.quantity = StiffnessQuantity(quantity - quantity_words.begin());
    const bool turn = out.as.direction >= 3;
    if (out.as.quantity == StiffnessQuantity::loss_angle)
      out.factor = factor(c, "rad", Dimension::angle);
    else
      out.factor = factor(c, turn ? "Nm/rad" : "N/m",
                          turn ? Dimension::rotational_stiffness : Dimension::stiffness);
    return out;
  }

  fs::path path_;
  CsvTable table_;
  double hertz_factor_ = 1;
};

} // namespace

std::vector<MeasuredStiffness> read_stiffness_table(const fs::path& path) {
  return StiffnessReader(path).all();
}

} // namespace plica
