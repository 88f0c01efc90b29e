// Nodes and elements of an Abaqus deck that are made of others: *NGEN, *NFILL, *NCOPY, *ELGEN,
// *ELCOPY.
#include "io/decks/abaqus_mesh.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace plica {
namespace {

using Eigen::Vector3d;

constexpr long most_generated = 5000000; // of a deck

long whole_or(const Keyword& k, const DataLine& line, std::size_t field, long otherwise) {
  return field < line.fields.size() && !line.fields[field].empty() ? whole_in(k, line, field)
                                                                   : otherwise;
}

Vector3d vector_at(const Keyword& k, const DataLine& line, std::size_t first) {
  return {number_in(k, line, first, 0), number_in(k, line, first + 1, 0),
          number_in(k, line, first + 2, 0)};
}

int checked_label(const Keyword& k, const DataLine& line, long label) {
  if (label < 1 || label > 999999999)
    deck_error(line.at, "*" + k.name, "makes number " + std::to_string(label), "1 to 999999999");
  return static_cast<int>(label);
}

} // namespace

KeywordHandlers AbaqusMesh::generated_points() {
  const auto lines = [this](void (AbaqusMesh::*one)(const Keyword&, const DataLine&)) {
    return [this, one](const Keyword& k) {
      for (const DataLine& line : k.data) (this->*one)(k, line);
    };
  };
  return {{"NGEN", {lines(&AbaqusMesh::generate_line), {"NSET", "LINE"}}},
          {"NFILL", {lines(&AbaqusMesh::fill_between), {"NSET"}}},
          {"NCOPY",
           {[this](const Keyword& k) { copy_nodes(k); },
            {"OLD SET", "NEW SET", "CHANGE NUMBER", "SHIFT", "MULTIPLE"}}}};
}

KeywordHandlers AbaqusMesh::generated_elements() {
  return {{"ELGEN",
           {[this](const Keyword& k) {
              for (const DataLine& line : k.data) generate_array(k, line);
            },
            {"ELSET"}}},
          {"ELCOPY",
           {[this](const Keyword& k) { copy_elements(k); },
            {"OLD SET", "NEW SET", "ELEMENT SHIFT", "SHIFT NODES"}}}};
}

void AbaqusMesh::count_generated(const Keyword& k, const DataLine& line, long count) {
  generated_ += count;
  if (generated_ > most_generated)
    deck_error(line.at, "*" + k.name, "makes more than five million", "fewer nodes and elements");
}

int AbaqusMesh::labelled(const Keyword& k, const DataLine& line, const std::map<Label, int>& index,
                         long label, const char* what) const {
  const auto found = index.find({k.scope, checked_label(k, line, label)});
  if (found == index.end() || found->second < 0)
    deck_error(line.at, "*" + k.name, std::string("there is no ") + what + std::to_string(label),
               "one of the deck");
  return found->second;
}

// First and last node, step of the numbers; on an arc (LINE=C) the node in its centre, or its
// coordinates, and the direction that it turns about where the three lie on one line.
void AbaqusMesh::generate_line(const Keyword& k, const DataLine& line) {
  const std::string kind = k.word_or("LINE", "S");
  if (kind != "S" && kind != "C")
    deck_error(k.at, "*NGEN", "has LINE=" + kind, "a straight line, or LINE=C");
  const int first = node(k, line, 0), last = node(k, line, 1);
  const long from = deck_.labels[std::size_t(first)], to = deck_.labels[std::size_t(last)];
  const long step = std::abs(whole_or(k, line, 2, 1));
  const long parts = step > 0 ? std::abs(to - from) / step : 0;
  if (parts < 1 || parts * step != std::abs(to - from))
    deck_error(line.at, "*NGEN",
               "goes from node " + std::to_string(from) + " to " + std::to_string(to) +
                   " in steps of " + std::to_string(step),
               "steps that end at the last node");
  count_generated(k, line, parts);
  const Vector3d a = deck_.nodes[std::size_t(first)], b = deck_.nodes[std::size_t(last)];
  Vector3d centre(0, 0, 0), axis(0, 0, 0);
  double angle = 0;
  if (kind == "C") {
    const bool named = line.fields.size() > 3 && !line.fields[3].empty();
    centre = named ? deck_.nodes[std::size_t(node(k, line, 3))] : place(k, vector_at(k, line, 4));
    const Vector3d given = turn(k) * vector_at(k, line, 7);
    axis = (a - centre).cross(b - centre);
    angle = std::atan2(axis.norm(), (a - centre).dot(b - centre));
    if (given.norm() > 0) {
      if (axis.dot(given) < 0) angle = 2 * std::numbers::pi - angle;
      axis = given;
    }
    if (!(axis.norm() > 1e-9 * (a - centre).squaredNorm()) || !(angle > 0))
      deck_error(line.at, "*NGEN", "is an arc whose plane is not known",
                 "a centre beside the line between its ends, or the direction it turns about");
    axis.normalize();
  }
  put_in_set(k, "NSET", first);
  for (long i = 1; i < parts; ++i) {
    const double s = double(i) / double(parts);
    const Vector3d x =
        angle > 0
            ? Vector3d(centre +
                       Eigen::AngleAxisd(s * angle, axis) *
                           Vector3d((1 + s * ((b - centre).norm() / (a - centre).norm() - 1)) *
                                    (a - centre)))
            : Vector3d(a + s * (b - a));
    const long label = from + (to > from ? i : -i) * step;
    put_in_set(k, "NSET", add_node(k, line, checked_label(k, line, label), x));
  }
  put_in_set(k, "NSET", last);
}

