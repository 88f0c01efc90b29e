#include "io/lab_files/universal_modes.hpp"

#include "io/lab_files/universal_axes.hpp"
#include "io/lab_files/universal_results.hpp"
#include "io/lab_files/universal_units.hpp"
#include "io/universal/reader.hpp"
#include "lab/identification/identified_measured.hpp"
#include "words/directions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

namespace plica {
namespace {

namespace fs = std::filesystem;
using std::numbers::pi;

struct Rate {
  double hertz = 0;
  std::optional<double> damping;
};

std::optional<Rate> rate_of(const UniversalShape& s) {
  if (const auto m = normal_mode(s)) {
    Rate rate{m->frequency, std::nullopt};
    if (m->viscous_damping > 0)
      rate.damping = m->viscous_damping;
    else if (m->hysteretic_damping > 0)
      rate.damping = m->hysteretic_damping / 2;
    return rate;
  }
  if (const auto m = complex_mode(s)) {
    const double size = std::abs(m->eigenvalue);
    return Rate{size / (2 * pi),
                size > 0 ? std::optional(-m->eigenvalue.real() / size) : std::nullopt};
  }
  return std::nullopt;
}

class ModesReader {
public:
  explicit ModesReader(const fs::path& path) : path_(path) {}

  Measured read() {
    UniversalReader reader(path_);
    while (const auto set = reader.next()) {
      if (const auto* u = std::get_if<UniversalUnits>(&*set)) take(*u);
      if (const auto* n = std::get_if<UniversalNodes>(&*set)) take(*n);
      if (const auto* s = std::get_if<UniversalShape>(&*set)) take(*s);
      if (const auto* t = std::get_if<UniversalText>(&*set)) take(*t);
      responses_ = responses_ || std::holds_alternative<UniversalFunction>(*set);
    }
    if (shapes_.empty())
      fail(0, "", "holds no modes",
           "data sets 55 or 2414 of normal or complex modes; frequency responses stand in a "
           "measured.yaml under frf");
    return measured();
  }

private:
  [[noreturn]] void fail(int line, const std::string& key, const std::string& wrong,
                         const std::string& allowed) const {
    throw InputError({{path_.string(), line, key, wrong, allowed}});
  }

  void take(const UniversalUnits& u) {
    doubt_of(u, path_); // throws for factors that are none
    length_ = u.length;
  }

  void take(const UniversalNodes& set) {
    for (const UniversalNode& n : set.nodes) nodes_[n.label] = n;
  }

  void take(const UniversalText& t) {
    if (t.number == 2414) {
      if (const auto s = shape_of_results(t, path_.string())) take(*s);
      return;
    }
    for (auto& [label, axes] : displacement_axes(t, path_.string())) axes_[label] = axes;
  }

  void take(const UniversalShape& s) {
    const auto rate = rate_of(s);
    constexpr int displacement = 8, velocity = 11, acceleration = 12;
    const bool motion = s.specific_data_type == displacement || s.specific_data_type == velocity ||
                        s.specific_data_type == acceleration;
    const bool vectors = (s.data_characteristic == 2 && s.real.cols() >= 3) ||
                         (s.data_characteristic == 3 && s.real.cols() >= 6);
    if (!rate || !motion || !vectors) {
      ++others_;
      return;
    }
    if (!std::isfinite(rate->hertz) || rate->hertz < 0 ||
        (rate->damping && !std::isfinite(*rate->damping)))
      fail(s.line, "data set of a mode", "has a frequency or a damping that is no number",
           "a frequency from zero on");
    if (rate->hertz > 0)
      shapes_.push_back({s, *rate});
    else
      ++rigid_;
  }

  // Row of a shape in the axes of the file.
  Eigen::Vector3cd turned(const UniversalShape& s, Eigen::Index row) const {
    Eigen::Vector3cd v = s.real.row(row).head<3>().transpose().cast<std::complex<double>>();
    if (s.imaginary.size() > 0)
      v += std::complex<double>(0, 1) *
           s.imaginary.row(row).head<3>().transpose().cast<std::complex<double>>();
    const auto node = nodes_.find(s.nodes[std::size_t(row)]);
    if (node == nodes_.end() || node->second.displacement_system == 0) return v;
    const auto own = axes_.find(node->second.displacement_system);
    if (own == axes_.end()) {
      if (axes_.empty() && node->second.displacement_system == 1) return v;
      fail(s.line, "node " + std::to_string(node->first),
           "has displacements in coordinate system " +
               std::to_string(node->second.displacement_system) + ", which the file does not have",
           "data sets 18 or 2420");
    }
    if (!own->second.straight)
      fail(s.line, "node " + std::to_string(node->first),
           "has displacements in cylindrical or spherical axes", "straight ones");
    return own->second.axes.transpose().cast<std::complex<double>>() * v;
  }

