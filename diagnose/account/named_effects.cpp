#include "diagnose/account/named_effects.hpp"

#include "diagnose/effects/growth.hpp"
#include "diagnose/effects/place_nodes.hpp"
#include "diagnose/effects/take_over.hpp"
#include "diagnose/effects/wall_spots.hpp"
#include "diagnose/judge/thresholds.hpp"
#include "diagnose/weigh/interval.hpp"
#include "diagnose/weigh/likely_values.hpp"
#include "diagnose/weigh/twins.hpp"
#include "model/description/place_keys.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace plica {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// "bellows.crown[": what a place is counted in; empty where it is not.
std::string list_of(const std::string& place) {
  return place.substr(0, place.find('[') + 1);
}

bool is_on_bellows(const Case& data, const std::string& place) {
  const Part* part = list_of(place).empty() ? nullptr : part_named(data, part_of_set(place));
  return part && std::holds_alternative<Bellows>(part->body);
}

double middle_of(const Model& model, const std::vector<int>& nodes) {
  double sum = 0;
  for (int node : nodes) sum += model.mesh.nodes[std::size_t(node)].y();
  return sum / double(nodes.size());
}

std::map<std::string, double> places_on_bellows(const GapProblem& problem) {
  const Structure structure = problem.nominal.structure(problem.test.data);
  std::map<std::string, double> at;
  for (const Hypothesis& h : problem.hypotheses)
    if (!at.contains(h.place) && is_on_bellows(problem.data, h.place))
      at[h.place] = middle_of(structure.built.model, nodes_at(structure, h.place));
  return at;
}

std::map<std::string, Eigen::Vector3d> spots_on_walls(const GapProblem& problem) {
  const Structure structure = problem.nominal.structure(problem.test.data);
  std::map<std::string, Eigen::Vector3d> at;
  for (const Part& part : problem.data.parts)
    if (is_from_file(part) || std::holds_alternative<Plate>(part.body))
      for (const auto& spots :
           {wall_spots(structure.built, part.name), damage_spots(structure.built, part.name)})
        for (const Spot& spot : spots)
          at[spot.place] = structure.built.model.mesh.nodes[std::size_t(spot.touched)];
  return at;
}

} // namespace

NamedEffects::NamedEffects(const GapProblem& problem, const Findings& found)
    : problem_(problem), found_(found), on_bellows_(places_on_bellows(problem)),
      on_walls_(spots_on_walls(problem)) {}

bool is_same(const NamedEffect& a, const NamedEffect& b) {
  return a.name == b.name && a.place == b.place;
}

std::vector<NamedEffect> NamedEffects::members_of(const HypothesisFit& fit) const {
  const Judgement& judgement = found_.judgement;
  std::vector<NamedEffect> members;
  for (std::size_t h = 0; h < fit.together.size(); ++h) {
    const Hypothesis& own = *fit.together[h];
    const double effect = judgement.probability_of(own.effect);
    members.push_back(
        named(fit, h, effect * judgement.share_of(own.effect, own.place), found_.fits));
    NamedEffect& e = members.back();
    e.anywhere = effect;
    if (judgement.names_sets())
      add_exchanged_places(e, fit, h);
    else
      add_other_places(e);
    if (own.in_case) e.in_case = in_case(own, e.parameters);
    e.nodes = nodes_of(own, e);
    e.along = along_bellows(e);
    e.within = within_of_spot(e);
  }
  return members;
}

NamedEffect NamedEffects::last_of(const HypothesisFit& fit) const {
  const std::size_t last = fit.together.size() - 1;
  NamedEffect e = named(fit, last, 0, {});
  for (std::size_t i = 0; i < e.parameters.size(); ++i) {
    EstimatedParameter& p = e.parameters[i];
    p.value = fit.values[fit.first_of(last) + Index(i)];
    p.interval = {std::min(p.interval[0], p.value), std::max(p.interval[1], p.value)};
  }
  e.nodes = nodes_of(*fit.together.back(), e);
  return e;
}

