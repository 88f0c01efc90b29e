#include "diagnose/judge/sets.hpp"

#include "diagnose/judge/added_up.hpp"
#include "diagnose/judge/matched_gain.hpp"
#include "diagnose/judge/places_fitted.hpp"
#include "diagnose/judge/thresholds.hpp"
#include "diagnose/results/stage_share.hpp"
#include "diagnose/weigh/twins.hpp"

#include "solve/parallel.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <map>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Together = std::vector<const Hypothesis*>;

constexpr std::size_t most_effects = 5;
constexpr std::size_t grown_sets = 3;                   // of each size
constexpr std::size_t moved_sets = 3, other_places = 3; // of each size; for one member
constexpr double worth_growing = 2;                     // nats, of one effect more
constexpr std::size_t few = 6; // effects that are tried beside a set that leads, or in place of one

struct Asked {
  Together together;
  VectorXd start;
};

// Coordinates of one member.
VectorXd part_of(const HypothesisFit& fit, std::size_t member) {
  return fit.z.segment(fit.first_of(member), Index(fit.together[member]->parameters.size()));
}

VectorXd joined(const std::vector<VectorXd>& parts) {
  Index size = 0, first = 0;
  for (const VectorXd& part : parts) size += part.size();
  VectorXd all(size);
  for (const VectorXd& part : parts) {
    all.segment(first, part.size()) = part;
    first += part.size();
  }
  return all;
}

bool contains(const Together& together, const Hypothesis* h) {
  return std::find(together.begin(), together.end(), h) != together.end();
}

class Growth {
public:
  explicit Growth(const SetSearch& search)
      : context_(search.context), ranked_(search.ranked), fits_(search.fits), all_(search.all),
        nominal_(search.nominal), held_out_(search.held_out), scores_(search.scores),
        standards_(search.standards), settings_(search.settings),
        levels_matter_(changes_with_level(context_.test)) {}

  std::vector<JudgedFit> sets() {
    std::vector<JudgedFit> front;
    for (std::size_t i = 0; i < std::min(grown_sets, ranked_.size()); ++i)
      if (ranked_[i].best->log_bayes_factor >= 1) front.push_back(*ranked_[i].best);
    std::vector<JudgedFit> found;
    const bool explained = grow(std::move(front), found);
    exchange(found);
    refine(found);
    solve_anew(found);
    // What explained the test while changes were added up may not do so solved anew.
    if (explained && std::none_of(found.begin(), found.end(), explains)) {
      grow(of_different_effects(found, grown_sets), found);
      exchange(found);
      refine(found);
    }
    return found;
  }

  std::vector<JudgedFit> beside(const JudgedFit& lead) {
    constexpr double hint = 0.5; // nats
    begins_ = ends_;             // all sizes lie behind
    add_up_no_more();
    std::vector<Asked> asked;
    for (const auto& [own, h] : asked_for(lead.fit, few))
      if (own > hint) add_joined(lead.fit, *h, asked);
    return fitted(asked);
  }

private:
  static bool explains(const JudgedFit& j) { return j.credible(); }
  std::size_t readings() const { return context_.fitted.rows().size(); }
  // Of so many effects, each of one free parameter: with fewer readings they are too free.
  bool carry(std::size_t effects) const {
    return readings() >= effects * std::size_t(threshold::readings_each);
  }

  // Adds sets of one effect more to those found, from the front on and then from the best of them,
  // until one explains the test and asks for no more (true) or one more is worth too little.
  bool grow(std::vector<JudgedFit> front, std::vector<JudgedFit>& found) {
    while (!front.empty() && !settings_.stop()) {
      const std::size_t size = front.front().fit.together.size() + 1;
      if (size > most_effects || size >= readings() || (size > 2 && !carry(size))) break;
      begin_size(size);
      const double before = dispersed_log_evidence(front.front().fit);
      std::vector<JudgedFit> level = fitted(larger(front));
      add(level, fitted(moved(level)));
      if (size > 2 && !level.empty()) add(found, fitted(smaller(level.front().fit)));
      add(found, level);
      const auto explains_all = [&](const JudgedFit& j) {
        return explains(j) && worth_of_one_more(j.fit, all_) < threshold::beyond_chance;
      };
      if (std::any_of(level.begin(), level.end(), explains_all)) return true;
      if (level.empty()) break;
      // Two of three may do little without the third, where the readings carry three.
      if (!(size == 2 && carry(3)) &&
          dispersed_log_evidence(level.front().fit) < before + worth_growing)
        break;
      front = of_different_effects(level, grown_sets);
    }
    return false;
  }

