// Nodes, elements and sets of an Abaqus deck, found by their numbers and names.
#pragma once

#include "io/decks/abaqus_keywords.hpp"

namespace plica {

struct AbaqusElement {
  DeckPosition at;
  std::string type;
  std::string origin;     // for messages: "element 12 in line 34"
  std::vector<int> nodes; // indices
  int shell = -1;         // index into DeckModel::shells
};

class AbaqusMesh {
public:
  AbaqusMesh(DeckModel& deck, LeftOut& left_out) : deck_(deck), left_out_(left_out) {}

  KeywordHandlers handlers();
  void read_sets(); // after all keywords: they may name what comes later

  // InputError when there is none, here and below.
  int node(const Keyword& keyword, const DataLine& line, std::size_t field) const;
  // By their number or the name of a set.
  std::vector<int> nodes(const Keyword& keyword, const DataLine& line,
                         const std::string& name) const;
  std::vector<int> elements(const Keyword& keyword, const DataLine& line,
                            const std::string& name) const; // labels
  AbaqusElement& element(int label) { return elements_.at(label); }
  const AbaqusElement& element(int label) const { return elements_.at(label); }

  // Elements of the set that a section, mass or spring is for; each of these types, and each has
  // one section.
  std::vector<AbaqusElement*> elements_for(const Keyword& keyword,
                                           const std::set<std::string>& types);
  void check_sections() const; // every element has what its type needs

private:
  void read_nodes(const Keyword& keyword);
  void read_elements(const Keyword& keyword);

  DeckModel& deck_;
  LeftOut& left_out_;
  std::map<int, int> index_; // of nodes, by label
  std::map<int, AbaqusElement> elements_;
  std::map<std::string, std::vector<int>> nsets_;  // indices
  std::map<std::string, std::vector<int>> elsets_; // labels
  std::vector<Keyword> sets_;
  std::set<std::pair<int, std::string>> given_; // element, keyword of its section
};

} // namespace plica
