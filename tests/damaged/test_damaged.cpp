// Damaged inputs of every reader, through the program as a user runs it.
//
// Whatever the damage, the program ends with 0, 1 or 2, in time, and with a message unless it is 0.
// Where it is 0, mass (of models), frequency and scale of the shape (of tests), the result (of a
// fit begun again) agree with the undamaged file, or the output has a warning that names the file
// and that the good file does not have, or the damage made another good file by the rule of
// damage.hpp, which no reader could tell: these are counted apart.
//
//   PLICA_DAMAGE_ROUNDS=N   rounds of the slow suites, 1000 unless told
//   PLICA_DAMAGE_SEED=N     that one alone
//   PLICA_DAMAGE_KEEP=DIR   where inputs that went wrong are kept
#include "tests/damaged/program.hpp"
#include "tests/damaged/samples.hpp"

#include "io/files/files.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>
#include <unistd.h>

namespace plica::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Outcome {
  Ended ended;
  std::map<std::string, double> numbers;
  std::set<std::string> warnings;
};

// NaN where it is null, as what is no number is written.
double number_in(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number() ? found->get<double>() : std::nan("");
}

void take_numbers(const Json& json, std::map<std::string, double>& numbers) {
  if (json.contains("model")) numbers["mass"] = number_in(json["model"], "mass");
  if (json.contains("parameters"))
    for (const Json& p : json["parameters"]) numbers[p.value("path", "")] = number_in(p, "after");
  if (json.contains("explained")) numbers["explained"] = number_in(json, "explained");
  if (!json.contains("modes") || json.contains("model") || json["modes"].empty()) return;
  const Json& mode = json["modes"][0];
  numbers["frequency"] = number_in(mode, "frequency");
  if (!mode.value("mass_normalised", false)) return;
  double largest = 0;
  for (const Json& c : mode["shape"])
    largest = std::max(largest, std::hypot(number_in(c, "real"), number_in(c, "imaginary")));
  numbers["shape"] = largest;
}

Outcome outcome_of(const Sample& sample, const std::string& bytes, const fs::path& folder) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  for (const auto& [name, text] : sample.beside) write_whole(folder / name, text);
  write_whole(folder / sample.file, bytes);
  Outcome outcome;
  outcome.ended = run_plica(sample.arguments, folder);
  std::istringstream lines(outcome.ended.output);
  for (std::string line; std::getline(lines, line);)
    if (line.find("arning") != std::string::npos && line.find(sample.file) != std::string::npos)
      outcome.warnings.insert(line);
  const fs::path result = folder / sample.result;
  if (outcome.ended.exit != 0 || sample.result.empty()) return outcome;
  if (fs::exists(result)) take_numbers(Json::parse(read_whole(result)), outcome.numbers);
  return outcome;
}

bool agree(const Outcome& a, const Outcome& b) {
  constexpr double rounding = 1e-3; // identified from what a changed last digit leaves
  for (const auto& [name, value] : a.numbers)
    if (const auto other = b.numbers.find(name);
        other != b.numbers.end() &&
        !(std::abs(other->second - value) <= rounding * std::abs(value)))
      return false;
  return true;
}

struct Counts {
  int refused = 0, verdict = 0, same = 0, named = 0, other = 0;
};

class Trial {
public:
  explicit Trial(const Sample& sample)
      : sample_(sample), folder_(fs::path(testing::TempDir()) /
                                 ("plica_damaged_" + sample.name + std::to_string(getpid()))),
        good_(outcome_of(sample, sample.bytes, folder_)) {
    EXPECT_EQ(good_.ended.exit, 0) << sample.name << ": " << good_.ended.output;
    EXPECT_EQ(good_.numbers.empty(), sample.result.empty()) << sample.name;
  }
  ~Trial() { fs::remove_all(folder_); }
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;

