// Which entries of a test were measured in which state of the specimen.
#pragma once

#include "lab/measured/measured.hpp"

#include <functional>

namespace plica {

bool is_baseline(const Measured& measured, const std::string& state);
bool has_baseline(const Measured& measured);
bool is_weighed_in_all_states(const Measured& measured);

// The entries measured in states of which `kept` is true ("" = as it stands), under the names they
// have then; what `hold_out` and `caveats` say goes along.
Measured measured_in(const Measured& measured,
                     const std::function<bool(const std::string& state)>& kept);

// Whether the case as it is drawn answers what was measured in a state: none, or, where there are
// baselines, a baseline that differs from the case by no known change.
bool as_drawn(const Measured& measured, const std::string& state);
Measured measured_as_drawn(const Measured& measured);

} // namespace plica