  void begin_size(std::size_t size) {
    const double each = (share::ledger - share::sets) / double(most_effects - 1);
    begins_ = std::max(begins_, share::sets + each * double(size - 2)); // sizes may come again
    ends_ = std::max(begins_, share::sets + each * double(size - 1));
    settings_.stage(fmt::format("sets of {} effects", size), begins_);
  }

  static void sort(std::vector<JudgedFit>& sets) {
    std::stable_sort(sets.begin(), sets.end(), [](const JudgedFit& a, const JudgedFit& b) {
      return a.fit.log_evidence > b.fit.log_evidence;
    });
  }

  static void add(std::vector<JudgedFit>& to, std::vector<JudgedFit> more) {
    for (JudgedFit& j : more) to.push_back(std::move(j));
    sort(to);
  }

  // Whether this set was not asked for before; it is from now on.
  bool is_new(Together together) {
    std::sort(together.begin(), together.end());
    if (std::find(asked_.begin(), asked_.end(), together) != asked_.end()) return false;
    asked_.push_back(std::move(together));
    return true;
  }

  bool is_fitted_alone(const Hypothesis& h) const {
    return std::any_of(fits_.begin(), fits_.end(),
                       [&](const JudgedFit& j) { return j.fit.together[0] == &h; });
  }

  // What names a place only, or lies between places, is asked for where it was worth a fit of its
  // own.
  bool may_join(const Together& set, const Hypothesis& h) const {
    return may_act_beside(set, h) &&
           (!(h.names_place_only || !h.between.empty()) || is_fitted_alone(h));
  }

  bool may_act_beside(const Together& set, const Hypothesis& h) const {
    bool softens = false;
    for (const Hypothesis* own : set) {
      softens = softens || own->softening;
      if (own->effect == h.effect && own->place == h.place && !may_be_twin(h, set)) return false;
      if (std::any_of(own->released.begin(), own->released.end(), [&](int node) {
            return std::find(h.released.begin(), h.released.end(), node) != h.released.end();
          }))
        return false; // an end is let go once
    }
    return !h.softening || (levels_matter_ && !softens);
  }

  // Each set with every effect at the place that its residual asks for, and where it is best alone;
  // with `most` of either.
  std::vector<Asked> larger(const std::vector<JudgedFit>& sets, std::size_t most = 1000) {
    std::vector<Asked> asked;
    for (const JudgedFit& j : sets) {
      for (const auto& [own, h] : asked_for(j.fit, most)) add_joined(j.fit, *h, asked);
      for (std::size_t i = 0; i < std::min(most, ranked_.size()); ++i)
        if (const Hypothesis& h = *ranked_[i].best->fit.together[0]; may_join(j.fit.together, h))
          add_joined(j.fit, h, asked);
    }
    return asked;
  }

  // Of each effect the place that the residual of a set asks for, with what it would be worth; the
  // most first.
  std::vector<std::pair<double, const Hypothesis*>> asked_for(const HypothesisFit& set,
                                                              std::size_t most) const {
    std::map<std::string, std::pair<double, const Hypothesis*>> best;
    for (const Signature& s : all_) {
      if (s.g.norm() < silent || !may_join(set.together, *s.hypothesis)) continue;
      const double own = gain_beside(set, s);
      auto& of_effect = best[s.hypothesis->effect];
      if (!of_effect.second || own > of_effect.first) of_effect = {own, s.hypothesis};
    }
    std::vector<std::pair<double, const Hypothesis*>> found;
    for (const auto& [effect, of_effect] : best) found.push_back(of_effect);
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    if (found.size() > most) found.resize(most);
    return found;
  }

