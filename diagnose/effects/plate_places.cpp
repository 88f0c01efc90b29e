#include "diagnose/effects/plate_places.hpp"

#include "diagnose/effects/plate_spots.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Vector6 = Eigen::Vector<double, 6>;

constexpr int most_cells = 8; // either way

// Adini's, over the cell from -1 to 1: of the motion of a corner, and of its slopes over half a
// cell.
struct CornerShapes {
  double value, slope_along, slope_across, bilinear;
};
CornerShapes adini(double corner_x, double corner_y, double x, double y) {
  const double X = x * corner_x, Y = y * corner_y;
  return {(1 + X) * (1 + Y) * (2 + X + Y - X * X - Y * Y) / 8,
          corner_x * (1 + X) * (1 + X) * (X - 1) * (1 + Y) / 8,
          corner_y * (1 + Y) * (1 + Y) * (Y - 1) * (1 + X) / 8, (1 + X) * (1 + Y) / 4};
}

// The motion of a grid along a direction.
class PlateMotion {
public:
  PlateMotion(const Structure& s, const PlateGrid& grid, const std::optional<Vector3d>& direction)
      : grid_(grid), direction_(direction) {
    for (int node : grid.nodes) x_.push_back(s.built.model.mesh.nodes[std::size_t(node)]);
  }

  std::size_t number(std::size_t i, std::size_t j) const { return j * grid_.at[0].size() + i; }

  template <class Add> void each_corner(const VectorXd& place, const Add& add) const {
    const Neighbours a = neighbours_of(grid_.at[0], place[0]),
                     b = neighbours_of(grid_.at[1], place[1]);
    const Vector3d normal = grid_.normal(place[0], place[1]), d = direction_.value_or(normal),
                   in_plane = d - d.dot(normal) * normal;
    const double out = d.dot(normal);
    for (const std::size_t j : {b.first, b.first + 1})
      for (const std::size_t i : {a.first, a.first + 1}) {
        const CornerShapes shapes =
            adini(i == a.first ? -1 : 1, j == b.first ? -1 : 1, 2 * a.share - 1, 2 * b.share - 1);
        const Vector3d along = x_[number(a.first + 1, j)] - x_[number(a.first, j)],
                       across = x_[number(i, b.first + 1)] - x_[number(i, b.first)];
        Vector6 factors; // a slope over d is the rotation . (d x normal)
        factors << shapes.value * out * normal + shapes.bilinear * in_plane,
            out / 2 *
                (shapes.slope_along * along.cross(normal) +
                 shapes.slope_across * across.cross(normal));
        add(number(i, j), factors);
      }
  }

private:
  PlateGrid grid_;
  std::optional<Vector3d> direction_;
  std::vector<Vector3d> x_; // of its nodes
};

} // namespace

std::vector<EffectParameter> PlateGrid::place() const {
  return {{"at", "m", {PriorKind::towards_ends, 0, length[0]}},
          {"across", "m", {PriorKind::towards_ends, 0, length[1]}}};
}

Vector3d PlateGrid::normal(double along, double across) const {
  return normal_at(plate, along / length[0], across / length[1]);
}

Triple PlateGrid::point(double along, double across) const {
  return point_at(plate, along / length[0], across / length[1]);
}

int PlateGrid::nearest(double along, double across) const {
  return nodes[nearest_of(at[1], across) * at[0].size() + nearest_of(at[0], along)];
}

std::vector<PlateGrid> plate_grids(const Structure& s) {
  std::vector<PlateGrid> found;
  for (const Part& part : s.data.parts) {
    const auto* plate = std::get_if<Plate>(&part.body);
    if (!plate || plate_spots(s.built, part.name, *plate).empty()) continue; // or all of it is held
    const std::vector<int>& all = s.built.model.mesh.sets.at(part.name + ".all");
    PlateGrid grid{.part = part.name, .at = {}, .nodes = {}, .plate = *plate};
    std::array<std::vector<int>, 2> lines;
    for (std::size_t edge = 0; edge < 2; ++edge) {
      const auto corner = [&](std::size_t k) { return Vector3d::Map(plate->corners[k].data()); };
      grid.length[edge] = (corner(edge + 1) - corner(edge)).norm();
      for (int line : lines_across(plate->elements[edge], most_cells)) {
        lines[edge].push_back(line);
        grid.at[edge].push_back(grid.length[edge] * line / plate->elements[edge]);
      }
    }
    for (int j : lines[1])
      for (int i : lines[0])
        grid.nodes.push_back(all[std::size_t(j * (plate->elements[0] + 1) + i)]);
    found.push_back(std::move(grid));
  }
  return found;
}

MovingMotion motion_on(const Structure& s, const PlateGrid& grid,
                       const std::optional<Vector3d>& direction, MotionTerm::Of of) {
  const PlateMotion motion(s, grid, direction);
  const auto between = [&](std::size_t edge, std::size_t i) {
    return grid.at[edge][i] + somewhere * (grid.at[edge][i + 1] - grid.at[edge][i]);
  };
  const MotionTerms terms(grid.nodes, [&](const MotionTerms::Sample& sample) {
    for (std::size_t j = 0; j + 1 < grid.at[1].size(); ++j)
      for (std::size_t i = 0; i + 1 < grid.at[0].size(); ++i)
        motion.each_corner(Eigen::Vector2d(between(0, i), between(1, j)), sample);
  });
  // What it does in its plane follows from the nominal modes.
  Index out = 0;
  const Vector3d normal = grid.normal(grid.length[0] / 2, grid.length[1] / 2);
  normal.cwiseAbs().maxCoeff(&out);
  const bool moves_out = !direction || std::abs(direction->dot(normal)) > 0.5;
  const auto follow = [&](int dof) {
    return moves_out && dof == int(out) ? Follow::series : Follow::nominal;
  };
  return {.terms = terms.changes(of, follow), .factors = [motion, terms](const VectorXd& place) {
            VectorXd factors = VectorXd::Zero(terms.size());
            motion.each_corner(place, [&](std::size_t node, const Vector6& own) {
              terms.add(node, own, factors);
            });
            return factors;
          }};
}

} // namespace plica
