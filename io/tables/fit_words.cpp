#include "io/tables/fit_words.hpp"

#include "io/tables/text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plica {

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
                  significant(fit.start_cost, 4), significant(fit.cost, 4));
  std::size_t width = 20;
  for (const FittedParameter& p : fit.parameters) width = std::max(width, p.path.size() + 2);
  for (const FittedTarget& t : fit.targets) width = std::max(width, t.quantity.size() + 13);
  text +=
      fmt::format("{:<{}}{:>12}{:>12}{:>11}\n", "parameter (SI)", width, "before", "after", "+/-");
  for (const FittedParameter& p : fit.parameters)
    text += fmt::format("{:<{}}{:>12}{:>12}{:>11}{}\n", p.path, width, significant(p.start, 5),
                        significant(p.value, 5),
                        p.sigma            ? significant(*p.sigma, 2)
                        : fit.aims.empty() ? "open"
                                           : "-",
                        p.at_bound ? "  at its bound" : "");
  for (const auto& [path, value, unit] : fit.ties)
    text += fmt::format("{:<{}}{:>12}{:>12}{:>11}\n", path, width, "", significant(value, 5),
                        "follows");
  text += fmt::format("\n{:<{}}{:>12}{:>12}{:>12}{:>9}{:>8}\n", "target", width, "test", "before",
                      "after", "diff %", "sigma");
  for (const FittedTarget& t : fit.targets)
    text += fmt::format("{:<{}}{:>12}{:>12}{:>12}{:>9}{:>8}\n",
                        t.quantity + (t.held_out ? " (held out)"
                                      : t.goal   ? " (goal)"
                                                 : ""),
                        width, significant(t.measured, 5), significant(t.start, 5),
                        significant(t.value, 5), with_sign(100 * (t.value / t.measured - 1), 2),
                        with_sign((t.value - t.measured) / t.sigma, 1));
  for (const FittedResponse& r : fit.responses)
    text += fmt::format("{:<{}}{:>12}{:>9} dB{:>9} dB  RMS of {} lines\n", r.name, width, "",
                        significant(r.start, 3), significant(r.value, 3), r.lines);
  for (const FittedStiffness& s : fit.stiffness)
    text += fmt::format("{:<{}}{:>12}{:>10} %{:>10} %  RMS of {} numbers, of the magnitude\n",
                        s.name + (s.held_out ? " (held out)" : ""), width, "",
                        significant(100 * s.start, 3), significant(100 * s.value, 3), s.numbers);
  for (const FittedAim& a : fit.aims)
    text += fmt::format("{:<{}}{:>12}{:>12}{:>12}{:>9}\n",
                        a.quantity + (a.least ? " (least)" : " (most)"), width, "",
                        significant(a.start, 5), significant(a.value, 5),
                        with_sign(100 * (a.value / a.start - 1), 2));
  for (const FittedConstraint& c : fit.constraints)
    text += fmt::format("{:<{}}{:>36}  ({})\n", c.name, width, significant(c.value, 5),
                        constraint_limits(c));
  if (!fit.open.empty()) text += "\nThe data leave open:\n";
  for (const OpenDirection& o : fit.open) text += "  " + open_text(o) + "\n";
  for (const std::string& w : fit.warnings) text += "warning: " + w + "\n";
  return text;
}

} // namespace plica
