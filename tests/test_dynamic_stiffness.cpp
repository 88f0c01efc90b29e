// Dynamic stiffness between two ends: closed forms, reciprocity, static limit, loops of friction,
// states, the exports read back.
#include "tests/sliding_chain.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tube_case.hpp"

#include "io/decks/nastran_cards.hpp"
#include "io/files/files.hpp"
#include "io/lab_files/stiffness_table.hpp"
#include "io/superelements/connector_tables.hpp"
#include "io/tables/stiffness_words.hpp"
#include "run/study/part_stiffness.hpp"
#include "solve/base_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <map>
#include <numbers>
#include <sstream>

namespace plica::test {
namespace {

using std::numbers::pi;

EndDynamicStiffness stiffness_of(const Case& data, const StiffnessRequest& request) {
  return part_stiffness(data, request, [](const std::string&) {});
}

StiffnessRequest at(std::vector<double> hertz) {
  StiffnessRequest r;
  r.hertz = Eigen::Map<Eigen::VectorXd>(hertz.data(), long(hertz.size()));
  return r;
}

// A rod in axial motion: EA k cot(k L), -EA k / sin(k L), k^2 = m w^2 / EA.
TEST(DynamicStiffness, of_a_rod_is_the_closed_form) {
  const double m = 2;
  const Case data = [&] {
    Case d = tube(m);
    std::get<BeamPart>(d.parts[0].body).elements = 200;
    return d;
  }();
  const EndDynamicStiffness s = stiffness_of(data, at({10, 200, 400}));
  const auto& over = s.states.at(0).over;
  ASSERT_EQ(over.hertz.size(), 3);
  for (long f = 0; f < over.hertz.size(); ++f) {
    const double k = 2 * pi * over.hertz[f] * std::sqrt(m / EA);
    const Complex1212& Z = over.at[0][std::size_t(f)];
    EXPECT_NEAR(driving_point_stiffness(Z, 1).real() / (EA * k / std::tan(k * L)), 1, 2e-4) << f;
    EXPECT_NEAR(transfer_stiffness(Z, 1).real() / (EA * k / std::sin(k * L)), 1, 2e-4) << f;
  }
}

// The same from the equations of the whole mesh at that frequency, and by symmetry as on the mesh.
TEST(DynamicStiffness, of_shells_does_not_depend_on_the_route) {
  Case data = verification_case("bellows_a", {.around = 16, .arc = 2, .wall = 2});
  data.analyses.damping.modal = 0.01;
  StiffnessRequest request = at({0, 100, 300});
  data.analyses.symmetry = Symmetry::off;
  const EndDynamicStiffness full = stiffness_of(data, request);
  data.analyses.symmetry = Symmetry::required;
  const EndDynamicStiffness cyclic = stiffness_of(data, request);
  for (std::size_t f = 0; f < 3; ++f) {
    const Complex1212 &a = full.states[0].over.at[0][f], &b = cyclic.states[0].over.at[0][f];
    const Eigen::Matrix<double, 12, 1> size = full.states[0].part.K.diagonal().cwiseSqrt();
    const double off = (a - b).cwiseAbs().cwiseQuotient(size * size.transpose()).maxCoeff();
    EXPECT_LT(off, 1e-5) << f;
  }
}

TEST(DynamicStiffness, is_reciprocal_and_begins_as_the_static_one) {
  Case data = verification_case("bellows_a", {.around = 16, .arc = 2, .wall = 2});
  data.analyses.damping.modal = 0.02;
  data.analyses.damping.loss_factors = {{.of = "bellows", .value = 0.01}};
  const EndDynamicStiffness s = stiffness_of(data, at({0, 50, 500}));
  const StateStiffness& state = s.states.at(0);
  const Eigen::Matrix<double, 12, 1> size = state.part.K.diagonal().cwiseSqrt();
  const Eigen::Matrix<double, 12, 12> scale = size * size.transpose();
  double reciprocity = 0;
  for (const Complex1212& Z : state.over.at[0])
    reciprocity =
        std::max(reciprocity, (Z - Z.transpose()).cwiseAbs().cwiseQuotient(scale).maxCoeff());
  EXPECT_LT(reciprocity, 1e-10);
  const Results r = run_silently(without_modes(data));
  const double at_rest = (state.over.at[0][0].real() - r.statics->end_stiffness)
                             .cwiseAbs()
                             .cwiseQuotient(scale)
                             .maxCoeff();
  EXPECT_LT(at_rest, 1e-9);
  std::printf("  reciprocity within %.1e, 0 Hz beside the static condensation %.1e\n", reciprocity,
              at_rest);
  // K (1 + i eta) at rest.
  EXPECT_NEAR(state.over.at[0][0](1, 1).imag() / state.part.K(1, 1), 0.01, 1e-9);
}

// Slowly, both elements share the motion X: a slider goes X / 2 and takes 4 F (X / 2 - x_s) a
// cycle, x_s = F / k_t; pi k'' X^2 is the area of the loop.
TEST(DynamicStiffness, of_friction_has_the_area_of_its_loop) {
  StiffnessRequest request = at({0.01});
  request.samples = 4096;
  for (const double X : {2e-4, 1e-3, 5e-3}) request.levels.push_back({.translation = X});
  const EndDynamicStiffness s = stiffness_of(sliding_chain(), request);
  EXPECT_TRUE(s.friction);
  const StiffnessOverFrequency& over = s.states.at(0).over;
  EXPECT_EQ(over.not_found, 0);
  const double slip = 3 / 6e4;       // x_s
  ASSERT_EQ(over.levels.size(), 4U); // small motion first
  for (std::size_t l = 1; l < over.levels.size(); ++l) {
    const double X = over.levels[l].translation;
    const double area = pi * X * X * driving_point_stiffness(over.at[l][0], 1).imag();
    const double expected = 2 * 4 * 3 * (X / 2 - slip);
    EXPECT_NEAR(area / expected, 1, 2e-3) << X;
    print_for_table("loop of two sliders over " + std::to_string(1e3 * X) + " mm, its area, J",
                    area, expected, 2e-3);
  }
  EXPECT_NEAR(transfer_stiffness(over.at[0][0], 1).real() / 4e4, 1, 1e-6); // stuck
  EXPECT_NEAR(transfer_stiffness(over.at[3][0], 1).real() / 1e4, 1, 0.05); // slipping
  EXPECT_NEAR(over.at[0][0](1, 1).imag(), 0, 1e-6);
}

// Two connectors in a row: stuck, half of spring and slider together; far above slip half of the
// spring, as the elastic part of a slider falls with X^-3/2. The mass between makes a percent.
TEST(DynamicStiffness, between_stuck_and_slipping_is_monotonic) {
  StiffnessRequest request = at({5});
  for (double X = 2e-5; X < 2e-2; X *= 2) request.levels.push_back({.translation = X});
  const StiffnessOverFrequency over = stiffness_of(sliding_chain(), request).states.at(0).over;
  ASSERT_EQ(over.levels.size(), request.levels.size() + 1);
  for (std::size_t l = 1; l < over.levels.size(); ++l)
    EXPECT_LE(transfer_stiffness(over.at[l][0], 1).real(),
              transfer_stiffness(over.at[l - 1][0], 1).real() * (1 + 1e-9))
        << l;
  EXPECT_NEAR(transfer_stiffness(over.at[0][0], 1).real() / 4e4, 1, 0.02);
  EXPECT_NEAR(transfer_stiffness(over.at.back()[0], 1).real() / 1e4, 1, 0.03);
}

TEST(DynamicStiffness, refuses_what_it_does_not_know) {
  Case data = sliding_chain();
  StiffnessRequest request = at({10});
  request.ends = {"left", "middle"};
  EXPECT_THROW(stiffness_of(data, request), InputError);
  request.ends = {"left", "left"};
  EXPECT_THROW(stiffness_of(data, request), InputError);
  request.ends.clear();
  data.caps.pop_back();
  EXPECT_THROW(stiffness_of(data, request), InputError);
}

// An offset makes a state of its own: a slack rod pulled out is the stiffer across, k = 6 N / (5
// L).
TEST(DynamicStiffness, has_the_state_as_an_axis) {
  Case data = tube(1);
  std::get<BeamPart>(data.parts[0].body).section.GA = 1e8; // stiff in shear, as the formula is
  StiffnessRequest request = at({0});
  request.shifts = {{}, {.direction = 1, .value = -1e-4}}; // left moved off the right: tension
  const EndDynamicStiffness s = stiffness_of(data, request);
  ASSERT_EQ(s.states.size(), 2);
  const double N = EA * 1e-4 / L;
  const auto across = [&](std::size_t k) {
    return transfer_stiffness(s.states[k].over.at[0][0], 0).real();
  };
  EXPECT_NEAR((across(1) - across(0)) / (6 * N / (5 * L)), 1, 0.01);
}

// Named states beside the case's own, each with every offset: N_hot = N + EA u / L.
TEST(DynamicStiffness, has_the_named_states_as_an_axis) {
  Case data = tube(1);
  std::get<BeamPart>(data.parts[0].body).section.GA = 1e8;
  const auto pulled = [](const std::string& name, double by) {
    return OperatingState{.name = name, .offset = {{.cap = "right", .move = {0, by, 0}}}};
  };
  data.states = {pulled("slack", -5e-5), pulled("pulled", 1e-4)};
  StiffnessRequest request = at({0});
  request.states = {"", "pulled"};
  request.shifts = {{}, {.direction = 1, .value = -5e-5}};
  const EndDynamicStiffness s = stiffness_of(data, request);
  ASSERT_EQ(s.states.size(), 4);
  const std::array<const char*, 4> names{"at rest", "left moved by -0.05 mm in y", "pulled",
                                         "pulled, left moved by -0.05 mm in y"};
  const std::array stretch{0., 5e-5, 1e-4, 1.5e-4};
  const auto across = [&](std::size_t k) {
    return transfer_stiffness(s.states[k].over.at[0][0], 0).real();
  };
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(s.states[k].name, names[k]);
    const double by_tension = 6 * EA * stretch[k] / L / (5 * L);
    EXPECT_NEAR(across(k) - across(0), by_tension, 0.01 * by_tension) << k;
  }
  EXPECT_NEAR(s.states[3].part.places[1][1] - s.states[3].part.places[0][1], L + 1.5e-4, 1e-12);
  request.states = {"pulld"};
  try {
    stiffness_of(data, request);
    ADD_FAILURE() << "a state that is not there";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("pulled"), std::string::npos) << error.what();
  }
  data.states = {pulled("pressed", -0.05)}; // 4 pi^2 EI / (EA L) = 11 mm is where it buckles
  request.states = {"pressed"};
  try {
    stiffness_of(data, request);
    ADD_FAILURE() << "a state that has buckled";
  } catch (const StateError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("pressed: ")) << error.what();
  }
}

