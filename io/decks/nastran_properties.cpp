#include "io/decks/nastran_properties.hpp"

#include "io/decks/keywords.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>
#include <numbers>

namespace plica {
namespace {

constexpr double rounded = 0.02; // of constants that a deck gives with few digits
constexpr double in_some_way = std::numeric_limits<double>::quiet_NaN(); // DeckExpansion

// Of a wall that is made of one material, or is not: then it does not expand in one way.
DeckExpansion of_all(const DeckExpansion& so_far, const DeckExpansion& other) {
  const bool same = so_far.alpha == other.alpha && so_far.reference == other.reference;
  return same || (so_far.alpha == 0 && other.alpha == 0) ? so_far : DeckExpansion{in_some_way, 0};
}

// Runs over all cards of a name and keeps what `make` gives, or none where it throws.
template <class Made, class F>
void make_all(const CardsByName& cards, const char* name, std::map<int, std::optional<Made>>& all,
              DeckProblems& problems, F&& make) {
  const auto found = cards.find(name);
  if (found == cards.end()) return;
  for (const Card* card : found->second) {
    std::optional<Made> made;
    problems.collect([&] { made = make(*card); });
    problems.collect([&] { all[card->whole(0)] = made; });
  }
}

template <class Made>
std::optional<Made> known(const std::map<int, std::optional<Made>>& all, const Card& asker,
                          int number, const std::string& what, const std::string& allowed) {
  const auto found = all.find(number);
  if (found == all.end()) asker.wrong("there is no " + what, allowed);
  return found->second;
}

} // namespace

NastranProperties::NastranProperties(const CardsByName& cards, double mass_factor,
                                     DeckProblems& problems, std::vector<std::string>& notes)
    : cards_(cards), mass_factor_(mass_factor) {
  const auto each = [&](const char* name, auto&& read) {
    if (const auto found = cards.find(name); found != cards.end())
      for (const Card* card : found->second) problems.collect([&] { read(*card); });
  };
  const std::size_t before = problems.count();
  bool damped = false;
  each("MAT1", [&](const Card& card) {
    read_mat1(card);
    damped = damped || card.real(7, 0) != 0;
  });
  each("MAT2", [&](const Card& card) { read_mat2(card); });
  each("MAT8", [&](const Card& card) { read_mat8(card); });
  if (damped)
    notes.emplace_back("structural damping GE of materials is passed over: the case says it");
  if (problems.count() > before) problems.raise();
  make_all(cards, "PSHELL", walls_, problems, [&](const Card& card) { return pshell(card); });
  for (const char* name : {"PCOMP", "PCOMPG"})
    make_all(cards, name, walls_, problems, [&](const Card& card) { return pcomp(card); });
  for (const char* name : {"PQUAD1", "PTRIA1"})
    make_all(cards, name, walls_, problems, [&](const Card& card) { return pquad1(card); });
  for (const char* name : {"PQUAD2", "PTRIA2", "PQDMEM", "PQDMEM1", "PQDMEM2", "PTRMEM"})
    make_all(cards, name, walls_, problems, [&](const Card& card) { return pquad2(card); });
  for (const char* name : {"PBAR", "PBARL", "PBEAM", "PBEAML"})
    make_all(cards, name, beams_, problems, [&](const Card& card) {
      expansions_[card.whole(0)] = material(card, 1).expansion;
      return beam_of(card);
    });
  make_all(cards, "PROD", rods_["PROD"], problems, [&](const Card& card) {
    return rod(material(card, 1), card.real(2), card.real(3, 0), card.real(5, 0));
  });
  make_all(cards, "PTUBE", rods_["PTUBE"], problems, [&](const Card& card) {
    const double outer = card.real(2), wall = card.real(3, outer / 2);
    if (!(outer > 0 && wall > 0 && wall <= outer / 2) || (card.has(5) && card.real(5) != outer))
      card.wrong("is no constant tube", "an outer diameter, a wall of at most half of it");
    const BeamProperties pipe = pipe_section(material(card, 1), outer / 2 - wall / 2, wall);
    const double A = pipe.EA / pipe.E;
    return rod(material(card, 1), A, 2 * pipe.EI_y / pipe.E, card.real(4, 0));
  });
}

const Card& NastranProperties::card(const char* name, int number, const Card& asker) const {
  if (const auto all = cards_.find(name); all != cards_.end())
    for (const Card* card : all->second)
      if (card->whole(0) == number) return *card;
  asker.wrong("there is no " + std::string(name) + " " + std::to_string(number), "one of the deck");
}

// --- materials

void NastranProperties::add_material(const Card& card, NastranMaterial m) {
  m.line = card.at.line;
  if (const auto [known, is_new] = materials_.try_emplace(card.whole(0), m);
      !is_new && known->second.line != m.line)
    card.wrong("material " + card.text(0) + " is there twice", "a number once");
}

// Two of E, G and nu give the third; one without stiffness is refused where it is used.
void NastranProperties::read_mat1(const Card& card) {
  NastranMaterial m;
  m.E = card.real(1, 0);
  m.G = card.real(2, 0);
  m.nu = card.real(3, 0);
  m.rho = mass_factor_ * card.real(4, 0);
  m.expansion = {card.real(5, 0), card.real(6, 0)};
  if (m.E == 0 && m.G == 0) {
    m.not_a_wall = "has no stiffness";
    return add_material(card, m);
  }
  if (!(card.has(3) ? m.nu > -1 && m.nu <= 0.5 : true))
    card.wrong("has nu = " + card.text(3), "above -1 and at most 0.5");
  if (card.has(1) && card.has(2) && !card.has(3) && m.G > 0) m.nu = m.E / (2 * m.G) - 1;
  if (!card.has(1) && card.has(2) && card.has(3)) m.E = 2 * (1 + m.nu) * m.G;
  if (!card.has(2)) m.G = m.isotropic_shear();
  if (!(m.E >= 0 && m.G >= 0 && m.E + m.G > 0) || (m.E == 0 && !card.has(1)) || m.rho < 0)
    card.wrong("is no material", "two of E, G and nu, E and G above 0, density at least 0");
  if (std::abs(m.G / m.isotropic_shear() - 1) > rounded)
    m.not_a_wall = fmt::format("has G = {:g}, which E and nu make {:g}", m.G, m.isotropic_shear());
  else if (!(m.nu < 0.5))
    m.not_a_wall = "has nu of 0.5 or more";
  m.ply = isotropic(m.E, m.nu, m.G, m.rho);
  add_material(card, m);
}

void NastranProperties::read_mat2(const Card& card) {
  NastranMaterial m;
  const double G11 = card.real(1, 0), G12 = card.real(2, 0), G22 = card.real(4, 0),
               G33 = card.real(6, 0);
  m.rho = mass_factor_ * card.real(7, 0);
  if (card.real(8, 0) != 0 || card.real(9, 0) != 0 || card.real(10, 0) != 0)
    m.expansion.alpha = in_some_way;
  m.nu = G11 > 0 ? G12 / G11 : 0;
  m.E = G11 * (1 - m.nu * m.nu);
  m.G = G33;
  const bool isotropic = G11 > 0 && std::abs(G22 / G11 - 1) < rounded &&
                         std::abs(G33 / ((G11 - G12) / 2) - 1) < rounded &&
                         std::abs(card.real(3, 0)) + std::abs(card.real(5, 0)) < 1e-6 * G11;
  if (!isotropic) m.not_a_wall = "is anisotropic (MAT2)";
  m.ply.emplace();
  const double G13 = card.real(3, 0), G23 = card.real(5, 0);
  m.ply->Q << G11, G12, G13, G12, G22, G23, G13, G23, G33;
  m.ply->G << G11, G12, G12, G22; // where it is the material of transverse shear
  m.ply->rho = m.rho;
  add_material(card, m);
}

void NastranProperties::read_mat8(const Card& card) {
  NastranMaterial m;
  m.E = card.real(1, 0);
  m.nu = card.real(3, 0);
  m.G = card.real(4, 0);
  m.rho = mass_factor_ * card.real(7, 0);
  if (card.real(8, 0) != 0 || card.real(9, 0) != 0) m.expansion.alpha = in_some_way;
  const bool isotropic = m.E > 0 && std::abs(card.real(2, 0) / m.E - 1) < rounded && m.nu < 0.5 &&
                         std::abs(m.G / m.isotropic_shear() - 1) < rounded;
  if (!isotropic) m.not_a_wall = "is orthotropic (MAT8)";
  m.ply = orthotropic(m.E, card.real(2, 0), m.nu, m.G, card.real(5, 0), card.real(6, 0), m.rho);
  add_material(card, m);
}

const NastranMaterial& NastranProperties::material(const Card& card, std::size_t field) const {
  const auto found = materials_.find(card.whole(field));
  if (found == materials_.end())
    card.wrong("there is no material " + card.text(field), "a MAT1 of the deck");
  if (found->second.not_a_wall == "has no stiffness")
    card.wrong("is of material " + card.text(field) + " in line " +
                   std::to_string(found->second.line) + ", which has no stiffness",
               "two of E, G and nu");
  return found->second;
}

// The wall of a shell is isotropic here: its G follows from E and nu.
const NastranMaterial& NastranProperties::wall_material(const Card& card, std::size_t field) const {
  const NastranMaterial& m = material(card, field);
  if (!m.not_a_wall.empty())
    card.wrong("has a wall of material " + card.text(field) + " in line " + std::to_string(m.line) +
                   ", which " + m.not_a_wall,
               "an isotropic wall: G within 2 % of E/2/(1+nu), nu below 0.5");
  return m;
}

const PlyMaterial& NastranProperties::ply_material(const Card& card, std::size_t field) const {
  const NastranMaterial& m = material(card, field);
  if (!m.ply || !is_material(*m.ply))
    card.wrong("has a wall of material " + card.text(field) + " in line " + std::to_string(m.line) +
                   ", which has no stiffness in some direction",
               "stiffness along both axes and in shear, E1 > nu12^2 E2");
  return *m.ply;
}

// --- walls

// MID1, MID2, MID4 of any kind, each with its stiffness: A, D, B; MID3 transverse shear.
NastranWall NastranProperties::general_pshell(const Card& card, NastranWall wall) const {
  const bool bends = wall.kind == WallKind::all;
  ShellLaminate all = solid_wall(ply_material(card, 1));
  all.D.setZero();
  if (bends) {
    const PlyMaterial& bending = ply_material(card, 3);
    all.D = card.real(4, 1) * bending.Q;
    all.S = solid_wall({bending.Q, Eigen::Matrix2d::Zero(), 0}).S; // rigid
    if (!(card.real(4, 1) > 0)) card.wrong("has a factor of zero", "12I/T**3 above 0");
  } else {
    all.S.setZero();
    all.drilling = 0;
  }
  if (bends && card.has(5) && card.whole(5) != 0) {
    const NastranMaterial& shear = material(card, 5);
    if (!shear.ply || !(shear.ply->G.diagonal().minCoeff() >= 0))
      card.wrong("has no shear stiffness in MID3", "a material with G");
    if (shear.ply->G.diagonal().minCoeff() > 0) all.S = card.real(6, 5. / 6) * shear.ply->G;
    if (!(all.S.determinant() > 0)) card.wrong("has a factor of zero", "TS/T above 0");
  }
  if (card.has(10)) {
    if (!bends) card.wrong("has MID4 and no MID2", "both");
    const NastranMaterial& coupling = material(card, 10);
    if (!coupling.ply) card.wrong("has no coupling in MID4", "a MAT1 or MAT2");
    all.B = coupling.ply->Q;
    Eigen::Matrix<double, 6, 6> whole;
    whole << all.A, all.B, all.B, all.D / 12;
    if (!(Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(whole)
              .eigenvalues()
              .minCoeff() > 0))
      card.wrong("couples membrane and bending by more than they resist (MID4)",
                 "a wall that resists every strain");
  }
  if (const double extra = mass_factor_ * card.real(7, 0); extra != 0) {
    if (!(wall.thickness > 0)) card.wrong("has NSM but no thickness", "a thickness");
    all.rho += extra / wall.thickness;
  }
  wall.laminate = all;
  return wall;
}

NastranWall NastranProperties::pshell(const Card& card) const {
  NastranWall wall{.section = {}, .thickness = card.real(2, 0)};
  const bool membrane = card.has(1) && card.whole(1) != 0,
             bends = card.has(3) && card.whole(3) != 0;
  if (!membrane && !bends) card.wrong("has neither MID1 nor MID2", "a material");
  if (bends && card.whole(3) < 0)
    card.wrong("is in plane strain (MID2 -1)", "a wall in plane stress");
  wall.expansion = material(card, membrane ? 1 : 3).expansion;
  if (membrane && bends) wall.expansion = of_all(wall.expansion, material(card, 3).expansion);
  wall.kind = !bends ? WallKind::membrane : membrane ? WallKind::all : WallKind::bending;
  const auto is_odd = [&](std::size_t field) { return !material(card, field).not_a_wall.empty(); };
  const bool other_nu = membrane && bends && !is_odd(1) && !is_odd(3) &&
                        std::abs(material(card, 1).nu - material(card, 3).nu) > 0.005;
  if (membrane && (is_odd(1) || (bends && is_odd(3)) || other_nu || card.has(10)))
    return general_pshell(card, wall);
  if (card.has(10)) card.wrong("has MID4 and no MID1", "both");
  const NastranMaterial& m = wall_material(card, membrane ? 1 : 3);
  ShellSection& s = wall.section;
  s = {.E = m.E, .nu = m.nu, .rho = m.rho};
  if (const double extra = mass_factor_ * card.real(7, 0); extra != 0) {
    if (!(wall.thickness > 0)) card.wrong("has NSM but no thickness", "a thickness");
    s.rho += extra / wall.thickness;
  }
  if (wall.kind == WallKind::membrane) {
    s.bending_factor = s.shear_correction = s.drilling = 0;
    return wall;
  }
  const NastranMaterial& bending = wall_material(card, 3);
  s.bending_factor = card.real(4, 1) * bending.E / m.E;
  const bool flexible = card.has(5) && card.whole(5) != 0;
  s.shear_correction =
      flexible ? card.real(6, 5. / 6) * material(card, 5).G / m.isotropic_shear() : rigid_in_shear;
  if (!(s.bending_factor > 0 && s.shear_correction > 0))
    card.wrong("has a factor of zero", "12I/T**3 and TS/T above 0");
  return wall;
}

// From line 2 on: MID, T, THETA, SOUT of two plies a line (PCOMPG: a ply number first, one a line).
NastranWall NastranProperties::pcomp(const Card& card) const {
  const bool numbered = card.name == "PCOMPG";
  const std::string form = in_capitals(card.text(7));
  if (form == "BEND" || form == "SMCORE")
    card.wrong("is laminated with LAM " + form, "LAM blank, SYM, MEM or SMEAR");
  const std::size_t step = numbered ? 8 : 4, shift = numbered ? 1 : 0;
  std::vector<LaminatePly> plies;
  std::vector<GeneralPly> general;
  double last = 0;
  bool isotropic = form != "MEM" && form != "SMEAR";
  std::optional<DeckExpansion> expansion;
  for (std::size_t i = 8; i < card.fields.size(); i += step) {
    if (!card.has(i) && !card.has(i + 1) && !card.has(i + 2)) continue;
    std::size_t named = i + shift;
    while (!card.has(named) && named >= 8 + step) named -= step; // blank: as the ply before
    const NastranMaterial& m = material(card, named);
    last = card.real(i + shift + 1, last);
    if (!(last > 0)) card.wrong("has a ply without thickness", "T above 0");
    isotropic = isotropic && m.not_a_wall.empty();
    expansion = expansion ? of_all(*expansion, m.expansion) : m.expansion;
    plies.push_back({m.E, m.nu, m.rho, m.G, last});
    general.push_back(
        {ply_material(card, named), last, card.real(i + shift + 2, 0) * std::numbers::pi / 180});
  }
  if (plies.empty()) card.wrong("has no ply", "MID, T, THETA, SOUT of each");
  if (form == "SYM") {
    plies.insert(plies.end(), plies.rbegin(), plies.rend());
    general.insert(general.end(), general.rbegin(), general.rend());
  }
  const IsotropicLaminate laminate = isotropic_laminate(plies);
  NastranWall wall{.section = laminate.section,
                   .thickness = laminate.thickness,
                   .expansion = expansion.value_or(DeckExpansion())};
  const double extra = mass_factor_ * card.real(2, 0) / wall.thickness;
  wall.section.rho += extra;
  wall.offset = card.has(1) ? card.real(1) + wall.thickness / 2 : 0;
  if (isotropic && laminate.refusal.empty()) return wall;
  wall.laminate = general_laminate(general);
  wall.laminate->rho += extra;
  if (form == "SMEAR") wall.laminate->D = wall.laminate->A;
  if (form == "SMEAR" || form == "MEM") wall.laminate->B.setZero();
  if (form == "MEM") {
    wall.laminate->D.setZero();
    wall.laminate->S.setZero();
    wall.laminate->drilling = 0;
  }
  return wall;
}

std::optional<NastranWall> NastranProperties::wall(const Card& asker, int number) const {
  return known(walls_, asker, number, "PSHELL " + std::to_string(number), "a property of the deck");
}

// --- bars

std::optional<NastranBeam> NastranProperties::beam(const Card& asker, int number) const {
  return known(beams_, asker, number, "property " + std::to_string(number) + " of a beam",
               "PBAR, PBARL, PBEAM, PBEAML");
}

DeckExpansion NastranProperties::expansion_of_beam(int number) const {
  const auto found = expansions_.find(number);
  return found == expansions_.end() ? DeckExpansion() : found->second;
}

const Taper* NastranProperties::taper_of_beam(int number) const {
  const auto found = tapers_.find(number);
  return found == tapers_.end() ? nullptr : &found->second;
}

std::optional<NastranRod> NastranProperties::rod(const Card& asker, int number) const {
  const std::string name = asker.name == "CTUBE" ? "PTUBE" : "PROD";
  return known(rods_.at(name), asker, number, name + " " + std::to_string(number),
               "a property of the deck");
}

NastranRod NastranProperties::rod(const NastranMaterial& m, double A, double J,
                                  double extra) const {
  return {m.E * A, m.G * J, m.rho * A + mass_factor_ * extra, m.expansion};
}

} // namespace plica
