// Modes of universal files as test data.
#include "compare/correlate.hpp"
#include "compare/sensors_by_place.hpp"
#include "io/files/files.hpp"
#include "io/input/measured_file.hpp"
#include "io/lab_files/universal_modes.hpp"
#include "io/universal/writer.hpp"
#include "tests/support/temporary_folder.hpp"
#include "words/input_error.hpp"

#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace plica::test {
namespace {

using std::numbers::pi;

UniversalNodes places(int system = 0) {
  UniversalNodes n;
  for (int k = 1; k <= 3; ++k)
    n.nodes.push_back({.label = k, .displacement_system = system, .position = {0, 100. * k, 0}});
  return n;
}

UniversalUnits millimetres() {
  UniversalUnits u;
  u.code = 5;
  u.length = 1000;
  u.force = 1000;
  return u;
}

UniversalShape along(int axis, double hertz, int mode) {
  UniversalShape s;
  s.ids[0] = "mode " + std::to_string(mode);
  describe(s, UniversalNormalMode{1, mode, hertz, 1, 0.01, 0});
  s.nodes = {1, 2, 3};
  s.real = Eigen::MatrixXd::Zero(3, 3);
  s.real.col(axis) << 1, 2, 1;
  return s;
}

std::string file_of(std::initializer_list<UniversalDataset> sets) {
  std::string text;
  for (const UniversalDataset& set : sets) text += universal_text(set);
  return text;
}

Measured read(const TemporaryFolder& folder, const std::string& text) {
  write_whole(folder.path / "modes.unv", text);
  return modes_of_universal(folder.path / "modes.unv");
}

TEST(UniversalModes, have_their_vectors_and_places) {
  const TemporaryFolder folder("exchange");
  const Measured m = read(folder, file_of({millimetres(), places(), along(0, 200, 2),
                                           along(1, 100, 1), along(1, 300, 3)}));
  ASSERT_EQ(m.modes.size(), 3);
  EXPECT_EQ(m.modes[0].frequency, 100); // from the lowest
  EXPECT_EQ(*m.modes[0].damping, 0.01);
  EXPECT_EQ(m.modes[0].shape, MeasuredShape::axial);
  EXPECT_EQ(m.modes[1].shape, MeasuredShape::transverse);
  EXPECT_EQ(*m.modes[1].direction, Axis::x);
  EXPECT_EQ(m.modes[2].order, 2);
  ASSERT_EQ(m.sensors.size(), 3);
  EXPECT_DOUBLE_EQ(m.sensors[1].at[1], 0.2);
  EXPECT_EQ(m.modes[0].vector->channels[4], "node2.y");
  EXPECT_EQ(m.modes[0].vector->real[4], 2);
  // As measured data, too.
  EXPECT_EQ(read_measured_file((folder.path / "modes.unv").string()).data.modes.size(), 3);
}

TEST(UniversalModes, of_complex_eigenvalues_have_their_damping) {
  const TemporaryFolder folder("exchange");
  UniversalShape s = along(2, 1, 1);
  const std::complex<double> eigenvalue(-5, 600);
  describe(s, UniversalComplexMode{1, 1, eigenvalue, 1, 1});
  s.data_type = UniversalDataType::complex_single;
  s.imaginary = 0.1 * s.real;
  const Measured m = read(folder, file_of({places(), s}));
  EXPECT_NEAR(m.modes.at(0).frequency, std::abs(eigenvalue) / (2 * pi), 1e-4);
  EXPECT_NEAR(*m.modes[0].damping, 5 / std::abs(eigenvalue), 1e-7);
  EXPECT_NEAR(m.modes[0].vector->imaginary[2], 0.1, 1e-6);
  EXPECT_FALSE(m.caveats.empty()); // no units: places in m
}

// Data set 2414 as Ideas and others write it, with displacements along axes of 2420 whose x is y of
// the part.
TEST(UniversalModes, of_results_at_nodes_turn_with_their_axes) {
  const TemporaryFolder folder("exchange");
  const std::string axes = "    -1\n  2420\n         1\npart\n         7         0         8\nCS\n"
                           "  0.0D+00  1.0D+00  0.0D+00\n -1.0D+00  0.0D+00  0.0D+00\n"
                           "  0.0D+00  0.0D+00  1.0D+00\n  0.0D+00  0.0D+00  0.0D+00\n    -1\n";
  std::string results =
      "    -1\n  2414\n         1\nMode shape 1\n         1\nA\nB\nC\nD\nE\n"
      "         1         2         2         8         2         3\n"
      "         0         0         1         0         0         1         0         0\n"
      "         0         0\n"
      "  0.00000E+00  8.80000E+01  0.00000E+00  1.00000E+00  2.00000E-02  0.00000E+00\n"
      "  0.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00\n";
  for (int k = 1; k <= 3; ++k)
    results += "         " + std::to_string(k) + "\n  1.00000E+00  0.00000E+00  5.00000E-01\n";
  results += "    -1\n";
  const Measured m = read(folder, axes + universal_text(places(7)) + results);
  ASSERT_EQ(m.modes.size(), 1);
  EXPECT_EQ(m.modes[0].frequency, 88);
  EXPECT_EQ(*m.modes[0].damping, 0.02);
  EXPECT_EQ(m.modes[0].vector->real[0], 0);
  EXPECT_EQ(m.modes[0].vector->real[1], 1); // x of the system is y of the part
  EXPECT_EQ(m.modes[0].vector->real[2], 0.5);
  EXPECT_THROW(read(folder, universal_text(places(7)) + results), InputError); // axes not stated
}

// As Code_Aster writes them: the name of the node behind its label, numbers that touch, exponents
// of three digits, the largest double for a mass that is not known; nodes by a data set 781.
TEST(UniversalModes, of_Code_Aster_have_comments_behind_their_nodes) {
  const TemporaryFolder folder("exchange");
  const std::string nodes =
      "    -1\n   781   %NOEUDS REAL*8\n         7         0         0        11\n"
      "  0.0E+00  2.5E-01  0.0E+00\n    -1\n";
  const std::string mode =
      "    -1\n    55   %VALEURS AUX NOEUDS\nA\nDEPL - DX DY DZ DRX DRY DRZ\nC\nD\n"
      "NUMERO D'ORDRE: 1 NUME_MODE: 1 FREQ:  9.31250E+00\n"
      "         1         2         3         8         2         6\n"
      "         2         4         1         1\n"
      "  0.93125D+01  0.17977+309  0.00000D+00  0.00000D+00\n"
      "         7     % NOEUD NO7     \n"
      "-8.67361E-027 3.12866E-002-5.09971E-002-4.54747E-021 4.80940E-001 2.96859E-017\n"
      "         9     % NOEUD NO9     \n"
      " 0.00000E+000 0.00000E+000-1.81060E-001 0.00000E+000 0.00000E+000 0.00000E+000\n    -1\n";
  const Measured m = read(folder, nodes + mode);
  ASSERT_EQ(m.modes.size(), 1);
  EXPECT_EQ(m.modes[0].frequency, 9.3125);
  ASSERT_EQ(m.modes[0].vector->channels.size(), 6);
  EXPECT_EQ(m.modes[0].vector->channels[3], "node9.x");
  EXPECT_EQ(m.modes[0].vector->real[1], 3.12866e-2);
  EXPECT_EQ(m.modes[0].vector->real[5], -0.18106);
  ASSERT_EQ(m.sensors.size(), 1);
  EXPECT_EQ(m.sensors[0].at[1], 0.25);
  std::string far = mode;
  far.replace(far.find("+309"), 4, "+310"); // no rounding makes this
  EXPECT_THROW(read(folder, far), InputError);
}

TEST(UniversalModes, are_called_as_the_sensors_where_they_stand) {
  const TemporaryFolder folder("exchange");
  const Measured test =
      read(folder, file_of({millimetres(), places(), along(0, 100, 1), along(2, 120, 2)}));
  Measured simulated = test;
  for (std::size_t k = 0; k < 3; ++k) {
    simulated.sensors[k].name = "s" + std::to_string(k);
    simulated.sensors[k].axes = {-3, 2, 1}; // its x is -z of the part
  }
  for (MeasuredMode& mode : simulated.modes) {
    mode.vector->channels.clear();
    const std::vector<double> of_part = mode.vector->real;
    for (std::size_t k = 0; k < 3; ++k)
      for (const char axis : {'x', 'y', 'z'})
        mode.vector->channels.push_back("s" + std::to_string(k) + "." + axis);
    for (std::size_t k = 0; k < 3; ++k) {
      mode.vector->real[3 * k] = -of_part[3 * k + 2];
      mode.vector->real[3 * k + 2] = of_part[3 * k];
    }
  }
  const Correlation c = correlate({.data = simulated, .responses = {}},
                                  {.data = named_by_place(test, simulated), .responses = {}});
  ASSERT_EQ(c.pairs.size(), 2);
  for (const PairedMode& p : c.pairs) {
    EXPECT_EQ(p.by, "shape");
    EXPECT_NEAR(*p.mac, 1, 1e-12);
  }
}

TEST(UniversalModes, that_are_none_or_damaged_are_refused) {
  const TemporaryFolder folder("exchange");
  EXPECT_THROW(read(folder, file_of({places()})), InputError);
  UniversalShape twice = along(0, 10, 1);
  twice.nodes = {1, 1, 2};
  EXPECT_THROW(read(folder, file_of({places(), twice})), InputError);
  // Bytes at random: read or refused, never more.
  const std::string whole =
      file_of({millimetres(), places(), along(0, 100, 1)}) +
      "    -1\n  2414\n         1\nM\n         1\nA\nB\nC\nD\nE\n"
      "         1         2         2         8         2         3\n"
      "         0         0         1         0         0         1\n"
      "         0         0\n 0. 8.8E+01 0. 1. 0. 0.\n 0. 0. 0. 0. 0. 0.\n"
      "         1\n 1. 0. .5\n    -1\n"
      "    -1\n    18\n         1         0         0         1         1\nCS\n"
      " 0. 0. 0. 1. 0. 0.\n 0. 0. 1.\n    -1\n";
  EXPECT_EQ(read(folder, whole).modes.size(), 2);
  std::mt19937 random(5);
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string text = whole;
    for (int k = 0; k < 3; ++k) text[random() % text.size()] = char(random() % 96 + 32);
    if (i % 3 == 0) text.resize(random() % text.size());
    try {
      for (const MeasuredMode& mode : read(folder, text).modes)
        EXPECT_TRUE(std::isfinite(mode.frequency));
    } catch (const InputError& error) {
      ++refused;
      EXPECT_FALSE(error.problems()[0].file.empty());
    }
  }
  EXPECT_GT(refused, 100);
}

} // namespace
} // namespace plica::test
