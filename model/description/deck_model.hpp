// A model that somebody else has written, as Abaqus and Nastran decks hold it: nodes, shells,
// beams, masses, springs, couplings, equations, what is held. In the units of the deck, which has
// none; seconds are assumed. Readers: io/decks.
#pragma once

#include "elements/shell_laminate.hpp"
#include "model/description/deck_loads.hpp"
#include "solve/model.hpp"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace plica {

// alpha (T - reference): strain of a material at a temperature. Not a number: it expands, and not
// in all directions alike.
struct DeckExpansion {
  double alpha = 0, reference = 0; // 1 over a degree of the deck, degrees
};

// What a beam, or a bar among the springs, is in its deck.
struct DeckBar {
  int element = 0;    // its number
  std::string origin; // for messages: "CBAR 12 in line 34"
  DeckExpansion expansion = {};
  Eigen::Vector3d y{0, 0, 0}; // of a beam: the first axis of its section, as the deck has it
  // Of a beam among the springs: from its nodes to where its ends weigh.
  std::array<Eigen::Vector3d, 2> arms = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 0, 0)};
};

struct DeckShell {
  std::vector<int> nodes;        // three or four
  int section = 0;               // index into DeckModel::sections
  std::vector<double> thickness; // one per corner
  double offset = 0;             // nodes to the middle of the wall, along the normal
  std::string origin = {};       // for messages: "element 12 in line 34"
  std::vector<std::optional<Eigen::Vector3d>> normal; // given ones, one per corner or none at all
  int laminate = -1; // index into DeckModel::laminates, in place of the section: a matrix
  Eigen::Vector3d along = Eigen::Vector3d::Zero(); // axis 1 of the laminate, not yet projected
  int element = 0;                                 // its number in a Nastran deck
  DeckExpansion expansion = {};
};

struct DeckCoupling {
  bool distributing = false; // or kinematic
  int reference = 0;
  std::vector<int> nodes;
  std::vector<double> weights; // distributing; empty = equal
  std::vector<int> dofs;       // 0..5, along DeckModel::axes; distributing: the first three, or all
  std::string origin;          // for messages: "*COUPLING SPIDER"
};

struct DeckModel {
  std::vector<Eigen::Vector3d> nodes;
  std::vector<int> labels; // numbers of the nodes in the deck
  std::map<std::string, std::vector<int>> sets;
  std::vector<ShellSection> sections;
  std::vector<ShellLaminate> laminates;
  std::vector<DeckShell> shells;
  std::vector<BeamElement> beams;
  std::vector<MassElement> masses;
  std::vector<BushingElement> bushings;        // their law acts in the middle
  std::vector<MatrixElement> springs;          // and bars, masses of single DOFs: global axes
  std::map<int, DeckBar> of_beams, of_springs; // by index; of springs those that are bars or walls
  std::vector<DeckCoupling> couplings;
  std::vector<Constraint> equations;
  std::vector<Constraint> supports;
  std::vector<DeckLoadCase> load_cases; // static ones
  // Nodes whose DOFs in couplings (where they follow), equations and supports are along the columns
  // of a matrix in place of the global axes.
  std::map<int, Eigen::Matrix3d> axes;
  std::set<int> scalars; // nodes without a place, of one DOF, their first
  // Shells, beams and bars have their mass at their nodes alone, as in Nastran without COUPMASS.
  bool lumped_mass = false;
  // DOFs with mass and without stiffness are held, as AUTOSPC of Nastran does.
  bool holds_what_has_no_stiffness = false;
  std::set<std::string> files;       // that it was read from
  std::vector<std::string> left_out; // cards that are not followed: "model.inp:12: *DAMPING"
  std::vector<std::string> notes;    // what else is to be known: "passed over: 12 FORCE, LOAD"
};

// By its suffix, in any case: .inp is Abaqus, .bdf .dat .nas .fem Nastran. A reader looks into a
// file as well: some Nastran decks are called .inp.
enum class DeckFormat { none, abaqus, nastran };
DeckFormat deck_format(const std::filesystem::path& file);

} // namespace plica
