// What a specimen of the suite is, and the list of all: the truth, before anything is measured.
#pragma once

#include "wall.hpp"

#include <cstdint>

namespace sealed {

struct Effect {
  std::string name, place;
  std::map<std::string, double> value;
};

struct Specimen {
  std::string id = {};        // "017"
  std::string structure = {}; // short_bellows, cantilever_masses, bolted_lap
  std::string kind = {};      // none, effect, stranger, pair, triple, known_and_stranger
  std::string cls = {};       // effect name; a stranger's own; "a+b" of a pair
  std::string strength = {};  // weak, medium, strong; empty without
  std::string wall = {};      // specimen of the wall; empty for beams
  std::vector<Effect> effects = {};
  bool linear = true;
  std::string without = {};  // an effect that its case leaves out
  std::string campaign = {}; // "sets": more modes and states of the cantilever
  // The right end stands on springs, sensors sit on both ends and between the axes, the level that
  // is held out is not the highest, and the case says how well damping is known.
  bool mounted = false;
  int level_out = -1; // number of the level held out, from 0; -1: the highest
};

// The case that a specimen is diagnosed by.
std::string case_of(const Specimen& s);

struct WallPlan {
  std::string name;
  WallSpecimen specimen;
};

struct Suite {
  std::uint64_t seed = 1;
  std::vector<Specimen> specimens;
  std::vector<WallPlan> walls; // those that the specimens ask for
};

Suite plan_suite(std::uint64_t seed, bool smoke);
void keep_first(Suite& suite, int count);       // their order is random
void keep_beams(Suite& suite);                  // without those that need a wall
Suite plan_mounted(std::uint64_t seed);         // specimens that are mounted, all of them
Suite plan_sixty_strangers(std::uint64_t seed); // outside of the library by design

// Effects that are made of a wall of its own, and what that is called.
bool needs_wall(const Effect& e);
std::string wall_of(const Effect& e, const std::string& road);
// Shuffles, numbers, and lists the walls.
void number_suite(Suite& suite);

// Scatter of the wall that a specimen stands on, by the name of that wall.
WallSpecimen wall_specimen(const Specimen& s, std::uint64_t seed);

// Value of an effect at weak, medium, strong (0, 1, 2) on a structure; empty when it has none
// there.
std::vector<Effect> graded(const std::string& structure, const std::string& name, int strength,
                           int variant);

const std::vector<std::string>& effect_names();

// A stranger at one of its variants.
Effect stranger(const std::string& structure, const std::string& cls, int variant);

const Effect* find(const Specimen& s, const std::string& name);
double value_of(const Specimen& s, const std::string& name, const std::string& place,
                const std::string& key, double otherwise);

} // namespace sealed
