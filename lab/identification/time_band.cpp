#include "lab/identification/time_band.hpp"

#include "words/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {

void check_band(const IdentifySettings& settings, double rate) {
  if (settings.high > 0.45 * rate)
    input_error(
        "rate",
        fmt::format("of {:.5g} Hz is too low for a band up to {:.5g} Hz", rate, settings.high),
        fmt::format("a band that ends below {:.4g} Hz, or signals sampled faster", 0.45 * rate));
}

void check_lines(std::size_t lines, double low, double high) {
  if (lines >= 2) return;
  input_error("file",
              fmt::format("is too short for the band of {:.4g} to {:.4g} Hz: its spectrum has {} "
                          "lines there",
                          low, high, lines),
              "a longer record, or a wider band (--band)");
}

void add_common_warnings(Identification& found, const std::string& what) {
  std::vector<std::string>& warnings = found.warnings;
  if (found.set.responses.size() < 2)
    warnings.emplace_back("one channel: no shape follows from it, and modes of different form "
                          "cannot be told apart");
  for (std::size_t i = 0; i < found.modes.size(); ++i) {
    const IdentifiedMode& a = found.modes[i];
    if (a.collinearity < 0.8 && found.set.responses.size() > 1)
      warnings.push_back(fmt::format("mode at {:.5g} Hz: the shape is far from real", a.frequency));
    for (std::size_t j = i + 1; j < found.modes.size(); ++j) {
      const IdentifiedMode& b = found.modes[j];
      const double width = std::max(a.damping * a.frequency, b.damping * b.frequency);
      if (std::abs(a.frequency - b.frequency) < width &&
          (a.shape.size() < 2 || found.auto_mac(Eigen::Index(i), Eigen::Index(j)) > 0.9))
        warnings.push_back(fmt::format("modes at {:.5g} and {:.5g} Hz overlap and look alike: they "
                                       "may be one mode that two poles fit better",
                                       a.frequency, b.frequency));
    }
  }
  if (found.modes.empty()) warnings.emplace_back("no mode stands out of the noise");
  if (found.misfit > 0.1)
    warnings.push_back(
        fmt::format("the modes leave {:.0f} % RMS of {} unexplained", 100 * found.misfit, what));
}

} // namespace plica
