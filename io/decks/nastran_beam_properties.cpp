#include "io/decks/keywords.hpp"
#include "io/decks/nastran_properties.hpp"
#include "words/short_text.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

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

// What a card gives at a place along the beam, as a share of its length.
struct Station {
  double x = 0;
  std::vector<double> numbers;
};

// `count` numbers at the stations from `field` on, SO and X/XB before them; first those of end A.
// Blank ones are those of end A at end B, between them on the straight line. Leaves `field` behind
// them. `step`: fields of a station, given whether stresses are asked for there.
template <class Step>
std::vector<Station> stations_of(const Card& card, const std::vector<double>& at_a,
                                 std::size_t& field, Step&& step) {
  struct Given {
    double x = 0;
    std::vector<std::optional<double>> numbers;
  };
  std::vector<Given> given;
  while (field < card.fields.size() && card.has(field) &&
         std::isalpha(static_cast<unsigned char>(card.text(field)[0]))) {
    Given& station = given.emplace_back();
    station.x = card.real(field + 1, 1);
    for (std::size_t i = 0; i < at_a.size(); ++i)
      station.numbers.push_back(card.has(field + 2 + i) ? std::optional(card.real(field + 2 + i))
                                                        : std::nullopt);
    field += step(in_capitals(card.text(field)) == "YES");
  }
  std::sort(given.begin(), given.end(), [](const Given& a, const Given& b) { return a.x < b.x; });
  std::vector<Station> all{{0, at_a}};
  if (given.empty()) return all;
  std::vector<double> at_b = at_a;
  for (std::size_t i = 0; i < at_b.size(); ++i) at_b[i] = given.back().numbers[i].value_or(at_a[i]);
  for (const Given& g : given) {
    if (!(g.x > all.back().x && g.x <= 1))
      card.wrong("has a station at X/XB " + short_text(g.x, 4), "one of each place above 0, to 1");
    Station& station = all.emplace_back(Station{g.x, {}});
    for (std::size_t i = 0; i < at_a.size(); ++i)
      station.numbers.push_back(g.numbers[i].value_or(at_a[i] + g.x * (at_b[i] - at_a[i])));
  }
  if (all.back().x != 1) all.push_back({1, at_b});
  return all;
}

bool is_tapered(const std::vector<Station>& stations) {
  return std::any_of(stations.begin(), stations.end(), [&](const Station& s) {
    return !std::equal(s.numbers.begin(), s.numbers.end(), stations.front().numbers.begin(), alike);
  });
}

// Of ends A and B, `step` fields apart, straight between; blank at B: as at A.
double between(const Card& card, std::size_t field, std::size_t step, double x) {
  const double a = card.real(field, 0);
  return a + x * (card.real(field + step, a) - a);
}

// Element y and z of both ends, in our axes.
Eigen::Vector3d place_at(const Card& card, std::size_t field, double x) {
  return {0, -between(card, field + 1, 2, x), between(card, field, 2, x)};
}

// Whether N, or what the mass that does not bear has, changes between the ends.
bool ends_differ(const Card& card, std::size_t field) {
  const bool mass = card.real(7, 0) != 0;
  return place_at(card, field + 12, 0) != place_at(card, field + 12, 1) ||
         (mass && place_at(card, field + 8, 0) != place_at(card, field + 8, 1)) ||
         between(card, field + 4, 1, 0) != between(card, field + 4, 1, 1);
}

// Centroid from shear centre; what is rounding is none.
Eigen::Vector3d from_shear_centre(const TurnedSection& s) {
  const double y = s.centroid[0] - s.shear_centre[0], z = s.centroid[1] - s.shear_centre[1];
  const double least = 1e-9 * std::sqrt((s.properties.EI_y + s.properties.EI_z) / s.properties.EA);
  return {0, std::abs(y) > least ? y : 0, std::abs(z) > least ? z : 0};
}

// A plain beam carries what does not bear along its own axis.
NastranBeam whole(NastranBeam section) {
  Eccentricity& at = section.eccentricity;
  if (!at.is_none()) return section;
  section.properties.mass += at.extra_mass;
  section.properties.inertia_x += at.extra_inertia;
  at = {};
  return section;
}

template <class F> Taper taper_of(const std::vector<Station>& stations, F&& section) {
  Taper taper;
  for (const Station& s : stations) {
    const NastranBeam beam = section(s);
    taper.push_back({s.x, beam.properties, beam.eccentricity});
  }
  if (taper.back().x != 1) {
    const NastranBeam beam = section(Station{1, stations.back().numbers});
    taper.push_back({1, beam.properties, beam.eccentricity});
  }
  return taper;
}

} // namespace

