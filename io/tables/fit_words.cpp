#include "io/tables/fit_words.hpp"

#include "io/tables/text.hpp"
#include "io/tables/text_table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plica {
namespace {

std::string parameters_text(const FitResult& fit) {
  TextRows rows{{"parameter (SI)", "before", "after", "+/-"}};
  for (const FittedParameter& p : fit.parameters)
    rows.push_back({p.path, significant(p.start, 5), significant(p.value, 5),
                    p.sigma            ? significant(*p.sigma, 2)
                    : fit.aims.empty() ? "open"
                                       : "-",
                    p.at_bound ? "at its bound" : ""});
  for (const auto& [path, value, unit] : fit.ties)
    rows.push_back({path, "", significant(value, 5), "follows"});
  return text_table(rows, "<>>><");
}

// Responses, stiffness and limits say behind their numbers what these are.
std::string targets_text(const FitResult& fit) {
  TextRows rows{{"target", "test", "before", "after", "diff %", "sigma"}};
  for (const FittedTarget& t : fit.targets)
    rows.push_back({t.quantity + (t.held_out ? " (held out)"
                                  : t.goal   ? " (goal)"
                                             : ""),
                    significant(t.measured, 5), significant(t.start, 5), significant(t.value, 5),
                    with_sign(100 * (t.value / t.measured - 1), 2),
                    with_sign((t.value - t.measured) / t.sigma, 1)});
  for (const FittedResponse& r : fit.responses)
    rows.push_back({r.name, "", significant(r.start, 3) + " dB", significant(r.value, 3) + " dB",
                    "", "", fmt::format("RMS of {} lines", r.lines)});
  for (const FittedStiffness& s : fit.stiffness)
    rows.push_back({s.name + (s.held_out ? " (held out)" : ""), "",
                    significant(100 * s.start, 3) + " %", significant(100 * s.value, 3) + " %", "",
                    "", fmt::format("RMS of {} numbers, of the magnitude", s.numbers)});
  for (const FittedAim& a : fit.aims)
    rows.push_back({a.quantity + (a.least ? " (least)" : " (most)"), "", significant(a.start, 5),
                    significant(a.value, 5), with_sign(100 * (a.value / a.start - 1), 2)});
  for (const FittedConstraint& c : fit.constraints)
    rows.push_back(
        {c.name, "", "", significant(c.value, 5), "", "", "(" + constraint_limits(c) + ")"});
  return text_table(rows, "<>>>>><");
}

} // namespace

std::string constraint_limits(const FittedConstraint& c) {
  if (c.min && c.max) return fmt::format("{:.6g} to {:.6g}", *c.min, *c.max);
  return c.max ? fmt::format("at most {:.6g}", *c.max) : fmt::format("at least {:.6g}", *c.min);
}

std::string open_text(const OpenDirection& open) {
  std::string parts;
  for (const auto& [path, weight] : open.parts)
    parts += fmt::format("{}{} ({:.2f})", parts.empty() ? "" : " and ", path, weight);
  return fmt::format("{} {}: {:.2g} sigma over the whole range of the bounds",
                     open.parts.size() > 1 ? "a joint change of" : "a change of", parts,
                     open.effect);
}

std::string fit_text(const FitResult& fit) {
  std::string text =
      fmt::format("{} evaluations, half the sum of squares {} -> {}\n\n", fit.evaluations,
                  significant(fit.start_cost, 4), significant(fit.cost, 4)) +
      parameters_text(fit) + "\n" + targets_text(fit);
  if (!fit.open.empty()) text += "\nThe data leave open:\n";
  for (const OpenDirection& o : fit.open) text += "  " + open_text(o) + "\n";
  for (const std::string& w : fit.warnings) text += "warning: " + w + "\n";
  return text;
}

} // namespace plica
