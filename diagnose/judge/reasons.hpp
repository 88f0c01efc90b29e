// Why what leads must not be named, of numbers that were solved for it (objections.hpp): the rules
// that compare them with thresholds, in words. Empty = nothing speaks against it.
#pragma once

#include "diagnose/judge/judge.hpp"

namespace plica {

// Readings foretold by what leads: those that were held out, or each in turn.
std::string held_out_no_better(const GapShrink& shrink);
std::string in_turn_no_better(const GapShrink& shrink);
// The same of what would explain all of so many readings: too few of them are but a warning.
Objection foretells(const JudgedFit& leads, const GapShrink& in_turn, std::size_t readings);

// The lower end of what it closes is less than half; `where`: " where ...", to say so of.
std::string closes_too_little(const Ledger& ledger, const std::string& where = "");
// Where nothing explains the test, an effect that closes little may do so by what the others are
// off. `ledger`: of the members of the fit, in their order.
Objection members_of_little(const Ledger& ledger, const HypothesisFit& fit);
// Effects that each open a gap for the other to close are known by their difference, which errors
// of the model make as well. `shares`: of the gap, of each effect.
std::string cancel(const Eigen::VectorXd& shares);

// Whether an effect is such a factor itself, or where a drawing may be as wrong, which beside a
// baseline it may not, on a whole part.
bool is_like(const Compensator& c, const HypothesisFit& fit, bool beside_baseline);
// One factor on everything that would leave no more of the gap.
std::string imitated(const JudgedFit& leads, const std::vector<Compensator>& tempting,
                     bool beside_baseline);

// A mass on a spring of its own, last in `resonator`, that is worth so many nats more than what
// leads, can be told from the readings, and resonates among the frequencies that were measured
// (`band`, Hz; none = all do): below these it is a spring, above them a mass, for all that is
// known.
bool resonator_explains(const JudgedFit& leads, const JudgedFit& resonator,
                        const std::optional<std::array<double, 2>>& band, double nats_more);
// "15 g on a spring of its own, which resonates at 805 Hz, at bellows.convolution[3]"
std::string words_of_last(const HypothesisFit& with_resonator);

// What explains the test closes half of its gap at least: errors may be smaller than they are
// stated, and then what is adequate leaves room for the cause.
std::string closes_less_than_half(const JudgedFit& leads, double gap_before);
// Beside a baseline an effect may be off by what it changes, so that much may remain of the gap.
std::string leaves_of_the_change(const JudgedFit& leads, double gap_before);

} // namespace plica
