// A case as it is seen at some of its nodes: enough to name modes, for sensors and for what acts on
// it, where the fields of all nodes are not wanted.
#pragma once

#include "model/shape/built_case.hpp"

#include <optional>
#include <string>

namespace plica {

// Which of the rings of the wall are seen: of every n-th one, nodes in equal steps around.
struct SeenRings {
  std::size_t most = 64;          // rings
  std::size_t around = 100000000; // nodes of each, at least, where it has them
};

// The nodes, increasing, and the case by their numbers: caps, sensors, springs, masses, beams and
// named sets as in the whole; of the shells those alone that something sits on, or one; no coupling
// but those that an end follows the wall by.
struct SeenCase {
  std::vector<int> nodes; // numbers in the whole
  BuiltCase built;
};

// `sets`: named sets whose nodes are seen. None where a shell belongs to no ring, for what it does
// is then not seen from rings, and where there are elements given by their matrices.
std::optional<SeenCase> seen_case(const BuiltCase& whole, const SeenRings& rings,
                                  const std::vector<std::string>& sets = {});

} // namespace plica
