// Numbers with what is not known of them: "8 mm +- 1 mm", "193 GPa +- 5 %", "3 kN [0.3, 30]".
//
// A number of the tolerance without a unit has that of the value. "+-" may be written as one sign.
#pragma once

#include "words/units.hpp"

#include <optional>

namespace plica {

struct TolerancedQuantity {
  ParsedQuantity value;
  struct Limits {
    double low = 0, high = 0;
    bool interval = false; // written as [low, high]
  };
  std::optional<Limits> limits;
};

// Wrong when the value, the tolerance or the order low <= value <= high is; says which.
TolerancedQuantity parse_toleranced(std::string_view text, Dimension dimension);

} // namespace plica