std::vector<int> AbaqusMesh::known_set(SetOf of, const Keyword& k, const DataLine& line,
                                       const std::string& name, int depth) const {
  const bool of_nodes = of == SetOf::nodes;
  const std::string kind = of_nodes ? "NSET" : "ELSET", wanted = in_capitals(name);
  const auto& index = of_nodes ? index_ : element_index_;
  const auto& sets = of_nodes ? nsets_ : elsets_;
  std::vector<int> all;
  if (const auto own = sets.find({k.scope, wanted}); own != sets.end()) all = own->second;
  const auto add = [&](const std::vector<int>& more) {
    std::copy_if(more.begin(), more.end(), std::back_inserter(all), [](int n) { return n >= 0; });
  };
  bool sorted = true;
  for (const Keyword& set : sets_) {
    if (set.name != kind || set.word(kind) != wanted) continue;
    if (set.has("UNSORTED")) sorted = false;
    if (set.scope != k.scope || (of_nodes && set.has("ELSET"))) continue;
    if (depth > 20) deck_error(line.at, "*" + k.name, "sets name each other", "sets that end");
    for (const DataLine& entry : set.data) {
      if (set.has("GENERATE")) {
        const int first = whole_in(set, entry, 0), last = whole_in(set, entry, 1);
        add(in_range(index, k.scope, first, last, std::max(1L, whole_or(set, entry, 2, 1))));
        continue;
      }
      for (const std::string& field : entry.fields) {
        if (field.empty()) continue;
        if (const auto label = deck_number(field))
          add(in_range(index, k.scope, *label, *label, 1));
        else
          add(known_set(of, k, line, field, depth + 1));
      }
    }
  }
  const auto number = [&](int n) { return of_nodes ? deck_.labels[std::size_t(n)] : n; };
  if (sorted || !of_nodes)
    std::sort(all.begin(), all.end(), [&](int p, int q) { return number(p) < number(q); });
  all.erase(std::unique(all.begin(), all.end()), all.end());
  const bool too_many = all.size() > std::size_t(most_generated);
  if (all.empty() ? of_nodes || depth == 0 : too_many)
    deck_error(line.at, "*" + k.name,
               std::string("there is no ") + (of_nodes ? "node" : "element") + " set " + name,
               of_nodes ? "a set of nodes" : "a set of elements");
  return all;
}

// Two sets whose nodes belong together in pairs, intervals between them, step of the numbers.
void AbaqusMesh::fill_between(const Keyword& k, const DataLine& line) {
  if (line.fields.size() < 2) deck_error(line.at, "*NFILL", "names one set", "two");
  const std::vector<int> from = known_set(SetOf::nodes, k, line, line.fields[0]);
  const std::vector<int> to = known_set(SetOf::nodes, k, line, line.fields[1]);
  const long parts = whole_or(k, line, 2, 1), step = whole_or(k, line, 3, 1);
  if (from.size() != to.size() || parts < 1)
    deck_error(line.at, "*NFILL",
               "joins sets of " + std::to_string(from.size()) + " and " +
                   std::to_string(to.size()) + " nodes in " + std::to_string(parts) + " intervals",
               "sets of as many nodes, one interval or more");
  count_generated(k, line, parts > most_generated ? parts : parts * long(from.size()));
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Vector3d a = deck_.nodes[std::size_t(from[i])], b = deck_.nodes[std::size_t(to[i])];
    const long label = deck_.labels[std::size_t(from[i])];
    put_in_set(k, "NSET", from[i]);
    for (long j = 1; j < parts; ++j)
      put_in_set(k, "NSET",
                 add_node(k, line, checked_label(k, line, label + j * step),
                          a + (double(j) / double(parts)) * (b - a)));
    put_in_set(k, "NSET", to[i]);
  }
}

