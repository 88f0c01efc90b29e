#include "io/decks/keywords.hpp"
#include "io/decks/nastran_properties.hpp"

#include <cmath>

namespace plica {
namespace {

bool alike(double a, double b) {
  return std::abs(a - b) <= 1e-6 * std::max(std::abs(a), std::abs(b));
}

// Shear stiffness of K1, K2 of A; zero = rigid. K1 is that of plane 1, our z.
void set_shear(const Card& card, TurnedSection& section, double K1, double K2, double GA) {
  if (section.turn != 0 && K1 != K2)
    card.wrong("has a product of inertia and K1 other than K2", "K1 and K2 alike, or I12 blank");
  if (K1 > 0) section.properties.GA_z = K1 * GA;
  if (K2 > 0) section.properties.GA_y = K2 * GA;
}

} // namespace

// Our local z is the y of the element, the direction of its orientation vector, our y its -z.
TurnedSection NastranProperties::beam_of(const Card& card) const {
  const NastranMaterial& m = material(card, 1);
  TurnedSection section = card.name == "PBAR"    ? pbar(card, m)
                          : card.name == "PBEAM" ? pbeam(card, m)
                                                 : shaped(card, m);
  const double shear = m.isotropic_shear() > 0 ? m.G / m.isotropic_shear() : 1;
  section.properties.GJ *= shear;
  section.properties.GA_y *= shear;
  section.properties.GA_z *= shear;
  return section;
}

TurnedSection NastranProperties::pbar(const Card& card, const NastranMaterial& m) const {
  const double A = card.real(2, 0);
  TurnedSection section =
      principal_section(m, A, card.real(3, 0), card.real(4, 0), -card.real(18, 0), card.real(5, 0));
  section.properties.mass += mass_factor_ * card.real(6, 0);
  set_shear(card, section, card.real(16, 0), card.real(17, 0), m.isotropic_shear() * A);
  return section;
}

// Stations along the beam, from `field` on, have to repeat its first end; leaves `field` behind
// them.
double NastranProperties::constant_along(const Card& card, std::size_t& field) const {
  while (field < card.fields.size() && card.has(field) &&
         std::isalpha(static_cast<unsigned char>(card.text(field)[0]))) {
    for (std::size_t i = 2; i < 8; ++i)
      if (card.has(field + i) && !alike(card.real(field + i), card.real(i, 0)))
        card.wrong("is tapered: it has stations along the beam with other values",
                   "a constant section");
    field += in_capitals(card.text(field)) == "YES" ? 16 : 8; // with points of stress, or without
  }
  return card.real(7, 0);
}

TurnedSection NastranProperties::pbeam(const Card& card, const NastranMaterial& m) const {
  const double A = card.real(2);
  std::size_t field = 16;
  const bool has_stress =
      !card.has(8) || !std::isalpha(static_cast<unsigned char>(card.text(8)[0]));
  if (!has_stress) field = 8;
  const double extra = constant_along(card, field);
  TurnedSection section =
      principal_section(m, A, card.real(3), card.real(4, 0), -card.real(5, 0), card.real(6, 0));
  section.properties.mass += mass_factor_ * extra;
  for (std::size_t i = 8; i < 16; ++i)
    if (card.real(field + i, 0) != 0)
      card.wrong("has a neutral axis or a centre of mass beside the shear centre (N, M)",
                 "M1, M2, N1, N2 blank");
  for (std::size_t i = field + 16; i < card.fields.size(); ++i)
    if (card.has(i)) card.wrong("goes on with \"" + card.text(i) + "\"", "a constant section");
  section.properties.inertia_x += mass_factor_ * card.real(field + 4, 0);
  set_shear(card, section, card.real(field, 1), card.real(field + 1, 1), m.isotropic_shear() * A);
  return section;
}

TurnedSection NastranProperties::shaped(const Card& card, const NastranMaterial& m) const {
  const std::size_t count = sizes_of_profile(card);
  const std::string type = in_capitals(card.text(3));
  static const std::set<std::string> symmetric{"ROD",  "TUBE", "TUBE2", "BAR",   "BOX",
                                               "BOX1", "I1",   "H",     "CROSS", "I"};
  std::vector<double> sizes;
  for (std::size_t i = 0; i < count; ++i) {
    if (!(card.real(8 + i) > 0) && !(type == "TUBE" && i == 1 && card.real(8 + i) == 0))
      card.wrong("has a size of " + card.text(8 + i), "above 0");
    sizes.push_back(card.real(8 + i));
  }
  const bool uneven = type == "I" && (!alike(sizes[1], sizes[2]) || !alike(sizes[4], sizes[5]));
  if (card.name == "PBEAML" && (!symmetric.contains(type) || uneven))
    card.wrong("has the shape " + type + ", whose shear centre lies beside its centroid",
               "a shape with two axes of symmetry, or PBARL");
  TurnedSection section = nastran_profile(card, m, sizes);
  section.properties.mass += mass_factor_ * card.real(8 + count, 0);
  for (std::size_t i = 9 + count; i < card.fields.size();) { // SO, X/XB, sizes, NSM of a station
    if (!card.has(i) || card.name != "PBEAML") {
      if (card.has(i)) card.wrong("goes on with \"" + card.text(i) + "\"", "a constant section");
      ++i;
      continue;
    }
    for (std::size_t k = 0; k <= count; ++k)
      if (card.has(i + 2 + k) && !alike(card.real(i + 2 + k), card.real(8 + k, 0)))
        card.wrong("is tapered: it has stations along the beam with other sizes",
                   "a constant section");
    i += 3 + count;
  }
  return section;
}

} // namespace plica