  void round(unsigned seed) {
    const Damaged d = damaged(sample_.bytes, seed);
    const Outcome now = outcome_of(sample_, d.bytes, folder_);
    const std::string wrong = judge(now, d);
    if (wrong.empty()) return;
    ADD_FAILURE() << sample_.name << ", seed " << seed << " (" << d.what << "): " << wrong << "\n"
                  << now.ended.output.substr(0, 600);
    if (const char* keep = std::getenv("PLICA_DAMAGE_KEEP")) {
      const fs::path kept = fs::path(keep) / (sample_.name + "_" + std::to_string(seed));
      fs::remove_all(kept);
      fs::create_directories(kept.parent_path());
      fs::copy(folder_, kept, fs::copy_options::recursive);
    }
  }

  void print(unsigned first, int rounds) const {
    std::printf(
        "| %-16s | seeds %u to %u | %4d refused | %3d verdicts | %4d the same | %3d named | "
        "%4d another good file |\n",
        sample_.name.c_str(), first, first + unsigned(rounds) - 1, counts_.refused, counts_.verdict,
        counts_.same, counts_.named, counts_.other);
  }

private:
  // What is wrong; counts what is not.
  std::string judge(const Outcome& now, const Damaged& d) {
    const Ended& ended = now.ended;
    if (ended.exit != 0 && ended.exit != 1 && ended.exit != 2) return ended.how;
    if (ended.exit != 0 && ended.output.empty()) return ended.how + " without a word";
    if (ended.exit == 1) return ++counts_.refused, "";
    if (ended.exit == 2) return ++counts_.verdict, "";
    for (const auto& [name, value] : now.numbers)
      if (!std::isfinite(value)) return "exit 0, but " + name + " is no number";
    if (agree(good_, now)) return ++counts_.same, "";
    const bool named =
        std::any_of(now.warnings.begin(), now.warnings.end(),
                    [&](const std::string& line) { return !good_.warnings.contains(line); });
    if (another_good_file(sample_.bytes, d.bytes, sample_.rule)) return ++counts_.other, "";
    if (named) return ++counts_.named, "";
    std::string wrong = "exit 0, but";
    for (const auto& [name, value] : good_.numbers)
      wrong += " " + name + " " + std::to_string(value) + " is " +
               (now.numbers.contains(name) ? std::to_string(now.numbers.at(name)) : "not there");
    return wrong;
  }

  const Sample& sample_;
  fs::path folder_;
  Outcome good_;
  Counts counts_;
};

void try_rounds(const Sample& sample, unsigned first, int rounds) {
  Trial trial(sample);
  if (testing::Test::HasFailure()) return;
  if (const char* told = std::getenv("PLICA_DAMAGE_SEED")) {
    first = unsigned(std::atol(told));
    rounds = 1;
  }
  for (int i = 0; i < rounds; ++i) trial.round(first + unsigned(i));
  trial.print(first, rounds);
}

const Sample& sample_named(const std::string& name) {
  for (const Sample& sample : samples())
    if (sample.name == name) return sample;
  throw std::invalid_argument(name);
}

int long_rounds() {
  const char* told = std::getenv("PLICA_DAMAGE_ROUNDS");
  return told ? std::atoi(told) : 1000;
}

class DamagedInput : public testing::TestWithParam<std::string> {};
class DamagedInputSlow : public testing::TestWithParam<std::string> {};

TEST_P(DamagedInput, is_refused_or_means_what_it_says) {
  const Sample& sample = sample_named(GetParam());
  try_rounds(sample, 1, sample.few);
}

TEST_P(DamagedInputSlow, is_refused_or_means_what_it_says) {
  try_rounds(sample_named(GetParam()), 1001, long_rounds());
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const Sample& sample : samples()) all.push_back(sample.name);
  return all;
}

const auto by_name = [](const auto& info) { return info.param; };
INSTANTIATE_TEST_SUITE_P(, DamagedInput, testing::ValuesIn(names()), by_name);
INSTANTIATE_TEST_SUITE_P(, DamagedInputSlow, testing::ValuesIn(names()), by_name);

} // namespace
} // namespace plica::test