// First line: a shift; second: two points of an axis and the angle about it, degrees, after it.
// MULTIPLE: again and again, the numbers likewise.
void AbaqusMesh::copy_nodes(const Keyword& k) {
  if (!k.has("SHIFT")) deck_error(k.at, "*NCOPY", "is no shift", "SHIFT");
  const DataLine& line = data_line(k, 0);
  const std::vector<int> old = known_set(SetOf::nodes, k, line, k.word("OLD SET"));
  const long change = whole_in(k, {k.at, {k.word("CHANGE NUMBER")}}, 0);
  const long times = k.has("MULTIPLE") ? whole_in(k, {k.at, {k.word("MULTIPLE")}}, 0) : 1;
  if (times < 1 || times > most_generated)
    deck_error(k.at, "*NCOPY", "has MULTIPLE=" + k.word("MULTIPLE"), "1 or more");
  count_generated(k, line, times * long(old.size()));
  const Vector3d shift = turn(k) * vector_at(k, line, 0);
  Vector3d a(0, 0, 0), axis(0, 0, 1);
  double angle = 0;
  if (k.data.size() > 1) {
    a = place(k, vector_at(k, k.data[1], 0));
    axis = place(k, vector_at(k, k.data[1], 3)) - a;
    angle = number_in(k, k.data[1], 6, 0) * std::numbers::pi / 180;
    if (angle != 0 && !(axis.norm() > 0))
      deck_error(k.data[1].at, "*NCOPY", "turns about a line without length", "two points");
  }
  for (long i = 1; i <= times; ++i)
    for (int n : old) {
      Vector3d x = deck_.nodes[std::size_t(n)] + double(i) * shift;
      if (angle != 0) x = a + Eigen::AngleAxisd(double(i) * angle, axis.normalized()) * (x - a);
      const long label = deck_.labels[std::size_t(n)] + i * change;
      put_in_set(k, "NEW SET", add_node(k, line, checked_label(k, line, label), x));
    }
}

void AbaqusMesh::shift_element(const Keyword& k, const DataLine& line, int element, long label,
                               long nodes, const char* set) {
  AbaqusElement copy = elements_.at(std::size_t(element));
  copy.at = line.at;
  copy.label = checked_label(k, line, label);
  copy.origin = "element " + std::to_string(label) + " of *" + k.name + " in line " +
                std::to_string(line.at.line);
  for (int& n : copy.nodes)
    n = labelled(k, line, index_, deck_.labels[std::size_t(n)] + nodes, "node ");
  add_element(k, std::move(copy));
  if (k.has(set) && std::string(set) != "ELSET")
    elsets_[{k.scope, k.word(set)}].push_back(labelled(k, line, element_index_, label, "element "));
}

// The element, then number, step of nodes and of elements in a row, of rows and of layers.
void AbaqusMesh::generate_array(const Keyword& k, const DataLine& line) {
  const int master = labelled(k, line, element_index_, whole_in(k, line, 0), "element ");
  const long label = elements_[std::size_t(master)].label;
  long count[3], nodes[3], elements[3];
  for (std::size_t d = 0; d < 3; ++d) {
    count[d] = whole_or(k, line, 1 + 3 * d, 1);
    nodes[d] = whole_or(k, line, 2 + 3 * d, d == 0 ? 1 : 0);
    elements[d] = whole_or(k, line, 3 + 3 * d, d == 0 ? 1 : 0);
    if (count[d] < 1 || count[d] > most_generated)
      deck_error(line.at, "*ELGEN", "makes " + std::to_string(count[d]) + " elements",
                 "1 or more along each direction");
    count_generated(k, line, d == 0 ? count[0] : 0);
  }
  if (double(count[0]) * double(count[1]) * double(count[2]) > double(most_generated))
    count_generated(k, line, most_generated);
  if (k.has("ELSET")) elsets_[{k.scope, k.word("ELSET")}].push_back(master);
  for (long h = 0; h < count[2]; ++h)
    for (long j = 0; j < count[1]; ++j)
      for (long i = 0; i < count[0]; ++i)
        if (h + j + i > 0)
          shift_element(k, line, master,
                        label + i * elements[0] + j * elements[1] + h * elements[2],
                        i * nodes[0] + j * nodes[1] + h * nodes[2], "ELSET");
}

void AbaqusMesh::copy_elements(const Keyword& k) {
  const DataLine line{k.at, {}};
  const std::vector<int> old = known_set(SetOf::elements, k, line, k.word("OLD SET"));
  count_generated(k, line, long(old.size()));
  const long elements = whole_in(k, {k.at, {k.word("ELEMENT SHIFT")}}, 0);
  const long nodes = whole_in(k, {k.at, {k.word("SHIFT NODES")}}, 0);
  for (int e : old)
    shift_element(k, line, e, elements_[std::size_t(e)].label + elements, nodes, "NEW SET");
}

} // namespace plica