// The cards read by columns, on their own: K and B of every direction over frequency.
TEST(DynamicStiffness, stands_in_the_tables_of_other_programs) {
  Case data = tube(2);
  data.analyses.damping.loss_factors = {{.of = "tube", .value = 0.05}};
  const EndDynamicStiffness s = stiffness_of(data, at({0, 50, 100}));
  std::istringstream bush(nastran_bush(s, true));
  std::map<int, std::vector<double>> tables;
  std::vector<int> K, B;
  int table = 0;
  for (std::string line; std::getline(bush, line);) {
    const auto field = [&](std::size_t at, std::size_t width) {
      return line.size() > at ? line.substr(at, width) : std::string();
    };
    if (line.starts_with("PBUSHT")) {
      for (std::size_t k = 0; k < 6; ++k) K.push_back(std::stoi(field(24 + 8 * k, 8)));
      std::getline(bush, line);
      for (std::size_t k = 0; k < 6; ++k) B.push_back(std::stoi(field(24 + 8 * k, 8)));
    } else if (line.starts_with("TABLED1*")) {
      table = std::stoi(field(8, 16));
    } else if (line.starts_with("*") && table > 0) {
      for (std::size_t k = 0; k < 4; ++k) {
        const std::string text = field(8 + 16 * k, 16);
        if (text.find("ENDT") != std::string::npos)
          table = 0;
        else if (text.find_first_not_of(' ') != std::string::npos && table > 0)
          tables[table].push_back(nastran_number(text));
      }
    }
  }
  ASSERT_EQ(K.size(), 6);
  ASSERT_EQ(B.size(), 6);
  const Complex1212& Z = s.states[0].over.at[0][2];
  const auto k = connector_in_middle(Z, s.states[0].part.places[0], s.states[0].part.places[1]);
  const std::vector<double> axial = tables[K[1]], damper = tables[B[1]];
  ASSERT_EQ(axial.size(), 6);
  ASSERT_EQ(damper.size(), 4); // none at 0 Hz
  EXPECT_NEAR(axial[5] / (k(1, 1).real() / 1000), 1, 1e-9);
  EXPECT_NEAR(damper[3] / (k(1, 1).imag() / 1000 / (2 * pi * 100)), 1, 1e-9);
  const std::vector<double> turn = tables[K[3]];
  EXPECT_NEAR(turn[5] / (k(3, 3).real() * 1000), 1, 1e-9); // N mm/rad
  const std::string connector = abaqus_connector(s, false);
  EXPECT_NE(connector.find("*CONNECTOR ELASTICITY, COMPONENT=6"), std::string::npos);
  EXPECT_NE(connector.find("*CONNECTOR DAMPING, COMPONENT=2"), std::string::npos);
}