// Our local z is the y of the element, the direction of its orientation vector, our y its -z.
NastranBeam NastranProperties::beam_of(const Card& card) {
  const NastranMaterial& m = material(card, 1);
  NastranBeam section = card.name == "PBAR"    ? pbar(card, m)
                        : card.name == "PBEAM" ? pbeam(card, m)
                                               : shaped(card, m);
  const double shear = m.isotropic_shear() > 0 ? m.G / m.isotropic_shear() : 1;
  const auto scale = [shear](BeamProperties& s) {
    s.GJ *= shear;
    s.GA_y *= shear;
    s.GA_z *= shear;
  };
  scale(section.properties);
  if (const auto taper = tapers_.find(card.whole(0)); taper != tapers_.end())
    for (BeamStation& station : taper->second) scale(station.section);
  return section;
}

NastranBeam NastranProperties::pbar(const Card& card, const NastranMaterial& m) const {
  const double A = card.real(2, 0);
  NastranBeam section{principal_section(m, A, card.real(3, 0), card.real(4, 0), -card.real(18, 0),
                                        card.real(5, 0))};
  section.properties.mass += mass_factor_ * card.real(6, 0);
  set_shear(card, section, card.real(16, 0), card.real(17, 0), m.isotropic_shear() * A);
  return section;
}

NastranBeam NastranProperties::pbeam(const Card& card, const NastranMaterial& m) {
  std::size_t field = 16;
  const bool has_stress =
      !card.has(8) || !std::isalpha(static_cast<unsigned char>(card.text(8)[0]));
  if (!has_stress) field = 8;
  const std::vector<Station> stations =
      stations_of(card,
                  {card.real(2), card.real(3), card.real(4, 0), card.real(5, 0), card.real(6, 0),
                   card.real(7, 0)},
                  field, [](bool stress) { return stress ? 16U : 8U; });
  for (std::size_t i = field + 16; i < card.fields.size(); ++i)
    if (card.has(i)) card.wrong("goes on with \"" + card.text(i) + "\"", "stations");
  const bool tapered = is_tapered(stations) || ends_differ(card, field);
  const auto section = [&](const Station& s) { // A, I1, I2, I12, J, NSM
    const std::vector<double>& n = s.numbers;
    NastranBeam made{principal_section(m, n[0], n[1], n[2], -n[3], n[4])};
    set_shear(card, made, card.real(field, 1), card.real(field + 1, 1), m.isotropic_shear() * n[0]);
    if (made.turn != 0 && tapered)
      card.wrong("is tapered and has a product of inertia", "I12 blank, or a constant section");
    made.eccentricity = {.neutral = place_at(card, field + 12, s.x),
                         .extra = place_at(card, field + 8, s.x),
                         .extra_mass = mass_factor_ * n[5],
                         .extra_inertia = mass_factor_ * between(card, field + 4, 1, s.x)};
    return made;
  };
  if (!tapered) return whole(section(stations.front()));
  tapers_[card.whole(0)] = taper_of(stations, section);
  return section(stations.front());
}

NastranBeam NastranProperties::shaped(const Card& card, const NastranMaterial& m) {
  const std::size_t count = sizes_of_profile(card);
  const std::string type = in_capitals(card.text(3));
  std::vector<double> sizes;
  for (std::size_t i = 0; i < count; ++i) {
    if (!(card.real(8 + i) > 0) && !(type == "TUBE" && i == 1 && card.real(8 + i) == 0))
      card.wrong("has a size of " + card.text(8 + i), "above 0");
    sizes.push_back(card.real(8 + i));
  }
  sizes.push_back(card.real(8 + count, 0)); // and NSM
  std::size_t field = 9 + count;
  std::vector<Station> stations{{0, sizes}};
  if (card.name == "PBEAML") // SO, X/XB, sizes, NSM of a station
    stations = stations_of(card, sizes, field, [count](bool) { return 3 + count; });
  for (; field < card.fields.size(); ++field)
    if (card.has(field)) card.wrong("goes on with \"" + card.text(field) + "\"", "stations");
  const auto section = [&](const Station& s) {
    NastranBeam made{nastran_profile(card, m, {s.numbers.begin(), s.numbers.end() - 1})};
    if (is_tapered(stations) && made.turn != 0)
      card.wrong("is tapered and has no axis of symmetry", "a constant section");
    made.eccentricity.extra_mass = mass_factor_ * s.numbers.back();
    if (card.name == "PBEAML") made.eccentricity.neutral = from_shear_centre(made);
    return made;
  };
  if (!is_tapered(stations)) return whole(section(stations.front()));
  tapers_[card.whole(0)] = taper_of(stations, section);
  return section(stations.front());
}

} // namespace plica
