// The verdict, by rules that are fixed before a test is seen. Thresholds come from healthy
// specimens.
//
//   adequate    chi2 of all readings, and of their means over the levels, at most that of 99 % of
//               healthy specimens, no block beyond its 99.95 %; without what the hypothesis is
//               allowed to be off (evidence.hpp), which carries laws of slip, a gap of 1.5
//               Nothing is listed whose parameters all stay at their priors
//   none        the nominal case is adequate and no effect has ln BF above the threshold; or no
//               effect comes nearer than it, and mounting anew alone may have made the change
//   several     a set is adequate, with 5 more than the best smaller one, or 7 where a smaller one
//               is adequate (among so many effects some nats turn up by chance), each member worth
//               3, held-out readings met and better by three tenths, or where nothing is held out
//               readings in turn (the interval of their shrink above zero), and three readings for
//               each free parameter; with it all sets of the same effects elsewhere within 5 of it
//               that are as adequate, whether or not held-out readings speak for them. Where such
//               sets are of different effects nothing says what acts beside what they share: up to
//               three of them are ambiguous, of more what they share is asked about as mostly.
//               Where the law of something that slips is allowed to be off by a tenth of the gap,
//               that may be what else acts: mostly, with what closes as much
//   identified  best effect adequate, ln BF above the threshold over the nominal case and 5 over
//               every other adequate effect, no parameter beyond |z| = 3, held-out readings met.
//               What is beyond |z| = 3 can be no cause that is sure, but has to be told apart
//   ambiguous   several adequate effects within that of the best, up to three of them, or all that
//               are within 3; or what would be identified has as many free parameters as there are
//               fitted readings, closes less than half of the gap, foretells readings taken in
//               turn no better than no effect does, leaves more than nine of ten healthy specimens
//               do, or is within 5 of what is as adequate and closes nothing, or within 3 of a set
//               without it at its place: then up to three effects within 8 of it. Or sets of
//               different effects that explain the test alike, of which what they share is no more
//               than 0.85 sure, or the best leaves more than nine of ten healthy specimens do, or
//               its effects cancel: some of them open ten times the gap, which the others close, or
//               what hangs on a spring of its own explains far more (5 nats) in place of one, or of
//               a fixture that would be identified. A
//               parameter is free where its posterior is narrower than half its prior, or a move
//               within the prior changes a reading by a tenth of its standard deviation. Of a list
//               none is sure: 5 nats are odds of nine to one
//   mostly      nothing adequate; effects of a probability of 0.9 each (inclusion.hpp) close at
//               least half of the gap, the lower end of the interval counts, with no parameter
//               beyond |z| = 3, three readings for each free parameter, and held-out readings
//               better by three tenths, these or readings in turn with an interval above zero; the
//               half is closed, too, where one effect more may act beside them, and of several
//               each closes a tenth: what is left without the others is asked about; and nothing
//               that hangs on a spring of its own, and resonates among the frequencies that were
//               measured, explains as much (within 3 nats), which is no effect here. What would
//               be identified, or several, is mostly where an effect of it names a place and no
//               cause (Hypothesis::names_place_only)
//   unknown     everything else; probabilities are then no more than the share that what comes
//               nearest closes, half of it where that failed a test of its own
#pragma once

#include "diagnose/judge/inclusion.hpp"
#include "diagnose/judge/judgement.hpp"

#include <functional>

namespace plica {

// Why a fit that leads must not be named; empty = it may.
struct Objection {
  std::string why;
  std::optional<GapShrink> in_turn = {};     // where it was asked for
  std::optional<HypothesisFit> sampled = {}; // the fit with draws at its dispersion, where it was
  std::vector<const Hypothesis*> small = {}; // members that close too little to be named
  std::string warning = {};                  // no objection, but the user is told
  std::optional<JudgedFit> resonator = {};   // what explains as much, where that is why
};
using Objecting = std::function<Objection(const JudgedFit&)>;

// What takes time is asked of those only that it is needed of. Left out: nobody objects.
struct Referee {
  Objecting to_all = {};  // to an effect that would explain all
  Objecting to_sets = {}; // to effects that would together
  Objecting to_most = {}; // to effects that would explain most
  // That mounting anew alone may have made the change, by as much as is not excluded.
  bool mounted_anew = false;
};

// Of what was tried until the search was stopped: unknown, with what comes nearest and even odds of
// it at most.
Judgement nearest_so_far(const JudgedFit& nominal, const Inclusion& inclusion);

Judgement judge(const JudgedFit& nominal, const std::vector<EffectFits>& effects,
                const std::vector<JudgedFit>& sets, const Inclusion& inclusion,
                const Standards& standards, const Referee& referee = {});

} // namespace plica
