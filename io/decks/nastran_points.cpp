#include "io/decks/deck_panels.hpp"
#include "io/decks/keywords.hpp"
#include "io/decks/nastran_elements.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace plica {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr const char* no_body = "a mass of at least 0, moments of inertia none below 0";

void conm2(const NastranReading& r, const Card& card) {
  const double factor = r.properties.mass_factor();
  MassElement element{.node = r.grids.at(card, 1), .body = {}};
  const Vector3d& x = r.deck.nodes[element.node];
  const int system = card.whole(2, 0);
  const Matrix3d axes = system > 0 ? r.grids.axes(card, 2, x) : Matrix3d(Matrix3d::Identity());
  if (system < -1) card.wrong("is in system " + card.text(2), "0, -1 or a system");
  RigidMass& body = element.body;
  body.mass = factor * card.real(3, 0);
  body.offset = axes * Vector3d(card.real(4, 0), card.real(5, 0), card.real(6, 0));
  if (system == -1) body.offset -= x;
  std::array<double, 6> J{};
  for (std::size_t i = 0; i < J.size(); ++i) J[i] = factor * card.real(8 + i, 0);
  // Products of inertia are integrals: the matrix has them with the other sign.
  body.inertia << J[0], -J[1], -J[3], -J[1], J[2], -J[4], -J[3], -J[4], J[5];
  body.inertia = axes * body.inertia * axes.transpose();
  if (is_body(body)) return r.deck.masses.push_back(element);
  // Some decks give moments of inertia of no body (one alone), and yet a matrix of mass.
  const Eigen::Vector3d spread =
      Eigen::SelfAdjointEigenSolver<Matrix3d>(body.inertia).eigenvalues();
  if (!(body.mass >= 0 && spread.allFinite() && spread[0] >= -1e-12 * std::abs(spread[2])))
    card.wrong("is no body", no_body);
  Eigen::MatrixXd to_centre = Eigen::MatrixXd::Identity(6, 6); // motion of the centre of mass
  const Vector3d& arm = body.offset;
  to_centre.topRightCorner<3, 3>() << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(),
      0;
  Eigen::MatrixXd own = Eigen::MatrixXd::Zero(6, 6);
  own.topLeftCorner<3, 3>().diagonal().setConstant(body.mass);
  own.bottomRightCorner<3, 3>() = body.inertia;
  r.deck.springs.push_back({.nodes = {element.node},
                            .K = Eigen::MatrixXd::Zero(6, 6),
                            .M = to_centre.transpose() * own * to_centre});
}

// A symmetric matrix of 6 x 6 by its lower triangle, in the axes of a system.
void conm1(const NastranReading& r, const Card& card) {
  const int node = r.grids.at(card, 1);
  const Matrix3d axes = r.grids.axes(card, 2, r.deck.nodes[node]);
  Eigen::MatrixXd M(6, 6), R = Eigen::MatrixXd::Zero(6, 6);
  std::size_t field = 3;
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column <= row; ++column)
      M(row, column) = M(column, row) = r.properties.mass_factor() * card.real(field++, 0);
  R.block<3, 3>(0, 0) = R.block<3, 3>(3, 3) = axes;
  r.deck.springs.push_back(
      {.nodes = {node}, .K = Eigen::MatrixXd::Zero(6, 6), .M = R * M * R.transpose()});
}

