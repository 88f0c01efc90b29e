// Temperatures of a subcase as strains of free expansion: alpha (T - T0), T0 that of
// TEMPERATURE(INITIAL), or TREF of the material.
//
// Of an element T is that of TEMPP1 or TEMPRB, else the mean over its grid points of TEMP and
// TEMPD.
#pragma once

#include "io/decks/nastran_elements.hpp"

namespace plica {

bool is_temperature_card(const std::string& name);

// `loads`: cards by name that act; `set` and `initial`: numbers of sets, initial 0 = none. Adds to
// strains, or to not_had what is missing or varies through a section.
void read_temperatures(const NastranReading& reading, const CardsByName& loads, int set,
                       int initial, DeckLoadCase& into);

} // namespace plica
