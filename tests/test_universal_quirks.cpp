// What real universal files do beside the standard.
#include "tests/universal_samples.hpp"

namespace plica::test {
namespace {

TEST(UniversalNumbers, of_every_spelling_are_read) {
  const std::vector<std::pair<std::string, std::vector<double>>> examples{
      {"1.0D+02 -2.5d-1", {100, -0.25}},
      {"1.00000-100 2.50000+100", {1e-100, 2.5e100}},
      {"-1.0E+00-2.0E+00", {-1, -2}},
      {"-1.5-2.5", {-1.5, -2.5}},
      {"1.0e0\t2.0E0", {1, 2}},
      {"1,2", {1, 2}},
      {".5 5.", {0.5, 5}},
      {"+1 -0", {1, 0}},
      {"123456789012345678901234567890 1e22", {1.2345678901234568e29, 1e22}},
      {"1.7976931348623157E+308 4.9E-324", {1.7976931348623157e308, 4.9e-324}},
      {"1E-400 0E+400", {0, 0}},
      {"0.1234567890123456 8.98846567431158e307", {0.1234567890123456, 8.98846567431158e307}}};
  for (const auto& [text, expected] : examples)
    EXPECT_EQ(values(of_data(text + "\n    -1\n", 2)), expected) << text;
}

TEST(UniversalLines, may_end_with_carriage_returns_or_trailing_blanks) {
  const std::string text = one_of_each();
  const auto plain = sets_of(text);
  for (const std::string end : {"\r\n", "          \n", "\t\n", " \r\n"}) {
    const auto sets = sets_of(replaced(text, "\n", end));
    ASSERT_EQ(sets.size(), plain.size());
    for (std::size_t i = 1; i < sets.size(); ++i) expect_same(sets[i], plain[i]);
  }
}

TEST(UniversalLines, of_any_width_hold_the_data) {
  const std::string numbers = "1 2 3 4 5 6 7\n";
  const std::vector<double> expected{1, 2, 3, 4, 5, 6, 7};
  EXPECT_EQ(values(of_data(numbers + closing, 7)), expected);
  EXPECT_EQ(values(of_data(replaced(numbers, " ", "\n") + closing, 7)), expected);
  EXPECT_EQ(values(of_data(replaced(numbers, "4 ", "4\n\n") + closing, 7)), expected);
}

TEST(UniversalDelimiter, need_not_keep_its_columns) {
  for (const std::string mark : {"-1", "  -1", "        -1", "\t-1", "-1   ", "    -1    "}) {
    const auto sets = sets_of(replaced(one_of_each(), "    -1\n", mark + "\n"));
    EXPECT_EQ(sets.size(), 8u) << mark;
  }
}

TEST(UniversalDelimiter, is_not_taken_from_ids_or_data) {
  const auto id = only<UniversalFunction>(
      replaced(function_header(2, 1, 1), "Drive point", "    -1") + "1.0\n" + closing);
  EXPECT_EQ(id.ids[0], "    -1");
  EXPECT_EQ(values(of_data("1.0\n-1\n2.0\n" + closing, 3)), (std::vector<double>{1, -1, 2}));
  EXPECT_EQ(values(of_data("1.0\n    -1\n2.0\n" + closing, 3)), (std::vector<double>{1, -1, 2}));
  EXPECT_EQ(values(of_data("1.0\n-1\n" + closing, 2)), (std::vector<double>{1, -1}));
  EXPECT_EQ(values(of_data("1.0\n-1\n" + closing, 1)), (std::vector<double>{1})) << "doubled";
  EXPECT_EQ(values(of_data(" -1 -1\n" + closing, 2)), (std::vector<double>{-1, -1}));
  const auto shape =
      only<UniversalShape>("    -1\n    55\nA\nB\nC\nD\n    -1\n"
                           "         1         1         1         8         2         1\n"
                           "         1         1         4\n"
                           "  0.00000E+00\n"
                           "         5\n-1\n         6\n-1.0\n    -1\n");
  EXPECT_EQ(shape.ids[4], "    -1");
  EXPECT_EQ(shape.real(0, 0), -1);
  const auto text = only<UniversalText>("    -1\n  2414\n        -1\n  more\n    -1\n");
  EXPECT_EQ(text.text, "  2414\n        -1\n  more\n");
}

TEST(UniversalDelimiter, may_be_missing_before_the_next_set_or_at_the_end) {
  const std::string one = function_header(2, 2, 1) + "  1.00000E+00  2.00000E+00\n";
  const auto sets = sets_of(one + one + closing);
  ASSERT_EQ(sets.size(), 2u) << "the second -1 closes the first data set and opens nothing";
  EXPECT_EQ(std::get<UniversalFunction>(sets[1]).warnings.size(), 1u);
  EXPECT_EQ(values(of_data("  1.00000E+00  2.00000E+00\n", 2)).size(), 2u);
  EXPECT_EQ(values(of_data("  1.00000E+00  2.00000E+00", 2)).size(), 2u);
  EXPECT_EQ(sets_of(one + closing + closing + one + closing + closing).size(), 2u) << "doubled";
}

TEST(UniversalFile, may_hold_text_around_its_sets) {
  const std::string one = function_header(2, 1, 1) + "1.0\n" + closing;
  const auto sets =
      sets_of("exported by a program\n\n" + one + "\n and then\n" + one + "the end\n");
  ASSERT_EQ(sets.size(), 2u);
  EXPECT_EQ(std::get<UniversalFunction>(sets[0]).line, 3);
}

TEST(UniversalCounts, that_are_wrong_keep_all_data_and_warn) {
  const auto fewer = of_data("1 2 3\n" + closing, 10), more = of_data("1 2 3\n4 5\n" + closing, 3);
  ASSERT_EQ(fewer.warnings.size(), 1u);
  EXPECT_EQ(fewer.warnings[0].stated, 10);
  EXPECT_EQ(fewer.warnings[0].found, 3);
  EXPECT_EQ(fewer.warnings[0].line, first_data_line + 1);
  EXPECT_EQ(fewer.real.size(), 3);
  ASSERT_EQ(more.warnings.size(), 1u);
  EXPECT_EQ(more.warnings[0].stated, 3);
  EXPECT_EQ(more.real.size(), 5);
  const auto vast = of_data("1 2 3\n" + closing, 2147483647);
  EXPECT_EQ(vast.real.size(), 3) << "nothing is allocated from the stated count";
}

// Some writers fill the last line with zeros.
TEST(UniversalCounts, leave_out_zeros_that_fill_the_last_line) {
  const auto f = only<UniversalFunction>(function_header(5, 3, 0) +
                                         "5.0 9.9 -1.0 5.1 1.0 0.0\n"
                                         "6.0 8.0 0.0 0.0 0.0 0.0\n" +
                                         closing);
  EXPECT_EQ(f.real.size(), 3);
  EXPECT_EQ(f.warnings.size(), 1u);
}

TEST(UniversalHeader, keeps_blanks_in_names_and_is_read_when_shifted) {
  const std::string plain = function_header(2, 1, 1) + "1.0\n" + closing;
  const auto check = [](const std::string& text, const std::string& entity) {
    const auto f = only<UniversalFunction>(text);
    EXPECT_EQ(f.type, FunctionType::frequency_response) << text;
    EXPECT_EQ(f.id, 7) << text;
    EXPECT_EQ(f.response.entity, entity) << text;
    EXPECT_EQ(f.response.node, 12) << text;
    EXPECT_EQ(f.response.direction, 3) << text;
    EXPECT_EQ(f.reference.node, 5) << text;
    EXPECT_EQ(f.reference.direction, -2) << text;
    EXPECT_EQ(f.abscissa_axis.unit, "Hz") << text;
    EXPECT_EQ(f.numerator.unit, "m/s^2") << text;
    EXPECT_EQ(f.denominator.label, "Excitation force") << text;
  };
  check(plain, "FLANGE A");
  check(replaced(plain, "FLANGE A  ", "F 01 2 A 9"), "F 01 2 A 9");
  check(replaced(plain, "    4         7", "4         7"), "FLANGE A");
  check(replaced(plain, "    4         7", "     4         7"), "FLANGE A");
  check(replaced(plain, "FLANGE A          12   3 NONE               5  -2",
                 "FLANGE\tA 12 3 NONE 5 -2"),
        "FLANGE A");
  check(replaced(plain, "   3 NONE               5  -2", "   3                    5  -2"),
        "FLANGE A");
  check(replaced(plain, "        12    1    0    0 ", "  12 1 0 0  "), "FLANGE A");
  check(replaced(plain, "Acceleration         m/s^2", "Acceleration of flange A  m/s^2"),
        "FLANGE A");
  const auto free = only<UniversalFunction>(
      replaced(plain, "         2         1         1  5.00000E-01  2.50000E-01  0.00000E+00",
               "2 1 1 0.500000000000E+00 0.25 0"));
  EXPECT_EQ(free.x0, 0.5);
  EXPECT_EQ(free.dx, 0.25);
}

TEST(UniversalElements, of_rods_may_leave_out_their_orientation) {
  const auto e = only<UniversalElements>("    -1\n  2412\n"
                                         "1 11 1 1 7 2\n 5 6\n"
                                         "2 11 1 1 7 2\n 0 1 1\n 6 7\n"
                                         "3 24 1 1 7 3\n 1 2 3\n"
                                         "4 24 1 1 7 3\n 0 1 1\n 1 2 3\n    -1\n");
  ASSERT_EQ(e.elements.size(), 4u);
  EXPECT_FALSE(e.elements[0].beam.has_value());
  EXPECT_TRUE(e.elements[1].beam.has_value());
  EXPECT_FALSE(e.elements[2].beam.has_value());
  EXPECT_TRUE(e.elements[3].beam.has_value());
  expect_refused("    -1\n  2412\n1 44 1 1 7 4\n 5 6 7\n    -1\n", 5, "data set 2412, record 2",
                 "ends");
  expect_refused("    -1\n  2412\n1 44 1 1 7 -4\n 5 6 7\n    -1\n", 3, "data set 2412, record 1",
                 "-4 nodes");
}

} // namespace
} // namespace plica::test