// In the middle of a prismatic rod nothing couples bending and shear: 12 EI / L^3 with shear there,
// EI / L about it.
TEST(DynamicStiffness, has_its_connector_in_the_middle) {
  const EndDynamicStiffness s = stiffness_of(tube(1), at({0}));
  const StateStiffness& state = s.states[0];
  const auto k =
      connector_in_middle(state.over.at[0][0], state.part.places[0], state.part.places[1]);
  EXPECT_NEAR(k(1, 1).real() / (EA / L), 1, 1e-6);
  EXPECT_NEAR(k(4, 4).real() / (GJ / L), 1, 1e-6);
  EXPECT_NEAR(k(3, 3).real() / (EI / L), 1, 1e-3);
  const double shear = 1 / (L * L * L / (12 * EI) + L / GA);
  EXPECT_NEAR(k(0, 0).real() / shear, 1, 1e-3);
  EXPECT_LT(left_off_diagonal(state), 1e-6);
}

TEST(DynamicStiffness, is_read_from_the_table_of_a_rig) {
  const TemporaryFolder folder("exchange");
  write_whole(folder.path / "rig.csv",
              "frequency [Hz],amplitude [mm],y storage [N/mm],y loss angle [deg],"
              "rx driving point magnitude [Nm/rad]\n10,0.1,50,3,200\n20,0.1,52,4,210\n");
  const std::vector<MeasuredStiffness> list = read_stiffness_table(folder.path / "rig.csv");
  ASSERT_EQ(list.size(), 6);
  EXPECT_DOUBLE_EQ(list[0].value, 5e4);
  EXPECT_DOUBLE_EQ(list[0].amplitude, 1e-4);
  EXPECT_NEAR(list[1].value, 3 * pi / 180, 1e-12);
  EXPECT_EQ(list[2].kind, StiffnessKind::driving_point);
  EXPECT_EQ(list[2].amplitude, 0); // of a length, and this one turns
  for (const char* bad : {"frequency [Hz],q storage [N/mm]\n1,2\n", "frequency [Hz],y stiff\n1,2\n",
                          "y storage [N/mm]\n1\n", "frequency [Hz],y storage [Pa]\n1,2\n",
                          "frequency [Hz],y storage [N/mm]\n-1,2\n"}) {
    write_whole(folder.path / "bad.csv", bad);
    EXPECT_THROW(read_stiffness_table(folder.path / "bad.csv"), InputError) << bad;
  }
}

