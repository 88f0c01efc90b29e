#include "diagnose/weigh/baseline.hpp"

#include "diagnose/readings/same_thing.hpp"
#include "diagnose/weigh/normal_draws.hpp"
#include "lab/measured/states.hpp"
#include "run/results/normal_distribution.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <utility>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Errors of a model of a real structure beside that of its frequencies, relative. A damping ratio
// is a guess, and the height of a peak goes with it.
constexpr double damping_error = 0.3, amplitude_error = 0.3, cross_error = 0.5;
constexpr double component_error = 0.05; // of the largest of a shape

double stated_error(ReadingKind kind, double of_frequency) {
  switch (kind) {
  case ReadingKind::mass:
  case ReadingKind::frequency:
    return of_frequency;
  case ReadingKind::stiffness:
  case ReadingKind::dynamic_stiffness:
    return 2 * of_frequency;
  case ReadingKind::damping:
  case ReadingKind::loss:
    return damping_error;
  case ReadingKind::amplitude:
    return amplitude_error;
  case ReadingKind::component:
    return component_error;
  case ReadingKind::cross:
    break;
  }
  return cross_error;
}

const char* plural(ReadingKind kind) {
  constexpr std::array names{
      "masses",           "static stiffnesses",         "frequencies",         "damping",
      "heights of peaks", "responses along other axes", "dynamic stiffnesses", "losses",
      "mode shapes"};
  return names[static_cast<std::size_t>(kind)];
}

// Readings numbered so that those of one thing share a number.
std::vector<int> things_of(const TestReadings& test) {
  return numbered(test, [&](const Reading& a, const Reading& b) { return same_thing(test, a, b); });
}

double level_of(const TestReadings& test, const Reading& r) {
  return r.run < 0 ? 0 : test.runs[std::size_t(r.run)].level;
}

class Conditioning {
public:
  Conditioning(const Measured& measured, const DiagnosisRequest& request, TestReadings& test,
               Uncertainty& u)
      : request_(request), asked_(measured.hold_out), test_(test), u_(u), things_(things_of(test)),
        deviation_(test.readings.size()) {
    for (std::size_t i = 0; i < test.readings.size(); ++i) {
      const Reading& r = test.readings[i];
      (is_baseline(measured, r.state) ? before_ : after_).push_back(Index(i));
      held_out_ = held_out_ || (is_baseline(measured, r.state) && r.held_out);
      deviation_[Index(i)] = r.log_value - u.nominal[Index(i)] - u.bias[Index(i)];
    }
  }

  BaselineFound found() {
    BaselineFound found;
    for (ReadingKind kind :
         {ReadingKind::mass, ReadingKind::stiffness, ReadingKind::frequency, ReadingKind::damping,
          ReadingKind::amplitude, ReadingKind::cross, ReadingKind::dynamic_stiffness,
          ReadingKind::loss, ReadingKind::component})
      add_model_error(kind, found);
    add_change_error(found);
    if (before_.empty()) return found;
    list_before(found);
    condition();
    if (held_out_ && !asked_.empty())
      test_.warnings.emplace_back("hold_out of what was measured in a baseline changes nothing: it "
                                  "is no evidence");
    return found;
  }

private:
  // What the baselines show of the model's error of a kind, beside what they scatter anyway.
  double shown(ReadingKind kind) const {
    double sum = 0;
    int count = 0;
    for (Index i : before_)
      if (reading(i).kind == kind) {
        sum += deviation_[i] * deviation_[i] - u_.measurement(i, i) - u_.reassembly(i, i);
        ++count;
      }
    return count > 0 && sum > 0 ? std::sqrt(sum / count) : 0;
  }

  // What a model changes is known no better than the model; none is stated where nothing is let
  // off.
  void add_change_error(BaselineFound& found) {
    u_.change_error = request_.change_error;
    const double seen = std::min(1., shown(ReadingKind::frequency));
    if (!(u_.change_error > 0) || seen <= u_.change_error) return;
    found.words.push_back(
        fmt::format("what an effect changes is known to {:.2g} % of the change, as "
                    "the model's frequencies lie from the baseline ({:.2g} % "
                    "stated)",
                    100 * seen, 100 * u_.change_error));
    u_.change_error = seen;
  }

