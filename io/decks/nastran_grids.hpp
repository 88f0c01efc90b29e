// Grid points of a Nastran deck: positions in the basic system, found by their numbers.
#pragma once

#include "io/decks/bulk_data.hpp"
#include "model/description/deck_model.hpp"

namespace plica {

// Cards by name.
using CardsByName = std::map<std::string, std::vector<const Card*>>;

// CORD2R, CORD2C, CORD2S by their number. GRID of a system; displacements in the basic one alone.
class NastranGrids {
public:
  NastranGrids(const CardsByName& cards, DeckModel& deck);

  // Index of the node with the number in that field; InputError when there is none.
  int at(const Card& card, std::size_t field) const { return find(card, card.whole(field)); }
  int find(const Card& card, int label) const;
  std::vector<int> find(const Card& card, const std::vector<int>& labels) const;

private:
  struct System {
    char kind = 'R';
    Eigen::Vector3d origin{0, 0, 0};
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  };
  const System& system(const Card& card, int number);
  static Eigen::Vector3d place(const System& system, const Eigen::Vector3d& coordinates);

  const CardsByName& cards_;
  std::map<int, System> systems_;
  std::set<int> open_; // systems that are being made
  std::map<int, int> index_;
};

} // namespace plica
