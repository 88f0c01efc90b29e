#include "diagnose/resonating.hpp"

#include "diagnose/judge/places_fitted.hpp"
#include "diagnose/judge/reasons.hpp"
#include "diagnose/results/stage_share.hpp"
#include "solve/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

bool is_better(const JudgedFit& a, const JudgedFit& b) {
  return dispersed_log_evidence(a.fit) > dispersed_log_evidence(b.fit);
}

// Those that were solved, the best first.
void sort_solved(std::vector<JudgedFit>& fits) {
  std::erase_if(fits, [](const JudgedFit& j) { return !j.fit.solved; });
  std::stable_sort(fits.begin(), fits.end(), is_better);
}

// Frequencies that were measured, Hz: the lowest and the highest; none = no frequency was.
std::optional<std::array<double, 2>> measured_band(const TestReadings& test) {
  std::optional<std::array<double, 2>> band;
  for (const Reading& r : test.readings) {
    if (r.held_out || r.kind != ReadingKind::frequency) continue;
    const double hertz = std::exp(r.log_value);
    if (!band) band = {hertz, hertz};
    band = {std::min((*band)[0], hertz), std::max((*band)[1], hertz)};
  }
  return band;
}

} // namespace

JudgedFit Resonating::judged_fit(const std::vector<const Hypothesis*>& together,
                                 const VectorXd& start) const {
  if (search_.settings.stop()) return {};
  return judged(fit_of(search_.context, together, start), plain_, search_.context, search_.held_out,
                search_.scores, search_.standards);
}

void Resonating::fit_alone() {
  if (fitted_) return;
  fitted_ = true;
  search_.settings.stage("what may hang on springs", share::ledger);
  hypotheses_ = list_();
  reduce_each(search_.context, looked_at(hypotheses_));
  std::vector<const Hypothesis*> all;
  for (const Hypothesis& h : hypotheses_) all.push_back(&h);
  alone_ =
      fit_places(search_.context, all, [&](const Hypothesis& h) { return judged_fit({&h}); }).fits;
  sort_solved(alone_);
}

std::vector<JudgedFit> Resonating::beside_others_of(const HypothesisFit& lead) const {
  constexpr std::size_t most = 3; // resonators that are tried beside others
  const std::size_t members = lead.together.size();
  if (members < 2) return {};
  std::vector<JudgedFit> fits(std::min(most, alone_.size()) * members);
  in_parallel(int(fits.size()), [&](int i) {
    const HypothesisFit& own = alone_[std::size_t(i) / members].fit;
    std::vector<const Hypothesis*> together;
    VectorXd z(0);
    const auto join = [&](const Hypothesis* h, const VectorXd& coordinates) {
      together.push_back(h);
      z.conservativeResize(z.size() + coordinates.size());
      z.tail(coordinates.size()) = coordinates;
    };
    for (std::size_t k = 0; k < members; ++k)
      if (k != std::size_t(i) % members)
        join(lead.together[k],
             lead.z.segment(lead.first_of(k), Index(lead.together[k]->parameters.size())));
    join(own.together.front(), own.z); // last: it is tried larger, smaller and elsewhere
    fits[std::size_t(i)] = judged_fit(together, z);
  });
  sort_solved(fits);
  return fits;
}

std::optional<JudgedFit> Resonating::instead_of(const JudgedFit& leads, double nats_more) {
  fit_alone();
  if (search_.settings.stop()) return {};
  const auto band = measured_band(search_.context.test);
  const auto first_of = [&](std::vector<JudgedFit>& sorted) {
    return std::find_if(sorted.begin(), sorted.end(), [&](const JudgedFit& own) {
      return resonator_explains(leads, own, band, nats_more);
    });
  };
  std::vector<JudgedFit> beside = beside_others_of(leads.fit);
  const auto alone = first_of(alone_), other = first_of(beside);
  if (other != beside.end() && (alone == alone_.end() || is_better(*other, *alone)))
    return std::move(*other);
  return alone == alone_.end() ? std::optional<JudgedFit>{} : *alone;
}

} // namespace plica
