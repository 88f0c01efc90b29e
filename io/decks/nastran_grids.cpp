#include "io/decks/nastran_grids.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace plica {

using Eigen::Vector3d;

NastranGrids::NastranGrids(const CardsByName& cards, DeckModel& deck) : cards_(cards) {
  systems_[0] = {};
  const auto grids = cards.find("GRID");
  if (grids == cards.end()) return;
  for (const Card* card : grids->second) {
    if (card->whole(5, 0) != 0)
      card->wrong("has displacements in system " + card->text(5), "in the basic system, CD blank");
    const int label = card->whole(0);
    if (!index_.try_emplace(label, int(deck.nodes.size())).second)
      card->wrong("grid point " + std::to_string(label) + " is there twice", "a number once");
    deck.nodes.push_back(place(system(*card, card->whole(1, 0)),
                               {card->real(2, 0), card->real(3, 0), card->real(4, 0)}));
    deck.labels.push_back(label);
    for (int dof : card->dofs(6))
      deck.supports.push_back({index_[label], dof, {}, "GRID " + std::to_string(label)});
  }
}

int NastranGrids::find(const Card& card, int label) const {
  const auto found = index_.find(label);
  if (found == index_.end())
    card.wrong("there is no grid point " + std::to_string(label), "a GRID of the deck");
  return found->second;
}

std::vector<int> NastranGrids::find(const Card& card, const std::vector<int>& labels) const {
  std::vector<int> nodes;
  nodes.reserve(labels.size());
  for (int label : labels) nodes.push_back(find(card, label));
  return nodes;
}

// Made when first asked for: a system may be given in another.
const NastranGrids::System& NastranGrids::system(const Card& card, int number) {
  if (const auto known = systems_.find(number); known != systems_.end()) return known->second;
  if (!open_.insert(number).second)
    card.wrong("coordinate systems refer to each other", "one that rests on the basic system");
  for (const char* name : {"CORD2R", "CORD2C", "CORD2S"}) {
    const auto all = cards_.find(name);
    if (all == cards_.end()) continue;
    for (const Card* c : all->second) {
      if (c->whole(0) != number) continue;
      const System& base = system(*c, c->whole(1, 0));
      const auto point = [&](std::size_t first) {
        return place(base, {c->real(first, 0), c->real(first + 1, 0), c->real(first + 2, 0)});
      };
      System s{name[5], point(2), {}};
      const Vector3d z = point(5) - s.origin, plane = point(8) - s.origin;
      const Vector3d y = z.cross(plane);
      if (!(y.norm() > 1e-12 * z.norm() * plane.norm()))
        c->wrong("has its three points on one line", "three points that span a plane");
      s.axes << y.cross(z).normalized(), y.normalized(), z.normalized();
      return systems_[number] = s;
    }
  }
  card.wrong("there is no coordinate system " + std::to_string(number),
             "a CORD2R, CORD2C or CORD2S");
}

Vector3d NastranGrids::place(const System& s, const Vector3d& c) {
  constexpr double degree = std::numbers::pi / 180;
  Vector3d x = c;
  if (s.kind == 'C') x << c[0] * std::cos(degree * c[1]), c[0] * std::sin(degree * c[1]), c[2];
  if (s.kind == 'S')
    x << c[0] * std::sin(degree * c[1]) * std::cos(degree * c[2]),
        c[0] * std::sin(degree * c[1]) * std::sin(degree * c[2]), c[0] * std::cos(degree * c[1]);
  return s.origin + s.axes * x;
}

} // namespace plica
