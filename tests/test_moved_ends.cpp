// Response to motion of chosen ends: closed forms, the motion of all ends together, the routes
// against each other. Places between the nodes of shells, where ends may sit.
#include "io/decks/write_nastran.hpp"
#include "io/files/files.hpp"
#include "model/shape/wall_places.hpp"
#include "solve/base_motion.hpp"
#include "solve/constraints.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tube_case.hpp"
#include "words/input_error.hpp"

#include <complex>
#include <numbers>

namespace plica::test {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

// Two springs in a row with half the bar each on either side of a mass m: with k1 = 1 / (1/k_left +
// 1/half) and k2 alike, moving both by a1, a2 gives the mass (a1 k1 + a2 k2) / (k1 + k2) at rest,
// and that times 1 + w^2 / (w0^2 - w^2 + 2 i zeta w0 w) in motion.
TEST(MovedEnds, one_mass_between_two_mounts_follows_the_closed_form) {
  constexpr double k_left = 4e4, k_right = 1e4, m = 2, zeta = 0.03, phase = 2;
  Case data = mass_between(k_left, k_right, m, zeta);
  Motion both = motion_of("left", 1);
  both.name = "both";
  both.with = {end_of(motion_of("right", 1, 0.4, phase))};
  data.analyses.response =
      Response{.bases = {},
               .motions = {motion_of("left", 1), motion_of("right", 1, 2.5), both},
               .band = {1, 80},
               .points = 60};
  const Results results = run_silently(data);
  ASSERT_EQ(results.responses.size(), 3u);
  EXPECT_EQ(results.responses[0].excitation, "left_y");
  EXPECT_EQ(results.responses[0].source, Source::ends);
  constexpr double half = 2 * EA / L;
  const double k1 = 1 / (1 / k_left + 1 / half), k2 = 1 / (1 / k_right + 1 / half);
  const double w0 = std::sqrt((k1 + k2) / m);
  const std::array<Complex, 3> carried{k1 / (k1 + k2), 2.5 * k2 / (k1 + k2),
                                       (k1 + 0.4 * std::polar(1., phase) * k2) / (k1 + k2)};
  for (std::size_t r = 0; r < 3; ++r) {
    const ResponseResult& response = results.responses[r];
    for (Eigen::Index i = 0; i < response.hertz.size(); ++i) {
      const double w = 2 * pi * response.hertz[i];
      const Complex wanted =
          carried[r] * (1. + w * w / Complex(w0 * w0 - w * w, 2 * zeta * w0 * w));
      EXPECT_LT(std::abs(response.acceleration(i, 1) - wanted), 1e-5 * std::abs(wanted))
          << response.excitation << " at " << response.hertz[i] << " Hz";
    }
  }
}

// Ends that all move alike are the base, for translations.
TEST(MovedEnds, that_move_together_are_the_base) {
  Case data = verification_case("bellows_a", {.around = 24, .arc = 3, .wall = 3});
  data.mount = {
      {.cap = "left"},
      {.cap = "right", .kind = MountKind::springs, .stiffness = {1e5, 2e5, 1e5, 10, 10, 10}}};
  data.sensors = {{.name = "mid", .at = {0.035, 0.03, 0}, .reach = 0.1}};
  data.analyses.modes = Modes{.count = 8};
  data.analyses.damping.modal = 0.02;
  Motion together = motion_of("left", 2);
  together.move = {"left", "right"};
  data.analyses.response =
      Response{.bases = {2}, .motions = {together}, .band = {10, 400}, .points = 40};
  const Results results = run_silently(data);
  ASSERT_EQ(results.responses.size(), 2u);
  const auto& base = results.responses[0].acceleration;
  EXPECT_LT((base - results.responses[1].acceleration).norm(), 1e-6 * base.norm());
}

// The same by rotational symmetry, on the full mesh and with superelements.
TEST(MovedEnds, are_the_same_on_every_route) {
  Case data = verification_case("bellows_a", {.around = 24, .arc = 3, .wall = 3});
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  data.sensors = {{.name = "mid", .at = {0.035, 0.03, 0}, .reach = 0.1}};
  data.analyses.modes = Modes{.count = 12};
  data.analyses.damping.modal = 0.02;
  Motion shaken = motion_of("right", 0);
  shaken.with = {end_of(motion_of("left", 4, 3, 0.5))};
  data.analyses.response =
      Response{.bases = {}, .motions = {shaken}, .band = {10, 800}, .points = 50};
  data.analyses.symmetry = Symmetry::required;
  const Results symmetric = run_silently(data);
  data.analyses.symmetry = Symmetry::off;
  const Results full = run_silently(data);
  const auto& wanted = full.responses.at(0).acceleration;
  ASSERT_EQ(symmetric.responses.at(0).acceleration.rows(), wanted.rows());
  EXPECT_LT((symmetric.responses[0].acceleration - wanted).norm(), 1e-5 * wanted.norm());
}

// A square plate of 1 m and 5 mm in x and y, simply supported; a weight at a place of it.
constexpr double plate_side = 1, plate_wall = 5e-3, set_down = 20;
constexpr std::array<double, 2> load_at{0.37, 0.29};

Case loaded_plate(int elements) {
  Plate plate{.material = "steel",
              .corners = {Triple{0, 0, 0},
                          {plate_side, 0, 0},
                          {plate_side, plate_side, 0},
                          {0, plate_side, 0}},
              .thickness = plate_wall,
              .elements = {elements, elements}};
  plate.places = {{"spot", {load_at[0], load_at[1], 0}}};
  Case data;
  data.name = "plate";
  data.materials["steel"] = {.E = 2e11, .nu = 0.3, .rho = 8000};
  data.parts = {{"plate", plate}, {"weight", PointMass{.at = "plate.spot", .mass = set_down}}};
  for (const char* edge : {"plate.edge1", "plate.edge3"}) // along x
    data.supports.push_back({.set = edge, .dofs = {0, 1, 2, 4}});
  for (const char* edge : {"plate.edge2", "plate.edge4"})
    data.supports.push_back({.set = edge, .dofs = {0, 1, 2, 3}});
  data.analyses.modes = Modes{.count = 4};
  data.analyses.statics = false;
  data.analyses.error_bars = false;
  return data;
}

// Kirchhoff's plate with a point mass m at (x, y), w = sum of sin sin: 1 = m w^2 sum f_ij^2 / (M
// (w_ij^2 - w^2)), M a quarter of the plate (Amba-Rao, J. Appl. Mech. 31, 1964). The first root
// above 0 and those between neighbouring w_ij, Hz.
std::vector<double> loaded_plate_frequencies(int count) {
  const double D = 2e11 * std::pow(plate_wall, 3) / (12 * (1 - 0.09)), per_area = 8000 * plate_wall;
  std::vector<std::pair<double, double>> modes; // w^2 and f^2
  for (int i = 1; i <= 200; ++i)
    for (int j = 1; j <= 200; ++j)
      modes.emplace_back(
          std::pow(pi / plate_side, 4) * D / per_area * std::pow(i * i + j * j, 2),
          std::pow(std::sin(i * pi * load_at[0]) * std::sin(j * pi * load_at[1]), 2));
  std::sort(modes.begin(), modes.end());
  const auto excess = [&](double w2) {
    double sum = 0;
    for (const auto& [own, f2] : modes)
      sum += f2 / (per_area * plate_side * plate_side / 4 * (own - w2));
    return set_down * w2 * sum - 1;
  };
  std::vector<double> found;
  double below = 0;
  for (std::size_t k = 0; int(found.size()) < count; ++k) {
    const double above = modes[k].first;
    if (above < below * (1 + 1e-9)) { // a pair: one of it keeps a node line through the weight
      found.push_back(std::sqrt(above) / (2 * pi));
      continue;
    }
    double low = below * (1 + 1e-12), high = above * (1 - 1e-12);
    for (int i = 0; i < 200; ++i) {
      const double middle = (low + high) / 2;
      (excess(middle) > 0 ? high : low) = middle;
    }
    found.push_back(std::sqrt(low) / (2 * pi));
    below = above;
  }
  return found;
}

// Whatever the mesh, the weight sits where it is said: the frequencies tend to the closed form with
// the square of the element size.
TEST(WallPlaces, a_weight_on_a_plate_tends_to_the_closed_form) {
  const std::vector<double> wanted = loaded_plate_frequencies(4);
  std::vector<std::array<double, 4>> errors;
  for (const int elements : {10, 20, 40}) {
    const Results r = run_silently(loaded_plate(elements));
    std::array<double, 4> own{};
    for (std::size_t j = 0; j < 4; ++j) own[j] = r.modes[j].frequency / wanted[j] - 1;
    errors.push_back(own);
    EXPECT_TRUE(r.verification.passed) << r.verification.reason;
  }
  for (std::size_t j = 0; j < 4; ++j) {
    EXPECT_LT(std::abs(errors[2][j]), 5e-3) << j;
    EXPECT_LT(std::abs(errors[2][j]), 0.4 * std::abs(errors[1][j]) + 2e-4) << j;
    EXPECT_LT(std::abs(errors[1][j]), 0.4 * std::abs(errors[0][j]) + 2e-4) << j;
  }
  print_for_table("Plate with a weight, first mode", wanted[0] * (1 + errors[2][0]), wanted[0],
                  5e-3);
}

// Where the mesh has a node, the place is that node.
TEST(WallPlaces, at_a_node_are_the_node) {
  Case place = loaded_plate(10);
  std::get<Plate>(place.parts[0].body).places = {{"spot", {1, 1, 0}}};
  place.supports = {{.set = "plate.edge1", .dofs = {0, 1, 2, 3, 4, 5}}};
  Case node = place;
  node.parts[1].body = PointMass{.at = "plate.corner3", .mass = set_down};
  const Results one = run_silently(place), other = run_silently(node);
  for (std::size_t j = 0; j < 4; ++j)
    EXPECT_NEAR(one.modes[j].frequency / other.modes[j].frequency, 1, 1e-9);
}

// A motion of the whole as a rigid body is followed exactly, whichever node leads: on warped quads,
// on triangles, with an arm, two places in one element.
TEST(WallPlaces, follow_rigid_motions_exactly) {
  Case data = loaded_plate(3);
  auto& plate = std::get<Plate>(data.parts[0].body);
  plate.corners = {Triple{0, 0, 0}, {1, 0.1, 0.2}, {1.1, 0.9, -0.1}, {-0.1, 1, 0.15}};
  const auto above = [&](double r, double t) { // 3 mm above the warped middle
    const auto& [p, q, v, w] = plate.corners;
    Triple x{};
    for (std::size_t i = 0; i < 3; ++i)
      x[i] = (1 - r) * (1 - t) * p[i] + r * (1 - t) * q[i] + r * t * v[i] + (1 - r) * t * w[i];
    x[2] += 3e-3;
    return x;
  };
  plate.places = {{"spot", above(0.38, 0.36)}, // three in one element
                  {"other", above(0.44, 0.41)},
                  {"third", above(0.6, 0.6)},
                  {"edge", above(1, 0.4)}};
  data.supports.clear();
  const BuiltCase built = build(data);
  const Model& model = built.model;
  Eigen::VectorXd u(6 * Eigen::Index(model.mesh.nodes.size()));
  const Eigen::Vector3d shift(0.3, -0.2, 0.5), turn(0.1, 0.7, -0.4);
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    u.segment<3>(6 * Eigen::Index(n)) = shift + turn.cross(model.mesh.nodes[n]);
    u.segment<3>(6 * Eigen::Index(n) + 3) = turn;
  }
  EXPECT_EQ(model.constraints.size(), 24u);
  for (const Constraint& row : model.constraints) {
    double sum = 0;
    for (const ConstraintTerm& t : row.terms) sum += t.factor * u[6 * t.node + t.dof];
    EXPECT_NEAR(sum, u[6 * row.node + row.dof], 1e-12) << row.origin;
  }
  const DofMap map = eliminate(model);
  EXPECT_EQ(map.size(), 6 * int(model.mesh.nodes.size()) - 24);
}

