#include "io/decks/deck_panels.hpp"
#include "io/decks/keywords.hpp"
#include "io/decks/nastran_elements.hpp"

#include <Eigen/Geometry>

namespace plica {
namespace {

using Eigen::Vector3d;

// The field of an element, or of BAROR or BEAMOR where that is blank.
const Card& given(const NastranReading& r, const Card& card, std::size_t field) {
  const auto found = r.cards.find(card.name == "CBAR" ? "BAROR" : "BEAMOR");
  return card.has(field) || found == r.cards.end() ? card : *found->second.front();
}

Vector3d vector(const Card& card, std::size_t first) {
  return {card.real(first, 0), card.real(first + 1, 0), card.real(first + 2, 0)};
}

// The direction of the y of the element, by components or by a grid point.
Vector3d orientation(const NastranReading& r, const Card& card, const BeamElement& beam,
                     bool in_basic) {
  const bool own = card.has(4) || card.has(5) || card.has(6);
  const Card& from = own ? card : given(r, card, 4);
  const bool by_grid = from.has(4) && !from.is_real(4) && !from.has(5) && !from.has(6);
  if (by_grid) return r.deck.nodes[r.grids.at(from, 4)] - r.deck.nodes[beam.node1];
  return in_basic ? vector(from, 4) : Vector3d(r.grids.axes(beam.node1) * vector(from, 4));
}

// Released DOFs in our local axes: the y of the element is our z, its z our -y.
std::vector<int> released(const Card& card) {
  static const int ours[6] = {0, 2, 1, 3, 5, 4};
  std::vector<int> all;
  for (std::size_t end : {std::size_t{0}, std::size_t{1}}) {
    if (!card.has(8 + end) || card.text(8 + end) == "0") continue;
    for (int dof : card.dofs(8 + end)) all.push_back(ours[dof] + 6 * int(end));
  }
  return all;
}

// From the local axes, of which y is the first of the section in the deck, to the global ones.
Eccentricity in_global(Eccentricity at, const Vector3d& axis, const Vector3d& up) {
  Eigen::Matrix3d axes;
  axes.col(0) = axis.normalized();
  axes.col(2) = up;
  axes.col(1) = up.cross(axes.col(0));
  at.neutral = axes * at.neutral;
  at.extra = axes * at.extra;
  return at;
}

// From a node to where the end of its beam weighs.
Vector3d arm_of_mass(const Vector3d& offset, const BeamProperties& section,
                     const Eccentricity& at) {
  const double mass = section.mass + at.extra_mass;
  if (!(mass > 0)) return offset;
  return offset + (section.mass * at.neutral + at.extra_mass * at.extra) / mass;
}

// Masses, and inertia about its axis, at its ends in place of those of a bar: of a taper, straight
// between stations, the integrals of both times 1 - x and x.
Eigen::MatrixXd mass_at_the_ends(const Taper& taper, const Vector3d& axis) {
  const auto shares = [&](auto&& number) { // by Simpson
    Eigen::Vector2d all(0, 0);
    for (std::size_t i = 1; i < taper.size(); ++i) {
      const BeamStation &a = taper[i - 1], &b = taper[i];
      const double of_a = number(a), of_b = number(b), share = axis.norm() * (b.x - a.x) / 6;
      const Eigen::Vector2d at_a(1 - a.x, a.x), at_b(1 - b.x, b.x);
      all += share * (of_a * at_a + (of_a + of_b) * (at_a + at_b) + of_b * at_b);
    }
    return all;
  };
  const Eigen::Vector2d mass =
      shares([](const BeamStation& s) { return s.section.mass + s.eccentricity.extra_mass; });
  const Eigen::Vector2d inertia = shares(
      [](const BeamStation& s) { return s.section.inertia_x + s.eccentricity.extra_inertia; });
  const Vector3d e = axis.normalized();
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(12, 12);
  for (Eigen::Index end = 0; end < 2; ++end) {
    M.diagonal().segment<3>(6 * end).setConstant(mass[end]);
    M.block<3, 3>(6 * end + 3, 6 * end + 3) = inertia[end] * e * e.transpose();
  }
  return M;
}

// As a beam, or as a matrix where it tapers, has released ends or bears beside its line.
void add_beam(const NastranReading& r, const Card& card, const BeamElement& beam,
              const Eccentricity& local, const Taper* taper, const DeckBar& bar) {
  const std::vector<int> free = released(card);
  const std::vector<Vector3d> ends{r.deck.nodes[beam.node1], r.deck.nodes[beam.node2]};
  const Vector3d axis = ends[1] + beam.offset2 - ends[0] - beam.offset1;
  if (taper == nullptr && free.empty() && local.is_none()) {
    r.deck.of_beams[int(r.deck.beams.size())] = bar;
    r.deck.beams.push_back(beam);
    return;
  }
  const Eccentricity at = in_global(local, axis, bar.y);
  DeckBar& kept = r.deck.of_springs[int(r.deck.springs.size())] = bar;
  kept.arms = {arm_of_mass(beam.offset1, beam.section, at),
               arm_of_mass(beam.offset2, beam.section, at)};
  const auto matrix = [&]() -> MatrixElement {
    if (taper == nullptr)
      return free.empty() ? beam_beside_its_line(ends, beam, at)
                          : released_beam(ends, beam, bar.y, free, at);
    if (!free.empty())
      card.wrong("is tapered and has released ends", "a constant section, or no pin flags");
    Taper turned = *taper;
    for (BeamStation& station : turned)
      station.eccentricity = in_global(station.eccentricity, axis, bar.y);
    const BeamStation &a = turned.front(), &b = turned.back();
    kept.arms = {arm_of_mass(beam.offset1, a.section, a.eccentricity),
                 arm_of_mass(beam.offset2, b.section, b.eccentricity)};
    return tapered_beam(ends, beam, turned);
  };
  MatrixElement& made = r.deck.springs.emplace_back(matrix());
  if (!r.deck.lumped_mass) return;
  const BeamStation end{0, beam.section, at};
  made.M = mass_at_the_ends(taper != nullptr ? *taper : Taper{end, {1, beam.section, at}}, axis);
}

void beam(const NastranReading& r, const Card& card) {
  const Card& by = given(r, card, 1);
  const auto section = r.properties.beam(card, by.has(1) ? by.whole(1) : card.whole(0));
  BeamElement beam{.node1 = r.grids.at(card, 2), .node2 = r.grids.at(card, 3), .section = {}};
  if (!section) return;
  beam.section = section->properties;
  if (r.deck.lumped_mass && card.name == "CBAR") beam.section.inertia_x = 0; // CBEAM has it
  const std::string axes = in_capitals(card.text(7));
  if (!axes.empty() && axes != "GGG" && axes != "BGG" && axes != "1" && axes != "2" &&
      !card.is_real(7)) // 1, 2 in old decks: a vector, a grid point
    card.wrong("has OFFT " + axes, "GGG, BGG or blank");
  if (card.is_real(7) && card.real(7) != 0) card.wrong("has a twist BIT", "OFFT blank");
  beam.up = orientation(r, card, beam, axes == "BGG");
  beam.offset1 = r.grids.axes(beam.node1) * vector(card, 10);
  beam.offset2 = r.grids.axes(beam.node2) * vector(card, 13);
  const Vector3d axis =
      r.deck.nodes[beam.node2] + beam.offset2 - r.deck.nodes[beam.node1] - beam.offset1;
  if (!(axis.cross(beam.up).norm() > 1e-6 * axis.norm() * beam.up.norm()))
    card.wrong("has no length, or an orientation along its axis", "a vector across the axis");
  const Vector3d up = beam.up;
  if (section->turn != 0) {
    const Vector3d y = up.cross(axis).normalized(), z = axis.cross(y).normalized();
    beam.up = std::cos(section->turn) * z - std::sin(section->turn) * y;
  }
  const Vector3d y = axis.cross(up).cross(axis).normalized();
  const int number = by.has(1) ? by.whole(1) : card.whole(0);
  const DeckBar bar{card.whole(0), card.origin(), r.properties.expansion_of_beam(number), y};
  add_beam(r, card, beam, section->eccentricity, r.properties.taper_of_beam(number), bar);
}

void add_rod(const NastranReading& r, const Card& card, int node1, int node2,
             const NastranRod& rod) {
  const Vector3d &x1 = r.deck.nodes[node1], &x2 = r.deck.nodes[node2];
  if (!((x2 - x1).norm() > 0)) card.wrong("has no length", "two places");
  if (!(rod.EA >= 0 && rod.GJ >= 0 && rod.mass >= 0)) card.wrong("is below zero", "0 or more");
  r.deck.of_springs[int(r.deck.springs.size())] = {card.whole(0), card.origin(), rod.expansion};
  r.deck.springs.push_back(truss({node1, node2}, x1, x2, rod.EA, rod.GJ, rod.mass,
                                 r.coupled_mass ? TrussMass::consistent : TrussMass::lumped));
}

} // namespace

void read_bars(const NastranReading& r) {
  for (const char* name : {"CBAR", "CBEAM"}) r.each(name, [&](const Card& card) { beam(r, card); });
  for (const char* name : {"CROD", "CTUBE"})
    r.each(name, [&](const Card& card) {
      const int node1 = r.grids.at(card, 2), node2 = r.grids.at(card, 3);
      if (const auto rod = r.properties.rod(card, card.whole(1, card.whole(0))))
        add_rod(r, card, node1, node2, *rod);
    });
  r.each("CONROD", [&](const Card& card) {
    const NastranMaterial& m = r.properties.material(card, 3);
    add_rod(r, card, r.grids.at(card, 1), r.grids.at(card, 2),
            r.properties.rod(m, card.real(4), card.real(5, 0), card.real(7, 0)));
  });
}

} // namespace plica
