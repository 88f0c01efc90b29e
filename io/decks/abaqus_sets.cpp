// Sets of an Abaqus deck, and which element has which section.
#include "io/decks/abaqus_mesh.hpp"

#include <unordered_set>

namespace plica {
namespace {

// The keyword that gives an element of this type its section; empty: none.
std::string section_of(const std::string& type) {
  static const std::map<std::string, std::string> needs{
      {"MASS", "MASS"},      {"ROTARYI", "ROTARY INERTIA"}, {"SPRING1", "SPRING"},
      {"SPRING2", "SPRING"}, {"SPRINGA", "SPRING"},         {"DCOUP3D", "DISTRIBUTING COUPLING"}};
  if (is_idle_type(type)) return "";
  if (type[0] == 'B' || type[0] == 'P' || type == "U1") return "BEAM SECTION";
  if (type[0] == 'T') return "SOLID SECTION";
  if (type.starts_with("M3D")) return "MEMBRANE SECTION";
  const auto need = needs.find(type);
  return need == needs.end() ? "SHELL SECTION" : need->second;
}

std::string kind_of_section(const std::string& keyword) {
  if (keyword == "BEAM GENERAL SECTION") return "BEAM SECTION";
  return keyword == "SHELL GENERAL SECTION" ? "SHELL SECTION" : keyword;
}

bool gives_sections(const std::string& kind) {
  static const std::set<std::string> kinds{
      "BEAM SECTION", "SHELL SECTION",  "SOLID SECTION", "MEMBRANE SECTION",
      "MASS",         "ROTARY INERTIA", "SPRING",        "DISTRIBUTING COUPLING"};
  return kinds.contains(kind);
}

void keep_first(std::vector<int>& list) {
  std::unordered_set<int> seen;
  std::erase_if(list, [&](int x) { return !seen.insert(x).second; });
}

} // namespace

std::vector<int> AbaqusMesh::in_range(const std::map<Label, int>& index, const std::string& scope,
                                      int first, int last, long step) {
  std::vector<int> found;
  for (auto at = index.lower_bound({scope, first});
       at != index.end() && at->first.first == scope && at->first.second <= last; ++at)
    if ((long(at->first.second) - first) % step == 0) found.push_back(at->second);
  return found;
}

// Entries of *NSET and *ELSET that are numbers, or a range of them. Numbers that no node or element
// has are left away, with a note, as CalculiX and Abaqus do.
std::vector<int> AbaqusMesh::numbers_of_set(const Keyword& k, const DataLine& line,
                                            const std::map<Label, int>& index) {
  const std::string scope = split(k, "").first;
  std::vector<int> found;
  long absent = 0;
  const auto take = [&](int one) {
    if (one >= 0) found.push_back(one);
  };
  if (k.has("GENERATE")) {
    const int first = whole_in(k, line, 0), last = whole_in(k, line, 1);
    const bool stepped = line.fields.size() > 2 && !line.fields[2].empty();
    const long step = stepped ? whole_in(k, line, 2) : 1;
    if (step <= 0)
      deck_error(line.at, "*" + k.name, "has a step of " + std::to_string(step), "1 or more");
    if (last < first) return found;
    absent = (long(last) - first) / step + 1;
    for (int one : in_range(index, scope, first, last, step)) {
      take(one);
      --absent;
    }
  } else {
    for (const std::string& field : line.fields)
      if (const auto label = deck_number(field)) {
        const auto at = index.find({scope, *label});
        if (at == index.end())
          ++absent;
        else
          take(at->second);
      }
  }
  if (absent > 0 && absent_ == 0)
    first_absent_ =
        "*" + k.name + " " + k.word(k.name) + " in line " + std::to_string(line.at.line);
  absent_ += static_cast<int>(std::min(absent, 1000000000L - absent_));
  return found;
}

// Each once, in their order: sets of sets would double with every level. A set of elements that are
// all skipped is empty.
void AbaqusMesh::read_sets() {
  for (auto& [name, set] : nsets_) keep_first(set); // what is generated may name a node again
  for (auto& [name, set] : elsets_) keep_first(set);
  for (const Keyword& k : sets_) {
    std::vector<int> more;
    const auto add = [&](const std::vector<int>& list) {
      more.insert(more.end(), list.begin(), list.end());
    };
    const bool of_nodes = k.name == "NSET";
    if (of_nodes && k.has("ELSET"))
      for (int e : elements(k, {k.at, {}}, k.word("ELSET"))) add(elements_.at(e).nodes);
    for (const DataLine& line : k.data) {
      if (of_nodes && k.has("ELSET")) break;
      add(numbers_of_set(k, line, of_nodes ? index_ : element_index_));
      if (k.has("GENERATE")) continue;
      for (const std::string& field : line.fields)
        if (!field.empty() && !deck_number(field))
          add(of_nodes ? nodes(k, line, field) : elements(k, line, field));
    }
    auto& sets = of_nodes ? nsets_ : elsets_;
    std::vector<int>& set = sets[{k.scope, k.word(k.name)}];
    set.insert(set.end(), more.begin(), more.end());
    keep_first(set);
  }
  for (const auto& [name, set] : nsets_)
    deck_.sets[name.first.empty() ? name.second : name.first + "." + name.second] = set;
  if (absent_ > 0)
    deck_.notes.push_back("of sets " + std::to_string(absent_) +
                          " numbers that no node or element has are left away, first in " +
                          first_absent_);
  if (same_nodes_ > 0)
    deck_.notes.push_back(std::to_string(same_nodes_) +
                          " nodes are given again where they are already");
}

void AbaqusMesh::choose_sections(const std::vector<Keyword>& keywords) {
  std::set<int> twice;
  std::string first;
  for (const Keyword& k : keywords) {
    const std::string kind = kind_of_section(k.name);
    if (!gives_sections(kind) || !k.has("ELSET")) continue;
    std::vector<int> of;
    try {
      of = elements(k, {k.at, {}}, k.word("ELSET"));
    } catch (const InputError&) {
      continue; // said where the section is read
    }
    if (!of.empty()) holds_.try_emplace({k.at.file, k.at.line}, false);
    for (int e : of) {
      const auto [known, is_new] = last_section_.insert_or_assign({e, kind}, k.at);
      if (is_new) continue;
      if (twice.empty())
        first = "element " + std::to_string(elements_.at(e).label) + ", *" + k.name + " in line " +
                std::to_string(k.at.line);
      twice.insert(e);
    }
  }
  for (const auto& [of, at] : last_section_) holds_[{at.file, at.line}] = true;
  if (!twice.empty())
    deck_.notes.push_back(std::to_string(twice.size()) +
                          " elements are given several sections and have the last of them, first " +
                          first);
}

bool AbaqusMesh::is_replaced(const Keyword& k) const {
  const auto known = holds_.find({k.at.file, k.at.line});
  return known != holds_.end() && !known->second;
}

std::vector<AbaqusElement*> AbaqusMesh::elements_for(const Keyword& k,
                                                     const std::set<std::string>& types) {
  const std::string kind = kind_of_section(k.name);
  std::vector<AbaqusElement*> chosen;
  for (int index : elements(k, {k.at, {}}, k.word("ELSET"))) {
    AbaqusElement& e = elements_.at(index);
    if (!types.contains(e.type))
      deck_error(k.at, "*" + k.name,
                 "is given to element " + std::to_string(e.label) + " of TYPE=" + e.type,
                 "an element set of one kind");
    const auto last = last_section_.find({index, kind});
    if (last != last_section_.end() &&
        (last->second.line != k.at.line || last->second.file != k.at.file))
      continue;
    given_.insert({index, kind});
    chosen.push_back(&e);
  }
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
