#include "io/decks/nastran_grids.hpp"

#include "io/decks/keywords.hpp"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <numbers>

namespace plica {

using Eigen::Matrix3d;
using Eigen::Vector3d;

NastranGrids::NastranGrids(const CardsByName& cards, DeckModel& deck) : cards_(cards), deck_(deck) {
  systems_[0] = {};
  if (const auto found = cards.find("GRDSET"); found != cards.end()) {
    defaults_ = found->second.front();
    if (found->second.size() > 1)
      found->second[1]->wrong("is there already in line " + std::to_string(defaults_->at.line),
                              "one GRDSET");
  }
  read_points();
  read_scalars();
}

void NastranGrids::read_points() {
  const auto grids = cards_.find("GRID");
  if (grids == cards_.end()) return;
  for (const Card* card : grids->second) {
    const auto [known, is_new] = grid_cards_.try_emplace(card->whole(0), card);
    if (!is_new && known->second->fields != card->fields)
      card->wrong("grid point " + card->text(0) + " is there twice", "a number once");
  }
  for (const Card* card : grids->second) {
    const int node = place_grid(*card);
    const auto field = [&](std::size_t i) {
      return card->has(i) || defaults_ == nullptr ? card : defaults_;
    };
    const Card& turned = *field(5);
    if (turned.whole(5, 0) < 0) turned.wrong("is a point of a fluid (CD -1)", "a structure");
    if (turned.whole(5, 0) != 0 && !deck_.axes.contains(node))
      deck_.axes[node] = axes(turned, 5, deck_.nodes[node]);
    if (grid_cards_.at(card->whole(0)) != card) continue; // the same once more
    const Card& held = *field(6);
    if (held.text(6) == "0") continue;
    for (int dof : held.dofs(6)) deck_.supports.push_back({node, dof, {}, "GRID " + card->text(0)});
  }
}

int NastranGrids::place_grid(const Card& card) {
  const int label = card.whole(0);
  if (const auto known = index_.find(label); known != index_.end()) return known->second;
  const Card& with_system = card.has(1) || defaults_ == nullptr ? card : *defaults_;
  const System s = system(with_system, with_system.whole(1, 0));
  const Vector3d x = place(s, {card.real(2, 0), card.real(3, 0), card.real(4, 0)});
  const int node = static_cast<int>(deck_.nodes.size());
  index_[label] = node;
  deck_.nodes.push_back(x);
  deck_.labels.push_back(label);
  return node;
}

void NastranGrids::read_scalars() {
  const auto points = cards_.find("SPOINT");
  if (points == cards_.end()) return;
  for (const Card* card : points->second)
    for (int label : card->list(0)) {
      const auto [known, is_new] = index_.try_emplace(label, int(deck_.nodes.size()));
      if (!is_new && !deck_.scalars.contains(known->second))
        card->wrong("scalar point " + std::to_string(label) + " is a grid point too",
                    "a number once");
      if (!is_new) continue;
      deck_.scalars.insert(known->second);
      deck_.nodes.emplace_back(0, 0, 0);
      deck_.labels.push_back(label);
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

std::vector<int> NastranGrids::list(const Card& card, std::size_t first) const {
  bool ranges = false;
  for (std::size_t i = first; i < card.fields.size(); ++i)
    ranges = ranges || in_capitals(card.text(i)) == "THRU";
  std::vector<int> labels = card.list(first);
  if (ranges) std::erase_if(labels, [&](int label) { return !index_.contains(label); });
  return find(card, labels);
}

int NastranGrids::dof(const Card& card, int node, std::size_t field) const {
  const bool blank = !card.has(field) || card.text(field) == "0";
  if (deck_.scalars.contains(node)) {
    if (!blank && card.text(field) != "1")
      card.wrong("acts on component " + card.text(field) + " of a scalar point", "0, 1 or blank");
    return 0;
  }
  const std::vector<int> dofs = blank ? std::vector<int>{} : card.dofs(field);
  if (dofs.size() != 1)
    card.wrong("acts on components \"" + card.text(field) + "\"", "one component");
  return dofs[0];
}

Matrix3d NastranGrids::axes(int node) const {
  const auto found = deck_.axes.find(node);
  return found == deck_.axes.end() ? Matrix3d(Matrix3d::Identity()) : found->second;
}

Matrix3d NastranGrids::axes(const Card& card, std::size_t field, const Vector3d& at) {
  return axes_at(system(card, card.whole(field, 0)), at);
}

NastranGrids::System NastranGrids::three_points(const Card& card, char kind,
                                                const std::array<Vector3d, 3>& points) {
  System s{kind, points[0], {}};
  const Vector3d z = points[1] - s.origin, plane = points[2] - s.origin;
  const Vector3d y = z.cross(plane);
  if (!(y.norm() > 1e-12 * z.norm() * plane.norm()))
    card.wrong("has its three points on one line", "three points that span a plane");
  s.axes << y.cross(z).normalized(), y.normalized(), z.normalized();
  return s;
}

// Made when first asked for: a system may be given in another, or by grid points.
const NastranGrids::System& NastranGrids::system(const Card& card, int number) {
  if (const auto known = systems_.find(number); known != systems_.end()) return known->second;
  if (!open_.insert(number).second)
    card.wrong("coordinate systems refer to each other", "one that rests on the basic system");
  for (const char* name : {"CORD2R", "CORD2C", "CORD2S", "CORD1R", "CORD1C", "CORD1S"}) {
    const auto all = cards_.find(name);
    if (all == cards_.end()) continue;
    for (const Card* c : all->second) {
      if (name[4] == '2') {
        if (c->whole(0) != number) continue;
        const System base = system(*c, c->whole(1, 0));
        const auto point = [&](std::size_t i) {
          return place(base, {c->real(i, 0), c->real(i + 1, 0), c->real(i + 2, 0)});
        };
        return systems_[number] = three_points(*c, name[5], {point(2), point(5), point(8)});
      }
      for (std::size_t first : {std::size_t{0}, std::size_t{4}}) {
        if (!c->has(first) || c->whole(first) != number) continue;
        const auto point = [&](std::size_t i) -> Vector3d {
          const auto grid = grid_cards_.find(c->whole(first + i));
          if (grid == grid_cards_.end())
            c->wrong("there is no grid point " + c->text(first + i), "a GRID of the deck");
          return deck_.nodes[place_grid(*grid->second)];
        };
        return systems_[number] = three_points(*c, name[5], {point(1), point(2), point(3)});
      }
    }
  }
  card.wrong("there is no coordinate system " + std::to_string(number), "a CORD1x or CORD2x");
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

// Radial, tangential and axial, or radial, along theta and along phi; on the axis of the system,
// where there is no radius, those of the system.
Matrix3d NastranGrids::axes_at(const System& s, const Vector3d& point) {
  const Vector3d x = s.axes.transpose() * (point - s.origin);
  const double radius = std::hypot(x[0], x[1]);
  if (s.kind == 'R' || !(radius > 1e-12 * x.norm()) || x.norm() == 0) return s.axes;
  const Vector3d out(x[0] / radius, x[1] / radius, 0), along(-out[1], out[0], 0);
  Matrix3d local;
  if (s.kind == 'C')
    local << out, along, Vector3d::UnitZ();
  else
    local << x.normalized(), along.cross(x.normalized()), along;
  return s.axes * local;
}

} // namespace plica
