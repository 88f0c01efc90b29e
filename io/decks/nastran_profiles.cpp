#include "io/decks/deck_profiles.hpp"
#include "io/decks/keywords.hpp"
#include "io/decks/nastran_properties.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plica {
namespace {

const std::map<std::string, std::size_t> sizes{
    {"ROD", 1},  {"TUBE", 2},  {"TUBE2", 2}, {"BAR", 2},   {"BOX", 4}, {"BOX1", 6},
    {"I", 6},    {"I1", 4},    {"H", 4},     {"T", 4},     {"T1", 4},  {"T2", 4},
    {"CHAN", 4}, {"CHAN1", 4}, {"CHAN2", 4}, {"CROSS", 4}, {"Z", 4},   {"L", 4},
    {"HAT", 4},  {"HAT1", 5},  {"HEXA", 3},  {"DBOX", 10}};

// One wall: where it counts, and its middle line up to the middles of those that it meets.
void add(Profile& p, const ProfileRectangle& r, const Eigen::Vector2d& from,
         const Eigen::Vector2d& to) {
  p.rectangles.push_back(r);
  p.walls.push_back({from, to, std::abs(from[0] - to[0]) > 0 ? r.depth : r.width});
}

// Of two equal parts on either side of y = 0.
void add_twice(Profile& p, const ProfileRectangle& r, const Eigen::Vector2d& from,
               const Eigen::Vector2d& to) {
  add(p, r, from, to);
  add(p, {-r.y, r.z, r.width, r.depth}, {-from[0], from[1]}, {-to[0], to[1]});
}

// A wall that another meets in its middle, at y = 0 or, standing, at z = 0.
void add_split(Profile& p, const ProfileRectangle& r, bool standing) {
  p.rectangles.push_back(r);
  const Eigen::Vector2d half =
      standing ? Eigen::Vector2d(0, r.depth / 2) : Eigen::Vector2d(r.width / 2, 0);
  const Eigen::Vector2d middle(r.y, r.z);
  p.walls.push_back({middle - half, middle, standing ? r.width : r.depth});
  p.walls.push_back({middle, middle + half, standing ? r.width : r.depth});
}

// A web from its lower end, and a flange to the right at either end of it.
Profile channel(double web, double flange, double width, double height) {
  Profile p;
  if (!(width > web)) throw std::invalid_argument("a web as wide as the whole");
  const double at = (height - flange) / 2, y = web / 2;
  add(p, {y, 0, web, height - 2 * flange}, {y, -at}, {y, at});
  add(p, {width / 2, -at, width, flange}, {y, -at}, {width, -at});
  add(p, {width / 2, at, width, flange}, {y, at}, {width, at});
  return p;
}

Profile standing_t(const std::vector<double>& d) { // T1
  Profile p;
  add_split(p, {0, 0, d[2], d[0]}, true);
  const double end = -d[2] / 2 - d[1];
  add(p, {(end - d[2] / 2) / 2, 0, d[1], d[3]}, {end, 0}, {0, 0});
  return p;
}

Profile trough(const std::vector<double>& d) { // CHAN2
  Profile p;
  const double at = (d[3] - d[0]) / 2, leg = d[2] - d[1];
  add(p, {0, d[1] / 2, d[3], d[1]}, {-at, d[1] / 2}, {at, d[1] / 2});
  add_twice(p, {at, d[1] + leg / 2, d[0], leg}, {at, d[1] / 2}, {at, d[2]});
  return p;
}

Profile cross(const std::vector<double>& d) {
  Profile p;
  const double end = (d[0] + d[1]) / 2; // the arms reach half of DIM1 to either side
  add_split(p, {0, 0, d[1], d[2]}, true);
  add_twice(p, {(end + d[1] / 2) / 2, 0, d[0] / 2, d[3]}, {0, 0}, {end, 0});
  return p;
}

Profile lying_i(const std::vector<double>& d) { // H
  Profile p;
  const double at = (d[0] + d[1] / 2) / 2;
  add_split(p, {-at, 0, d[1] / 2, d[2]}, true);
  add_split(p, {at, 0, d[1] / 2, d[2]}, true);
  add(p, {0, 0, d[0], d[3]}, {-at, 0}, {at, 0});
  return p;
}

// Seen along the beam the element's z points to the left, our y to the right.
Profile zed(const std::vector<double>& d) {
  Profile p;
  const double flange = (d[3] - d[2]) / 2, at = (d[2] + flange) / 2, end = d[0] + d[1] / 2;
  add(p, {0, 0, d[1], d[3]}, {0, -at}, {0, at});
  add(p, {-(d[0] + d[1]) / 2, at, d[0], flange}, {-end, at}, {0, at});
  add(p, {(d[0] + d[1]) / 2, -at, d[0], flange}, {0, -at}, {end, -at});
  return p;
}

Profile hat(const std::vector<double>& d) {
  Profile p;
  const double t = d[1], side = (d[2] - t) / 2, top = d[0] - t / 2, brim = d[3] + t;
  add(p, {0, top, d[2], t}, {-side, top}, {side, top});
  add_twice(p, {side, d[0] / 2, t, d[0] - 2 * t}, {side, t / 2}, {side, top});
  add_twice(p, {d[2] / 2 + d[3] - brim / 2, t / 2, brim, t}, {side, t / 2},
            {d[2] / 2 + d[3], t / 2});
  return p;
}

// A hat on a plate as wide as its brims, which are one wall with it.
Profile hat_on_plate(const std::vector<double>& d) {
  Profile p;
  const double t = d[3], plate = d[4], side = (d[2] - t) / 2, top = d[1] - t / 2, end = d[0] / 2;
  const double inner = d[2] / 2, web = d[1] - plate - t, low = plate / 2;
  add(p, {0, low, d[2], plate}, {-side, low}, {side, low});
  add(p, {0, top, d[2], t}, {-side, top}, {side, top});
  add_twice(p, {side, plate + web / 2, t, web}, {side, low}, {side, top});
  add_twice(p, {(inner + end) / 2, (plate + t) / 2, end - inner, plate + t}, {side, low},
            {end, low});
  return p;
}

// From the left and below; DIM3 to the middle of the wall between the cells.
Profile two_cells(const std::vector<double>& d) {
  Profile p;
  const double left = d[3] / 2, middle = d[2], right = d[0] - d[5] / 2, half = d[1] / 2;
  const double in_left = middle - d[4] / 2 - d[3], in_right = d[0] - d[5] - middle - d[4] / 2;
  const double y_left = d[3] + in_left / 2, y_right = middle + d[4] / 2 + in_right / 2;
  const auto standing = [&](double y, double t, double low, double high) {
    add(p, {y, half, t, d[1]}, {y, low}, {y, high});
  };
  const double top_left = d[1] - d[6] / 2, top_right = d[1] - d[8] / 2;
  const double low_left = d[7] / 2, low_right = d[9] / 2;
  standing(left, d[3], low_left, top_left);
  standing(right, d[5], low_right, top_right);
  p.rectangles.push_back({middle, half, d[4], d[1]});
  std::vector<double> joints{low_left, low_right, top_left, top_right};
  std::sort(joints.begin(), joints.end());
  for (std::size_t k = 1; k < joints.size(); ++k)
    if (joints[k] > joints[k - 1])
      p.walls.push_back({{middle, joints[k - 1]}, {middle, joints[k]}, d[4]});
  add(p, {y_left, d[1] - d[6] / 2, in_left, d[6]}, {left, top_left}, {middle, top_left});
  add(p, {y_left, d[7] / 2, in_left, d[7]}, {left, low_left}, {middle, low_left});
  add(p, {y_right, d[1] - d[8] / 2, in_right, d[8]}, {middle, top_right}, {right, top_right});
  add(p, {y_right, d[9] / 2, in_right, d[9]}, {middle, low_right}, {right, low_right});
  return p;
}

Profile of_walls(const std::string& type, const std::vector<double>& d) {
  if (type == "I") return i_profile(d[0], d[3], {d[1], d[4]}, {d[2], d[5]});
  if (type == "I1") {
    const Flange flange{d[0] + d[1], (d[3] - d[2]) / 2};
    return i_profile(d[3], d[1], flange, flange);
  }
  if (type == "T") return i_profile(d[1], d[3], {}, {d[0], d[2]});
  if (type == "T2") return i_profile(d[1], d[3], {d[0], d[2]}, {});
  if (type == "T1") return standing_t(d);
  if (type == "H") return lying_i(d);
  if (type == "CHAN") return channel(d[2], d[3], d[0], d[1]);
  if (type == "CHAN1") return channel(d[1], (d[3] - d[2]) / 2, d[0] + d[1], d[3]);
  if (type == "CHAN2") return trough(d);
  if (type == "CROSS") return cross(d);
  if (type == "L") return l_profile(d[0], d[1], d[2], d[3]);
  if (type == "HAT") return hat(d);
  if (type == "HAT1") return hat_on_plate(d);
  if (type == "DBOX") return two_cells(d);
  if (type == "BOX") return box_profile(d[0], d[1], {d[3], d[2], d[3], d[2]});
  if (type == "BOX1") return box_profile(d[0], d[1], {d[5], d[2], d[4], d[3]});
  return zed(d);
}

} // namespace

