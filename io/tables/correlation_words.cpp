#include "io/tables/correlation_words.hpp"

#include "io/tables/text.hpp"
#include "io/tables/text_table.hpp"
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
  TextRows rows{{"test mode", "test Hz", "simul. Hz", "diff %", "in sigma", "damping %", "simul. %",
                 "MAC", "paired by"}};
  for (const PairedMode& p : c.pairs) {
    const MeasuredMode &s = a.data.modes[p.simulated], &t = b.data.modes[p.measured];
    const auto in_percent = [](const std::optional<double>& x) {
      return x ? significant(100 * *x, 3) : std::string("-");
    };
    rows.push_back({mode_name(t, p.measured), significant(t.frequency, 5),
                    significant(s.frequency, 5), percent(p.frequency_error),
                    p.frequency_sigmas ? with_sign(*p.frequency_sigmas, 1) : "-",
                    in_percent(t.damping), in_percent(s.damping), plain(p.mac), p.by});
  }
  for (const int j : c.unpaired_measured)
    rows.push_back({mode_name(b.data.modes[j], j), significant(b.data.modes[j].frequency, 5), "",
                    "", "", "", "", "", "no partner"});
  return text_table(rows, "<>>>>>>><");
}

std::string numbers_text(const Correlation& c) {
  if (c.numbers.empty()) return "";
  TextRows rows{{"", "test", "simul.", "diff %", "in sigma", "unit"}};
  for (const ComparedNumber& n : c.numbers) {
    const auto [factor, unit] = shown_unit(n.measured, n.unit);
    rows.push_back({n.quantity, significant(n.measured * factor, 4),
                    significant(n.simulated * factor, 4),
                    with_sign(100 * (n.simulated / n.measured - 1), 1),
                    n.sigma ? with_sign((n.simulated - n.measured) / *n.sigma, 1) : "-", unit});
  }
  return text_table(rows, "<>>>><") + "\n";
}

std::string responses_text(const Correlation& c) {
  if (c.responses.empty()) return "";
  TextRows rows{{"response", "reference", "level", "band Hz", "FRAC", "best FRAC", "at stretch %"}};
  for (const ComparedResponse& r : c.responses)
    rows.push_back({r.response, r.reference, plain(r.level),
                    significant(r.low, 3) + " to " + significant(r.high, 4),
                    fmt::format("{:.3f}", r.frac), fmt::format("{:.3f}", r.best_frac),
                    with_sign(100 * r.stretch, 2)});
  std::string text = "\n" + text_table(rows, "<<>");
  for (const ComparedLines& l : c.lines)
    text += fmt::format("{}: CSAC {:.3f}, CSF {:.3f} (means over the lines)\n", l.reference,
                        l.csac.mean(), l.csf.mean());
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
  text += numbers_text(c) + pairs_text(c, a, b) + responses_text(c);
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
