// Which poles of rising order are physical: the stabilisation diagram and its automatic reading.
#pragma once

#include "lab/identification/lscf.hpp"

namespace plica {

enum class Stability { fresh, frequency, damping, all }; // what holds against the order below

struct StabilityLimits {
  double frequency = 0.01;     // relative
  double damping = 0.05;       // relative
  double participation = 0.95; // |u' v|^2
};

struct DiagramPole {
  int order = 0;
  Pole pole;
  Stability stability = Stability::fresh;
};

std::vector<DiagramPole> stabilisation(const std::vector<PolesOfOrder>& orders,
                                       const StabilityLimits& limits = {});

// A group of stable poles that lie within `width` of half their bandwidth of each other, in at
// least a third of the orders above the first at which it shows and in four at least.
struct StableGroup {
  Pole pole;     // the median one in damping
  int order = 0; // at which it was found
  int count = 0; // orders it holds in
  std::vector<DiagramPole> members;
  double scatter_frequency = 0, scatter_damping = 0; // standard deviations over them
};

std::vector<StableGroup> stable_groups(const std::vector<DiagramPole>& diagram,
                                       double width = 1. / 3);

} // namespace plica
