// Valid universal files damaged at random: nothing but InputError may come out, and what is read
// reads equal once it is written. The seed is fixed.
#include "tests/mutator.hpp"
#include "tests/universal_samples.hpp"

namespace plica::test {
namespace {

std::vector<std::string> universal_seeds() {
  std::vector<std::string> files{one_of_each()};
  for (int type : {2, 4, 5, 6})
    for (bool even : {true, false})
      for (bool binary : {true, false}) {
        UniversalFunction f;
        f.data_type = UniversalDataType(type);
        f.even = even;
        f.real = Eigen::VectorXd::LinSpaced(11, -3, 5);
        if (is_complex(f.data_type)) f.imaginary = -f.real;
        if (!even) f.abscissa = f.real;
        if (binary)
          f.binary = UniversalBinaryForm{type > 4 ? UniversalByteOrder::big_endian
                                                  : UniversalByteOrder::little_endian};
        files.push_back(universal_text(f) + universal_text(sets_of(one_of_each())[2]));
      }
  UniversalShape s;
  s.data_type = UniversalDataType::complex_single;
  s.nodes = {1, 2, 3};
  s.real = s.imaginary = Eigen::MatrixXd::Constant(3, 6, -1.5);
  describe(s, UniversalComplexMode{1, 2, {-3, 400}, {1, 2}, {5, 6}});
  files.push_back(universal_text(s) + files[5]);
  return files;
}

// What was read is written; where the writer takes it, it reads the same.
void read_and_write(const std::string& text, int& read, int& refused) {
  std::vector<UniversalDataset> sets;
  try {
    sets = sets_of(text);
    ++read;
  } catch (const InputError&) {
    ++refused;
    return;
  }
  for (const UniversalDataset& set : sets) {
    std::string written;
    try {
      written = universal_text(set);
    } catch (const InputError&) {
      continue;
    }
    const auto first = sets_of(written);
    ASSERT_EQ(first.size(), 1u) << written;
    ASSERT_EQ(universal_text(first[0]), written);
  }
}

void fuzz_universal(unsigned seed, long rounds) {
  const std::vector<std::string> files = universal_seeds();
  Mutator mutator(seed);
  int read = 0, refused = 0;
  for (long round = 0; round < rounds && !testing::Test::HasFailure(); ++round) {
    std::string text = files[mutator.below(files.size())];
    for (std::size_t k = 0, n = 1 + mutator.below(4); k < n; ++k) mutator.damage(text);
    try {
      read_and_write(text, read, refused);
    } catch (const std::exception& error) {
      ADD_FAILURE() << "round " << round << ": " << error.what() << "\n" << text;
    }
    if (testing::Test::HasFailure()) std::fprintf(stderr, "round %ld\n%s\n", round, text.c_str());
  }
  EXPECT_GT(read, rounds / 20) << "the damage is so heavy that nothing is tried";
  EXPECT_GT(refused, rounds / 20);
}

TEST(UniversalFuzz, few_damaged_files_are_read_or_refused) {
  fuzz_universal(1, 4000);
}

TEST(UniversalFuzzSlow, many_damaged_files_are_read_or_refused) {
  fuzz_universal(2, fuzz_rounds());
}

} // namespace
} // namespace plica::test
