#include "model/shape/constraint_clash.hpp"

#include "words/input_error.hpp"

namespace plica {

void asked_at(Model& model, std::size_t first, const std::string& key) {
  for (std::size_t i = first; i < model.constraints.size(); ++i) model.constraints[i].key = key;
}

void refuse_clash(const ConstraintError& error) {
  std::string key, allowed = "every degree of freedom tied or held once";
  for (const Constraint& row : error.rows) {
    if (key.empty()) key = row.key;
    if (row.supports_deck)
      allowed = "held: false at the part of the deck, if the case holds these nodes instead, or "
                "other nodes";
  }
  input_error(key, error.what(), allowed);
}

DofMap eliminate_constraints(const Model& model) {
  try {
    return eliminate(model);
  } catch (const ConstraintError& error) {
    refuse_clash(error);
  }
}

} // namespace plica
