#include "diagnose/effects/wall_damage.hpp"

#include "diagnose/effects/wall_spots.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <set>

namespace plica {
namespace {

using Eigen::Vector3d;

enum class Kind { quad, triangle, beam };
struct Piece {
  Kind kind;
  int number = 0; // among those of the model
  std::vector<int> nodes;
};

// What a part is made of.
class Pieces {
public:
  Pieces(const Model& model, const std::string& part) : mesh_(model.mesh) {
    const auto own = [&](int component) {
      return component >= 0 && model.components[std::size_t(component)] == part;
    };
    const auto add_shells = [&](Kind kind, const auto& shells) {
      for (std::size_t i = 0; i < shells.size(); ++i)
        if (own(model.shells[std::size_t(shells[i].section)].component))
          add({kind, int(i), {shells[i].nodes.begin(), shells[i].nodes.end()}});
    };
    add_shells(Kind::quad, model.mesh.quads);
    add_shells(Kind::triangle, model.mesh.triangles);
    for (std::size_t i = 0; i < model.beams.size(); ++i)
      if (const BeamElement& b = model.beams[i]; own(b.component))
        add({Kind::beam, int(i), {b.node1, b.node2}});
  }

  bool has_walls() const { return area_ > 0; }
  double reach() const {
    constexpr double of_wall = 0.1, of_box = 0.05;
    return has_walls() ? of_wall * std::sqrt(area_) : of_box * (high_ - low_).norm();
  }

  // Those about a node, from one to the next: a wall that lies opposite is another one.
  ElementList about(int node) const {
    const double reach_of_all = reach();
    ElementList found;
    std::set<int> taken, reached{node};
    for (std::vector<int> next{node}; !next.empty();) {
      const int from = next.back();
      next.pop_back();
      for (int i : at_.at(from)) {
        const Piece& piece = pieces_[std::size_t(i)];
        const bool is_near = from == node || (middle(piece) - x(node)).norm() < reach_of_all;
        if (!is_near || !taken.insert(i).second) continue;
        (piece.kind == Kind::quad       ? found.quads
         : piece.kind == Kind::triangle ? found.triangles
                                        : found.beams)
            .push_back(piece.number);
        for (int n : piece.nodes)
          if (reached.insert(n).second) next.push_back(n);
      }
    }
    return found;
  }

private:
  Vector3d x(int node) const { return mesh_.nodes[std::size_t(node)]; }
  Vector3d middle(const Piece& piece) const {
    Vector3d sum = Vector3d::Zero();
    for (int node : piece.nodes) sum += x(node);
    return sum / double(piece.nodes.size());
  }
  void add(Piece piece) {
    const std::vector<int>& n = piece.nodes;
    if (n.size() == 3) area_ += (x(n[1]) - x(n[0])).cross(x(n[2]) - x(n[0])).norm() / 2;
    if (n.size() == 4) area_ += (x(n[2]) - x(n[0])).cross(x(n[3]) - x(n[1])).norm() / 2;
    for (int node : n) {
      at_[node].push_back(int(pieces_.size()));
      low_ = low_.cwiseMin(x(node));
      high_ = high_.cwiseMax(x(node));
    }
    pieces_.push_back(std::move(piece));
  }

  const Mesh& mesh_;
  std::vector<Piece> pieces_;
  std::map<int, std::vector<int>> at_; // by node
  double area_ = 0;
  Vector3d low_ = Vector3d::Constant(std::numeric_limits<double>::infinity()), high_ = -low_;
};

std::string across(double metres) {
  return fmt::format("{:.{}f} mm across", 1e3 * metres, metres < 0.01 ? 1 : 0);
}

} // namespace

void halve_modulus(Model& model, const ElementList& elements) {
  std::map<int, int> halved;
  const auto soften = [&](auto& shell) {
    const auto [known, is_new] = halved.try_emplace(shell.section, int(model.shells.size()));
    if (is_new) {
      ShellProperties soft = model.shells[std::size_t(shell.section)];
      soft.section.E /= 2;
      model.shells.push_back(soft);
    }
    shell.section = known->second;
  };
  for (int q : elements.quads) soften(model.mesh.quads[std::size_t(q)]);
  for (int t : elements.triangles) soften(model.mesh.triangles[std::size_t(t)]);
  for (int i : elements.beams) {
    BeamProperties& b = model.beams[std::size_t(i)].section;
    for (double* n : {&b.EA, &b.EI_y, &b.EI_z, &b.GJ, &b.GA_y, &b.GA_z}) *n /= 2;
  }
}

std::vector<DamagedSpot> damaged_spots(const Structure& s, const Part& part) {
  std::vector<DamagedSpot> found;
  if (!std::holds_alternative<Plate>(part.body) && !is_from_file(part)) return found;
  const Pieces pieces(s.built.model, part.name);
  for (Spot& spot : damage_spots(s.built, part.name)) {
    ModelChange halved{
        .apply = [own = pieces.about(spot.touched)](Model& model) { halve_modulus(model, own); },
        .follow = Follow::series};
    found.push_back(
        {std::move(spot), pieces.has_walls() ? across(2 * pieces.reach()) : "", std::move(halved)});
  }
  return found;
}

} // namespace plica