// A value between single DOFs: node and component from two fields each, or scalar points.
void scalar(const NastranReading& r, const Card& card, double value,
            const std::vector<std::size_t>& at, bool points, bool mass) {
  std::vector<SpringEnd> ends;
  for (std::size_t field : at) {
    if (!card.has(field) || card.whole(field) == 0) continue;
    const int node = r.grids.at(card, field);
    if (points && !r.deck.scalars.contains(node))
      card.wrong("is tied to grid point " + card.text(field), "scalar points (SPOINT)");
    const int dof = points ? 0 : r.grids.dof(card, node, field + 1);
    ends.push_back({node, along(r.grids.axes(node), dof)});
  }
  if (ends.empty()) card.wrong("is tied to nothing", "a grid point");
  const Eigen::MatrixXd matrix = spring_matrix(ends, value);
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(matrix.rows(), matrix.cols());
  std::vector<int> nodes;
  for (const SpringEnd& end : ends) nodes.push_back(end.node);
  r.deck.springs.push_back({.nodes = nodes, .K = mass ? none : matrix, .M = mass ? matrix : none});
}

Eigen::Matrix3d bush_axes(const NastranReading& r, const Card& card, int node1, int node2) {
  const Vector3d& x1 = r.deck.nodes[node1];
  if (card.has(7) && card.whole(7) >= 0) return r.grids.axes(card, 7, x1);
  const Vector3d along = node2 < 0 ? Vector3d(0, 0, 0) : Vector3d(r.deck.nodes[node2] - x1);
  const bool by_grid = card.has(4) && !card.is_real(4) && !card.has(5) && !card.has(6);
  const bool given = card.has(4) || card.has(5) || card.has(6);
  if (!(along.norm() > 1e-9 * x1.norm())) return r.grids.axes(node1);
  Vector3d v = by_grid ? Vector3d(r.deck.nodes[r.grids.at(card, 4)] - x1)
                       : Vector3d(r.grids.axes(node1) *
                                  Vector3d(card.real(4, 0), card.real(5, 0), card.real(6, 0)));
  if (!given) {
    Eigen::Index least = 0;
    along.cwiseAbs().minCoeff(&least);
    v = Vector3d::Unit(least);
  }
  const Vector3d z = along.cross(v);
  if (!(z.norm() > 1e-9 * along.norm() * v.norm()))
    card.wrong("has an orientation along its axis", "a vector across the axis, or CID");
  Matrix3d axes;
  axes << along.normalized(), z.cross(along).normalized(), z.normalized();
  return axes;
}

// The law acts at S of the way from GA to GB, or beside GA by S1 S2 S3 in the system OCID.
void add_bush(const NastranReading& r, const Card& card, const BushingElement& element,
              bool has_length) {
  const bool beside = card.has(9) && card.whole(9) >= 0;
  if (!has_length || (card.real(8, 0.5) == 0.5 && !beside)) {
    r.deck.bushings.push_back(element);
    return;
  }
  const Vector3d &x1 = r.deck.nodes[element.node1], &x2 = r.deck.nodes[element.node2];
  Vector3d point = x1 + card.real(8, 0.5) * (x2 - x1);
  if (beside)
    point = x1 + r.grids.axes(card, 9, x1) *
                     Vector3d(card.real(10, 0), card.real(11, 0), card.real(12, 0));
  r.deck.springs.push_back({.nodes = {element.node1, element.node2},
                            .K = bushing_matrix(element.bushing, x1, x2, point),
                            .M = Eigen::MatrixXd::Zero(12, 12)});
}

void bush(const NastranReading& r, const Card& card) {
  const Card& property = r.properties.card("PBUSH", card.whole(1, card.whole(0)), card);
  const int node1 = card.has(2) ? r.grids.at(card, 2) : r.grids.at(card, 3);
  const int node2 = card.has(2) && card.has(3) ? r.grids.at(card, 3) : -1;
  BushingElement element{.node1 = node1, .node2 = node2, .bushing = {}};
  for (std::size_t row = 0; row < property.fields.size(); row += 8) {
    const std::string kind = in_capitals(property.text(row + 1));
    if (kind == "K")
      for (int d = 0; d < 6; ++d)
        element.bushing.law(d, d) = property.real(row + 2 + std::size_t(d), 0);
    else if (kind == "M" && property.real(row + 2, 0) != 0)
      property.wrong("has a mass", "values of K; masses by CONM2");
  }
  const auto& law = element.bushing.law;
  element.bushing.axes = bush_axes(r, card, node1, node2);
  const bool has_length = node2 >= 0 && (r.deck.nodes[node1] - r.deck.nodes[node2]).norm() > 0;
  const bool oriented =
      card.has(4) || card.has(5) || card.has(6) || (card.has(7) && card.whole(7) >= 0);
  if (has_length && !oriented && (law(1, 1) != law(2, 2) || law(4, 4) != law(5, 5)))
    card.wrong("has axes across it that nothing gives, and other stiffnesses in them",
               "CID, G0 or X1 X2 X3");
  add_bush(r, card, element, has_length);
}

