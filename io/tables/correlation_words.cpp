#include "io/tables/correlation_words.hpp"

#include "io/tables/text.hpp"
#include "lab/measured/measured_words.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plica {
namespace {

std::string percent(const std::optional<double>& x, int digits = 1) {
  return x ? with_sign(100 * *x, digits) : "-";
}

std::string plain(const std::optional<double>& x, int digits = 3) {
  return x ? significant(*x, digits) : "-";
}

std::string pairs_text(const Correlation& c, const TestData& a, const TestData& b) {
  std::string text =
      fmt::format("{:<24}{:>10}{:>12}{:>9}{:>10}{:>11}{:>11}{:>8}  {}\n", "test mode", "test Hz",
                  "simul. Hz", "diff %", "in sigma", "damping %", "simul. %", "MAC", "paired by");
  for (const PairedMode& p : c.pairs) {
    const MeasuredMode &s = a.data.modes[p.simulated], &t = b.data.modes[p.measured];
    const auto in_percent = [](const std::optional<double>& x) {
      return x ? significant(100 * *x, 3) : std::string("-");
    };
    text += fmt::format("{:<24}{:>10}{:>12}{:>9}{:>10}{:>11}{:>11}{:>8}  {}\n",
                        mode_name(t, p.measured), significant(t.frequency, 5),
                        significant(s.frequency, 5), percent(p.frequency_error),
                        p.frequency_sigmas ? with_sign(*p.frequency_sigmas, 1) : "-",
                        in_percent(t.damping), in_percent(s.damping), plain(p.mac), p.by);
  }
  for (const int j : c.unpaired_measured)
    text += fmt::format("{:<24}{:>10}  no partner\n", mode_name(b.data.modes[j], j),
                        significant(b.data.modes[j].frequency, 5));
  return text;
}

} // namespace

std::string mode_name(const MeasuredMode& mode, int index) {
  if (mode.shape == MeasuredShape::other) return "mode " + std::to_string(index + 1);
  std::string name = word_of(mode.shape);
  name += " " + std::to_string(mode.order);
  if (mode.direction && mode.shape != MeasuredShape::axial)
    name += std::string(" in ") + word_of(*mode.direction);
  return name;
}

std::string correlation_text(const Correlation& c, const TestData& a, const TestData& b) {
  std::string text =
      fmt::format("{} beside {}\n\n", a.data.source.empty() ? a.data.specimen : a.data.source,
                  b.data.source.empty() ? b.data.specimen : b.data.source);
  for (const ComparedNumber& n : c.numbers) {
    const auto [factor, unit] = shown_unit(n.measured, n.unit);
    text += fmt::format("{:<24}{:>10}{:>12}{:>9}{:>10}  {}\n", n.quantity,
                        significant(n.measured * factor, 4), significant(n.simulated * factor, 4),
                        with_sign(100 * (n.simulated / n.measured - 1), 1),
                        n.sigma ? with_sign((n.simulated - n.measured) / *n.sigma, 1) : "-", unit);
  }
  if (!c.numbers.empty()) text += "\n";
  text += pairs_text(c, a, b);
  if (!c.responses.empty()) {
    text += fmt::format("\n{:<20}{:<14}{:>8}{:>16}{:>8}{:>12}{:>14}\n", "response", "reference",
                        "level", "band Hz", "FRAC", "best FRAC", "at stretch %");
    for (const ComparedResponse& r : c.responses)
      text +=
          fmt::format("{:<20}{:<14}{:>8}{:>16}{:>8.3f}{:>12.3f}{:>14}\n", r.response, r.reference,
                      plain(r.level), significant(r.low, 3) + " to " + significant(r.high, 4),
                      r.frac, r.best_frac, with_sign(100 * r.stretch, 2));
    for (const ComparedLines& l : c.lines)
      text += fmt::format("{}: CSAC {:.3f}, CSF {:.3f} (means over the lines)\n", l.reference,
                          l.csac.mean(), l.csf.mean());
  }
  if (c.comac.size() > 0) {
    text += "\nCOMAC";
    for (Eigen::Index q = 0; q < c.comac.size(); ++q)
      text += fmt::format("  {} {:.3f}", c.channels[q], c.comac[q]);
    text += "\n";
  }
  for (const std::string& limit : c.limits) text += "What these data cannot tell: " + limit + ".\n";
  for (const TestData* side : {&a, &b})
    for (const std::string& warning : warnings_of(*side)) text += "Warning: " + warning + ".\n";
  return text;
}

} // namespace plica
