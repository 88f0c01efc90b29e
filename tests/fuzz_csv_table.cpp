// CSV tables damaged at random: nothing but InputError may come out, and what is read is finite.
#include "io/lab_files/csv_table.hpp"
#include "tests/mutator.hpp"
#include "words/input_error.hpp"

#include <array>
#include <gtest/gtest.h>

namespace plica::test {
namespace {

constexpr std::array csv_seeds{
    "f [Hz],mid y real [g],mid y imaginary [g]\n1,2.5,-3\n2,1e-3,4\n3,-7,8.5\n",
    "# made by a lab\nf;\"a;b\";c\n1;2,5;-3+2j\n2;1e-3;(4-1i)\n\n3;1;2\n",
    "0.5+0j;-1.5e-3+2i;(1-2j)\n1;3j;4\n2;5;6\n", "1\t2\t3\n4\t5\t6\n"};

void fuzz_csv(unsigned seed, long rounds) {
  Mutator mutator(seed);
  int read = 0, refused = 0;
  for (long round = 0; round < rounds && !testing::Test::HasFailure(); ++round) {
    std::string text = csv_seeds[mutator.below(csv_seeds.size())];
    for (std::size_t k = 0, n = 1 + mutator.below(4); k < n; ++k) mutator.damage(text);
    try {
      const CsvTable table = csv_of_text(text, "fuzz.csv");
      ++read;
      for (const CsvColumn& c : table.columns)
        ASSERT_TRUE(c.real.allFinite() && c.imaginary.allFinite() &&
                    c.real.size() == table.columns[0].real.size());
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(read, rounds / 50);
  EXPECT_GT(refused, rounds / 50);
}

TEST(FuzzCsv, damaged_tables_are_read_or_refused) {
  fuzz_csv(1, 4000);
}

TEST(FuzzCsvSlow, damaged_tables_are_read_or_refused_for_long) {
  fuzz_csv(2, fuzz_rounds());
}

} // namespace
} // namespace plica::test