// What is computed, written as a test, lies on what is computed.
TEST(DynamicStiffness, lies_on_itself) {
  StiffnessRequest request = at({20, 40});
  request.levels = {{.translation = 1e-3}};
  const EndDynamicStiffness s = stiffness_of(sliding_chain(), request);
  std::vector<MeasuredStiffness> measured;
  for (std::size_t f = 0; f < 2; ++f) {
    const auto k = transfer_stiffness(s.states[0].over.at[1][f], 1);
    MeasuredStiffness m{.hertz = s.states[0].over.hertz[long(f)], .amplitude = 1e-3};
    m.value = k.real();
    measured.push_back(m);
    m.quantity = StiffnessQuantity::loss;
    m.value = k.imag();
    measured.push_back(m);
  }
  const std::vector<StiffnessComparison> compared = compare_stiffness(s, measured, 5, 256);
  ASSERT_EQ(compared.size(), 4U);
  for (const StiffnessComparison& c : compared) EXPECT_NEAR(c.computed / c.measured.value, 1, 1e-6);
  const std::vector<ShownDeviation> shown = deviations(compared);
  EXPECT_EQ(shown.size(), 2U); // storage and loss
  for (const ShownDeviation& d : shown) EXPECT_EQ(d.count, 2);
}

} // namespace
} // namespace plica::test
