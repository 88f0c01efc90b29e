// Universal files against snippets of the published formats, and written and read again.
#include "tests/support/temporary_folder.hpp"
#include "tests/universal_samples.hpp"

#include <cmath>
#include <cstring>
#include <fstream>

namespace plica::test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(UniversalFunction, has_every_field_of_its_records) {
  const auto f =
      only<UniversalFunction>(function_header(5, 2, 1) +
                              "  1.00000E+00 -2.00000E+00  3.00000E+00  4.00000E+00\n" + closing);
  EXPECT_EQ(f.line, 1);
  EXPECT_EQ(f.ids[0], "Drive point");
  EXPECT_EQ(f.ids[2], "16-Apr-21 10:11:12");
  EXPECT_EQ(f.type, FunctionType::frequency_response);
  EXPECT_EQ(f.id, 7);
  EXPECT_EQ(f.version, 1);
  EXPECT_EQ(f.response.entity, "FLANGE A");
  EXPECT_EQ(f.response.node, 12);
  EXPECT_EQ(f.response.direction, 3);
  EXPECT_EQ(f.reference.entity, "NONE");
  EXPECT_EQ(f.reference.node, 5);
  EXPECT_EQ(f.reference.direction, -2);
  EXPECT_EQ(f.data_type, UniversalDataType::complex_single);
  EXPECT_TRUE(same(abscissa(f), VectorXd(Eigen::Vector2d(0.5, 0.75))));
  EXPECT_EQ(f.abscissa_axis.data_type, 18);
  EXPECT_EQ(f.abscissa_axis.unit, "Hz");
  EXPECT_EQ(f.numerator.length, 1);
  EXPECT_EQ(f.denominator.label, "Excitation force");
  EXPECT_EQ(f.denominator.force, 1);
  EXPECT_EQ(f.z_axis.label, "NONE");
  EXPECT_TRUE(same(f.real, VectorXd(Eigen::Vector2d(1, 3))));
  EXPECT_TRUE(same(f.imaginary, VectorXd(Eigen::Vector2d(-2, 4))));
  EXPECT_TRUE(f.warnings.empty());
}

// The eight cases of record 12, each with its own columns.
TEST(UniversalFunction, is_read_in_all_eight_forms_of_its_data) {
  const std::string narrow = "  1.00000E+00  2.00000E+00  3.00000E+00  4.00000E+00",
                    x = "  1.00000E+00", wide1 = "  1.000000000000E+00",
                    wide2 = "  2.000000000000E+00", wide3 = "  3.000000000000E+00",
                    wide4 = "  4.000000000000E+00";
  struct Example {
    int type, even, points;
    std::string data;
  };
  const std::vector<Example> examples{{2, 1, 4, narrow + "\n"},
                                      {2, 0, 2, narrow + "\n"},
                                      {5, 1, 2, narrow + "\n"},
                                      {5, 0, 1, "  1.00000E+00  2.00000E+00  3.00000E+00\n"},
                                      {4, 1, 4, wide1 + wide2 + wide3 + wide4 + "\n"},
                                      {4, 0, 2, x + wide2 + "  3.00000E+00" + wide4 + "\n"},
                                      {6, 1, 2, wide1 + wide2 + wide3 + wide4 + "\n"},
                                      {6, 0, 1, x + wide2 + wide3 + "\n"}};
  for (const Example& e : examples) {
    const std::string text = function_header(e.type, e.points, e.even) + e.data + closing;
    const auto f = only<UniversalFunction>(text);
    SCOPED_TRACE(text);
    ASSERT_EQ(f.real.size(), e.points);
    EXPECT_EQ(f.real[0], e.even ? 1 : 2);
    EXPECT_EQ(f.abscissa.size(), e.even ? 0 : e.points);
    EXPECT_EQ(f.imaginary.size(), e.type > 4 ? e.points : 0);
    if (e.type > 4) {
      EXPECT_EQ(f.imaginary[0], e.even ? 2 : 3);
    }
    EXPECT_EQ(universal_text(f), text) << "written as the standard has it";
  }
}

UniversalFunction wave(UniversalDataType type, bool even) {
  UniversalFunction f;
  f.data_type = type;
  f.even = even;
  constexpr Eigen::Index n = 100;
  const auto k = VectorXd::LinSpaced(n, 1, 7).array();
  f.real =
      is_double(type) ? VectorXd(k.sin() * 1e-3) : VectorXd(k.sin().cast<float>().cast<double>());
  if (is_complex(type)) f.imaginary = -f.real.reverse();
  if (!even) f.abscissa = k.cast<float>().cast<double>();
  return f;
}

