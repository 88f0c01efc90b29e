#include "diagnose/judge/reasons.hpp"

#include "diagnose/effects/resonators.hpp"
#include "diagnose/judge/thresholds.hpp"
#include "diagnose/weigh/fit_words.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace plica {
namespace {

std::string no_better(const char* how, const GapShrink& g) {
  if (g.is_sure()) return "";
  return fmt::format("{}readings are foretold no better with it (shrink {:.0f} % [{:.0f}, {:.0f}])",
                     how, 100 * g.shrink(), 100 * g.interval[0], 100 * g.interval[1]);
}

// Values of what comes last in a fit.
Eigen::VectorXd values_of_last(const HypothesisFit& fit) {
  return fit.values.tail(fit.values.size() - fit.first_of(fit.together.size() - 1));
}

} // namespace

std::string held_out_no_better(const GapShrink& shrink) {
  return no_better("held-out ", shrink);
}

std::string in_turn_no_better(const GapShrink& shrink) {
  return no_better("taken in turn, ", shrink);
}

Objection foretells(const JudgedFit& leads, const GapShrink& in_turn, std::size_t readings) {
  constexpr std::size_t fewest = 4;
  Objection found{.why = in_turn_no_better(in_turn), .in_turn = in_turn};
  if (found.why.empty() || readings >= fewest) return found;
  found.warning = name_of(leads.fit) + ": " + found.why;
  found.why.clear();
  return found;
}

std::string closes_too_little(const Ledger& ledger, const std::string& where) {
  if (ledger.explained_interval[0] >= threshold::most_closed) return "";
  return fmt::format("it closes {:.0f} % of the gap [{:.0f}, {:.0f}]{}", 100 * ledger.explained,
                     100 * ledger.explained_interval[0], 100 * ledger.explained_interval[1], where);
}

Objection members_of_little(const Ledger& ledger, const HypothesisFit& fit) {
  Objection found;
  if (fit.together.size() < 2) return found;
  for (std::size_t i = 0; i < fit.together.size(); ++i)
    if (ledger.rows[i].share < threshold::least_closed) {
      found.why = fmt::format("{} at {} closes {:.1f} % of the gap only", fit.together[i]->effect,
                              fit.together[i]->place, 100 * ledger.rows[i].share);
      found.small.push_back(fit.together[i]);
    }
  if (found.small.size() == fit.together.size()) found.small.clear();
  return found;
}

std::string cancel(const Eigen::VectorXd& shares) {
  double opened = 0;
  for (double share : shares) opened -= std::min(0., share);
  if (opened <= threshold::most_opened) return "";
  return fmt::format("the effects cancel: some open {:.1f} times the gap, which the others close",
                     opened);
}

bool is_like(const Compensator& c, const HypothesisFit& fit, bool beside_baseline) {
  struct Like {
    FreeFactor factor;
    const char* effect;
    bool drawn; // may be as wrong on a drawing
  };
  static constexpr Like all[] = {{FreeFactor::damping, "damping", false},
                                 {FreeFactor::modulus, "temperature", false},
                                 {FreeFactor::modulus, "ply_slip", true},
                                 {FreeFactor::modulus, "component_stiffness", true},
                                 {FreeFactor::modulus, "forming_thinning", true},
                                 {FreeFactor::density, "unweighed_mass", true}};
  return std::any_of(std::begin(all), std::end(all), [&](const Like& like) {
    return like.factor == c.on && !(like.drawn && beside_baseline) &&
           std::any_of(fit.together.begin(), fit.together.end(),
                       [&](const Hypothesis* h) { return h->effect == like.effect; });
  });
}

std::string imitated(const JudgedFit& leads, const std::vector<Compensator>& tempting,
                     bool beside_baseline) {
  for (const Compensator& c : tempting)
    if (c.gap_after < threshold::one_factor * leads.gap_after &&
        !is_like(c, leads.fit, beside_baseline))
      return fmt::format("{} times {:.3g} would leave no more of the gap ({:.2g}, {:.2g} with it)",
                         c.name, c.factor, c.gap_after, leads.gap_after);
  return "";
}

bool resonator_explains(const JudgedFit& leads, const JudgedFit& resonator,
                        const std::optional<std::array<double, 2>>& band, double nats_more) {
  const double more = dispersed_log_evidence(resonator.fit) - dispersed_log_evidence(leads.fit);
  if (more < nats_more || resonator.absurd || resonator.fails_held_out ||
      !resonator.saturated().empty())
    return false;
  constexpr Eigen::Index frequency = 1; // among its parameters
  const double own = values_of_last(resonator.fit)[frequency];
  return !band || (own >= (*band)[0] && own <= (*band)[1]);
}

std::string words_of_last(const HypothesisFit& with_resonator) {
  return words_of_resonator(*with_resonator.together.back(), values_of_last(with_resonator));
}

std::string closes_less_than_half(const JudgedFit& leads, double gap_before) {
  const double closed = 1 - std::pow(leads.gap_after / gap_before, 2);
  if (closed >= threshold::most_closed) return "";
  return fmt::format("it closes {:.0f} % of the gap", 100 * closed);
}

std::string leaves_of_the_change(const JudgedFit& leads, double gap_before) {
  if (leads.gap_after < threshold::most_allowed ||
      leads.gap_after < threshold::part_left * gap_before)
    return "";
  return fmt::format("it leaves {:.0f} % of the change", 100 * leads.gap_after / gap_before);
}

} // namespace plica
