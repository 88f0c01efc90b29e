// Effects of a fit as they are told: place, values with intervals, probability, other places.
#pragma once

#include "diagnose/account/findings.hpp"

#include <map>

namespace plica {

class NamedEffects {
public:
  // Both must outlive it.
  NamedEffects(const GapProblem& problem, const Findings& found);

  // All that is told of the members of a fit.
  std::vector<NamedEffect> members_of(const HypothesisFit& fit) const;

  // Name, values and probability of one member of a fit. `fits`: of single hypotheses, where other
  // ways of the same effect are looked for.
  NamedEffect named(const HypothesisFit& fit, std::size_t member, double probability,
                    const std::vector<JudgedFit>& fits) const;

  // Of what comes last in a fit and is no effect of the library: name, values at the optimum, with
  // intervals, and nodes.
  NamedEffect last_of(const HypothesisFit& fit) const;

private:
  std::vector<int> nodes_of(const Hypothesis& h, const NamedEffect& e) const;
  std::optional<NamedEffect::Along> along_bellows(const NamedEffect& e) const;
  std::optional<double> within_of_spot(const NamedEffect& e) const;
  std::function<CaseEdits(const Case&)>
  in_case(const Hypothesis& h, const std::vector<EstimatedParameter>& parameters) const;
  void add_other_places(NamedEffect& e) const;
  void add_places_as_far_off(NamedEffect& e) const;
  void add_exchanged_places(NamedEffect& e, const HypothesisFit& set, std::size_t member) const;

  const GapProblem& problem_;
  const Findings& found_;
  const std::map<std::string, double> on_bellows_; // places that are counted along one: their y, m
  const std::map<std::string, Eigen::Vector3d> on_walls_; // spots on surfaces and decks
};

// At one place, whichever way.
bool is_same(const NamedEffect& a, const NamedEffect& b);

// Of each effect of a set the number of what takes its place in another one: the same effect, the
// same elsewhere, else another; the size of that one where none is left.
std::vector<std::size_t> in_place_of(const std::vector<NamedEffect>& first,
                                     const std::vector<NamedEffect>& set);

// Of sets that explain a test alike the members of the first, each with what takes its place in the
// others.
std::vector<std::vector<NamedEffect>>
alternatives(const std::vector<std::vector<NamedEffect>>& sets);

} // namespace plica
