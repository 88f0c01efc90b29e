// How heavy what was added to a structure may be.
#pragma once

#include "diagnose/effects/effect.hpp"

namespace plica {

EffectParameter added_kilograms(const Structure& s);

} // namespace plica
