#include "diagnose/weigh/thickness_fields.hpp"

#include "diagnose/effects/places.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Shells of a part, with where each lies: a column per direction, from 0 to 1.
struct Sheet {
  std::string part;
  std::vector<int> quads, triangles;
  MatrixXd at;
  VectorXd area;
};

// Stiffness and mass follow a parabola through two points of each field; a large one lets the
// motion settle where the wall is thin. `shape`: of the quads, then of the triangles.
Hypothesis field_of(const Sheet& sheet, const VectorXd& shape, double sigma, bool large) {
  const double reach = 2 * sigma;
  const std::vector<double> samples{-reach, reach};
  const auto coefficients = coefficients_through(
      [reach](double x) { return VectorXd(Eigen::Vector2d(x / reach, x * x / (reach * reach))); },
      samples);
  Hypothesis h{.effect = "thickness field",
               .place = sheet.part,
               .way = "",
               .parameters = {{"thickness", "", {PriorKind::normal, 0, sigma}}},
               .coefficients = [coefficients](const VectorXd& v) { return coefficients(v[0]); }};
  for (double x : samples)
    h.changes.push_back({[quads = sheet.quads, triangles = sheet.triangles, shape, x](Model& m) {
                           Eigen::Index next = 0;
                           for (int q : quads)
                             m.mesh.quads[std::size_t(q)].thickness *= 1 + x * shape[next++];
                           for (int t : triangles)
                             m.mesh.triangles[std::size_t(t)].thickness *= 1 + x * shape[next++];
                         },
                         large ? Follow::series : Follow::nominal});
  return h;
}

bool is_large(double field) {
  constexpr double small = 0.03;
  return field > small;
}

VectorXd cosine(const VectorXd& at, int half_waves) {
  return (std::numbers::pi * half_waves * at.array()).cos();
}

void add_along(std::vector<Hypothesis>& all, const WallElements& wall, double field) {
  constexpr int waves = 4;
  const VectorXd along = Eigen::Map<const VectorXd>(wall.along.data(), std::ssize(wall.along));
  const Sheet sheet{.part = wall.part, .quads = wall.quads, .triangles = {}, .at = {}, .area = {}};
  for (int k = 1; k <= waves; ++k)
    all.push_back(
        field_of(sheet, cosine(along, k), field * std::sqrt(2. / waves), is_large(field)));
}

// Middle and area of a shell by its corners in order.
template <std::size_t n>
std::pair<Eigen::Vector3d, double> middle_and_area(const Mesh& mesh,
                                                   const std::array<int, n>& nodes) {
  const auto x = [&](std::size_t i) { return mesh.nodes[std::size_t(nodes[i])]; };
  Eigen::Vector3d middle = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    middle += x(i) / double(n);
    if (i >= 2) normal += (x(i - 1) - x(0)).cross(x(i) - x(0));
  }
  return {middle, normal.norm() / 2};
}

// Rows as points.
MatrixXd rows_of(const std::vector<Eigen::Vector3d>& points) {
  MatrixXd x(std::ssize(points), 3);
  for (Eigen::Index i = 0; i < x.rows(); ++i) x.row(i) = points[std::size_t(i)].transpose();
  return x;
}

// Along the two longest directions from the least corner of the wall, 0, to the most, 1.
Sheet sheet_of(const Model& model, const std::string& part) {
  Sheet sheet{.part = part, .quads = {}, .triangles = {}, .at = {}, .area = {}};
  std::vector<Eigen::Vector3d> middles, corners;
  std::vector<double> areas, at_corners;
  const auto add = [&](std::vector<int>& own, const auto& shells) {
    for (std::size_t i = 0; i < shells.size(); ++i) {
      const int component = model.shells[std::size_t(shells[i].section)].component;
      if (model.components[std::size_t(component)] != part) continue;
      own.push_back(int(i));
      const auto [middle, area] = middle_and_area(model.mesh, shells[i].nodes);
      middles.push_back(middle);
      areas.push_back(area);
      for (int node : shells[i].nodes) {
        corners.push_back(model.mesh.nodes[std::size_t(node)]);
        at_corners.push_back(area / double(shells[i].nodes.size()));
      }
    }
  };
  add(sheet.quads, model.mesh.quads);
  add(sheet.triangles, model.mesh.triangles);
  if (middles.empty()) return sheet;
  sheet.area = Eigen::Map<const VectorXd>(areas.data(), std::ssize(areas));
  const MatrixXd x = rows_of(corners);
  const VectorXd share = Eigen::Map<const VectorXd>(at_corners.data(), x.rows());
  const Eigen::RowVector3d centre = share.transpose() * x / share.sum();
  const MatrixXd from_centre = x.rowwise() - centre;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(
      Eigen::Matrix3d(from_centre.transpose() * share.asDiagonal() * from_centre));
  const Eigen::Matrix<double, 3, 2> longest = axes.eigenvectors().rowwise().reverse().leftCols<2>();
  const MatrixXd all = x * longest;
  const Eigen::RowVector2d low = all.colwise().minCoeff(), range = all.colwise().maxCoeff() - low;
  sheet.at = ((rows_of(middles) * longest).rowwise() - low).array().rowwise() / range.array();
  return sheet;
}

void add_over(std::vector<Hypothesis>& all, const Sheet& sheet, double field) {
  constexpr int waves = 3;
  constexpr double flat = 1e-6; // of one element across, odd half waves are nowhere
  std::vector<VectorXd> shapes;
  for (int all_waves = 1; all_waves <= waves; ++all_waves)
    for (int across = 0; across <= all_waves; ++across) {
      VectorXd shape =
          cosine(sheet.at.col(0), all_waves - across).cwiseProduct(cosine(sheet.at.col(1), across));
      const double square = sheet.area.dot(shape.cwiseAbs2()) / sheet.area.sum();
      if (square > flat) shapes.push_back(shape / std::sqrt(square));
    }
  for (const VectorXd& shape : shapes)
    all.push_back(
        field_of(sheet, shape, field / std::sqrt(double(shapes.size())), is_large(field)));
}

} // namespace

std::optional<double> field_over(const Part& part) {
  if (const auto* plate = std::get_if<Plate>(&part.body)) return plate->thickness_field;
  if (const auto* surface = std::get_if<SurfacePart>(&part.body)) return surface->thickness_field;
  if (const auto* deck = std::get_if<DeckPart>(&part.body)) return deck->thickness_field;
  return std::nullopt;
}

std::vector<Hypothesis> thickness_fields(const Structure& s) {
  std::vector<Hypothesis> all;
  for (const WallElements& wall : walls(s))
    if (wall.thickness_field.value_or(0) > 0) add_along(all, wall, *wall.thickness_field);
  for (const Part& part : s.data.parts)
    if (const double field = field_over(part).value_or(0); field > 0) {
      const Sheet sheet = sheet_of(s.built.model, part.name);
      if (sheet.area.size() > 0) add_over(all, sheet, field);
    }
  return all;
}

} // namespace plica
