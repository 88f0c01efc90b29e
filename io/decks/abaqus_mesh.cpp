#include "io/decks/abaqus_mesh.hpp"

#include <optional>
#include <unordered_set>

namespace plica {
namespace {

std::size_t nodes_of_type(const std::string& type) {
  static const std::map<std::string, std::size_t> count{
      {"S4", 4},  {"S4R", 4},  {"S4R5", 4},    {"S3", 3},      {"S3R", 3},     {"B31", 2},
      {"B33", 2}, {"MASS", 1}, {"ROTARYI", 1}, {"SPRING1", 1}, {"SPRING2", 2}, {"DCOUP3D", 1}};
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

// The keyword that gives an element of this type its section.
std::string section_of(const std::string& type) {
  static const std::map<std::string, std::string> needs{{"B31", "BEAM SECTION"},
                                                        {"B33", "BEAM SECTION"},
                                                        {"MASS", "MASS"},
                                                        {"ROTARYI", "ROTARY INERTIA"},
                                                        {"SPRING1", "SPRING"},
                                                        {"SPRING2", "SPRING"},
                                                        {"DCOUP3D", "DISTRIBUTING COUPLING"}};
  const auto need = needs.find(type);
  return need == needs.end() ? "SHELL SECTION" : need->second;
}

void keep_first(std::vector<int>& list) {
  std::unordered_set<int> seen;
  std::erase_if(list, [&](int x) { return !seen.insert(x).second; });
}

} // namespace

KeywordHandlers AbaqusMesh::handlers() {
  const auto keep = [this](const Keyword& k) { sets_.push_back(k); };
  return {{"NODE", {[this](const Keyword& k) { read_nodes(k); }, {"NSET"}}},
          {"ELEMENT", {[this](const Keyword& k) { read_elements(k); }, {"TYPE", "ELSET"}}},
          {"NSET", {keep, {"NSET", "GENERATE", "ELSET", "UNSORTED", "INTERNAL"}}},
          {"ELSET", {keep, {"ELSET", "GENERATE", "INTERNAL"}}}};
}

void AbaqusMesh::read_nodes(const Keyword& k) {
  for (const DataLine& line : k.data) {
    const int label = whole_in(k, line, 0);
    if (!index_.try_emplace(label, int(deck_.nodes.size())).second)
      deck_error(line.at, "*NODE", "node " + std::to_string(label) + " is there twice",
                 "a number once");
    deck_.nodes.emplace_back(number_in(k, line, 1, 0), number_in(k, line, 2, 0),
                             number_in(k, line, 3, 0));
    deck_.labels.push_back(label);
    if (k.has("NSET")) nsets_[k.word("NSET")].push_back(int(deck_.nodes.size()) - 1);
  }
}

void AbaqusMesh::read_elements(const Keyword& k) {
  const std::string type = k.word("TYPE");
  const std::size_t count = nodes_of_type(type);
  if (count == 0) {
    left_out_.note(k, "has TYPE=" + type + ", which is not known",
                   "S4, S4R, S4R5, S3, S3R, B31, B33, MASS, ROTARYI, SPRING1, SPRING2, DCOUP3D");
    return;
  }
  for (const DataLine& line : k.data) {
    const int label = whole_in(k, line, 0);
    if (line.fields.size() != count + 1)
      deck_error(line.at, "*ELEMENT",
                 "has " + std::to_string(line.fields.size() - 1) + " nodes for " + type,
                 std::to_string(count));
    AbaqusElement element{.at = line.at,
                          .type = type,
                          .origin = "element " + std::to_string(label) + " in line " +
                                    std::to_string(line.at.line),
                          .nodes = {}};
    for (std::size_t i = 1; i <= count; ++i) element.nodes.push_back(node(k, line, i));
    if (!elements_.try_emplace(label, std::move(element)).second)
      deck_error(line.at, "*ELEMENT", "element " + std::to_string(label) + " is there twice",
                 "a number once");
    if (k.has("ELSET")) elsets_[k.word("ELSET")].push_back(label);
  }
}

int AbaqusMesh::node(const Keyword& k, const DataLine& line, std::size_t field) const {
  const int label = whole_in(k, line, field);
  const auto found = index_.find(label);
  if (found == index_.end())
    deck_error(line.at, "*" + k.name, "there is no node " + std::to_string(label),
               "a node of the deck");
  return found->second;
}

// Each once, in their order: sets of sets would double with every level.
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
    std::vector<int>& set = k.name == "NSET" ? nsets_[k.word("NSET")] : elsets_[k.word("ELSET")];
    set.insert(set.end(), more.begin(), more.end());
    keep_first(set);
  }
  deck_.sets = nsets_;
}

std::vector<int> AbaqusMesh::nodes(const Keyword& k, const DataLine& line,
                                   const std::string& name) const {
  if (const auto label = as_number(name)) {
    const auto found = index_.find(*label);
    if (found == index_.end())
      deck_error(line.at, "*" + k.name, "there is no node " + name, "a node of the deck");
    return {found->second};
  }
  const auto found = nsets_.find(in_capitals(name));
  if (found == nsets_.end())
    deck_error(line.at, "*" + k.name, "there is no node set " + name, "a set given by *NSET");
  return found->second;
}

std::vector<int> AbaqusMesh::elements(const Keyword& k, const DataLine& line,
                                      const std::string& name) const {
  if (const auto label = as_number(name)) {
    if (!elements_.contains(*label))
      deck_error(line.at, "*" + k.name, "there is no element " + name, "an element of the deck");
    return {*label};
  }
  const auto found = elsets_.find(in_capitals(name));
  if (found == elsets_.end())
    deck_error(line.at, "*" + k.name, "there is no element set " + name,
               "a set given by *ELSET or *ELEMENT");
  return found->second;
}

std::vector<AbaqusElement*> AbaqusMesh::elements_for(const Keyword& k,
                                                     const std::set<std::string>& types) {
  std::vector<AbaqusElement*> chosen;
  for (int label : elements(k, {k.at, {}}, k.word("ELSET"))) {
    AbaqusElement& e = elements_.at(label);
    if (!types.contains(e.type))
      deck_error(k.at, "*" + k.name,
                 "is given to element " + std::to_string(label) + " of TYPE=" + e.type,
                 "an element set of one kind");
    if (!given_.insert({label, k.name == "BEAM GENERAL SECTION" ? "BEAM SECTION" : k.name}).second)
      deck_error(k.at, "*" + k.name, "element " + std::to_string(label) + " has one already",
                 "one for each element");
    chosen.push_back(&e);
  }
  return chosen;
}

void AbaqusMesh::check_sections() const {
  for (const auto& [label, e] : elements_)
    if (const std::string keyword = section_of(e.type); !given_.contains({label, keyword}))
      deck_error(e.at, "*ELEMENT", "element " + std::to_string(label) + " has no *" + keyword,
                 "one that names its set");
}

} // namespace plica
