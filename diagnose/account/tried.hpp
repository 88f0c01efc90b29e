// What was tried: each effect at its best place, and each set, with what it is worth and why it is
// not the cause.
#pragma once

#include "diagnose/account/findings.hpp"
#include "diagnose/account/named_effects.hpp"

namespace plica {

// Which gate of the verdict (judge.hpp) a fit does not pass, in words; empty: it passes all. Of one
// that is not adequate the first of its parts that is too far off.
std::string why_rejected(const JudgedFit& j, const Standards& limit);

struct Tried {
  std::vector<TriedHypothesis> all; // by evidence, the nominal case among them
  std::optional<std::size_t> best;  // which of them the account is of; none of the nominal case
};
// `best`: the fit that the account is of, or the nominal case.
Tried tried(const GapProblem& problem, const Findings& found, const NamedEffects& names,
            const JudgedFit& best);

} // namespace plica