TEST(UniversalFunction, in_binary_form_is_read_again_bit_for_bit) {
  for (int type : {2, 4, 5, 6})
    for (bool even : {true, false})
      for (UniversalByteOrder order :
           {UniversalByteOrder::little_endian, UniversalByteOrder::big_endian})
        for (int width : {4, 8}) {
          UniversalFunction f = wave(UniversalDataType(type), even);
          f.binary = UniversalBinaryForm{order, UniversalFloatFormat::ieee, width};
          const auto g = std::get<UniversalFunction>(again(f));
          ASSERT_TRUE(g.binary.has_value());
          EXPECT_EQ(g.binary->order, order);
          EXPECT_TRUE(g.warnings.empty());
          EXPECT_EQ(g.binary->abscissa_bytes, even ? 4 : width);
          expect_same(f, g);
        }
}

// Two singles 1.0 and -2.0, big endian, written out by hand.
TEST(UniversalFunction, in_binary_form_follows_its_header) {
  const char data[] = "\x3f\x80\x00\x00\xc0\x00\x00\x00";
  const std::string header = function_header(
      2, 2, 1, "    58b     2     2          11           8     0     0           0           0");
  const auto f = only<UniversalFunction>(header + std::string(data, 8) + closing);
  EXPECT_TRUE(same(f.real, VectorXd(Eigen::Vector2d(1, -2))));
  EXPECT_EQ(universal_text(f), header + std::string(data, 8) + closing);
}

TEST(UniversalFunction, in_text_form_is_read_again_to_the_digits_of_the_format) {
  for (int type : {2, 4, 5, 6})
    for (bool even : {true, false}) {
      const UniversalFunction f = wave(UniversalDataType(type), even);
      const auto g = std::get<UniversalFunction>(again(f));
      const double digits = is_double(f.data_type) ? 5e-13 : 5e-6;
      EXPECT_LT(((g.real - f.real).array() / f.real.array()).abs().maxCoeff(), digits);
      expect_same(g, again(g));
    }
}

TEST(UniversalShape, of_a_normal_mode_has_its_parameters) {
  const auto s = std::get<UniversalShape>(sets_of(one_of_each()).at(6));
  const auto mode = normal_mode(s);
  ASSERT_TRUE(mode.has_value());
  EXPECT_EQ(mode->load_case, 1);
  EXPECT_EQ(mode->mode, 3);
  EXPECT_EQ(mode->frequency, 125);
  EXPECT_EQ(mode->viscous_damping, 0.01);
  EXPECT_EQ(s.nodes, (std::vector<int>{1, 2}));
  EXPECT_EQ(s.real(0, 2), -3);
  EXPECT_FALSE(complex_mode(s).has_value());
}

// With six values the translations and rotations of a node take two lines, as complex values do.
TEST(UniversalShape, is_read_again_for_every_number_of_values) {
  for (int per_node : {1, 2, 3, 6, 9})
    for (int type : {2, 4, 5, 6}) {
      UniversalShape s;
      s.data_type = UniversalDataType(type);
      s.nodes = {3, 1, 1234567890};
      s.decimals = is_double(s.data_type) ? 12 : 5;
      s.real = MatrixXd::Constant(3, per_node, 0.25) + MatrixXd::Identity(3, per_node);
      if (is_complex(s.data_type)) s.imaginary = -2 * s.real;
      describe(s, UniversalComplexMode{1, 2, {-3, 400}, {1, 2}, {5, 6}});
      const auto t = std::get<UniversalShape>(again(s));
      expect_same(s, t);
      EXPECT_EQ(complex_mode(t)->eigenvalue, std::complex<double>(-3, 400));
      EXPECT_EQ(complex_mode(t)->modal_b, std::complex<double>(5, 6));
    }
}

TEST(UniversalShape, of_a_frequency_response_has_its_frequency) {
  UniversalShape s;
  s.nodes = {1};
  s.real = MatrixXd::Ones(1, 3);
  describe(s, UniversalFrequencyStep{2, 9, 37.5});
  const auto step = frequency_step(std::get<UniversalShape>(again(s)));
  ASSERT_TRUE(step.has_value());
  EXPECT_EQ(step->step, 9);
  EXPECT_EQ(step->frequency, 37.5);
}

TEST(UniversalShape, may_leave_out_records_of_zeros) {
  const auto s =
      only<UniversalShape>("    -1\n    55\nA\nB\nC\nD\nE\n"
                           "         1         1         2         8         2         3\n"
                           "         1         1         4\n"
                           "  0.00000E+00\n"
                           "         5\n"
                           "         6\n"
                           "  1.00000E+00  2.00000E+00  3.00000E+00\n"
                           "         7\n    -1\n");
  EXPECT_EQ(s.nodes, (std::vector<int>{5, 6, 7}));
  EXPECT_EQ(s.real.row(0).norm(), 0);
  EXPECT_EQ(s.real(1, 2), 3);
  EXPECT_EQ(s.real.row(2).norm(), 0);
}