  MeasuredMode mode_of(const UniversalShape& s, const Rate& rate) const {
    MeasuredMode mode;
    mode.frequency = rate.hertz;
    mode.damping = rate.damping;
    mode.note = s.ids[0] == "NONE" ? "" : s.ids[0];
    MeasuredVector vector;
    Eigen::VectorXcd all(3 * s.real.rows());
    const bool complex = s.imaginary.size() > 0;
    for (Eigen::Index i = 0; i < s.real.rows(); ++i) {
      const Eigen::Vector3cd v = turned(s, i);
      for (int k = 0; k < 3; ++k) {
        if (!std::isfinite(v[k].real()) || !std::isfinite(v[k].imag()))
          fail(s.line, "data set of a mode", "has a number that is not finite", "finite numbers");
        vector.channels.push_back(name_of(s.nodes[std::size_t(i)]) + "." + axis_word(k));
        vector.real.push_back(v[k].real());
        if (complex) vector.imaginary.push_back(v[k].imag());
        all[3 * i + k] = v[k];
      }
    }
    const KindOfShape kind = plica::kind_of(all, vector.channels, {});
    mode.shape = kind.shape;
    mode.direction = kind.direction;
    if (vector.channels.size() >= 2 && all.norm() > 0) mode.vector = std::move(vector);
    return mode;
  }

  static std::string name_of(int node) { return "node" + std::to_string(node); }

  Measured measured() {
    Measured m;
    m.specimen = path_.stem().string();
    m.source = path_.filename().string();
    std::set<int> seen;
    std::map<std::pair<MeasuredShape, int>, int> so_far;
    std::stable_sort(shapes_.begin(), shapes_.end(),
                     [](const auto& a, const auto& b) { return a.second.hertz < b.second.hertz; });
    for (const auto& [shape, rate] : shapes_) {
      std::set<int> own;
      for (const int node : shape.nodes) {
        if (!own.insert(node).second)
          fail(shape.line, "node " + std::to_string(node), "stands twice in one mode", "once");
        seen.insert(node);
      }
      m.modes.push_back(mode_of(shape, rate));
      MeasuredMode& mode = m.modes.back();
      mode.order = ++so_far[{mode.shape, mode.direction ? int(*mode.direction) : -1}];
    }
    for (const int node : seen)
      if (const auto at = nodes_.find(node); at != nodes_.end()) {
        const Eigen::Vector3d x = at->second.position / length_.value_or(1);
        m.sensors.push_back({.name = name_of(node), .at = {x[0], x[1], x[2]}, .node = node});
      }
    add_caveats(m, seen.size());
    return m;
  }

  void add_caveats(Measured& m, std::size_t nodes) const {
    m.caveats.emplace_back("kinds and orders of the modes follow from their vectors in the axes of "
                           "the file, taken for those of the part frame (y along the pipe)");
    if (!length_ && !m.sensors.empty())
      m.caveats.emplace_back("the file states no units (data set 164): places are taken in m");
    if (m.sensors.size() < nodes)
      m.caveats.push_back(std::to_string(nodes - m.sensors.size()) +
                          " nodes of the modes have no place (data set 15 or 2411)");
    if (others_ > 0)
      m.caveats.push_back(std::to_string(others_) + " data sets of results that are no modes, or "
                                                    "no motion, are passed over");
    if (rigid_ > 0)
      m.caveats.push_back(std::to_string(rigid_) + " rigid modes at 0 Hz are passed over");
    if (responses_)
      m.caveats.emplace_back("the functions of the file (data sets 58) are not read beside its "
                             "modes: name it under frf of a measured.yaml");
  }

  fs::path path_;
  std::optional<double> length_;
  std::map<int, UniversalNode> nodes_;
  std::map<int, DisplacementAxes> axes_;
  std::vector<std::pair<UniversalShape, Rate>> shapes_;
  int others_ = 0, rigid_ = 0;
  bool responses_ = false;
};

} // namespace

bool is_universal_file(const fs::path& path) {
  std::string e = path.extension().string();
  std::transform(e.begin(), e.end(), e.begin(), [](unsigned char c) { return std::tolower(c); });
  return e == ".uff" || e == ".unv" || e == ".uf" || e == ".ufb" || e == ".bunv";
}

Measured modes_of_universal(const fs::path& path) {
  return ModesReader(path).read();
}

} // namespace plica