  void add_joined(const HypothesisFit& set, const Hypothesis& h, std::vector<Asked>& asked) {
    Together together = set.together;
    together.push_back(&h);
    if (is_new(together))
      asked.push_back({together, joined({set.z, VectorXd::Zero(Index(h.parameters.size()))})});
  }

  // The best sets of different effects with one member at the places that come next.
  std::vector<Asked> moved(const std::vector<JudgedFit>& sets) {
    std::vector<Asked> asked;
    for (const JudgedFit& best : of_different_effects(sets, moved_sets)) {
      const HypothesisFit& set = best.fit;
      for (std::size_t member = 0; member < set.together.size(); ++member) {
        Together rest = set.together;
        rest.erase(rest.begin() + Index(member));
        std::vector<const HypothesisFit*> others;
        for (const JudgedFit& j : fits_)
          if (const Hypothesis* h = j.fit.together[0]; h->effect == set.together[member]->effect &&
                                                       !contains(set.together, h) &&
                                                       may_join(rest, *h))
            others.push_back(&j.fit);
        std::stable_sort(others.begin(), others.end(), [](const auto* a, const auto* b) {
          return a->log_evidence > b->log_evidence;
        });
        if (others.size() > other_places) others.resize(other_places);
        for (const HypothesisFit* other : others) {
          Together together = set.together;
          std::vector<VectorXd> start;
          for (std::size_t k = 0; k < together.size(); ++k)
            start.push_back(k == member ? other->z : part_of(set, k));
          together[member] = other->together[0];
          if (is_new(together)) asked.push_back({together, joined(start)});
        }
      }
    }
    return asked;
  }

  // A set without each of its members in turn.
  std::vector<Asked> smaller(const HypothesisFit& set) {
    std::vector<Asked> asked;
    for (std::size_t out = 0; out < set.together.size(); ++out) {
      Asked rest;
      std::vector<VectorXd> start;
      for (std::size_t k = 0; k < set.together.size(); ++k)
        if (k != out) {
          rest.together.push_back(set.together[k]);
          start.push_back(part_of(set, k));
        }
      rest.start = joined(start);
      if (is_new(rest.together)) asked.push_back(std::move(rest));
    }
    return asked;
  }

  // The best set with each member in turn given up for the effects that the rest asks for most, or
  // that are best alone.
  void exchange(std::vector<JudgedFit>& found) {
    sort(found);
    if (found.empty() || settings_.stop()) return;
    const Together best = best_of(found).fit.together;
    if (best.size() > 2) add(found, fitted(smaller(best_of(found).fit)));
    std::vector<JudgedFit> rests;
    for (const Hypothesis* out : best) {
      Together rest = best;
      rest.erase(std::find(rest.begin(), rest.end(), out));
      const auto take = [&](const std::vector<JudgedFit>& fits) {
        std::copy_if(fits.begin(), fits.end(), std::back_inserter(rests),
                     [&](const JudgedFit& j) { return is_of(j.fit, rest); });
      };
      take(fits_);
      take(found);
    }
    add(found, fitted(larger(rests, few)));
  }

  // The best sets of different effects with each member at the places next to its own that lie
  // between others, where these are better once more. What a single effect outdoes is left as it
  // is.
  void refine(std::vector<JudgedFit>& found) {
    constexpr int rounds = 2;
    for (int round = 0; round < rounds && !found.empty() && !settings_.stop(); ++round) {
      if (best_of(found).fit.log_evidence < ranked_.front().best->fit.log_evidence) return;
      std::vector<Asked> asked;
      for (const JudgedFit& best : of_different_effects(found, moved_sets))
        add_next_places(best.fit, asked);
      if (asked.empty()) return;
      add(found, fitted(asked));
    }
  }

