// Rigid elements whose independent degrees of freedom belong to several grid points.
#include "io/decks/deck_average.hpp"
#include "io/decks/keywords.hpp"
#include "io/decks/nastran_joints.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

// Motion of single DOFs (rows) by that of a body: its translation at `about`, and its turns.
MatrixXd by_the_body(const NastranReading& r, const std::vector<NodeDof>& dofs,
                     const Vector3d& about) {
  MatrixXd rows(static_cast<Index>(dofs.size()), 6);
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    const Vector3d e = r.grids.axes(dofs[i].node).col(dofs[i].dof % 3);
    const Vector3d arm = r.deck.nodes[dofs[i].node] - about;
    if (dofs[i].dof < 3)
      rows.row(Index(i)) << e.transpose(), arm.cross(e).transpose();
    else
      rows.row(Index(i)) << 0, 0, 0, e.transpose();
  }
  return rows;
}

// Points and components in turn, up to a word; leaves `field` there.
std::vector<NodeDof> dofs_up_to_a_word(const NastranReading& r, const Card& card,
                                       std::size_t& field) {
  std::vector<NodeDof> all;
  for (; field < card.fields.size(); ++field) {
    if (!card.has(field)) continue;
    if (std::isalpha(static_cast<unsigned char>(card.text(field)[0])) || card.is_real(field)) break;
    const int node = r.grids.at(card, field);
    do ++field;
    while (field < card.fields.size() && !card.has(field));
    const std::vector<int> dofs = card.dofs(field);
    if (dofs.empty()) card.wrong("has a point without components", "G1, C1, G2, C2 ...");
    for (int dof : dofs) all.push_back({node, dof});
  }
  return all;
}

// RBE1 and CRIGD3: six DOFs move the body, those behind UM or MSET follow.
void rigid_body(const NastranReading& r, const Card& card, const std::string& word) {
  std::size_t field = 1;
  const std::vector<NodeDof> lead = dofs_up_to_a_word(r, card, field);
  if (lead.size() != 6 || in_capitals(card.text(field)) != word)
    card.wrong("has " + std::to_string(lead.size()) + " independent degrees of freedom",
               "six, and " + word + " before those that follow");
  const std::vector<NodeDof> follow = dofs_up_to_a_word(r, card, ++field);
  if (follow.empty()) card.wrong("ties nothing", word + " with points and components");
  const Vector3d about = r.deck.nodes[lead.front().node];
  double size = 0;
  for (const NodeDof& d : lead) size = std::max(size, (r.deck.nodes[d.node] - about).norm());
  MatrixXd body = by_the_body(r, lead, about);
  if (size > 0) body.rightCols<3>() /= size; // rows of like size: turns times a length
  Eigen::FullPivLU<MatrixXd> moved(body);
  moved.setThreshold(1e-9);
  if (!moved.isInvertible())
    card.wrong("has independent degrees of freedom that do not determine how a body moves",
               "six that hold it");
  MatrixXd followed = by_the_body(r, follow, about);
  if (size > 0) followed.rightCols<3>() /= size;
  const MatrixXd share = followed * moved.inverse();
  for (std::size_t i = 0; i < follow.size(); ++i) {
    Constraint row{follow[i].node, follow[i].dof, {}, card.name + " " + card.text(0)};
    for (std::size_t k = 0; k < 6; ++k)
      if (const double factor = share(Index(i), Index(k)); std::abs(factor) > 1e-12)
        row.terms.push_back({lead[k].node, lead[k].dof, factor});
    (row.terms.empty() ? r.deck.supports : r.deck.equations).push_back(std::move(row));
  }
}

// A rod that keeps its length: one translation of one end follows.
void rigid_rod(const NastranReading& r, const Card& card, bool of_second, const NodeDof& follow) {
  const int a = r.grids.at(card, 1), b = r.grids.at(card, 2);
  const Vector3d axis = r.deck.nodes[b] - r.deck.nodes[a];
  if (!(axis.norm() > 0)) card.wrong("has no length", "two places");
  const Vector3d e = axis.normalized();
  const bool is_translation = follow.dof <= 2;
  const double own = is_translation ? r.grids.axes(follow.node).col(follow.dof).dot(e) : 0;
  if (std::abs(own) < 1e-3)
    card.wrong(is_translation ? "lets a component follow that lies across it"
                              : "lets a rotation follow",
               "1, 2 or 3, along the rod");
  Constraint row{follow.node, follow.dof, {}, card.name + " " + card.text(0)};
  for (const int node : {a, b})
    for (int dof = 0; dof < 3; ++dof) {
      const double along = r.grids.axes(node).col(dof).dot(e);
      if ((node == follow.node && dof == follow.dof) || std::abs(along) < 1e-12) continue;
      const bool same_end = (node == b) == of_second;
      row.terms.push_back({node, dof, (same_end ? -1 : 1) * along / own});
    }
  r.deck.equations.push_back(std::move(row));
}

void rrod(const NastranReading& r, const Card& card) {
  const bool second = card.has(4);
  if (second == card.has(3)) card.wrong("needs one component that follows", "CMA or CMB");
  const std::size_t field = second ? 4 : 3;
  const std::vector<int> dofs = card.dofs(field);
  if (dofs.size() != 1) card.wrong("needs one component that follows", "1, 2 or 3");
  rigid_rod(r, card, second, {r.grids.at(card, second ? 2 : 1), dofs.front()});
}

void crigdr(const NastranReading& r,
            const Card& card) { // EID, G, of which follows the other: G2, C
  const std::vector<int> dofs = card.dofs(3);
  if (dofs.size() != 1) card.wrong("needs one component that follows", "1, 2 or 3");
  rigid_rod(r, card, true, {r.grids.at(card, 2), dofs.front()});
}

} // namespace

void read_rigid_bodies(const NastranReading& r) {
  r.each("RBE1", [&](const Card& card) { rigid_body(r, card, "UM"); });
  r.each("CRIGD3", [&](const Card& card) { rigid_body(r, card, "MSET"); });
  r.each("RROD", [&](const Card& card) { rrod(r, card); });
  r.each("CRIGDR", [&](const Card& card) { crigdr(r, card); });
}

} // namespace plica
