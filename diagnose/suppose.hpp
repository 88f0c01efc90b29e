// What effects that somebody states, with numbers, would explain of a gap.
#pragma once

#include "diagnose/diagnose.hpp"

namespace plica {

// Their shares of the gap at these very numbers, and what they leave (results/diagnosis.hpp): no
// fit, no judgement. A row for each effect, in their order. Throws InputError where an effect, its
// place or a number is none of the library; otherwise as diagnose() does.
Ledger suppose(const Case& data, const TestData& test, const Supposition& supposition,
               const DiagnosisSettings& settings);

} // namespace plica
