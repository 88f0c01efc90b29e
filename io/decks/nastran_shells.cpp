#include "io/decks/deck_panels.hpp"
#include "io/decks/nastran_elements.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <numbers>
#include <stdexcept>

namespace plica {
namespace {

struct ShellCard {
  std::vector<int> nodes;
  std::vector<double> thickness;                   // one per node
  Eigen::Vector3d along = Eigen::Vector3d::Zero(); // axis 1 of its plies
};

// THETA from the side G1-G2, or the x axis of a system MCID.
Eigen::Vector3d first_axis(const NastranReading& r, const Card& card, const ShellCard& shell,
                           std::size_t field) {
  const auto& x = r.deck.nodes;
  const std::vector<int>& n = shell.nodes;
  const Eigen::Vector3d side = x[n[1]] - x[n[0]];
  if (!card.has(field)) return side;
  if (card.is_real(field)) {
    const Eigen::Vector3d across = n.size() == 4 ? (x[n[2]] - x[n[0]]).cross(x[n[3]] - x[n[1]])
                                                 : side.cross(x[n[2]] - x[n[0]]);
    return Eigen::AngleAxisd(card.real(field) * std::numbers::pi / 180, across.normalized()) * side;
  }
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (int node : n) middle += x[node] / double(n.size());
  return r.grids.axes(card, field, middle).col(0);
}

// Of what is there already, or added.
template <class T, class Same> int index_of(std::vector<T>& all, const T& one, Same&& same) {
  for (std::size_t i = all.size(); i > 0; --i)
    if (same(all[i - 1], one)) return static_cast<int>(i - 1);
  all.push_back(one);
  return static_cast<int>(all.size()) - 1;
}

// Membranes of three nodes and plates alone have no element of their own in Model.
void add_wall(const NastranReading& r, const Card& card, const NastranWall& wall,
              const ShellCard& shell, double offset) {
  DeckModel& deck = r.deck;
  const bool triangle = shell.nodes.size() == 3;
  DeckShell made{.nodes = shell.nodes,
                 .thickness = shell.thickness,
                 .offset = offset,
                 .origin = card.origin(),
                 .normal = {},
                 .element = card.whole(0),
                 .expansion = wall.expansion};
  if (wall.laminate) {
    made.laminate = index_of(deck.laminates, *wall.laminate, [](const auto& a, const auto& b) {
      return a.A == b.A && a.B == b.B && a.D == b.D && a.S == b.S && a.rho == b.rho &&
             a.drilling == b.drilling;
    });
    made.along = shell.along;
    return deck.shells.push_back(made);
  }
  Eigen::Matrix3Xd x(3, shell.nodes.size());
  for (std::size_t i = 0; i < shell.nodes.size(); ++i)
    x.col(Eigen::Index(i)) = deck.nodes[shell.nodes[i]];
  if (wall.kind == WallKind::bending || (wall.kind == WallKind::membrane && triangle)) {
    for (double t : shell.thickness)
      if (t != shell.thickness[0])
        card.wrong("is a membrane or a plate alone of thickness that varies", "one thickness");
    if (offset != 0) card.wrong("is a membrane or a plate alone beside its nodes", "no offset");
    const Eigen::Vector3d across =
        triangle ? Eigen::Vector3d((x.col(1) - x.col(0)).eval().cross((x.col(2) - x.col(0)).eval()))
                 : Eigen::Vector3d((x.col(2) - x.col(0)).cross(x.col(3) - x.col(1)));
    if (!(across.norm() > 1e-9 * (x.col(1) - x.col(0)).squaredNorm()))
      card.wrong("has no area", "corners that span one");
    deck.of_springs[int(deck.springs.size())] = {made.element, made.origin, wall.expansion};
    deck.springs.push_back(
        wall.kind == WallKind::bending
            ? plate_alone(shell.nodes, x, wall.section, shell.thickness[0])
            : membrane_triangle(shell.nodes, x, wall.section, shell.thickness[0]));
    return;
  }
  made.section =
      index_of(deck.sections, wall.section, [](const ShellSection& s, const ShellSection& w) {
        return s.E == w.E && s.nu == w.nu && s.rho == w.rho &&
               s.bending_factor == w.bending_factor && s.shear_correction == w.shear_correction &&
               s.drilling == w.drilling;
      });
  deck.shells.push_back(made);
}

std::optional<NastranWall> wall_of(const NastranReading& r, const Card& card) {
  return r.properties.wall(card, card.whole(1, card.whole(0)));
}

// Corners from field 2 on, thicknesses T1 ... from a field on.
ShellCard corners(const NastranReading& r, const Card& card, const NastranWall& wall, std::size_t n,
                  std::size_t thickness, bool relative) {
  ShellCard shell;
  const double t = wall.thickness;
  for (std::size_t i = 0; i < n; ++i) {
    shell.nodes.push_back(r.grids.at(card, 2 + i));
    const std::size_t field = thickness + i;
    const bool given = thickness > 0 && card.has(field);
    shell.thickness.push_back(!given ? t : relative ? t * card.real(field) : card.real(field));
    if (!(shell.thickness.back() > 0)) card.wrong("has no thickness", "T of PSHELL, or T1 ...");
  }
  return shell;
}

void shell(const NastranReading& r, const Card& card) {
  const bool old = card.name.ends_with("1") || card.name.ends_with("2") ||
                   card.name.find("MEM") != std::string::npos;
  const std::size_t n = card.name.starts_with("CQ") ? 4 : 3;
  const auto wall = wall_of(r, card);
  if (!wall) return;
  ShellCard shell = corners(r, card, *wall, n, old ? 0 : 10, !old && card.whole(9, 0) == 1);
  if (wall->laminate) shell.along = first_axis(r, card, shell, n + 2);
  add_wall(r, card, *wall, shell, old ? 0 : card.real(n + 3, wall->offset));
}

int add_point(const NastranReading& r, const Eigen::Vector3d& x) {
  r.deck.nodes.push_back(x);
  r.deck.labels.push_back(0);
  return static_cast<int>(r.deck.nodes.size()) - 1;
}

// Of eight nodes four shells around a node in the middle, of six nodes four triangles.
void quadratic_shell(const NastranReading& r, const Card& card) {
  const bool quad = card.name == "CQUAD8";
  const std::size_t n = quad ? 4 : 3;
  const auto wall = wall_of(r, card);
  if (!wall) return;
  ShellCard c = corners(r, card, *wall, n, 10, card.whole(quad ? 16 : 13, 0) == 1);
  if (wall->laminate) c.along = first_axis(r, card, c, quad ? 14 : 8);
  const double offset = card.real(quad ? 15 : 9, wall->offset);
  std::vector<int> sides;
  std::vector<double> t;
  for (std::size_t i = 0; i < n; ++i) {
    if (!card.has(2 + n + i) || card.whole(2 + n + i) == 0) continue;
    sides.push_back(r.grids.at(card, 2 + n + i));
    t.push_back((c.thickness[i] + c.thickness[(i + 1) % n]) / 2);
  }
  if (sides.empty()) return add_wall(r, card, *wall, c, offset);
  if (sides.size() < n)
    card.wrong("lacks some of its nodes amid the sides", "all of them, or none");
  const auto part = [&](const std::vector<int>& nodes, const std::vector<double>& thickness) {
    add_wall(r, card, *wall, {nodes, thickness, c.along}, offset);
  };
  for (std::size_t i = 0; i < n && !quad; ++i)
    part({c.nodes[i], sides[i], sides[(i + 2) % 3]}, {c.thickness[i], t[i], t[(i + 2) % 3]});
  if (!quad) return part(sides, t);
  Eigen::Vector3d x = Eigen::Vector3d::Zero(); // of the shape functions of eight nodes
  double thickness = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    x += r.deck.nodes[sides[i]] / 2 - r.deck.nodes[c.nodes[i]] / 4;
    thickness += c.thickness[i] / 4;
  }
  const int middle = add_point(r, x);
  for (std::size_t i = 0; i < 4; ++i)
    part({c.nodes[i], sides[i], middle, sides[(i + 3) % 4]},
         {c.thickness[i], t[i], thickness, t[(i + 3) % 4]});
}

// F1, F2: shares of the panel that act as bars along its edges; above 1.01 of the square of its
// thickness.
void panel(const NastranReading& r, const Card& card) {
  const Card& p = r.properties.card("PSHEAR", card.whole(1, card.whole(0)), card);
  const NastranMaterial& m = r.properties.material(p, 1);
  const double t = p.real(2);
  std::vector<int> nodes;
  Eigen::Matrix<double, 3, 4> x;
  for (std::size_t i = 0; i < 4; ++i) {
    nodes.push_back(r.grids.at(card, 2 + i));
    x.col(Eigen::Index(i)) = r.deck.nodes[nodes[i]];
  }
  try {
    r.deck.springs.push_back(
        shear_panel(nodes, x, m.G, m.nu, t, m.rho * t + r.properties.mass_factor() * p.real(3, 0)));
  } catch (const std::invalid_argument& error) {
    card.wrong("is a shear panel that " + std::string(error.what()),
               "corners in turn, all outward");
  }
  const Eigen::Vector3d d13 = x.col(2) - x.col(0), d24 = x.col(3) - x.col(1);
  const double area = d13.cross(d24).norm() / 2;
  for (std::size_t k = 0; k < 2; ++k) {
    const double share = p.real(4 + k, 0);
    if (share < 0) card.wrong("has bars along its edges of F below 0", "F1 and F2 of 0 or more");
    if (share == 0) continue;
    const std::size_t from[2] = {k, k == 0 ? 3U : 0U}, to[2] = {k + 1, k == 0 ? 2U : 3U};
    double lengths = 0;
    for (std::size_t bar = 0; bar < 2; ++bar)
      lengths += (x.col(Eigen::Index(to[bar])) - x.col(Eigen::Index(from[bar]))).norm();
    const double section = share > 1.01 ? share * t * t / 2 : share * t * area / lengths;
    for (std::size_t bar = 0; bar < 2; ++bar) {
      const int a = nodes[from[bar]], b = nodes[to[bar]];
      r.deck.of_springs[int(r.deck.springs.size())] = {card.whole(0), card.origin(), m.expansion};
      r.deck.springs.push_back(
          truss({a, b}, r.deck.nodes[a], r.deck.nodes[b], m.E * section, 0, 0));
    }
  }
}

} // namespace

void read_shells(const NastranReading& r) {
  for (const char* name : {"CQUAD4", "CQUADR", "CTRIA3", "CTRIAR", "CQUAD1", "CTRIA1", "CQUAD2",
                           "CTRIA2", "CQDMEM", "CQDMEM1", "CQDMEM2", "CTRMEM"})
    r.each(name, [&](const Card& card) { shell(r, card); });
  std::size_t split = 0;
  for (const char* name : {"CQUAD8", "CTRIA6"}) {
    r.each(name, [&](const Card& card) { quadratic_shell(r, card); });
    if (const auto found = r.cards.find(name); found != r.cards.end())
      split += found->second.size();
  }
  if (split > 0)
    r.deck.notes.push_back(
        fmt::format("{} shells of eight or six nodes (CQUAD8, CTRIA6) are split, "
                    "each into four of four or three nodes",
                    split));
  r.each("CSHEAR", [&](const Card& card) { panel(r, card); });
  note_laminates(r.deck);
}

} // namespace plica