  void add_next_places(const HypothesisFit& set, std::vector<Asked>& asked) {
    for (std::size_t member = 0; member < set.together.size(); ++member) {
      const Hypothesis& own = *set.together[member];
      const Together rest = without(set.together, {&own});
      Together together = set.together;
      for (const Signature& s : all_) {
        if (!lie_next(own, *s.hypothesis) || !may_act_beside(rest, *s.hypothesis)) continue;
        together[member] = s.hypothesis;
        if (is_new(together)) asked.push_back({together, set.z});
      }
    }
  }

  // The sets that may count once more, with what their members do to each other: so far their
  // changes were added up.
  void solve_anew(std::vector<JudgedFit>& found) {
    if (found.empty() || settings_.stop()) return;
    const double best = best_of(found).fit.log_evidence;
    const auto count = std::min<std::ptrdiff_t>(
        most_solved_anew, std::find_if(found.begin(), found.end(), [&](const JudgedFit& j) {
                            return j.fit.log_evidence < best - may_count;
                          }) - found.begin());
    add_up_no_more();
    std::vector<Asked> asked;
    for (auto j = found.begin(); j != found.begin() + count; ++j)
      asked.push_back({j->fit.together, j->fit.z});
    found.erase(found.begin(), found.begin() + count);
    add(found, fitted(asked));
  }

  void add_up_no_more() {
    context_.predictors.solve_anew();
    adds_up_ = false;
  }

  static bool is_of(const HypothesisFit& fit, const Together& members) {
    return fit.together.size() == members.size() &&
           std::is_permutation(members.begin(), members.end(), fit.together.begin());
  }

  // What members change is prepared once: each is in several sets.
  void keep_members(const std::vector<Asked>& asked) {
    StateModels::Together members;
    for (const Asked& set : asked)
      for (const Hypothesis* h : set.together)
        if (!contains(members, h)) members.push_back(h);
    StateModels& models = *context_.predictors.models();
    for (std::size_t state : models.fitted_states(context_.test)) models.keep(state, members);
  }

  std::vector<JudgedFit> fitted(const std::vector<Asked>& asked) {
    keep_members(asked);
    std::vector<JudgedFit> own(asked.size());
    constexpr double of_the_rest = 0.6; // of a stage: lists get shorter
    const double ends = begins_ + of_the_rest * (ends_ - begins_);
    StageShare behind(settings_, begins_, ends, asked.size());
    in_parallel(int(asked.size()), [&](int i) {
      if (settings_.stop()) return;
      const Asked& set = asked[std::size_t(i)];
      own[std::size_t(i)] = judged(fit_of(context_, set.together, set.start), nominal_.fit,
                                   context_, held_out_, scores_, standards_);
      own[std::size_t(i)].added_up = adds_up_ && change_together(set.together);
      behind.one_is_done();
    });
    begins_ = ends;
    context_.predictors.forget_sets(); // each was asked for once, and a search asks for hundreds
    std::erase_if(own, [](const JudgedFit& j) { return !j.fit.solved || j.too_free(); });
    sort(own);
    return own;
  }

  const FitContext& context_;
  const std::vector<EffectFits>& ranked_;
  const std::vector<JudgedFit>& fits_;
  const std::vector<Signature>& all_;
  const JudgedFit& nominal_;
  const Whitening& held_out_;
  const BlockScores& scores_;
  const Standards& standards_;
  const DiagnosisSettings& settings_;
  bool levels_matter_ = false;
  bool adds_up_ = true; // what members of sets change
  double begins_ = share::sets,
         ends_ = share::ledger; // of the stage: what lies before its next list
  std::vector<Together> asked_;
};

} // namespace

std::vector<JudgedFit> fit_sets(const SetSearch& search) {
  return Growth(search).sets();
}

std::vector<JudgedFit> fit_beside(const SetSearch& search, const JudgedFit& lead) {
  return Growth(search).beside(lead);
}

} // namespace plica
