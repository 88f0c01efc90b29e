// Universal files that are damaged: refused with line, record and reason, or read whole.
#include "tests/support/temporary_folder.hpp"
#include "tests/universal_samples.hpp"

#include <fstream>
#include <unistd.h>

namespace plica::test {
namespace {

namespace fs = std::filesystem;
using Eigen::VectorXd;

TEST(UniversalNumbers, that_are_none_are_refused_with_their_line) {
  for (const std::string bad : {"NaN", "Inf", "-Infinity", "*************", "1.0E", "1E400",
                                "1.2.3", "0x1p3", "--1", "1.0E+00E+00", "abc"})
    expect_refused(function_header(2, 3, 1) + " 1.0 2.0\n " + bad + "\n    -1\n",
                   first_data_line + 1, "data set 58, record 12", "is not a number");
}

TEST(UniversalCounts, that_are_absurd_are_refused) {
  expect_refused(function_header(2, -5, 1) + "1.0\n" + closing, 9, "data set 58, record 7",
                 "number of values is -5");
  expect_refused(function_header(2, 9999999999, 1) + "1.0\n" + closing, 9, "data set 58, record 7",
                 "is not this record");
  expect_refused(function_header(5, 2, 1) + "1.0 2.0 3.0\n" + closing, 15, "data set 58, record 12",
                 "last point is not whole; 3 of 4 numbers");
  expect_refused(function_header(3, 2, 1) + "1.0\n" + closing, 9, "data set 58, record 7",
                 "unknown type of ordinate data 3");
}

TEST(UniversalFile, that_ends_inside_of_a_set_is_refused) {
  expect_refused(function_header(2, 100, 1) + "1.0 2.0\n3.0\n", 15, "data set 58, record 12",
                 "3 of 100 numbers are there");
  expect_refused(function_header(2, 2, 1) + "  1.00000E+00  2.0000", 14, "data set 58, record 12",
                 "inside of a number");
  expect_refused(function_header(2, 2, 1).substr(0, 200), 9, "data set 58, record 8",
                 "the file ends");
  expect_refused("    -1\n  2414\nsome\n", 3, "data set 2414", "that line 1 opens");
  expect_refused("    -1\n    15\n         1         0         0         1  1.0 2.0 3.", 3,
                 "data set 15, record 1", "inside of the data set");
}

// A line of -1 opens each data set and closes it.
std::size_t closed_sets(const std::string& text) {
  std::size_t marks = 0;
  for (std::size_t at = text.find(closing); at != std::string::npos;
       at = text.find(closing, at + closing.size()))
    ++marks;
  return marks / 2;
}

// Every length of a file: read as before, or refused, and no data set with fewer data than the file
// has up to there.
TEST(UniversalFile, cut_anywhere_is_refused_or_whole) {
  const std::string text = one_of_each();
  const auto whole = sets_of(text);
  ASSERT_EQ(whole.size(), 8U);
  std::size_t read = 0, refused = 0;
  for (std::size_t length = 0; length < text.size(); ++length) {
    try {
      const auto sets = sets_of(text.substr(0, length));
      ++read;
      EXPECT_GE(sets.size(), closed_sets(text.substr(0, length)));
      for (std::size_t i = 0; i + 1 < sets.size(); ++i) expect_same(sets[i], whole[i]);
      if (sets.size() == whole.size()) {
        EXPECT_GE(length, text.size() - 8) << "only the -1 is gone";
      }
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GE(read, whole.size() - 1); // behind each set but the last
  EXPECT_GT(refused, 0U);
}

TEST(UniversalHeader, that_is_damaged_is_refused_with_its_record) {
  const std::string plain = function_header(2, 1, 1) + "1.0\n" + closing;
  expect_refused(replaced(plain, "    4         7", "four"), 8, "data set 58, record 6",
                 "does not describe a degree of freedom");
  expect_refused(replaced(plain, "        12    1", "      none"), 11, "data set 58, record 9",
                 "does not describe an axis");
  expect_refused("    -1\nhello\n    -1\n", 2, "", "follows the -1");
}

std::string binary(const std::string& number, long points, int even, const std::string& data) {
  return function_header(2, points, even, number) + data + closing;
}

TEST(UniversalBinary, of_foreign_formats_is_refused_by_name) {
  const std::string eight(8, '\0');
  expect_refused(binary("    58b     1     1          11           8", 2, 1, eight), 2,
                 "data set 58b, record 0", "DEC VMS");
  expect_refused(binary("    58b     2     3          11           8", 2, 1, eight), 2,
                 "data set 58b, record 0", "IBM");
  expect_refused(binary("    58b     7     2          11           8", 2, 1, eight), 2,
                 "data set 58b, record 0", "unknown byte order 7");
  expect_refused(
      binary("    58b     1     2          11           8", 2, 1, "\xff\xff\xff\x7f" + eight), 14,
      "data set 58b, record 12", "no -1 follows");
  expect_refused(binary("    58b     1     2          11           8", 2, 1,
                        std::string("\0\0\0\0\0\0\xc0\x7f", 8)),
                 14, "data set 58b, record 12", "number 2 is NaN");
  expect_refused(function_header(2, 9, 1, "    58b     1     2          11          36") + eight,
                 14, "data set 58b, record 12", "2 of 9 points are there");
}

TEST(UniversalBinary, is_measured_by_its_bytes_where_counts_are_wrong) {
  const std::string twelve = std::string(12, '\0');
  const auto wrong_bytes =
      only<UniversalFunction>(binary("    58b     1     2          11           6", 3, 1, twelve));
  EXPECT_EQ(wrong_bytes.real.size(), 3);
  EXPECT_EQ(wrong_bytes.warnings.size(), 1u);
  const auto wrong_points = only<UniversalFunction>(
      binary("    58b     1     2          11          12", 100, 1, twelve));
  EXPECT_EQ(wrong_points.real.size(), 3);
  EXPECT_EQ(wrong_points.warnings.size(), 1u);
  const auto wide_abscissa =
      only<UniversalFunction>(binary("    58b     1     2          11          12", 1, 0, twelve));
  EXPECT_EQ(wide_abscissa.binary->abscissa_bytes, 8);
  const auto line_end = only<UniversalFunction>(
      binary("    58b     1     2          11          12", 3, 1, twelve + "\r\n"));
  EXPECT_EQ(line_end.real.size(), 3);
  EXPECT_TRUE(line_end.warnings.empty());
}

TEST(UniversalShape, with_wrong_counts_warns_or_is_refused) {
  const std::string head = "    -1\n    55\nA\nB\nC\nD\nE\n";
  const auto s = only<UniversalShape>(head + "2 2 2 8 2 3\n"
                                             "2 6 1 4\n"
                                             "1.0 2.0\n"
                                             "5\n1.0 2.0 3.0\n    -1\n");
  EXPECT_EQ(s.reals.size(), 2u);
  EXPECT_EQ(s.warnings.size(), 1u);
  expect_refused(head + "2 2 2 8 2 3\n2 1 1 4\n1.0\n5\n1.0 2.0\n    -1\n", 13,
                 "data set 55, record 10", "node 5 has 2 numbers");
  expect_refused(head + "2 2 2 8 2 3\n2 1 1 4\n1.0\n5\n1.0 2.0\n", 12, "data set 55, record 10",
                 "2 of 3 numbers of node 5");
  expect_refused(head + "2 2 2 8 2 0\n", 8, "data set 55, record 6", "0 values per node");
}

TEST(UniversalFile, that_is_none_is_refused) {
  const TemporaryFolder folder("universal");
  EXPECT_THROW(UniversalReader(folder.path), InputError) << "a folder";
  EXPECT_THROW(UniversalReader(folder.path / "none.uff"), InputError);
  EXPECT_THROW(UniversalReader("/dev/zero"), InputError) << "without an end";
  const fs::path path = folder.path / "file.uff";
  std::ofstream(path).close();
  EXPECT_THROW(UniversalReader{path}, InputError) << "empty";
  std::ofstream(path) << "no data sets\n";
  EXPECT_THROW(read_universal(path), InputError);
  fs::permissions(path, fs::perms::none);
  if (geteuid() != 0) { // root reads all
    EXPECT_THROW(UniversalReader{path}, InputError);
  }
}

TEST(UniversalReader, is_at_its_end_after_an_error) {
  UniversalReader reader = UniversalReader::of_text("    -1\nhello\n" + one_of_each(), "f");
  EXPECT_THROW(reader.next(), InputError);
  EXPECT_FALSE(reader.next().has_value());
}

} // namespace
} // namespace plica::test