// Along the line between its points, or along x of CID; K in small motion, whatever its table says.
void bush1d(const NastranReading& r, const Card& card) {
  const Card& property = r.properties.card("PBUSH1D", card.whole(1, card.whole(0)), card);
  if (property.real(3, 0) != 0) property.wrong("has a mass", "K; masses by CONM2");
  std::vector<int> nodes;
  for (std::size_t field : {2, 3})
    if (card.has(field)) nodes.push_back(r.grids.at(card, field));
  if (nodes.empty()) card.wrong("is tied to nothing", "a grid point");
  Vector3d line = nodes.size() == 2 ? Vector3d(r.deck.nodes[nodes[1]] - r.deck.nodes[nodes[0]])
                                    : Vector3d(0, 0, 0);
  if (card.has(4)) line = r.grids.axes(card, 4, r.deck.nodes[nodes[0]]).col(0);
  if (!(line.norm() > 0)) card.wrong("has no direction", "CID, or points that lie apart");
  std::vector<SpringEnd> ends;
  for (int node : nodes) {
    ends.push_back({.node = node});
    ends.back().direction.head<3>() = line.normalized();
  }
  const Eigen::MatrixXd K = spring_matrix(ends, property.real(1, 0));
  r.deck.springs.push_back(
      {.nodes = nodes, .K = K, .M = Eigen::MatrixXd::Zero(K.rows(), K.cols())});
}

} // namespace

void read_points(const NastranReading& r) {
  r.each("CONM2", [&](const Card& card) { conm2(r, card); });
  r.each("CONM1", [&](const Card& card) { conm1(r, card); });
  r.each("CBUSH", [&](const Card& card) { bush(r, card); });
  r.each("CBUSH1D", [&](const Card& card) { bush1d(r, card); });
  const auto value = [&](const char* name, const Card& card) {
    // Up to two PELAS, four PMASS stand in a card.
    const std::size_t step = std::string(name) == "PELAS" ? 4 : 2;
    if (const auto all = r.cards.find(name); all != r.cards.end())
      for (const Card* p : all->second)
        for (std::size_t i = 0; i + 1 < p->fields.size() && i < 8; i += step)
          if (p->has(i) && p->whole(i) == card.whole(1, card.whole(0))) return p->real(i + 1);
    card.wrong("there is no " + std::string(name) + " " + card.text(1), "one of the deck");
  };
  for (const bool mass : {false, true}) {
    const std::string name = mass ? "CMASS" : "CELAS";
    const char* property = mass ? "PMASS" : "PELAS";
    const double factor = mass ? r.properties.mass_factor() : 1;
    r.each((name + "1").c_str(), [&](const Card& card) {
      scalar(r, card, factor * value(property, card), {2, 4}, false, mass);
    });
    r.each((name + "2").c_str(), [&](const Card& card) {
      scalar(r, card, factor * card.real(1), {2, 4}, false, mass);
    });
    r.each((name + "3").c_str(), [&](const Card& card) {
      scalar(r, card, factor * value(property, card), {2, 3}, true, mass);
    });
    r.each((name + "4").c_str(), [&](const Card& card) {
      scalar(r, card, factor * card.real(1), {2, 3}, true, mass);
    });
  }
}

} // namespace plica
