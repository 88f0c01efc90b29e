// What the numbers of a function of a universal file are to be multiplied by to be in SI.
//
// Each axis by the unit that it names; where it names none by the factors of the data set 164
// before it and the exponents of the axis (else those of its data type); where there is none either
// it is taken as SI, with a warning. Where unit and data set contradict each other the unit of the
// axis is taken, with a warning. A ratio of like quantities needs no units.
#pragma once

#include "io/lab_files/lab_units.hpp"
#include "io/universal/file.hpp"
#include "lab/measured/frf_set.hpp"
#include "words/input_error.hpp"

#include <filesystem>

namespace plica {

struct FunctionUnits {
  double abscissa = 1, ordinate = 1;   // SI (Hz, s) = factor * number
  std::optional<UnitPowers> powers;    // of the ordinate, where it is known
  std::optional<FrfQuantity> quantity; // of a response, where it is known
  std::vector<UniversalWarning> warnings;
  std::optional<InputProblem> problem; // why it cannot be taken
};

// `system`: the data set 164 that holds, or null. `base`: wanted as a transmissibility.
FunctionUnits function_units(const UniversalFunction& f, const UniversalUnits* system, bool base,
                             const std::filesystem::path& file);

// What is wrong with the factors themselves: not above zero (thrown), or not those of the code.
std::optional<UniversalWarning> doubt_of(const UniversalUnits& system,
                                         const std::filesystem::path& file);

// Receptance, mobility, accelerance or transmissibility of what is over what.
std::optional<FrfQuantity> quantity_of(const UnitPowers& numerator, const UnitPowers& denominator);

} // namespace plica
