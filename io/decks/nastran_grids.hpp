// Grid and scalar points of a Nastran deck: positions in the basic system, axes of their
// displacements, found by their numbers.
#pragma once

#include "io/decks/bulk_data.hpp"
#include "model/description/deck_model.hpp"

#include <array>

namespace plica {

// Cards by name.
using CardsByName = std::map<std::string, std::vector<const Card*>>;

// CORD1R .. CORD2S by their number, GRID with what GRDSET says where it is blank, SPOINT.
class NastranGrids {
public:
  NastranGrids(const CardsByName& cards, DeckModel& deck);

  // Index of the node with the number in that field; InputError when there is none.
  int at(const Card& card, std::size_t field) const { return find(card, card.whole(field)); }
  int find(const Card& card, int label) const;
  std::vector<int> find(const Card& card, const std::vector<int>& labels) const;
  // "1 THRU 9" of a list from a field on: those that are there; else each has to be.
  std::vector<int> list(const Card& card, std::size_t first) const;
  // A DOF 0..5 from a field; blank or 0 is that of a scalar point.
  int dof(const Card& card, int node, std::size_t field) const;

  Eigen::Matrix3d axes(int node) const; // of its displacements, columns in the basic system
  // Axes of a system at a point of the basic one, by the number in a field, blank = basic.
  Eigen::Matrix3d axes(const Card& card, std::size_t field, const Eigen::Vector3d& at);

private:
  struct System {
    char kind = 'R';
    Eigen::Vector3d origin{0, 0, 0};
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  };
  void read_points();
  void read_scalars();
  int place_grid(const Card& card); // and those that its system rests on
  const System& system(const Card& card, int number);
  System three_points(const Card& card, char kind, const std::array<Eigen::Vector3d, 3>& points);
  static Eigen::Vector3d place(const System& system, const Eigen::Vector3d& coordinates);
  static Eigen::Matrix3d axes_at(const System& system, const Eigen::Vector3d& point);

  const CardsByName& cards_;
  DeckModel& deck_;
  const Card* defaults_ = nullptr; // GRDSET
  std::map<int, System> systems_;
  std::set<int> open_; // systems that are being made
  std::map<int, const Card*> grid_cards_;
  std::map<int, int> index_;
};

} // namespace plica
