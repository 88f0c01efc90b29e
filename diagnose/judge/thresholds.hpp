// What a verdict asks for: how far ahead, how adequate, how much of the gap closed. Differences of
// log evidence in nats.
#pragma once

#include <cstddef>

namespace plica::threshold {

// Of healthy specimens.
inline constexpr double healthy = 0.99;           // share of them that is adequate
inline constexpr double sure = 0.9;               // that leave more than what is named for sure
inline constexpr double healthy_held_out = 0.999; // the same, on held-out readings
inline constexpr double worst_block = 3.3;        // standard score of the worst block

// Between effects.
inline constexpr double over_nothing = 3;  // nats over the nominal case, at least
inline constexpr double effects_apart = 5; // that are told apart: a model's errors make some nats
inline constexpr double alike = 3;         // nats within which choices explain alike
inline constexpr double open_to = 8;       // nats, where the one that leads is not believed
inline constexpr std::size_t most_listed = 3; // of these
inline constexpr double far_ahead = 0.9;      // probability of each effect that explains most

// Of one effect more, which is worth `alike` in any case. Among so many effects and places one of
// some nats turns up by chance.
inline constexpr double beyond_chance = 7; // nats, where fewer explain the test
inline constexpr double set_gain = 5; // nats over the best smaller set, none of which explains it
inline constexpr double set_shrink = 0.3; // of held-out readings
// Nats that a second effect may make up, beside one that explains the test.
inline constexpr double within_reach = 30;

// Of the gap: its square G for what is closed, its root for what is left.
inline constexpr double most_closed = 0.5;  // share of G that `mostly` closes at least
inline constexpr double least_closed = 0.1; // share of G below which nothing is explained
inline constexpr double most_opened = 10;   // times G that effects of a set open together
inline constexpr double most_allowed = 1.5; // gap without what a hypothesis is allowed to be off
inline constexpr double most_left = 0.5;    // gap, of a change from a baseline
inline constexpr double part_left = 0.3;    // of a change, as a share of its own gap
inline constexpr double as_far_off = 2;     // of what is left, between places of what is not all
inline constexpr double one_factor = 1.2;   // gap that one factor on everything may leave more
inline constexpr double cause_closes = 0.5; // of what a place without a cause closes
inline constexpr double even_odds = 0.5;    // at most, of what failed a test of its own
inline constexpr double shared_odds = 0.85; // at most, of what sets of different effects share

// Of a fit.
inline constexpr double absurd_z = 3;            // standard deviations of a prior
inline constexpr double believable_shrink = 0.6; // of held-out readings, though they are not met
inline constexpr double moves = 0.1;             // standard deviations of a reading
inline constexpr double narrower = 0.5;          // standard deviations of a prior
inline constexpr double untold_z = 0.1;  // |z| below which a parameter is as it was expected,
inline constexpr double untold = 0.95;   // and standard deviations of a prior, as well known
inline constexpr int readings_each = 3;  // of a free parameter or effect, of several
inline constexpr int spare_readings = 2; // beyond several free parameters, to identify an effect

} // namespace plica::threshold
