#include "diagnose/predict/passed_over.hpp"

#include "diagnose/predict/predictor.hpp"
#include "words/directions.hpp"

#include <fmt/ranges.h>
#include <map>
#include <utility>

namespace plica {

bool may_move(const ModeLabel& label, int axis) {
  return axis < 0 || label.direction.empty() || label.direction == axis_word(axis);
}

namespace {

struct Pair {
  int order = 0, nominal = -1;
  std::string entry;
};

// Empty: nothing lies between two that the test should have seen.
std::string between(const NominalState& state, int axis, const Pair& a, const Pair& b) {
  const auto hertz = [&](int mode) {
    return fmt::format("{:.4g}", plica::frequency(state.model->lambda()[mode]));
  };
  std::vector<std::string> passed;
  for (int j = a.nominal + 1; j < b.nominal; ++j)
    if (may_move(state.labels[std::size_t(j)], axis)) passed.push_back(hertz(j));
  if (int(passed.size()) < b.order - a.order) return "";
  return fmt::format("{} and {} are paired with the model's modes at {} and {} Hz, past {} Hz: the "
                     "test missed a mode, or modes are taken for others",
                     a.entry, b.entry, hertz(a.nominal), hertz(b.nominal), fmt::join(passed, ", "));
}

} // namespace

std::vector<std::string> words_of_passed_over(const Nominal& nominal, const TestReadings& test) {
  const std::vector<int> modes = Predictor(nominal, test, {}).nominal_modes();
  std::map<std::pair<int, int>, std::map<int, Pair>> lists; // by run and axis, then by order
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const Reading& r = test.readings[i];
    if (r.kind == ReadingKind::frequency && r.shape == MeasuredShape::other && modes[i] >= 0 &&
        !test.runs[std::size_t(r.run)].input.any())
      lists[{r.run, r.axis}][r.order] = {r.order, modes[i], r.entry};
  }
  std::vector<std::string> words;
  for (const auto& [of, list] : lists) {
    const NominalState& state = nominal.state(test.runs[std::size_t(of.first)].state);
    for (auto a = list.begin(), b = a; ++b != list.end(); a = b)
      if (std::string said = between(state, of.second, a->second, b->second); !said.empty())
        words.push_back(std::move(said));
  }
  return words;
}

} // namespace plica