TEST(WallPlaces, on_triangles_and_beyond_their_edges) {
  Model model;
  model.mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  ShellTriangle t;
  t.nodes = {0, 1, 2};
  t.directors.colwise() = Eigen::Vector3d::UnitZ();
  t.thickness.setConstant(0.002);
  model.mesh.triangles = {t};
  model.shells.resize(1);
  const WallPoint inside = nearest_on_wall(model, {0.2, 0.3, 0.004});
  EXPECT_LT((inside.at - Eigen::Vector3d(0.2, 0.3, 0)).norm(), 1e-14);
  EXPECT_NEAR(off_wall(inside), 0.003, 1e-14);
  const WallPoint beyond = nearest_on_wall(model, {1, 1, 0});
  EXPECT_LT((beyond.at - Eigen::Vector3d(0.5, 0.5, 0)).norm(), 1e-14);
  const WallPoint corner = nearest_on_wall(model, {2, -1, 0});
  EXPECT_LT((corner.at - Eigen::Vector3d(1, 0, 0)).norm(), 1e-14);
  EXPECT_TRUE(nearest_on_wall(model, {0, 0, 0}, 3).nodes.empty()) << "of another component";
}

// Mass, centre and inertia of plate and weight together, exactly.
TEST(WallPlaces, have_the_mass_of_a_rigid_body) {
  Case data = loaded_plate(7);
  data.supports.clear();
  data.parts[1].body = PointMass{.at = "plate.spot",
                                 .offset = {0, 0, 0.1},
                                 .mass = set_down,
                                 .inertia = {0.1, 0.2, 0.3, 0, 0, 0}};
  const Results r = run_silently(data);
  constexpr double plate = 8000 * plate_wall * plate_side * plate_side, all = plate + set_down;
  const Eigen::Vector3d own(0.5, 0.5, 0), hung(load_at[0], load_at[1], 0.1);
  const Eigen::Vector3d centre = (plate * own + set_down * hung) / all;
  const auto about = [&](const Eigen::Vector3d& x, int axis) {
    return (x - centre).squaredNorm() - std::pow((x - centre)[axis], 2);
  };
  const double flat = plate * (plate_side * plate_side + plate_wall * plate_wall) / 12;
  const std::array inertia{flat, flat, 2 * plate * plate_side * plate_side / 12};
  const std::array hanging{0.1, 0.2, 0.3};
  for (std::size_t j = 0; j < 3; ++j) {
    EXPECT_NEAR(r.free_mass[j], all, 1e-9);
    EXPECT_NEAR(r.free_mass[3 + j],
                inertia[j] + hanging[j] + plate * about(own, int(j)) +
                    set_down * about(hung, int(j)),
                1e-8);
  }
}