std::size_t sizes_of_profile(const Card& card) {
  const auto found = sizes.find(in_capitals(card.text(3)));
  if (found != sizes.end()) return found->second;
  std::string known;
  for (const auto& [name, count] : sizes) known += (known.empty() ? "" : ", ") + name;
  card.wrong("has the shape " + card.text(3), known);
}

TurnedSection nastran_profile(const Card& card, const NastranMaterial& m,
                              const std::vector<double>& d) {
  const std::string type = in_capitals(card.text(3));
  if (type == "ROD") return {round_section(m, d[0])};
  if (type == "TUBE" && d[0] > d[1]) return {pipe_section(m, (d[0] + d[1]) / 2, d[0] - d[1])};
  if (type == "TUBE2" && d[0] > d[1]) return {pipe_section(m, d[0] - d[1] / 2, d[1])};
  if (type == "BAR") return {rectangle_section(m, d[0], d[1])};
  if (type == "TUBE" || type == "TUBE2")
    card.wrong("has walls that do not fit its shape " + type, "an inner radius below the outer");
  try {
    if (type == "HEXA") return hexagon_section(m, d[0], d[1], d[2]);
    return profile_section(m, of_walls(type, d));
  } catch (const std::invalid_argument&) {
    card.wrong("has sizes that do not fit its shape " + type,
               "walls and flanges within the height and width, that leave room between them");
  }
}

} // namespace plica