  void add_model_error(ReadingKind kind, BaselineFound& found) {
    if (std::none_of(test_.readings.begin(), test_.readings.end(),
                     [&](const Reading& r) { return r.kind == kind; }))
      return;
    constexpr double usual = 0.02; // of a frequency
    const double stated = stated_error(kind, request_.model_error.value_or(usual));
    const double seen = shown(kind), sigma = std::max(stated, seen);
    std::string why = "as stated";
    if (seen > stated)
      why = fmt::format("as the baseline shows ({:.2g} % stated)", 100 * stated);
    else if (!before_.empty())
      why += fmt::format(" (the baseline shows {:.2g} %)", 100 * seen);
    constexpr double another_model = 0.1; // of a frequency
    if (kind == ReadingKind::frequency && seen > another_model)
      test_.warnings.push_back(fmt::format(
          "the model's frequencies lie {:.2g} % from those of the baseline: modes may be "
          "taken for others (order, direction), or the case wants to be fitted first "
          "(--fit-baseline)",
          100 * seen));
    const double shared = request_.correlation;
    if (shared < 1)
      why +=
          fmt::format(", {:g} % of its square common to baselines and later states", 100 * shared);
    found.words.push_back(
        fmt::format("model error of {}: {:.2g} %, {}", plural(kind), 100 * sigma, why));
    const Index n = u_.form.rows();
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j < n; ++j)
        if (reading(i).kind == kind && things_[std::size_t(i)] == things_[std::size_t(j)])
          u_.form(i, j) += sigma * sigma * (reading(i).state == reading(j).state ? 1 : shared);
    for (Index k = 0; k < u_.healthy.cols(); ++k) {
      constexpr unsigned apart = 100000; // seeds of the specimens lie below
      NormalDraws draw(apart * (1 + unsigned(kind)) + unsigned(k));
      std::map<int, double> common;
      std::map<std::pair<int, std::string>, double> own;
      for (Index i = 0; i < n; ++i) {
        if (reading(i).kind != kind) continue;
        const int thing = things_[std::size_t(i)];
        const auto [all, first] = common.try_emplace(thing);
        if (first) all->second = draw();
        const auto [one, fresh] = own.try_emplace({thing, reading(i).state});
        if (fresh) one->second = draw();
        u_.healthy(i, k) += sigma * (std::sqrt(shared) * all->second +
                                     std::sqrt(std::max(0., 1 - shared)) * one->second);
      }
    }
  }

  void list_before(BaselineFound& found) const {
    const MatrixXd total = u_.total();
    for (Index i : before_) {
      const double model = value_of(reading(i), reading(i).log_value - deviation_[i]);
      found.readings.push_back({.kind = reading(i).kind,
                                .name = reading(i).name,
                                .unit = reading(i).unit,
                                .measured = reading(i).value,
                                .nominal = model,
                                .best = model,
                                .second = {},
                                .sigma = std::sqrt(total(i, i)),
                                .held_out = false});
    }
  }

  void condition() {
    const MatrixXd total = u_.total();
    const Eigen::LLT<MatrixXd> root(MatrixXd(total(before_, before_)));
    const MatrixXd gain =
        root.solve(MatrixXd(total(before_, after_))).transpose(); // after x before
    u_.bias = VectorXd(u_.bias(after_)) + gain * VectorXd(deviation_(before_));
    u_.nominal = VectorXd(u_.nominal(after_));
    u_.correction = VectorXd(u_.correction(after_));
    u_.healthy =
        MatrixXd(u_.healthy(after_, Eigen::all)) - gain * MatrixXd(u_.healthy(before_, Eigen::all));
    // Of what the baseline leaves open, each part its own: that of y_a - K y_b.
    for (MatrixXd* part : {&u_.measurement, &u_.reassembly, &u_.numeric, &u_.form}) {
      const MatrixXd across = gain * MatrixXd((*part)(before_, after_));
      *part = MatrixXd((*part)(after_, after_)) - across - across.transpose() +
              gain * MatrixXd((*part)(before_, before_)) * gain.transpose();
    }
    std::vector<Reading> kept;
    std::vector<int> series;
    std::map<Index, CrossScatter> across;
    for (const CrossScatter& c : u_.cross) across[c.reading] = c;
    u_.cross.clear();
    for (Index i : after_) {
      if (const auto known = across.find(i); known != across.end()) {
        u_.cross.push_back(known->second);
        u_.cross.back().reading = Index(kept.size());
      }
      kept.push_back(reading(i));
      series.push_back(u_.series[std::size_t(i)]);
    }
    u_.settle_cross();
    u_.series = std::move(series);
    test_.readings = std::move(kept);
  }

  const Reading& reading(Index i) const { return test_.readings[std::size_t(i)]; }

  const DiagnosisRequest& request_;
  const std::vector<std::string>& asked_; // to be held out
  TestReadings& test_;
  Uncertainty& u_;
  std::vector<int> things_;
  std::vector<Index> before_, after_;
  bool held_out_ = false; // something of a baseline
  VectorXd deviation_;    // of the test from the model
};

} // namespace