// On the crown of a bellows the angle makes no difference: at a node, between two, between rings.
TEST(WallPlaces, on_a_bellows_do_not_know_where_the_nodes_are) {
  Case data = verification_case("bellows_a", {.around = 24, .arc = 3, .wall = 3});
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  data.analyses.modes = Modes{.count = 4};
  data.analyses.statics = false;
  data.analyses.error_bars = false;
  const Mesh mesh = build(data).model.mesh;
  const Eigen::Vector3d at = mesh.nodes[std::size_t(mesh.sets.at("bellows.crown[2]").front())];
  const double radius = std::hypot(at.x(), at.z());
  std::vector<std::vector<double>> found;
  for (const double step : {0., 0.25, 0.5}) {
    const double angle = std::atan2(at.z(), at.x()) + step * 2 * pi / 24;
    Case placed = data;
    bellows_of(placed).places = {
        {"knob", {radius * std::cos(angle), at.y(), radius * std::sin(angle)}}};
    placed.parts.push_back({"knob", PointMass{.at = "bellows.knob", .mass = 0.05}});
    const Results r = run_silently(placed);
    EXPECT_TRUE(r.verification.passed) << r.verification.reason;
    found.emplace_back();
    for (const ModeResult& m : r.modes) found.back().push_back(m.frequency);
  }
  const Results bare = run_silently(data);
  EXPECT_LT(found[0][0], 0.99 * bare.modes[0].frequency);
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t k : {1u, 2u}) EXPECT_NEAR(found[k][j] / found[0][j], 1, 0.01) << j;
}

