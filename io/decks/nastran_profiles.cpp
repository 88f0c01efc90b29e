#include "io/decks/keywords.hpp"
#include "io/decks/nastran_properties.hpp"

#include <cmath>

namespace plica {
namespace {

const std::map<std::string, std::size_t> sizes{
    {"ROD", 1},  {"TUBE", 2},  {"TUBE2", 2}, {"BAR", 2},   {"BOX", 4}, {"BOX1", 6},
    {"I", 6},    {"I1", 4},    {"H", 4},     {"T", 4},     {"T1", 4},  {"T2", 4},
    {"CHAN", 4}, {"CHAN1", 4}, {"CHAN2", 4}, {"CROSS", 4}, {"Z", 4}};

// Rectangles with y and z of ours: across, and up the height of the profile.
std::vector<ProfileRectangle> rectangles(const std::string& type, const std::vector<double>& d) {
  if (type == "I") {
    const double web = d[0] - d[4] - d[5];
    return {{0, d[4] / 2, d[1], d[4]},
            {0, d[0] - d[5] / 2, d[2], d[5]},
            {0, d[4] + web / 2, d[3], web}};
  }
  if (type == "I1") {
    const double flange = (d[3] - d[2]) / 2, at = (d[2] + flange) / 2;
    return {{0, -at, d[0] + d[1], flange}, {0, at, d[0] + d[1], flange}, {0, 0, d[1], d[2]}};
  }
  if (type == "H") {
    const double at = (d[0] + d[1] / 2) / 2;
    return {{-at, 0, d[1] / 2, d[2]}, {at, 0, d[1] / 2, d[2]}, {0, 0, d[0], d[3]}};
  }
  if (type == "T")
    return {{0, d[1] - d[2] / 2, d[0], d[2]}, {0, (d[1] - d[2]) / 2, d[3], d[1] - d[2]}};
  if (type == "T2") return {{0, d[2] / 2, d[0], d[2]}, {0, (d[1] + d[2]) / 2, d[3], d[1] - d[2]}};
  if (type == "T1") return {{0, 0, d[2], d[0]}, {-(d[1] + d[2]) / 2, 0, d[1], d[3]}};
  if (type == "CHAN") {
    const double at = (d[1] - d[3]) / 2;
    return {{d[2] / 2, 0, d[2], d[1] - 2 * d[3]},
            {d[0] / 2, -at, d[0], d[3]},
            {d[0] / 2, at, d[0], d[3]}};
  }
  if (type == "CHAN1") {
    const double flange = (d[3] - d[2]) / 2, at = (d[2] + flange) / 2, all = d[0] + d[1];
    return {{d[1] / 2, 0, d[1], d[2]}, {all / 2, -at, all, flange}, {all / 2, at, all, flange}};
  }
  if (type == "CHAN2") {
    const double at = (d[3] - d[0]) / 2, leg = d[2] - d[1];
    return {{0, d[1] / 2, d[3], d[1]},
            {-at, d[1] + leg / 2, d[0], leg},
            {at, d[1] + leg / 2, d[0], leg}};
  }
  if (type == "CROSS") {
    const double at = (d[0] / 2 + d[1]) / 2; // the arms reach half of DIM1 to either side
    return {{0, 0, d[1], d[2]}, {-at, 0, d[0] / 2, d[3]}, {at, 0, d[0] / 2, d[3]}};
  }
  // Z: seen along the beam the element's z points to the left, our y to the right.
  const double flange = (d[3] - d[2]) / 2, at = (d[2] + flange) / 2, out = (d[0] + d[1]) / 2;
  return {{0, 0, d[1], d[3]}, {-out, at, d[0], flange}, {out, -at, d[0], flange}};
}

} // namespace

std::size_t sizes_of_profile(const Card& card) {
  const auto found = sizes.find(in_capitals(card.text(3)));
  if (found == sizes.end())
    card.wrong(
        "has the shape " + card.text(3),
        "ROD, TUBE, TUBE2, BAR, BOX, BOX1, I, I1, H, T, T1, T2, CHAN, CHAN1, CHAN2, CROSS, Z");
  return found->second;
}

TurnedSection nastran_profile(const Card& card, const NastranMaterial& m,
                              const std::vector<double>& d) {
  const std::string type = in_capitals(card.text(3));
  if (type == "ROD") return {round_section(m, d[0]), 0};
  if (type == "TUBE" && d[0] > d[1]) return {pipe_section(m, (d[0] + d[1]) / 2, d[0] - d[1]), 0};
  if (type == "TUBE2" && d[0] > d[1]) return {pipe_section(m, d[0] - d[1] / 2, d[1]), 0};
  if (type == "BAR") return {rectangle_section(m, d[0], d[1]), 0};
  if (type == "BOX" && d[0] > 2 * d[3] && d[1] > 2 * d[2])
    return box_section(m, d[0], d[1], d[3], d[2]);
  if (type == "BOX1" && d[2] == d[3] && d[4] == d[5] && d[0] > 2 * d[4] && d[1] > 2 * d[2])
    return box_section(m, d[0], d[1], d[4], d[2]);
  if (type == "TUBE" || type == "TUBE2" || type == "BOX" || type == "BOX1")
    card.wrong("has walls that do not fit its shape " + type,
               "an inner radius below the outer, walls that leave a hole, alike on both sides");
  const std::vector<ProfileRectangle> parts = rectangles(type, d);
  for (const ProfileRectangle& r : parts)
    if (!(r.width > 0 && r.depth > 0))
      card.wrong("has sizes that do not fit its shape " + type, "flanges within the height");
  return rectangles_section(m, parts);
}

} // namespace plica