std::vector<int> NamedEffects::nodes_of(const Hypothesis& h, const NamedEffect& e) const {
  std::vector<double> along;
  for (const std::size_t p : h.along) along.push_back(e.parameters[p].value);
  return nodes_at(problem_.nominal.structure(problem_.test.data), e.place, along);
}

std::optional<NamedEffect::Along> NamedEffects::along_bellows(const NamedEffect& e) const {
  if (!on_bellows_.contains(e.place)) return std::nullopt;
  std::map<std::string, double> at;
  for (const Hypothesis& h : problem_.hypotheses)
    if (h.effect == e.name && list_of(h.place) == list_of(e.place))
      at[h.place] = on_bellows_.at(h.place);
  std::set<double> all;
  for (const auto& [place, y] : at) all.insert(y);
  if (!at.contains(e.place) || all.size() < 2) return std::nullopt;
  const Model& model = problem_.nominal.structure(problem_.test.data).built.model;
  const double left = middle_of(model, model.mesh.sets.at(part_of_set(e.place) + ".left"));
  NamedEffect::Along along{.value = at.at(e.place) - left, .interval = {}};
  along.interval = {along.value, along.value};
  std::vector<std::string> places = e.other_places;
  places.push_back(e.place);
  for (const std::string& place : places) {
    if (!at.contains(place)) continue;
    const double y = at.at(place);
    const auto here = all.find(y), next = std::next(here);
    const double after = next != all.end() ? *next - y : y - *std::prev(here);
    const double before = here != all.begin() ? y - *std::prev(here) : after;
    along.interval[0] = std::min(along.interval[0], y - left - before / 2);
    along.interval[1] = std::max(along.interval[1], y - left + after / 2);
  }
  return along;
}

