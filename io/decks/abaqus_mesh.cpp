#include "io/decks/abaqus_mesh.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <optional>
#include <unordered_set>

namespace plica {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::size_t nodes_of_type(const std::string& type) {
  static const std::map<std::string, std::size_t> count{
      {"S4", 4},       {"S4R", 4},     {"S4R5", 4},    {"S3", 3},       {"S3R", 3},
      {"STRI3", 3},    {"S6", 6},      {"STRI65", 6},  {"S8", 8},       {"S8R", 8},
      {"S8R5", 8},     {"M3D3", 3},    {"M3D4", 4},    {"M3D4R", 4},    {"B31", 2},
      {"B31R", 2},     {"B31H", 2},    {"B33", 2},     {"B33H", 2},     {"PIPE31", 2},
      {"B32", 3},      {"B32R", 3},    {"B32H", 3},    {"PIPE32", 3},   {"B21", 2},
      {"B21H", 2},     {"B23", 2},     {"B22", 3},     {"T3D2", 2},     {"T2D2", 2},
      {"T3D3", 3},     {"T2D3", 3},    {"MASS", 1},    {"ROTARYI", 1},  {"SPRING1", 1},
      {"SPRING2", 2},  {"SPRINGA", 2}, {"DCOUP3D", 1}, {"DASHPOT1", 1}, {"DASHPOT2", 2},
      {"DASHPOTA", 2}, {"R3D3", 3},    {"R3D4", 4},    {"RB3D2", 2},    {"R2D2", 2}};
  const auto found = count.find(type);
  return found == count.end() ? 0 : found->second;
}

template <class F> void for_each_entry(const Keyword& k, F&& f) {
  for (const DataLine& line : k.data) {
    if (k.has("GENERATE")) {
      const int first = whole_in(k, line, 0), last = whole_in(k, line, 1);
      const bool stepped = line.fields.size() > 2 && !line.fields[2].empty();
      const long step = stepped ? whole_in(k, line, 2) : 1;
      if (step <= 0)
        deck_error(line.at, "*" + k.name, "has a step of " + std::to_string(step), "1 or more");
      for (long label = first; label <= last; label += step) f(line, std::to_string(label));
    } else {
      for (const std::string& field : line.fields)
        if (!field.empty()) f(line, in_capitals(field));
    }
  }
}

std::optional<int> as_number(const std::string& text) {
  if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos || text.size() > 9)
    return std::nullopt;
  return std::stoi(text);
}

// The keyword that gives an element of this type its section; empty: none.
std::string section_of(const std::string& type) {
  static const std::map<std::string, std::string> needs{
      {"MASS", "MASS"},      {"ROTARYI", "ROTARY INERTIA"}, {"SPRING1", "SPRING"},
      {"SPRING2", "SPRING"}, {"SPRINGA", "SPRING"},         {"DCOUP3D", "DISTRIBUTING COUPLING"}};
  if (is_idle_type(type)) return "";
  if (type[0] == 'B' || type[0] == 'P') return "BEAM SECTION";
  if (type[0] == 'T') return "SOLID SECTION";
  if (type.starts_with("M3D")) return "MEMBRANE SECTION";
  const auto need = needs.find(type);
  return need == needs.end() ? "SHELL SECTION" : need->second;
}

std::string kind_of_section(const std::string& keyword) {
  if (keyword == "BEAM GENERAL SECTION") return "BEAM SECTION";
  return keyword == "SHELL GENERAL SECTION" ? "SHELL SECTION" : keyword;
}

void keep_first(std::vector<int>& list) {
  std::unordered_set<int> seen;
  std::erase_if(list, [&](int x) { return !seen.insert(x).second; });
}

// Coordinates of a node of a kind of system as Cartesian ones.
Vector3d cartesian(const Keyword& k, const Vector3d& x) {
  constexpr double degree = std::numbers::pi / 180;
  const std::string kind = k.word_or("SYSTEM", "R");
  if (kind == "C") return {x[0] * std::cos(degree * x[1]), x[0] * std::sin(degree * x[1]), x[2]};
  if (kind == "S") {
    const double out = x[0] * std::cos(degree * x[2]);
    return {out * std::cos(degree * x[1]), out * std::sin(degree * x[1]),
            x[0] * std::sin(degree * x[2])};
  }
  if (kind != "R") deck_error(k.at, "*" + k.name, "has SYSTEM=" + kind, "R, C or S");
  return x;
}

