#include "diagnose/judge/judgement.hpp"

namespace plica {

double Judgement::probability_of(const std::string& effect) const {
  for (const auto& [name, p] : probabilities)
    if (name == effect) return p;
  return 0;
}

double Judgement::share_of(const std::string& effect, const std::string& place) const {
  const auto known = places.find(effect);
  if (known == places.end()) return 1;
  for (const auto& [name, share] : known->second)
    if (name == place) return share;
  return 0;
}

bool Judgement::resonator_is_ahead(const JudgedFit& nominal) const {
  return resonator &&
         dispersed_log_evidence(resonator->fit) - dispersed_log_evidence(told(nominal).fit) >=
             threshold::effects_apart;
}

} // namespace plica