TEST(UniversalGeometry, has_nodes_elements_lines_and_units) {
  const auto sets = sets_of(one_of_each());
  ASSERT_EQ(sets.size(), 8u);
  EXPECT_EQ(std::get<UniversalText>(sets[0]).number, 151);
  EXPECT_EQ(std::get<UniversalText>(sets[0]).text, "   151\nmodel\nNONE\nprogram\n");
  const auto& units = std::get<UniversalUnits>(sets[1]);
  EXPECT_EQ(units.code, 1);
  EXPECT_EQ(units.description, "SI: Meter (newton)");
  EXPECT_EQ(units.temperature_mode, 2);
  EXPECT_EQ(units.temperature_offset, 273.15);
  const auto& fine = std::get<UniversalNodes>(sets[2]);
  ASSERT_EQ(fine.nodes.size(), 2u);
  EXPECT_EQ(fine.nodes[0].position, Eigen::Vector3d(0.5, -2.5, 3));
  const auto& coarse = std::get<UniversalNodes>(sets[3]);
  EXPECT_FALSE(coarse.double_precision);
  EXPECT_EQ(coarse.nodes[0].colour, 8);
  EXPECT_EQ(coarse.nodes[0].position, Eigen::Vector3d(1, -2, 0.03));
  const auto& elements = std::get<UniversalElements>(sets[4]).elements;
  ASSERT_EQ(elements.size(), 2u);
  EXPECT_EQ(elements[0].nodes, (std::vector<int>{1, 2, 3, 4}));
  ASSERT_TRUE(elements[1].beam.has_value());
  EXPECT_EQ(elements[1].beam->fore_section, 1);
  EXPECT_EQ(elements[1].nodes, (std::vector<int>{1, 2}));
  EXPECT_EQ(std::get<UniversalTraceline>(sets[5]).nodes,
            (std::vector<int>{1, 2, 3, 0, 4, 5, 6, 7, 8}));
}

TEST(UniversalFile, is_written_as_it_was_read) {
  std::string text;
  for (const UniversalDataset& set : sets_of(one_of_each())) text += universal_text(set);
  EXPECT_EQ(text, one_of_each());
}

TEST(UniversalFile, is_read_from_disk_with_the_lines_of_its_sets) {
  const TemporaryFolder folder("universal");
  const auto path = folder.path / "all.uff";
  {
    std::ofstream out(path, std::ios::binary);
    for (const UniversalDataset& set : sets_of(one_of_each())) write_universal(out, set);
  }
  const auto sets = read_universal(path);
  ASSERT_EQ(sets.size(), 8u);
  EXPECT_EQ(std::get<UniversalUnits>(sets[1]).line, 7);
  EXPECT_EQ(std::get<UniversalNodes>(sets[2]).line, 13);
}

// Larger than the buffer, with binary data in the middle that hold line ends and "    -1\n".
TEST(UniversalFile, of_mixed_forms_crosses_the_buffer) {
  UniversalFunction large = wave(UniversalDataType::real_double, true);
  large.real = VectorXd::LinSpaced(50000, -1, 1);
  UniversalFunction tricky = large;
  tricky.binary = UniversalBinaryForm{};
  for (Eigen::Index k = 0; k + 1 < tricky.real.size(); k += 1000)
    std::memcpy(&tricky.real[k], "\n    -1\n", 8);
  const std::string text = universal_text(large) + universal_text(tricky) + universal_text(large);
  const auto sets = sets_of(text);
  ASSERT_EQ(sets.size(), 3u);
  EXPECT_TRUE(same(std::get<UniversalFunction>(sets[1]).real, tricky.real));
  expect_same(sets[0], sets[2]);
}

TEST(UniversalWriter, refuses_what_would_not_read_again) {
  const auto refused = [](const UniversalDataset& set) {
    EXPECT_THROW((void)universal_text(set), InputError);
  };
  UniversalFunction f = wave(UniversalDataType::complex_double, false);
  UniversalFunction g = f;
  g.real[3] = std::nan("");
  refused(g);
  g.binary = UniversalBinaryForm{};
  refused(g);
  g = f;
  g.imaginary.resize(1);
  refused(g);
  g = f;
  g.response.entity = "longer than ten";
  refused(g);
  g = f;
  g.ids[1] = "two\nlines";
  refused(g);
  g = wave(UniversalDataType::real_single, true);
  g.real[0] = 1e300;
  g.binary = UniversalBinaryForm{};
  refused(g);
  UniversalShape s;
  s.nodes = {1, 2};
  s.real = MatrixXd::Ones(1, 3);
  refused(s);
}

} // namespace
} // namespace plica::test
