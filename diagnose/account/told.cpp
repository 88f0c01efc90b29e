#include "diagnose/account/told.hpp"

#include "diagnose/account/shrink.hpp"

namespace plica {
namespace {

std::vector<HypothesisFit> fits_of(const FitContext& context, const Judgement& judgement,
                                   int particles) {
  if (judgement.sampled) return {*judgement.sampled};
  std::vector<const JudgedFit*> chosen = judgement.named;
  if (chosen.empty() && judgement.nearest) chosen.push_back(judgement.nearest);
  std::vector<HypothesisFit> fits;
  for (const JudgedFit* j : chosen) fits.push_back(j->fit);
  if (judgement.names_sets() || judgement.verdict == Verdict::mostly ||
      judgement.verdict == Verdict::unknown)
    for (HypothesisFit& fit : fits) sample(context, fit, particles, 1, dispersion(fit));
  return fits;
}

// Asked for before the verdict where it rests on them.
GapShrink taken_in_turn(const FitContext& context, const HypothesisFit& nominal,
                        const HypothesisFit& best, const Judgement& judgement) {
  if (judgement.in_turn && !judgement.named.empty()) {
    const HypothesisFit& asked = judgement.named.front()->fit;
    if (asked.together == best.together && asked.z == best.z) return *judgement.in_turn;
  }
  return in_turn(context, nominal, best);
}

} // namespace

Told told_of(GapProblem& problem, const JudgedFit& nominal, const std::vector<EffectFits>& ranked,
             const Judgement& judgement, int particles) {
  const FitContext context = problem.context();
  const JudgedFit* first = &judgement.told(nominal);
  Told told{.fits = fits_of(context, judgement, particles),
            .first = first,
            .best = {},
            .second = {},
            .resonator = {},
            .in_turn = {},
            .drifts = {}};
  told.best = told.fits.empty() ? first->fit : told.fits.front();
  complete(context, told.best);
  for (const EffectFits& f : ranked)
    if (f.best != first) {
      told.second = f.best->fit;
      complete(context, *told.second);
      break;
    }
  if (judgement.resonator) {
    told.resonator = judgement.resonator->fit;
    sample(context, *told.resonator, particles, 1, dispersion(*told.resonator));
  }
  constexpr std::size_t enough = 3; // readings, to take one in turn
  if (problem.held_out->rows().empty() && problem.fitted->rows().size() >= enough &&
      !told.best.together.empty())
    told.in_turn = taken_in_turn(context, nominal.fit, told.best, judgement);
  if (told.best.together.size() == 1) told.drifts = drifts(context, told.best);
  return told;
}

} // namespace plica