// Axes by a point on their x and one in their plane of x and y.
Matrix3d axes_by(const Keyword& k, const DataLine& line, const Vector3d& a, const Vector3d& b) {
  Matrix3d axes;
  const Vector3d z = a.cross(b);
  if (!(z.norm() > 1e-12 * a.norm() * b.norm()))
    deck_error(line.at, "*" + k.name, "has its points on one line", "points that span a plane");
  axes << a.normalized(), z.cross(a).normalized(), z.normalized();
  return axes;
}

Vector3d vector_in(const Keyword& k, const DataLine& line, std::size_t first) {
  return {number_in(k, line, first, 0), number_in(k, line, first + 1, 0),
          number_in(k, line, first + 2, 0)};
}

} // namespace

KeywordHandlers AbaqusMesh::handlers() {
  const auto keep = [this](const Keyword& k) { sets_.push_back(k); };
  return {{"NODE", {[this](const Keyword& k) { read_nodes(k); }, {"NSET", "SYSTEM"}}},
          {"SYSTEM", {[this](const Keyword& k) { read_system(k); }, {}}},
          {"ELEMENT", {[this](const Keyword& k) { read_elements(k); }, {"TYPE", "ELSET"}}},
          {"NSET", {keep, {"NSET", "GENERATE", "ELSET", "UNSORTED", "INTERNAL", "INSTANCE"}}},
          {"ELSET", {keep, {"ELSET", "GENERATE", "INTERNAL", "INSTANCE", "UNSORTED"}}}};
}

KeywordHandlers AbaqusMesh::axes() {
  return {{"TRANSFORM", {[this](const Keyword& k) { read_transform(k); }, {"NSET", "TYPE"}}}};
}

Vector3d AbaqusMesh::place(const Keyword& k, const Vector3d& point) const {
  const auto own = instances_.find(k.scope);
  return own == instances_.end() ? point : Vector3d(own->second.turn * point + own->second.move);
}

Matrix3d AbaqusMesh::turn(const Keyword& k) const {
  const auto found = instances_.find(k.scope);
  return found == instances_.end() ? Matrix3d(Matrix3d::Identity()) : found->second.turn;
}

// Origin, a point on x, one in the plane of x and y; without data the axes of the part again.
void AbaqusMesh::read_system(const Keyword& k) {
  system_ = {};
  if (k.data.empty()) return;
  const DataLine& line = k.data[0];
  system_.move = vector_in(k, line, 0);
  const Vector3d a = vector_in(k, line, 3) - system_.move;
  const bool second = k.data.size() > 1;
  system_.turn = axes_by(k, line, a,
                         second ? Vector3d(vector_in(k, k.data[1], 0) - system_.move)
                                : Vector3d(Vector3d::UnitZ().cross(a)));
}

void AbaqusMesh::read_nodes(const Keyword& k) {
  DeckProblems problems; // of all its lines at once
  for (const DataLine& line : k.data) problems.collect([&] { read_node(k, line); });
  problems.raise();
}

void AbaqusMesh::read_node(const Keyword& k, const DataLine& line) {
  const auto place = instances_.find(k.scope);
  const int label = whole_in(k, line, 0);
  const int index = static_cast<int>(deck_.nodes.size());
  const auto [known, is_new] = index_.try_emplace({k.scope, label}, index);
  if (!is_new)
    deck_error(line.at, "*NODE",
               "node " + std::to_string(label) + " is there twice, first in line " +
                   std::to_string(node_lines_[std::size_t(known->second)]),
               "a number once");
  deck_.nodes.emplace_back(0, 0, 0);
  deck_.labels.push_back(label);
  node_lines_.push_back(line.at.line);
  Vector3d x = system_.turn * cartesian(k, vector_in(k, line, 1)) + system_.move;
  if (place != instances_.end()) x = place->second.turn * x + place->second.move;
  deck_.nodes.back() = x;
  if (k.has("NSET")) nsets_[{k.scope, k.word("NSET")}].push_back(index);
}