double most_of(const Remounting& seen) {
  if (seen.measurements <= 0) return seen.frequency;
  const double one_sided = normal_quantile(0.95);
  const double n = seen.measurements, share = 2 / (9 * n);
  return seen.frequency * std::pow(1 - share - one_sided * std::sqrt(share), -1.5);
}

Remounting remounting_of(const TestReadings& test, const Measured& measured,
                         const DiagnosisRequest& request) {
  Remounting usual;
  if (!has_baseline(measured)) return usual;
  constexpr double frequency = 0.0045, damping = 0.15, speaks = 4;
  const std::vector<int> things = things_of(test);
  const auto seen = [&](ReadingKind kind, double sigma) {
    std::map<std::pair<int, double>, std::map<std::string, std::vector<double>>> groups;
    for (std::size_t i = 0; i < test.readings.size(); ++i)
      if (const Reading& r = test.readings[i]; r.kind == kind && is_baseline(measured, r.state))
        groups[{things[i], level_of(test, r)}][r.state].push_back(r.log_value);
    double sum = speaks * sigma * sigma, count = speaks;
    for (const auto& [thing, states] : groups) {
      std::vector<double> means;
      double mean = 0;
      for (const auto& [state, values] : states) {
        means.push_back(VectorXd::Map(values.data(), Index(values.size())).mean());
        mean += means.back() / double(states.size());
      }
      for (double m : means) sum += (m - mean) * (m - mean);
      count += double(means.size()) - 1;
    }
    if (kind == ReadingKind::frequency) usual.measurements = count;
    return std::sqrt(sum / count);
  };
  usual.frequency = seen(ReadingKind::frequency, frequency);
  if (request.remounting) usual = {.frequency = *request.remounting};
  usual.damping = seen(ReadingKind::damping, damping);
  return usual;
}

void pair_like_baselines(const Nominal& nominal, const Measured& measured, TestReadings& test) {
  if (!has_baseline(measured)) return;
  const auto y = Predictor(nominal, test, {})(VectorXd());
  if (!y) return;
  // Of each thing, how far the baselines lie off the model.
  const std::vector<int> things = things_of(test);
  std::map<int, std::vector<double>> off;
  for (std::size_t i = 0; i < test.readings.size(); ++i)
    if (const Reading& r = test.readings[i]; r.kind == ReadingKind::frequency &&
                                             is_baseline(measured, r.state) &&
                                             std::isfinite((*y)[Index(i)]))
      off[things[i]].push_back(r.log_value - (*y)[Index(i)]);
  std::vector<std::vector<double>> peaks;
  for (const TestRun& run : test.runs) peaks.push_back(run.peaks);
  for (std::size_t i = 0; i < test.readings.size(); ++i) {
    Reading& r = test.readings[i];
    const auto before = off.find(things[i]);
    if (r.kind != ReadingKind::frequency || is_baseline(measured, r.state) || before == off.end())
      continue;
    const std::vector<double>& all = before->second;
    const double stretch = VectorXd::Map(all.data(), Index(all.size())).mean();
    r.paired_as = r.value * std::exp(-stretch);
    peaks[std::size_t(r.run)][std::size_t(r.peak)] = r.paired_as;
  }
  std::map<std::string, double> paired_as; // what else was read of a mode goes with its frequency
  for (const Reading& r : test.readings)
    if (r.kind == ReadingKind::frequency && r.paired_as > 0) paired_as[r.entry] = r.paired_as;
  for (Reading& r : test.readings)
    if (const auto own = paired_as.find(r.entry); own != paired_as.end()) r.paired_as = own->second;
  // Readings know their peaks by number, so that these keep their order or stay as they are.
  for (std::size_t k = 0; k < peaks.size(); ++k)
    if (test.runs[k].input.any() && std::is_sorted(peaks[k].begin(), peaks[k].end()))
      test.runs[k].peaks = std::move(peaks[k]);
}

BaselineFound given_baselines(const Measured& measured, const DiagnosisRequest& request,
                              TestReadings& test, Uncertainty& u) {
  if (!has_baseline(measured) && !request.model_error) return {};
  return Conditioning(measured, request, test, u).found();
}

} // namespace plica
