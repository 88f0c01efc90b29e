// Valid universal files damaged at random: nothing but InputError may come out, and what is read
// reads equal once it is written. The seed is fixed; PLICA_FUZZ_ROUNDS sets the rounds of the slow
// suite, 300,000 unless told.
#include "tests/universal_samples.hpp"

#include <cstdlib>
#include <random>

namespace plica::test {
namespace {

std::vector<std::string> seeds() {
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

class Mutator {
public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }

  void damage(std::string& text) {
    const std::size_t at = below(text.size());
    switch (below(9)) {
    case 0:
      if (!text.empty()) text[at] = char(below(256));
      break;
    case 1:
      if (!text.empty()) text[at] = char(text[at] ^ (1 << below(8)));
      break;
    case 2:
      text.erase(at, 1 + below(20));
      break;
    case 3:
      text.resize(at);
      break;
    case 4:
      number(text, at);
      break;
    case 5:
      duplicate_line(text, at);
      break;
    case 6:
      erase_line(text, at);
      break;
    case 7:
      text.insert(at, pick({"-1", "\n", "\n    -1\n", "\n    58\n", " ", "NaN", "\t", "\r", "1E999",
                            "-1.0-2.0", "\n   151\n", "\n58b 1 2 11 8\n"}));
      break;
    default:
      swap_parts(text, at);
    }
  }

private:
  std::string pick(std::initializer_list<const char*> choices) {
    return choices.begin()[below(choices.size())];
  }
  static std::pair<std::size_t, std::size_t> line_at(const std::string& text, std::size_t at) {
    const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    const std::size_t end = text.find('\n', begin);
    return {begin, end == std::string::npos ? text.size() : end + 1};
  }
  void number(std::string& text, std::size_t at) {
    const std::size_t digit = text.find_first_of("0123456789", at);
    if (digit == std::string::npos) return;
    text.replace(digit, 1,
                 pick({"0", "9", "-1", "-7", "99999999999", "2147483647", "1E30", "3", "1000000",
                       "4294967296", ""}));
  }
  void duplicate_line(std::string& text, std::size_t at) {
    const auto [begin, end] = line_at(text, at);
    text.insert(end, text.substr(begin, end - begin));
  }
  void erase_line(std::string& text, std::size_t at) {
    const auto [begin, end] = line_at(text, at);
    text.erase(begin, end - begin);
  }
  void swap_parts(std::string& text, std::size_t at) {
    const std::string part = text.substr(at, below(200));
    text.insert(below(text.size()), part);
  }
  std::mt19937 random_;
};

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

void fuzz(unsigned seed, long rounds) {
  const std::vector<std::string> files = seeds();
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
  fuzz(1, 4000);
}

TEST(UniversalFuzzSlow, many_damaged_files_are_read_or_refused) {
  const char* rounds = std::getenv("PLICA_FUZZ_ROUNDS");
  fuzz(2, rounds != nullptr ? std::atol(rounds) : 300000);
}

} // namespace
} // namespace plica::test
