// What varies between admissible specimens and tests: the scatter that no effect has to explain.
//
// Standard deviations stand below; the tolerances of the case itself come besides. The wall's
// thickness scatters where the drawing gives no tolerance, its stiffness as a smooth field. What
// varies along a sheet is its thickness: where the case says how far, that field stands in place of
// the one of stiffness (thickness_fields.hpp).
#pragma once

#include "diagnose/effects/effect.hpp"

namespace plica {

std::vector<Hypothesis> scatter(const Structure& s);
// Of these: one number of the whole or the mass of a component, not the form of anything.
bool is_nuisance(const Hypothesis& varied);

// Relative but for the last two of a sensor.
namespace scatters {
constexpr double modulus = 0.01, density = 0.005, thickness = 0.01, field = 0.02, masses = 0.01,
                 joints = 0.05;
constexpr double all_damping =
    0.08; // of all modes alike, where the case says nothing (all_damping_of),
constexpr double mode_damping = 0.12;             // and of each on its own
constexpr double gain = 0.01, other_axes = 0.005; // of a sensor; of the table along other axes
constexpr double turn = 1, off_place = 1e-3;      // of a sensor: degrees about each axis, m
// Standard deviation of the logarithm of all damping: by the tolerance of analyses.damping.modal,
// where it has one.
double all_damping_of(const Case& data);
} // namespace scatters

} // namespace plica
