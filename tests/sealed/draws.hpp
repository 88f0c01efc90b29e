// Chance of the sealed suite: a generator that gives the same numbers everywhere (the standard
// library's distributions differ between makers), seeded by the suite and a name.
#pragma once

#include <cstdint>
#include <string>

namespace sealed {

class Draws {
public:
  Draws(std::uint64_t seed, const std::string& name);

  static Draws none(); // every normal() is 0

  double uniform();                        // in [0, 1)
  double between(double low, double high); // evenly
  double normal();                         // mean 0, standard deviation 1
  int below(int count);                    // 0 .. count - 1

private:
  std::uint64_t next();
  std::uint64_t state_;
  bool silent_ = false;
};

// FNV-1a, 64 bit: the seed of a name, and the published fingerprint of the truth (it proves that
// the files are the same; it is not made to resist forgery).
std::uint64_t fnv1a(const std::string& text, std::uint64_t start = 14695981039346656037ULL);

} // namespace sealed
