// Fits made up for tests of the verdict.
#pragma once

#include "diagnose/judge/inclusion.hpp"
#include "diagnose/judge/judge.hpp"

#include <deque>

namespace plica {

// Fits by effect and evidence; the nominal case has evidence 0.
class Fits {
public:
  JudgedFit nominal(bool adequate) const {
    JudgedFit j;
    j.fit.solved = true;
    j.adequate = adequate;
    return j;
  }
  JudgedFit& add(const std::string& effect, double log_evidence, bool adequate = true,
                 const std::string& place = "here") {
    singles.push_back(fit_of({hypothesis(effect, place)}, log_evidence, adequate));
    return singles.back();
  }
  JudgedFit& add_set(const std::vector<std::string>& effects, double log_evidence,
                     bool adequate = true) {
    std::vector<const Hypothesis*> together;
    for (const std::string& effect : effects) together.push_back(hypothesis(effect, "here"));
    sets.push_back(fit_of(std::move(together), log_evidence, adequate));
    sets.back().held_out_met = true;
    sets.back().held_out_shrink = 0.5;
    return sets.back();
  }
  JudgedFit& add_pair(const std::string& a, const std::string& b, double log_evidence) {
    return add_set({a, b}, log_evidence);
  }
  Judgement judgement(bool nominal_adequate, const Referee& referee = {}) {
    nominal_ = nominal(nominal_adequate);
    effects_ = fits_by_effect(singles);
    return judge(nominal_, effects_, sets, Inclusion(nominal_, singles, sets), {}, referee);
  }
  // Fits of ten readings that leave this gap each, as log evidences are without their dispersion.
  Judgement judgement_of_gaps(double nominal_gap, const Referee& referee = {}) {
    nominal_ = nominal(false);
    leave(nominal_, nominal_gap);
    effects_ = fits_by_effect(singles);
    return judge(nominal_, effects_, sets, Inclusion(nominal_, singles, sets), {}, referee);
  }
  static void leave(JudgedFit& j, double gap) {
    constexpr int readings = 10;
    j.gap_after = gap;
    j.fit.error = Eigen::VectorXd::Constant(readings, gap);
    j.fit.J = Eigen::MatrixXd::Zero(readings, j.fit.z.size());
    j.fit.chi2 = j.fit.error.squaredNorm();
    j.readings = readings;
    j.fit.log_evidence = -j.fit.chi2 / 2;
  }
  JudgedFit& add_gap(const std::string& effect, double gap, const std::string& place = "here") {
    leave(add(effect, 0, false, place), gap);
    return singles.back();
  }

  // The hypothesis that came last, of a set its last member, sits there.
  void move_last(const std::string& place) { hypotheses_.back().place = place; }
  // It names a place and no cause.
  void leave_cause_open() { hypotheses_.back().names_place_only = true; }

  std::vector<JudgedFit> singles, sets;

private:
  const Hypothesis* hypothesis(const std::string& effect, const std::string& place) {
    hypotheses_.emplace_back();
    hypotheses_.back().effect = effect;
    hypotheses_.back().place = place;
    return &hypotheses_.back();
  }
  static JudgedFit fit_of(std::vector<const Hypothesis*> together, double log_evidence,
                          bool adequate) {
    JudgedFit j;
    j.fit.together = std::move(together);
    j.fit.solved = true;
    j.fit.log_evidence = log_evidence;
    j.log_bayes_factor = log_evidence;
    j.adequate = adequate;
    return j;
  }
  std::deque<Hypothesis> hypotheses_;
  JudgedFit nominal_;
  std::vector<EffectFits> effects_;
};

inline double probability(const Judgement& j, const std::string& effect) {
  for (const auto& [name, p] : j.probabilities)
    if (name == effect) return p;
  return 0;
}

} // namespace plica
