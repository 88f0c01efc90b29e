// Static load cases of an Abaqus deck: every step of *STATIC with what acts and holds at its end.
//
// Loads go on from step to step until OP=NEW; a load that is given again in a later step replaces
// the one before, within a step they add. A perturbation has its own loads alone and leaves none.
#pragma once

#include "io/decks/abaqus_joints.hpp"

namespace plica {

bool is_load_keyword(const std::string& name);

class AbaqusLoads {
public:
  AbaqusLoads(DeckModel& deck, AbaqusMesh& mesh, AbaqusJoints& joints)
      : deck_(deck), mesh_(mesh), joints_(joints) {}

  // The handlers of what holds together with those of loads and steps: they go in the order of the
  // deck.
  KeywordHandlers with(KeywordHandlers joints);
  void finish(); // a step without *END STEP

private:
  void begin_step(const Keyword& keyword);
  void end_step();
  void add_case(); // of the step that ends
  void read(const Keyword& keyword, void (AbaqusLoads::*how)(const Keyword&));
  void cload(const Keyword& keyword);
  void dload(const Keyword& keyword);
  void dsload(const Keyword& keyword);
  void gravity(const Keyword& keyword, const DataLine& line);
  void temperature(const Keyword& keyword);
  void initial_conditions(const Keyword& keyword);
  void press(int element, const std::string& label, double value);
  void add_distributed(DeckLoadCase& made) const;
  void add_strains(DeckLoadCase& made) const;

  struct Loads {
    std::map<std::pair<int, int>, double> forces; // by node and DOF, along its axes
    // By element and what acts: "P" along the normal of a shell, "SPOS", "SNEG" on a side of it,
    // "PX" .. "P2" of a beam.
    std::map<std::pair<int, std::string>, double> pressures;
    std::map<int, double> temperatures;             // by node
    std::map<std::string, Eigen::Vector3d> gravity; // by the name of its elements
    std::set<std::string> not_had;
  };

  DeckModel& deck_;
  AbaqusMesh& mesh_;
  AbaqusJoints& joints_;
  Loads now_, before_; // before_: when the step began
  std::map<std::pair<int, int>, double> moved_before_;
  std::size_t held_before_ = 0;
  int steps_ = 0;
  bool open_ = false, static_ = false, riks_ = false, large_ = false, perturbation_ = false;
  // Given in this step already: what comes again adds.
  std::set<std::pair<int, int>> forces_of_step_;
  std::set<std::pair<int, std::string>> pressures_of_step_;
  std::set<std::string> gravity_of_step_;
  std::set<std::string> new_;                // keywords with OP=NEW in this step
  std::map<int, double> initial_;            // temperatures by node
  std::vector<std::string> unknown_initial_; // what of them is not had
};

} // namespace plica
