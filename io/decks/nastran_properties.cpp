#include "io/decks/nastran_properties.hpp"

#include "io/decks/keywords.hpp"
#include "io/decks/nastran_laminate.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plica {
namespace {

constexpr double rounded = 0.02;       // of constants that a deck gives with few digits
constexpr double rigid_in_shear = 1e3; // times the shear stiffness of a solid wall

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
    notes.push_back("structural damping GE of materials is passed over: the case says it");
  if (problems.count() > before) problems.raise();
  make_all(cards, "PSHELL", walls_, problems, [&](const Card& card) { return pshell(card); });
  for (const char* name : {"PCOMP", "PCOMPG"})
    make_all(cards, name, walls_, problems, [&](const Card& card) { return pcomp(card); });
  for (const char* name : {"PQUAD2", "PTRIA2", "PQDMEM", "PQDMEM1", "PQDMEM2", "PTRMEM"})
    make_all(cards, name, walls_, problems, [&](const Card& card) { return pquad2(card); });
  for (const char* name : {"PBAR", "PBARL", "PBEAM", "PBEAML"})
    make_all(cards, name, beams_, problems, [&](const Card& card) { return beam_of(card); });
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
  add_material(card, m);
}

void NastranProperties::read_mat2(const Card& card) {
  NastranMaterial m;
  const double G11 = card.real(1, 0), G12 = card.real(2, 0), G22 = card.real(4, 0),
               G33 = card.real(6, 0);
  m.rho = mass_factor_ * card.real(7, 0);
  m.nu = G11 > 0 ? G12 / G11 : 0;
  m.E = G11 * (1 - m.nu * m.nu);
  m.G = G33;
  const bool isotropic = G11 > 0 && std::abs(G22 / G11 - 1) < rounded &&
                         std::abs(G33 / ((G11 - G12) / 2) - 1) < rounded &&
                         std::abs(card.real(3, 0)) + std::abs(card.real(5, 0)) < 1e-6 * G11;
  if (!isotropic) m.not_a_wall = "is anisotropic (MAT2)";
  add_material(card, m);
}

void NastranProperties::read_mat8(const Card& card) {
  NastranMaterial m;
  m.E = card.real(1, 0);
  m.nu = card.real(3, 0);
  m.G = card.real(4, 0);
  m.rho = mass_factor_ * card.real(7, 0);
  const bool isotropic = m.E > 0 && std::abs(card.real(2, 0) / m.E - 1) < rounded && m.nu < 0.5 &&
                         std::abs(m.G / m.isotropic_shear() - 1) < rounded;
  if (!isotropic) m.not_a_wall = "is orthotropic (MAT8)";
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

// --- walls

NastranWall NastranProperties::pshell(const Card& card) const {
  if (card.has(10)) card.wrong("couples membrane and bending (MID4)", "MID4 blank");
  NastranWall wall{.section = {}, .thickness = card.real(2, 0)};
  const bool membrane = card.has(1) && card.whole(1) != 0,
             bends = card.has(3) && card.whole(3) != 0;
  if (!membrane && !bends) card.wrong("has neither MID1 nor MID2", "a material");
  if (bends && card.whole(3) < 0)
    card.wrong("is in plane strain (MID2 -1)", "a wall in plane stress");
  const NastranMaterial& m = wall_material(card, membrane ? 1 : 3);
  wall.kind = !bends ? WallKind::membrane : membrane ? WallKind::all : WallKind::bending;
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
  if (std::abs(bending.nu - m.nu) > 0.005)
    card.wrong("bends with another nu than it stretches with (MID1 and MID2)", "nu alike in both");
  s.bending_factor = card.real(4, 1) * bending.E / m.E;
  const bool flexible = card.has(5) && card.whole(5) != 0;
  s.shear_correction =
      flexible ? card.real(6, 5. / 6) * material(card, 5).G / m.isotropic_shear() : rigid_in_shear;
  if (!(s.bending_factor > 0 && s.shear_correction > 0))
    card.wrong("has a factor of zero", "12I/T**3 and TS/T above 0");
  return wall;
}

// Of one material all through, without flexibility in shear; PQDMEM and its like without bending.
NastranWall NastranProperties::pquad2(const Card& card) const {
  const NastranMaterial& m = wall_material(card, 1);
  NastranWall wall{.section = {.E = m.E, .nu = m.nu, .rho = m.rho}, .thickness = card.real(2)};
  if (!(wall.thickness > 0)) card.wrong("has no thickness", "T above 0");
  wall.section.rho += mass_factor_ * card.real(3, 0) / wall.thickness;
  wall.section.shear_correction = rigid_in_shear;
  if (card.name.find("MEM") != std::string::npos) {
    wall.kind = WallKind::membrane;
    wall.section.bending_factor = wall.section.shear_correction = wall.section.drilling = 0;
  }
  return wall;
}

// From line 2 on: MID, T, THETA, SOUT of two plies a line (PCOMPG: a ply number first, one a line).
NastranWall NastranProperties::pcomp(const Card& card) const {
  const bool numbered = card.name == "PCOMPG";
  if (const std::string form = in_capitals(card.text(7));
      form == "MEM" || form == "BEND" || form == "SMEAR" || form == "SMCORE")
    card.wrong("is laminated with LAM " + form, "LAM blank or SYM");
  const std::size_t step = numbered ? 8 : 4, shift = numbered ? 1 : 0;
  std::vector<LaminatePly> plies;
  double last = 0;
  for (std::size_t i = 8; i < card.fields.size(); i += step) {
    if (!card.has(i) && !card.has(i + 1) && !card.has(i + 2)) continue;
    std::size_t named = i + shift;
    while (!card.has(named) && named >= 8 + step) named -= step; // blank: as the ply before
    const NastranMaterial& m = wall_material(card, named);
    last = card.real(i + shift + 1, last);
    if (!(last > 0)) card.wrong("has a ply without thickness", "T above 0");
    plies.push_back({m.E, m.nu, m.rho, m.G, last});
  }
  if (plies.empty()) card.wrong("has no ply", "MID, T, THETA, SOUT of each");
  if (in_capitals(card.text(7)) == "SYM") plies.insert(plies.end(), plies.rbegin(), plies.rend());
  const IsotropicLaminate laminate = isotropic_laminate(plies);
  if (!laminate.refusal.empty())
    card.wrong(laminate.refusal, "plies that make an isotropic, symmetric wall");
  NastranWall wall{.section = laminate.section, .thickness = laminate.thickness};
  wall.section.rho += mass_factor_ * card.real(2, 0) / wall.thickness;
  wall.offset = card.has(1) ? card.real(1) + wall.thickness / 2 : 0;
  return wall;
}

std::optional<NastranWall> NastranProperties::wall(const Card& asker, int number) const {
  return known(walls_, asker, number, "PSHELL " + std::to_string(number), "a property of the deck");
}

// --- bars

std::optional<TurnedSection> NastranProperties::beam(const Card& asker, int number) const {
  return known(beams_, asker, number, "property " + std::to_string(number) + " of a beam",
               "PBAR, PBARL, PBEAM, PBEAML");
}

std::optional<NastranRod> NastranProperties::rod(const Card& asker, int number) const {
  const std::string name = asker.name == "CTUBE" ? "PTUBE" : "PROD";
  return known(rods_.at(name), asker, number, name + " " + std::to_string(number),
               "a property of the deck");
}

NastranRod NastranProperties::rod(const NastranMaterial& m, double A, double J,
                                  double extra) const {
  return {m.E * A, m.G * J, m.rho * A + mass_factor_ * extra};
}

} // namespace plica
