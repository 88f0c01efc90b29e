// Nodes, elements and sets of an Abaqus deck, found by their numbers and names.
//
// A number or a name belongs to the scope of the keyword that gives it: an instance, or the
// assembly, which is all there is of a flat deck. "PLATE-1.7" and "PLATE-1.EDGE" name what another
// scope has; a set of the assembly that says INSTANCE= lists numbers of that instance.
#pragma once

#include "io/decks/abaqus_keywords.hpp"
#include "io/decks/abaqus_parts.hpp"
#include "io/decks/deck_refusal.hpp"

namespace plica {

struct AbaqusElement {
  DeckPosition at;
  std::string type;
  std::string origin; // for messages: "element 12 in line 34"
  int label = 0;
  std::vector<int> nodes;      // indices
  std::vector<int> shells;     // indices into DeckModel::shells, more than one where it is split
  std::vector<int> beams = {}; // likewise
  std::vector<int> bars = {};  // into springs: of a truss, a membrane of three nodes
  int towards = -1; // a node that a beam names after its own: n1 of its section points there
};

class AbaqusMesh {
public:
  AbaqusMesh(DeckModel& deck, LeftOut& left_out, MissingCards& missing,
             const std::map<std::string, InstancePlace>& instances)
      : deck_(deck), left_out_(left_out), missing_(missing), instances_(instances) {}

  // Nodes, what is made of nodes, elements, what is made of elements: each may stand before what it
  // builds on.
  KeywordHandlers points();
  KeywordHandlers generated_points();
  KeywordHandlers handlers();
  KeywordHandlers generated_elements();
  KeywordHandlers axes(); // *TRANSFORM, once there are sets
  void read_sets();       // after all keywords: they may name what comes later
  // An element that several sections name has the last, as in CalculiX; a note says so.
  void choose_sections(const std::vector<Keyword>& keywords);
  bool is_replaced(const Keyword& section) const; // of all its elements, by later ones

  Eigen::Matrix3d turn(const Keyword& keyword) const; // of the instance it belongs to
  Eigen::Vector3d place(const Keyword& keyword, const Eigen::Vector3d& point) const; // of that
  // InputError when there is none, here and below.
  int node(const Keyword& keyword, const DataLine& line, std::size_t field) const;
  // By their number or the name of a set.
  std::vector<int> nodes(const Keyword& keyword, const DataLine& line,
                         const std::string& name) const;
  std::vector<int> elements(const Keyword& keyword, const DataLine& line,
                            const std::string& name) const; // indices
  const std::vector<AbaqusElement>& elements() const { return elements_; }
  AbaqusElement& element(int index) { return elements_.at(index); }
  const AbaqusElement& element(int index) const { return elements_.at(index); }

  // Elements of the set that a section, mass or spring is for; each of these types, and each has
  // one section.
  std::vector<AbaqusElement*> elements_for(const Keyword& keyword,
                                           const std::set<std::string>& types);
  void check_sections(DeckProblems& problems) const; // every element has what its type needs

private:
  using Name = std::pair<std::string, std::string>; // scope, name
  using Label = std::pair<std::string, int>;
  void read_nodes(const Keyword& keyword);
  void read_system(const Keyword& keyword);
  void read_node(const Keyword& keyword, const DataLine& line);
  int add_node(const Keyword& keyword, const DataLine& line, int label, const Eigen::Vector3d& x);
  void generate_line(const Keyword& keyword, const DataLine& line);  // *NGEN
  void fill_between(const Keyword& keyword, const DataLine& line);   // *NFILL
  void copy_nodes(const Keyword& keyword);                           // *NCOPY
  void generate_array(const Keyword& keyword, const DataLine& line); // *ELGEN
  void copy_elements(const Keyword& keyword);                        // *ELCOPY
  void put_in_set(const Keyword& keyword, const char* parameter, int node);
  void shift_element(const Keyword& keyword, const DataLine& line, int element, long label,
                     long nodes, const char* set);
  int labelled(const Keyword& keyword, const DataLine& line, const std::map<Label, int>& index,
               long label, const char* what) const;
  // Those of a set while not all sets are known; nodes by their numbers, but where it is UNSORTED.
  enum class SetOf { nodes, elements };
  std::vector<int> known_set(SetOf of, const Keyword& keyword, const DataLine& line,
                             const std::string& name, int depth = 0) const;
  // Of the numbers first, first + step .. last those that are there, skipped elements (-1) too.
  static std::vector<int> in_range(const std::map<Label, int>& index, const std::string& scope,
                                   int first, int last, long step);
  void count_generated(const Keyword& keyword, const DataLine& line, long count);
  void read_elements(const Keyword& keyword);
  void add_element(const Keyword& keyword, AbaqusElement element);
  void read_element(const Keyword& keyword, const DataLine& line, const std::string& type,
                    std::size_t count);
  void read_transform(const Keyword& keyword);
  // A name as written by a keyword: its scope and what is left of it.
  Name split(const Keyword& keyword, const std::string& name) const;
  std::vector<int> numbers_of_set(const Keyword& keyword, const DataLine& line,
                                  const std::map<Label, int>& index);
  template <class Indices>
  std::vector<int> find(const Keyword& keyword, const DataLine& line, const std::string& name,
                        const Indices& index, const std::map<Name, std::vector<int>>& sets,
                        const std::string& what) const;

  DeckModel& deck_;
  LeftOut& left_out_;
  MissingCards& missing_;
  const std::map<std::string, InstancePlace>& instances_;
  InstancePlace system_;       // *SYSTEM in force
  std::map<Label, int> index_; // of nodes
  std::vector<int> node_lines_;
  std::vector<AbaqusElement> elements_;
  std::map<Label, int> element_index_; // -1: skipped, of a type that is not had
  std::map<Name, std::vector<int>> nsets_, elsets_;
  std::vector<Keyword> sets_;
  std::set<std::pair<int, std::string>> given_; // element, keyword of its section
  std::map<std::pair<int, std::string>, DeckPosition> last_section_;
  std::map<std::pair<std::string, int>, bool> holds_; // sections by file and line: of some element
  long generated_ = 0;
  int same_nodes_ = 0, absent_ = 0;
  std::string first_absent_;
};

} // namespace plica
