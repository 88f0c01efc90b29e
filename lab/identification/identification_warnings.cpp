#include "lab/identification/identification_warnings.hpp"

#include "lab/identification/missed_peaks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

int count_within(const Eigen::VectorXd& hertz, double low, double high) {
  return static_cast<int>((hertz.array() >= low && hertz.array() <= high).count());
}

void warn_of_mode(const FrfSet& set, const IdentifiedMode& m, std::vector<std::string>& warnings) {
  const std::string mode = fmt::format("mode at {:.5g} Hz: ", m.frequency);
  const double half = m.damping * m.frequency;
  const int lines = count_within(set.hertz, m.frequency - half, m.frequency + half);
  if (lines < 5)
    warnings.push_back(
        mode + fmt::format("{} lines within the half-power bandwidth of {:.2g} Hz, five are "
                           "needed for its damping",
                           lines, 2 * half));
  if (const double bias = std::pow(set.resolution / (2 * half), 2) / 2; bias > 0.02)
    warnings.push_back(
        mode + fmt::format("the window widens it, its damping is high by about {:.0f} %; take "
                           "longer blocks (--block)",
                           100 * bias));
  // The response lags a sweep by about rate / (2 pi (zeta f)^2) of it.
  const double lag = set.sweep_rate * m.frequency / (2 * std::numbers::pi * half * half);
  if (lag > 0.01)
    warnings.push_back(
        mode + fmt::format("the sweep is too fast for it, the response is off by about {:.0f} % "
                           "and may show one mode as two",
                           100 * lag));
  // What the modes leave out shifts a fit without widening its uncertainty.
  const double by_circle = m.circle_frequency - m.frequency,
               by_peak = m.peak_frequency - m.frequency;
  const double apart = std::min(std::abs(by_circle), std::abs(by_peak));
  if (m.circle_frequency > 0 && m.peak_frequency > 0 && by_circle * by_peak > 0 &&
      apart > std::max(3 * m.sigma_frequency, 0.01 * half))
    warnings.push_back(
        mode +
        fmt::format("circle fit ({:.6g} Hz) and peak ({:.6g} Hz) both lie {} it by more than "
                    "its uncertainty, which does not hold what the modes leave out",
                    m.circle_frequency, m.peak_frequency, by_peak > 0 ? "above" : "below"));
  if (m.rank > 0.3)
    warnings.push_back(mode +
                       "its residues are not of one mode: a close pair, or references that were "
                       "not measured on the same structure");
  if (m.collinearity < 0.8 && set.responses.size() > 1)
    warnings.push_back(mode + "the shape is far from real");
}

} // namespace

std::vector<std::string> identification_warnings(const Identification& found) {
  const FrfSet& set = found.set;
  std::vector<std::string> warnings = set.warnings;
  if (set.responses.size() < 3)
    warnings.push_back(
        fmt::format("{} response{}: a shape says little, modes of different form cannot be told "
                    "apart by it",
                    int(set.responses.size()), set.responses.size() == 1 ? "" : "s"));
  for (const IdentifiedMode& m : found.modes) warn_of_mode(set, m, warnings);
  for (std::size_t i = 0; i < found.modes.size(); ++i)
    for (std::size_t j = i + 1; j < found.modes.size(); ++j) {
      const IdentifiedMode &a = found.modes[i], &b = found.modes[j];
      const double width = std::max(a.damping * a.frequency, b.damping * b.frequency);
      if (std::abs(a.frequency - b.frequency) < width &&
          (set.responses.size() < 2 || found.auto_mac(Eigen::Index(i), Eigen::Index(j)) > 0.9))
        warnings.push_back(fmt::format(
            "modes at {:.5g} and {:.5g} Hz overlap and look alike: they may be one mode "
            "that two poles fit better",
            a.frequency, b.frequency));
    }
  std::string peaks;
  for (const double f : missed_peaks(set, found.modes))
    peaks += fmt::format("{}{:.5g}", peaks.empty() ? "" : ", ", f);
  if (!peaks.empty())
    warnings.push_back("no mode was found at the peaks of " + peaks +
                       " Hz, which stand out of the noise; identify a narrower band around them "
                       "(--band)");
  if (found.modes.empty()) warnings.emplace_back("no mode stands out of the noise");
  if (found.misfit > 0.1)
    warnings.push_back(fmt::format("the modes leave {:.0f} % RMS of the responses unexplained",
                                   100 * found.misfit));
  return warnings;
}

} // namespace plica