void AbaqusMesh::read_elements(const Keyword& k) {
  const std::string type = k.word("TYPE");
  const std::size_t count = nodes_of_type(type);
  if (count == 0) {
    const auto elements = static_cast<int>(k.data.size());
    if (is_solid_type(type))
      missing_.add_solid(type, true, k.at, elements);
    else
      missing_.add("*ELEMENT, TYPE=" + type, "is not had", k.at);
    for (const DataLine& line : k.data)
      if (!line.fields.empty() && as_number(line.fields[0]))
        element_index_.try_emplace({k.scope, *as_number(line.fields[0])}, -1);
    return;
  }
  DeckProblems problems; // of all its lines at once
  for (std::size_t i = 0; i < k.data.size(); ++i) {
    DataLine line = k.data[i];
    while (line.fields.size() < count + 1 && i + 1 < k.data.size() &&
           (line.fields.back().empty() || count > 4)) { // goes on in the next line
      if (line.fields.back().empty()) line.fields.pop_back();
      ++i;
      line.fields.insert(line.fields.end(), k.data[i].fields.begin(), k.data[i].fields.end());
    }
    while (line.fields.size() > count + 1 && line.fields.back().empty()) line.fields.pop_back();
    missing_.count_element(true);
    problems.collect([&] { read_element(k, line, type, count); });
  }
  if (k.has("ELSET")) elsets_.try_emplace({k.scope, k.word("ELSET")});
  problems.raise();
}

void AbaqusMesh::read_element(const Keyword& k, const DataLine& line, const std::string& type,
                              std::size_t count) {
  const int label = whole_in(k, line, 0);
  if (line.fields.size() != count + 1)
    deck_error(line.at, "*ELEMENT",
               "has " + std::to_string(line.fields.size() - 1) + " nodes for " + type,
               std::to_string(count));
  AbaqusElement element{.at = line.at,
                        .type = type,
                        .origin = "element " + std::to_string(label) + " in line " +
                                  std::to_string(line.at.line),
                        .label = label,
                        .nodes = {},
                        .shells = {}};
  for (std::size_t n = 1; n <= count; ++n) element.nodes.push_back(node(k, line, n));
  const int index = static_cast<int>(elements_.size());
  const auto [known, is_new] = element_index_.try_emplace({k.scope, label}, index);
  if (!is_new)
    deck_error(line.at, "*ELEMENT",
               "element " + std::to_string(label) + " is there twice" +
                   (known->second < 0
                        ? std::string()
                        : ", first in line " +
                              std::to_string(elements_[std::size_t(known->second)].at.line)),
               "a number once");
  elements_.push_back(std::move(element));
  if (k.has("ELSET")) elsets_[{k.scope, k.word("ELSET")}].push_back(index);
}

int AbaqusMesh::node(const Keyword& k, const DataLine& line, std::size_t field) const {
  if (field < line.fields.size() && line.fields[field].find('.') != std::string::npos &&
      !instances_.empty()) {
    const std::vector<int> one = nodes(k, line, line.fields[field]);
    if (one.size() == 1) return one.front();
  }
  const int label = whole_in(k, line, field);
  const auto found = index_.find({k.scope, label});
  if (found == index_.end())
    deck_error(line.at, "*" + k.name, "there is no node " + std::to_string(label),
               "a node of the deck");
  return found->second;
}

AbaqusMesh::Name AbaqusMesh::split(const Keyword& k, const std::string& name) const {
  const std::size_t dot = name.find('.');
  if (dot != std::string::npos && instances_.contains(name.substr(0, dot)))
    return {name.substr(0, dot), name.substr(dot + 1)};
  const bool lists = k.name == "NSET" || k.name == "ELSET";
  return {lists && k.has("INSTANCE") ? k.word("INSTANCE") : k.scope, name};
}

template <class Indices>
std::vector<int> AbaqusMesh::find(const Keyword& k, const DataLine& line, const std::string& name,
                                  const Indices& index,
                                  const std::map<Name, std::vector<int>>& sets,
                                  const std::string& what) const {
  const auto [scope, own] = split(k, in_capitals(name));
  if (const auto label = as_number(own)) {
    const auto found = index.find({scope, *label});
    if (found == index.end())
      deck_error(line.at, "*" + k.name, "there is no " + what + " " + name, "one of the deck");
    return found->second < 0 ? std::vector<int>{} : std::vector<int>{found->second};
  }
  auto found = sets.find({scope, own});
  if (found == sets.end()) found = sets.find({"", own});
  if (found == sets.end())
    deck_error(line.at, "*" + k.name, "there is no " + what + " set " + name,
               what == "node" ? "a set given by *NSET" : "a set given by *ELSET or *ELEMENT");
  return found->second;
}