std::string wall_complaint(const Case& data) {
  try {
    run_silently(data);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

// Rigid mounts, hangers with damping and ends that move, in the middle of an element; with all of
// the plate held in its plane the place follows the plate.
TEST(WallPlaces, may_be_held_hung_and_moved) {
  Case data = loaded_plate(6);
  data.supports.clear();
  auto& plate = std::get<Plate>(data.parts[0].body);
  plate.places.push_back({"bolt", {0.61, 0.72, 0}});
  plate.places.push_back({"bracket", {0.2, 0.8, 0}});
  data.caps = {{.name = "bolt", .of = {"plate.bolt"}}, {.name = "hanger", .of = {"plate.bracket"}}};
  SpringDamping rubber;
  rubber.loss_factor = 0.1;
  data.mount = {{.cap = "bolt"},
                {.cap = "hanger",
                 .kind = MountKind::springs,
                 .stiffness = {1e3, 1e3, 1e4, 0, 0, 0},
                 .damping = rubber}};
  data.sensors = {{.name = "between", .at = {0.55, 0.43, 0}}};
  data.analyses.damping.modal = 0.01;
  data.analyses.response =
      Response{.bases = {2}, .motions = {motion_of("bolt", 2)}, .band = {0.01, 10}, .points = 30};
  const Results r = run_silently(data);
  EXPECT_TRUE(r.verification.passed) << r.verification.reason;
  EXPECT_LT(r.sensors.at(0).distance, 1e-12) << "a sensor sits between the nodes, too";
  EXPECT_NEAR(std::abs(r.responses.at(0).acceleration(0, 2)), 1, 1e-3) << "slowly all moves as one";

  Case held = loaded_plate(6);
  held.supports.push_back({.set = "plate.all", .dofs = {0, 1, 5}});
  const double other = run_silently(loaded_plate(6)).modes[0].frequency;
  EXPECT_NEAR(run_silently(held).modes[0].frequency / other, 1, 1e-6);
  held.caps = {{.name = "bolt", .of = {"plate.spot"}}};
  held.mount = {{.cap = "bolt"}};
  EXPECT_NE(wall_complaint(held).find("places.spot: is held, on a wall whose motion"),
            std::string::npos)
      << wall_complaint(held);
}

TEST(WallPlaces, off_the_wall_are_refused_with_the_nearest_point) {
  Case data = loaded_plate(6);
  std::get<Plate>(data.parts[0].body).places = {{"spot", {0.37, 0.29, 0.02}}};
  const std::string said = wall_complaint(data);
  EXPECT_NE(said.find("parts.plate.places.spot.at: is 17.50 mm off the wall"), std::string::npos)
      << said;
  EXPECT_NE(said.find("[370.00 mm, 290.00 mm, 0.00 mm]"), std::string::npos) << said;
}

// Decks hold the place by equations: read back they have the same modes.
TEST(WallPlaces, go_through_decks) {
  const Case data = loaded_plate(6);
  const TemporaryFolder folder("wall_places");
  write_whole(folder.path / "plate.bdf", nastran_model(data, build(data)));
  write_whole(
      folder.path / "deck.yaml",
      "case: deck\nparts: {plate: {type: deck, file: plate.bdf, length_unit: 1 m, mass_unit: 1 "
      "kg}}\nanalyses: {static: false, modes: {count: 4}, error_bars: false}\n");
  const Results own = run_silently(data);
  const Results read = run_silently(read_case((folder.path / "deck.yaml").string()).data);
  for (std::size_t j = 0; j < 4; ++j)
    EXPECT_NEAR(read.modes[j].frequency / own.modes[j].frequency, 1, 1e-3) << j;
  EXPECT_NEAR(read.model.mass, own.model.mass, 1e-6);
}

} // namespace
} // namespace plica::test