// As far as the nodes lie that are nearer to it, or to another of its places, than to any spot that
// was looked at besides.
std::optional<double> NamedEffects::within_of_spot(const NamedEffect& e) const {
  if (!on_walls_.contains(e.place)) return std::nullopt;
  std::set<std::string> own(e.other_places.begin(), e.other_places.end()), looked_at;
  own.insert(e.place);
  for (const JudgedFit& j : found_.fits)
    if (j.fit.together[0]->effect == e.name) looked_at.insert(j.fit.together[0]->place);
  looked_at.insert(own.begin(), own.end());
  std::erase_if(looked_at, [&](const std::string& place) {
    return !on_walls_.contains(place) || part_of_set(place) != part_of_set(e.place);
  });
  const Mesh& mesh = problem_.nominal.structure(problem_.test.data).built.model.mesh;
  double within = 0;
  for (int node : mesh.sets.at(part_of_set(e.place) + ".all")) {
    const Eigen::Vector3d& x = mesh.nodes[std::size_t(node)];
    const auto distance = [&](const std::string& place) {
      return (on_walls_.at(place) - x).norm();
    };
    const auto nearest =
        std::min_element(looked_at.begin(), looked_at.end(),
                         [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    if (own.contains(*nearest)) within = std::max(within, distance(e.place));
  }
  return within;
}

namespace {

// Of one effect: which of them it is at is as uncertain as how it acts there.
bool are_spots_of_one_part(const Hypothesis& a, const Hypothesis& b) {
  return a.free_numbers > 0 && b.free_numbers > 0 && part_of_set(a.place) == part_of_set(b.place);
}

// An interval of places along a part ends at whole millimetres, outwards: no part is drawn or
// measured closer.
void end_at_millimetres(std::array<double, 2>& ends, const Prior& path) {
  constexpr double step = 1e-3; // m
  ends[0] = std::max(path.centre, step * std::floor(ends[0] / step));
  ends[1] = std::min(path.width, step * std::ceil(ends[1] / step));
}

// Whether a number of one prior stands in the other where it has as many standard deviations; of
// the parameters that both have.
bool are_alike(const Hypothesis& a, const Hypothesis& b) {
  constexpr double times = 5;
  const auto both = std::ptrdiff_t(std::min(a.parameters.size(), b.parameters.size()));
  return std::equal(a.parameters.begin(), a.parameters.begin() + both, b.parameters.begin(),
                    [](const EffectParameter& one, const EffectParameter& two) {
                      const auto [least, most] = std::minmax(one.prior.width, two.prior.width);
                      return one.prior.kind == two.prior.kind && most <= times * least;
                    });
}

// Of a prior that reaches down to nothing the ends that lie there.
void end_at_nothing(std::array<double, 2>& ends, const Prior& prior) {
  constexpr double nothing = 1e-5; // of the centre
  if (prior.kind == PriorKind::log_normal && prior.low > 0 && prior.low < nothing * prior.centre &&
      ends[0] < nothing * prior.centre)
    ends[0] = 0;
}

} // namespace

NamedEffect NamedEffects::named(const HypothesisFit& fit, std::size_t member, double probability,
                                const std::vector<JudgedFit>& fits) const {
  const Hypothesis& h = *fit.together[member];
  NamedEffect e{.name = h.effect,
                .place = h.place,
                .way = h.way,
                .probability = probability,
                .parameters = {}};
  std::vector<const HypothesisFit*> ways{&fit};
  if (fit.together.size() == 1)
    for (const JudgedFit& j : fits)
      if (const Hypothesis& other = *j.fit.together[0];
          other.effect == h.effect && are_alike(other, h) &&
          (other.place == h.place ? other.way != h.way : are_spots_of_one_part(other, h)))
        ways.push_back(&j.fit);
  const Index first = fit.first_of(member);
  const VectorXd likely = likely_values(fit, member);
  for (std::size_t i = 0; i < h.parameters.size(); ++i) {
    const Index row = first + Index(i);
    std::erase_if(ways, [&](const HypothesisFit* way) { return way->z.size() <= row; });
    Interval between = interval_of(ways, row, h.parameters[i].prior);
    const double value = likely[Index(i)];
    if (std::find(h.along.begin(), h.along.end(), i) != h.along.end()) {
      // Two coordinates of a place belong together: neither is moved into its interval.
      between.ends = {std::min(between.ends[0], value), std::max(between.ends[1], value)};
      end_at_millimetres(between.ends, h.parameters[i].prior);
    }
    end_at_nothing(between.ends, h.parameters[i].prior);
    const bool within = value >= between.ends[0] && value <= between.ends[1];
    e.parameters.push_back({.name = h.parameters[i].name,
                            .unit = h.parameters[i].unit,
                            .value = within ? value : between.middle,
                            .interval = between.ends,
                            .z = fit.z[row]});
  }
  return e;
}

// Of an effect that grew from state to state the last of them.
std::function<CaseEdits(const Case&)>
NamedEffects::in_case(const Hypothesis& h,
                      const std::vector<EstimatedParameter>& parameters) const {
  VectorXd values(Index(parameters.size()));
  for (Index i = 0; i < values.size(); ++i) values[i] = parameters[std::size_t(i)].value;
  const std::vector<std::string> states = changed_states(problem_.test.data);
  if (h.values_in && !states.empty()) values = h.values_in(values, states.back());
  return [edits = h.in_case, values](const Case& now) { return edits(now, values); };
}

// Places of one member of a set with which the others explain the test as well.
void NamedEffects::add_exchanged_places(NamedEffect& e, const HypothesisFit& set,
                                        std::size_t member) const {
  for (const JudgedFit& j : found_.sets) {
    if (!j.credible() || j.fit.together.size() != set.together.size() ||
        evidence_of(set) - evidence_of(j.fit) >= found_.standards.apart)
      continue;
    const Members own = without(j.fit.together, without(set.together, {set.together[member]}));
    if (own.size() == 1 && own[0]->effect == e.name && own[0]->place != e.place &&
        std::find(e.other_places.begin(), e.other_places.end(), own[0]->place) ==
            e.other_places.end())
      e.other_places.push_back(own[0]->place);
  }
}

// Where nothing explains the test, all that was tried is wrong, and evidence between places is made
// by what is wrong: places of a single effect that leave not much more of the gap stand beside it.
void NamedEffects::add_places_as_far_off(NamedEffect& e) const {
  const Judgement& judgement = found_.judgement;
  const JudgedFit* lead = judgement.named.empty() ? judgement.nearest : judgement.named.front();
  if (!lead || lead->fit.together.size() != 1) return;
  const double most = std::min(threshold::as_far_off * lead->gap_after,
                               std::sqrt(1 - threshold::most_closed) * found_.nominal.gap_after);
  for (const JudgedFit& j : found_.fits) {
    const Hypothesis& h = *j.fit.together[0];
    if (h.effect == e.name && h.place != e.place && j.gap_after <= most &&
        std::find(e.other_places.begin(), e.other_places.end(), h.place) == e.other_places.end())
      e.other_places.push_back(h.place);
  }
}

// Places of the effect that the readings do not tell from the named one: alone, or where errors
// are larger than stated over all that was tried.
void NamedEffects::add_other_places(NamedEffect& e) const {
  const Judgement& judgement = found_.judgement;
  if (judgement.verdict == Verdict::mostly || judgement.verdict == Verdict::unknown) {
    constexpr double worth_a_word = 0.05;
    for (const auto& [place, share] : judgement.places.at(e.name))
      if (place != e.place && share > worth_a_word) e.other_places.push_back(place);
    add_places_as_far_off(e);
    return;
  }
  double own = -1e300;
  for (const JudgedFit& j : found_.fits)
    if (j.fit.together[0]->effect == e.name && j.fit.together[0]->place == e.place)
      own = std::max(own, j.fit.log_evidence);
  for (const JudgedFit& j : found_.fits) {
    const Hypothesis& h = *j.fit.together[0];
    if (h.effect == e.name && h.place != e.place &&
        own - j.fit.log_evidence < found_.standards.apart &&
        std::find(e.other_places.begin(), e.other_places.end(), h.place) == e.other_places.end())
      e.other_places.push_back(h.place);
  }
}

std::vector<std::size_t> in_place_of(const std::vector<NamedEffect>& first,
                                     const std::vector<NamedEffect>& set) {
  using Alike = bool (*)(const NamedEffect&, const NamedEffect&);
  constexpr Alike elsewhere = [](const NamedEffect& a, const NamedEffect& b) {
    return a.name == b.name;
  };
  constexpr Alike another = [](const NamedEffect&, const NamedEffect&) { return true; };
  std::vector<std::size_t> found(first.size(), set.size());
  std::vector<bool> placed(set.size());
  for (const Alike alike : {Alike(is_same), elsewhere, another})
    for (std::size_t j = 0; j < set.size(); ++j)
      for (std::size_t i = 0; i < first.size() && !placed[j]; ++i)
        if (found[i] == set.size() && alike(first[i], set[j])) {
          found[i] = j;
          placed[j] = true;
        }
  return found;
}

std::vector<std::vector<NamedEffect>>
alternatives(const std::vector<std::vector<NamedEffect>>& sets) {
  std::vector<std::vector<NamedEffect>> groups(sets.front().size());
  for (const std::vector<NamedEffect>& set : sets) {
    const std::vector<std::size_t> member = in_place_of(sets.front(), set);
    for (std::size_t i = 0; i < groups.size(); ++i)
      if (member[i] < set.size() &&
          std::none_of(groups[i].begin(), groups[i].end(),
                       [&](const NamedEffect& own) { return is_same(own, set[member[i]]); }))
        groups[i].push_back(set[member[i]]);
  }
  return groups;
}

} // namespace plica