std::vector<int> AbaqusMesh::nodes(const Keyword& k, const DataLine& line,
                                   const std::string& name) const {
  return find(k, line, name, index_, nsets_, "node");
}

std::vector<int> AbaqusMesh::elements(const Keyword& k, const DataLine& line,
                                      const std::string& name) const {
  return find(k, line, name, element_index_, elsets_, "element");
}

// Each once, in their order: sets of sets would double with every level. A set of elements that are
// all skipped is empty.
void AbaqusMesh::read_sets() {
  for (const Keyword& k : sets_) {
    std::vector<int> more;
    const auto add = [&](const std::vector<int>& list) {
      more.insert(more.end(), list.begin(), list.end());
    };
    if (k.name == "NSET" && k.has("ELSET")) {
      for (int e : elements(k, {k.at, {}}, k.word("ELSET"))) add(elements_.at(e).nodes);
    } else {
      for_each_entry(k, [&](const DataLine& line, const std::string& entry) {
        add(k.name == "NSET" ? nodes(k, line, entry) : elements(k, line, entry));
      });
    }
    auto& sets = k.name == "NSET" ? nsets_ : elsets_;
    std::vector<int>& set = sets[{k.scope, k.word(k.name)}];
    set.insert(set.end(), more.begin(), more.end());
    keep_first(set);
  }
  for (const auto& [name, set] : nsets_)
    deck_.sets[name.first.empty() ? name.second : name.first + "." + name.second] = set;
}

// TYPE=R: points on x and in the plane of x and y; C: two points on the axis, radial, tangential
// and along it; S: the centre and a point of the polar axis.
void AbaqusMesh::read_transform(const Keyword& k) {
  const DataLine& line = data_line(k, 0);
  const std::string type = k.word_or("TYPE", "R");
  const Matrix3d turned = turn(k);
  const auto place = instances_.find(k.scope);
  const Vector3d move = place == instances_.end() ? Vector3d(0, 0, 0) : place->second.move;
  const Vector3d a = vector_in(k, line, 0), b = vector_in(k, line, 3);
  for (int n : nodes(k, line, k.word("NSET"))) {
    Matrix3d axes;
    if (type == "R")
      axes = axes_by(k, line, a, b);
    else {
      const Vector3d x = turned.transpose() * (deck_.nodes[n] - move) - a, z = (b - a).normalized();
      const Vector3d out = x - z * z.dot(x);
      if (!(out.norm() > 1e-9 * x.norm()) || (type != "C" && type != "S"))
        deck_error(line.at, "*TRANSFORM",
                   type == "C" || type == "S" ? "has a node on its axis" : "has TYPE=" + type,
                   "TYPE=R, or nodes beside the axis of C or S");
      const Vector3d tangent = z.cross(out).normalized();
      if (type == "C")
        axes << out.normalized(), tangent, z;
      else
        axes << x.normalized(), tangent, x.normalized().cross(tangent);
    }
    deck_.axes[n] = turned * axes;
  }
}

std::vector<AbaqusElement*> AbaqusMesh::elements_for(const Keyword& k,
                                                     const std::set<std::string>& types) {
  std::vector<AbaqusElement*> chosen;
  std::vector<int> twice;
  for (int index : elements(k, {k.at, {}}, k.word("ELSET"))) {
    AbaqusElement& e = elements_.at(index);
    if (!types.contains(e.type))
      deck_error(k.at, "*" + k.name,
                 "is given to element " + std::to_string(e.label) + " of TYPE=" + e.type,
                 "an element set of one kind");
    if (!given_.insert({index, kind_of_section(k.name)}).second) twice.push_back(e.label);
    chosen.push_back(&e);
  }
  if (!twice.empty())
    deck_error(k.at, "*" + k.name,
               "element " + std::to_string(twice.front()) + " has one already" +
                   (twice.size() > 1
                        ? ", and so have " + std::to_string(twice.size() - 1) + " others of its set"
                        : ""),
               "one for each element");
  return chosen;
}

void AbaqusMesh::check_sections(DeckProblems& problems) const {
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const AbaqusElement& e = elements_[i];
    const std::string keyword = section_of(e.type);
    if (!keyword.empty() && !given_.contains({int(i), keyword}))
      problems.collect([&] {
        deck_error(e.at, "*ELEMENT", "element " + std::to_string(e.label) + " has no *" + keyword,
                   "one that names its set");
      });
  }
}

} // namespace plica
