#include "model/shape/mesh_choice.hpp"

#include "mesh/generation/meridian.hpp"
#include "model/description/profile.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace plica {
namespace {

using std::numbers::pi;

int rounded_up(double x) {
  return static_cast<int>(std::ceil(x - 1e-9));
}

double accuracy_of(const MeshDensity& mesh) {
  constexpr double left_out = 0.01;
  return mesh.accuracy > 0 ? mesh.accuracy : left_out;
}

double bending_length(const Bellows& bellows) {
  return std::sqrt(bellows.root_radius * total_thickness(bellows.wall));
}

// An arc or a wall of half a convolution: its length, the angle it turns through, elements along
// it, and the height over the root from its start (0) to its end (1).
struct Piece {
  double length = 0, turn = 0;
  int elements = 1;
  std::function<double(double)> height;
};

std::vector<Piece> pieces_of_arcs(const MeridianSection& s, const ElementCounts& n) {
  const double root = root_arc_radius(s), crown = crown_arc_radius(s);
  const auto [phi, wall] = half_convolution(
      {.height = s.height, .pitch = s.pitch, .root_arc = root, .crown_arc = crown});
  const int arc = rounded_up(n.arc * phi / (pi / 2));
  const auto rise = [angle = phi](double radius, double x) {
    return radius * (1 - std::cos(angle * x));
  };
  const double foot = rise(root, 1), head = s.height - rise(crown, 1);
  std::vector<Piece> pieces{{root * phi, phi, arc, [=](double x) { return rise(root, x); }},
                            {crown * phi, phi, arc, [=, height = s.height](double x) {
                               return height - rise(crown, 1 - x);
                             }}};
  if (wall > 1e-9 * s.pitch)
    pieces.push_back({wall, 0, n.wall, [=](double x) { return foot + x * (head - foot); }});
  return pieces;
}

// None of a cuff, and of a curve through points, of which nothing is known beforehand.
std::vector<Piece> half_pieces(const MeridianSection& s, const ElementCounts& n) {
  switch (s.shape) {
  case SectionShape::u:
  case SectionShape::omega:
    return pieces_of_arcs(s, n);
  case SectionShape::disc:
    return {
        {std::hypot(s.height, s.pitch / 2), 0, n.wall, [&s](double x) { return x * s.height; }}};
  case SectionShape::cuff:
  case SectionShape::points:
    break;
  }
  return {};
}

template <class F> double along_piece(const Piece& piece, F&& of_height) {
  constexpr int samples = 64;
  double sum = 0;
  for (int i = 0; i < samples; ++i) sum += of_height(piece.height((i + 0.5) / samples));
  return sum * piece.length / samples;
}

struct PieceErrors {
  double arc = 0, wall = 0; // shares of the stiffness

  double sum() const { return arc + wall; }
};

PieceErrors errors_of(const std::vector<Piece>& pieces, double bending_length) {
  double length = 0, moment = 0;
  for (const Piece& p : pieces) {
    length += p.length;
    moment += along_piece(p, [](double h) { return h; });
  }
  const double mean = moment / length;
  const auto square = [mean](double h) { return (h - mean) * (h - mean); };
  double compliance = 0;
  for (const Piece& p : pieces) compliance += along_piece(p, square);
  PieceErrors errors;
  for (const Piece& p : pieces) {
    const double d = p.turn / p.elements, l = p.length / p.elements;
    const double chord = d > 0 ? l * std::sin(d / 2) / (d / 2) : l;
    const double exact = along_piece(p, square);
    double facets = 0;
    for (int i = 0; i < p.elements; ++i)
      facets +=
          chord *
          square((p.height(double(i) / p.elements) + p.height(double(i + 1) / p.elements)) / 2);
    (p.turn > 0 ? errors.arc : errors.wall) += (exact - facets) / compliance;
    if (p.turn > 0)
      errors.arc +=
          (0.1 * l * l / (bending_length * bending_length) - d * d / 5) * exact / compliance;
  }
  return errors;
}

PieceErrors worst_errors(const Bellows& bellows, const ElementCounts& counts) {
  PieceErrors worst;
  for (const MeridianSection& s : bellows.profile) {
    const std::vector<Piece> pieces = half_pieces(s, counts);
    if (pieces.empty()) continue;
    const PieceErrors errors = errors_of(pieces, bending_length(bellows));
    if (std::abs(errors.sum()) > std::abs(worst.sum())) worst = errors;
  }
  return worst;
}

// Longest arc (for a quarter turn) and wall of the profile, as multiples of sqrt(R t), at least 1.
struct Slenderness {
  double arc = 1, wall = 1;
};

Slenderness slenderness(const Bellows& bellows) {
  Slenderness longest;
  for (const MeridianSection& s : bellows.profile)
    for (const Piece& p : half_pieces(s, {.around = 0, .arc = 1, .wall = 1})) {
      double& of_kind = p.turn > 0 ? longest.arc : longest.wall;
      const double quarter = p.turn > 0 ? pi / 2 / p.turn : 1;
      of_kind = std::max(of_kind, quarter * p.length / bending_length(bellows));
    }
  return longest;
}

// In fours, so that both planes of symmetry have nodes.
int elements_for_waves(double accuracy, int waves) {
  const double share = 0.75 * accuracy;
  return 4 * rounded_up(2 * pi * std::sqrt((waves * waves - 1) / (8 * share)) / 4);
}

} // namespace

double mesh_accuracy(const Bellows& bellows) {
  const MeshDensity& mesh = bellows.mesh;
  return mesh.around > 0 || mesh.arc > 0 || mesh.wall > 0 ? 0 : accuracy_of(mesh);
}

double meridian_error(const Bellows& bellows, const ElementCounts& counts) {
  return worst_errors(bellows, counts).sum();
}

ElementCounts element_counts(const Bellows& bellows) {
  const MeshDensity& mesh = bellows.mesh;
  const double accuracy = accuracy_of(mesh), each = accuracy / 2;
  const double around_constant = bellows.membrane == Membrane::incompatible ? 7 : 60;
  constexpr double least_error = 0.007; // at 4 elements per quarter arc, 5 per wall
  const double refine = std::sqrt(least_error / each);
  const Slenderness s = slenderness(bellows);
  ElementCounts n{.around = std::max(16, 4 * rounded_up(std::sqrt(around_constant / each) / 4)),
                  .arc = std::max(2, rounded_up(4 * refine * s.arc)),
                  .wall = std::max(2, rounded_up(5 * refine * s.wall))};
  if (mesh.waves > 1) n.around = std::max(n.around, elements_for_waves(accuracy, mesh.waves));
  constexpr double share = 0.45; // of the accuracy
  for (PieceErrors e = worst_errors(bellows, n); std::abs(e.sum()) > share * accuracy;
       e = worst_errors(bellows, n))
    ++(std::abs(e.arc) > std::abs(e.wall) ? n.arc : n.wall);
  if (mesh.around > 0) n.around = mesh.around;
  if (mesh.arc > 0) n.arc = mesh.arc;
  if (mesh.wall > 0) n.wall = mesh.wall;
  return n;
}

} // namespace plica
