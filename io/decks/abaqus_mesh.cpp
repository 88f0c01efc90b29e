#include "io/decks/abaqus_mesh.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

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
      {"DASHPOTA", 2}, {"U1", 2},      {"R3D3", 3},    {"R3D4", 4},     {"RB3D2", 2},
      {"R2D2", 2}};
  const auto found = count.find(type);
  return found == count.end() ? 0 : found->second;
}

// Coordinates of a node of a kind of system as Cartesian ones.
Vector3d cartesian(const Keyword& k, const Vector3d& x) {
  constexpr double in_radians = std::numbers::pi / 180;
  const std::string kind = k.word_or("SYSTEM", "R");
  if (kind == "C")
    return {x[0] * std::cos(in_radians * x[1]), x[0] * std::sin(in_radians * x[1]), x[2]};
  if (kind == "S") {
    const double out = x[0] * std::cos(in_radians * x[2]);
    return {out * std::cos(in_radians * x[1]), out * std::sin(in_radians * x[1]),
            x[0] * std::sin(in_radians * x[2])};
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

KeywordHandlers AbaqusMesh::points() {
  const auto keep = [this](const Keyword& k) { sets_.push_back(k); };
  return {{"NODE", {[this](const Keyword& k) { read_nodes(k); }, {"NSET", "SYSTEM"}}},
          {"SYSTEM", {[this](const Keyword& k) { read_system(k); }, {}}},
          {"NSET", {keep, {"NSET", "GENERATE", "ELSET", "UNSORTED", "INTERNAL", "INSTANCE"}}},
          {"ELSET", {keep, {"ELSET", "GENERATE", "INTERNAL", "INSTANCE", "UNSORTED"}}}};
}

KeywordHandlers AbaqusMesh::handlers() {
  return {{"ELEMENT", {[this](const Keyword& k) { read_elements(k); }, {"TYPE", "ELSET"}}}};
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
  Vector3d x = system_.turn * cartesian(k, vector_in(k, line, 1)) + system_.move;
  if (place != instances_.end()) x = place->second.turn * x + place->second.move;
  put_in_set(k, "NSET", add_node(k, line, whole_in(k, line, 0), x));
}

// A number that is given again in the same place is the node that is there.
int AbaqusMesh::add_node(const Keyword& k, const DataLine& line, int label, const Vector3d& x) {
  const int index = static_cast<int>(deck_.nodes.size());
  const auto [known, is_new] = index_.try_emplace({k.scope, label}, index);
  if (!is_new && deck_.nodes[std::size_t(known->second)] == x) {
    ++same_nodes_;
    return known->second;
  }
  if (!is_new)
    deck_error(line.at, "*" + k.name,
               "node " + std::to_string(label) + " is there twice, first in line " +
                   std::to_string(node_lines_[std::size_t(known->second)]),
               "a number once");
  deck_.nodes.push_back(x);
  deck_.labels.push_back(label);
  node_lines_.push_back(line.at.line);
  return index;
}

void AbaqusMesh::put_in_set(const Keyword& k, const char* parameter, int node) {
  if (k.has(parameter)) nsets_[{k.scope, k.word(parameter)}].push_back(node);
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
      if (!line.fields.empty() && deck_number(line.fields[0]))
        element_index_.try_emplace({k.scope, *deck_number(line.fields[0])}, -1);
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
  const bool turned = (type[0] == 'B' && type[1] == '3') || type == "PIPE31" || type == "PIPE32";
  if (line.fields.size() != count + 1 && !(turned && line.fields.size() == count + 2))
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
  if (line.fields.size() == count + 2) element.towards = node(k, line, count + 1);
  add_element(k, std::move(element));
}

void AbaqusMesh::add_element(const Keyword& k, AbaqusElement element) {
  const int index = static_cast<int>(elements_.size());
  const auto [known, is_new] = element_index_.try_emplace({k.scope, element.label}, index);
  if (!is_new)
    deck_error(element.at, "*" + k.name,
               "element " + std::to_string(element.label) + " is there twice" +
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
  auto found = sets.find({scope, own});
  if (found == sets.end()) found = sets.find({"", own});
  const bool by_parameter = line.fields.empty(); // ELSET=2 is a set, not element 2
  if (const auto label = deck_number(own); label && !(by_parameter && found != sets.end())) {
    const auto one = index.find({scope, *label});
    if (one == index.end())
      deck_error(line.at, "*" + k.name, "there is no " + what + " " + name, "one of the deck");
    return one->second < 0 ? std::vector<int>{} : std::vector<int>{one->second};
  }
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

} // namespace plica
