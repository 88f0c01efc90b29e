// Universal files written out by hand after the published formats, and comparison of data sets.
#pragma once

#include "io/universal/reader.hpp"
#include "io/universal/writer.hpp"
#include "words/input_error.hpp"

#include <gtest/gtest.h>

namespace plica::test {

inline std::vector<UniversalDataset> sets_of(const std::string& text) {
  UniversalReader reader = UniversalReader::of_text(text, "sample.uff");
  std::vector<UniversalDataset> sets;
  while (std::optional<UniversalDataset> set = reader.next()) sets.push_back(std::move(*set));
  return sets;
}

template <class Set> Set only(const std::string& text) {
  const std::vector<UniversalDataset> sets = sets_of(text);
  if (sets.size() != 1) throw std::logic_error(std::to_string(sets.size()) + " data sets");
  return std::get<Set>(sets[0]);
}

// The header of a function up to its data: type of ordinate data, stated points, spacing.
inline std::string function_header(int data_type, long points, int even,
                                   const std::string& number = "    58") {
  const auto wide = [](long value) {
    const std::string digits = std::to_string(value);
    return std::string(10 - digits.size(), ' ') + digits;
  };
  return "    -1\n" + number +
         "\n"
         "Drive point\n"
         "NONE\n"
         "16-Apr-21 10:11:12\n"
         "NONE\n"
         "NONE\n"
         "    4         7    1         0 FLANGE A          12   3 NONE               5  -2\n" +
         wide(data_type) + wide(points) + wide(even) +
         "  5.00000E-01  2.50000E-01  0.00000E+00\n"
         "        18    0    0    0 Frequency            Hz                  \n"
         "        12    1    0    0 Acceleration         m/s^2               \n"
         "        13    0    1    0 Excitation force     N                   \n"
         "         0    0    0    0 NONE                 NONE                \n";
}

inline const std::string closing = "    -1\n";

// One of each data set.
inline std::string one_of_each() {
  return "    -1\n   151\nmodel\nNONE\nprogram\n    -1\n"
         "    -1\n   164\n"
         "         1SI: Meter (newton)           2\n"
         "  1.00000000000000000D+00  1.00000000000000000D+00  1.00000000000000000D+00\n"
         "  2.73149999999999977D+02\n"
         "    -1\n"
         "    -1\n  2411\n"
         "         1         1         1        11\n"
         "   5.0000000000000000D-01  -2.5000000000000000D+00   3.0000000000000000D+00\n"
         "         2         1         1        11\n"
         "   4.0000000000000000D+00   5.0000000000000000D+00   6.0000000000000000D+00\n"
         "    -1\n"
         "    -1\n    15\n"
         "         7         1         0         8  1.00000E+00 -2.00000E+00  3.00000E-02\n"
         "    -1\n"
         "    -1\n  2412\n"
         "         1        44         2         3         7         4\n"
         "         1         2         3         4\n"
         "         2        21         2         3         7         2\n"
         "         0         1         1\n"
         "         1         2\n"
         "    -1\n"
         "    -1\n    82\n"
         "         1         9         4\n"
         "pipe\n"
         "         1         2         3         0         4         5         6         7\n"
         "         8\n"
         "    -1\n"
         "    -1\n    55\n"
         "NONE\nNONE\nNONE\nNONE\nNONE\n"
         "         1         2         2         8         2         3\n"
         "         2         4         1         3\n"
         "  1.25000E+02  1.00000E+00  1.00000E-02  0.00000E+00\n"
         "         1\n"
         "  1.00000E+00  2.00000E+00 -3.00000E+00\n"
         "         2\n"
         "  0.00000E+00  5.00000E-01  0.00000E+00\n"
         "    -1\n" +
         function_header(5, 4, 1) +
         "  1.00000E+00 -2.00000E+00  3.00000E+00  4.00000E+00 -5.00000E+00  6.00000E+00\n"
         "  7.00000E+00  8.00000E+00\n"
         "    -1\n";
}

template <class Matrix> bool same(const Matrix& a, const Matrix& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() &&
         (a.size() == 0 || (a.array() == b.array()).all());
}

// Equal in all that the file holds. Text is written for every digit of the format, so the texts of
// equal sets are equal; numbers are compared beside it for what the format rounds.
inline void expect_same(const UniversalDataset& a, const UniversalDataset& b) {
  ASSERT_EQ(a.index(), b.index());
  EXPECT_EQ(universal_text(a), universal_text(b));
  if (const auto* f = std::get_if<UniversalFunction>(&a)) {
    const auto& g = std::get<UniversalFunction>(b);
    EXPECT_TRUE(same(f->real, g.real));
    EXPECT_TRUE(same(f->imaginary, g.imaginary));
    EXPECT_TRUE(same(f->abscissa, g.abscissa));
    EXPECT_EQ(f->dx, g.dx);
  } else if (const auto* s = std::get_if<UniversalShape>(&a)) {
    const auto& t = std::get<UniversalShape>(b);
    EXPECT_TRUE(same(s->real, t.real));
    EXPECT_TRUE(same(s->imaginary, t.imaginary));
    EXPECT_EQ(s->reals, t.reals);
  }
}

inline UniversalDataset again(const UniversalDataset& set) {
  return sets_of(universal_text(set)).at(0);
}

inline constexpr int first_data_line = 14; // of a function that opens the file

inline std::string replaced(std::string text, const std::string& old, const std::string& by) {
  for (std::size_t at = text.find(old); at != std::string::npos;
       at = text.find(old, at + by.size()))
    text.replace(at, old.size(), by);
  return text;
}

// A real function of single precision and even spacing.
inline UniversalFunction of_data(const std::string& data, long points) {
  return only<UniversalFunction>(function_header(2, points, 1) + data);
}

inline std::vector<double> values(const UniversalFunction& f) {
  return {f.real.data(), f.real.data() + f.real.size()};
}

inline InputProblem refusal(const std::string& text) {
  try {
    (void)sets_of(text);
  } catch (const InputError& error) {
    return error.problems().at(0);
  }
  ADD_FAILURE() << "is read: " << text;
  return {};
}

inline void expect_refused(const std::string& text, int line, const std::string& key,
                           const std::string& wrong) {
  const InputProblem p = refusal(text);
  EXPECT_EQ(p.file, "sample.uff");
  EXPECT_EQ(p.line, line) << to_string(p);
  EXPECT_EQ(p.key, key) << to_string(p);
  EXPECT_NE(p.wrong.find(wrong), std::string::npos) << to_string(p);
  EXPECT_FALSE(p.allowed.empty());
}

} // namespace plica::test
