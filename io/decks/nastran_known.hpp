// Which cards of a Nastran deck are followed, passed over and not had.
#pragma once

#include "io/decks/bulk_data.hpp"

namespace plica {

enum class CardKind {
  followed,
  passed,     // says what to compute, how it is damped, what is optimised: no stiffness, no mass
  solid,      // an element or property of solids
  structural, // changes stiffness, mass or what is held, and is not had
  unknown
};

CardKind kind_of(const std::string& card);
bool is_element(const std::string& card); // with a number of its own, solids included
const std::set<std::string>& followed_cards();
bool is_analysis_set(const std::string& card); // what of a structure a reduction keeps: ASET, QSET1

// Parameters that change stiffness or mass and are not followed.
bool is_structural_parameter(const std::string& name);

// Cards that share their numbers: "beam" of PBAR and PBEAM; empty when a number may come again.
std::string group_of_numbers(const std::string& card);

// Fields that a card can have, rounded up to whole lines; 0 of those with lists.
std::size_t longest_card(const std::string& card);

} // namespace plica
