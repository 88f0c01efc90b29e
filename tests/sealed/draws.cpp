#include "draws.hpp"

#include <cmath>
#include <numbers>

namespace sealed {

std::uint64_t fnv1a(const std::string& text, std::uint64_t start) {
  for (const char c : text) start = (start ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return start;
}

Draws::Draws(std::uint64_t seed, const std::string& name)
    : state_(fnv1a(name) ^ (seed * 0x9E3779B97F4A7C15ULL)) {}

Draws Draws::none() {
  Draws draws(0, "");
  draws.silent_ = true;
  return draws;
}

// SplitMix64 (Steele, Lea & Flood 2014).
std::uint64_t Draws::next() {
  state_ += 0x9E3779B97F4A7C15ULL;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31);
}

double Draws::uniform() {
  return static_cast<double>(next() >> 11) * 0x1p-53;
}

double Draws::between(double low, double high) {
  return low + (high - low) * uniform();
}

// Box and Muller.
double Draws::normal() {
  if (silent_) return 0;
  const double u = 1 - uniform(), v = uniform();
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
}

int Draws::below(int count) {
  return static_cast<int>(uniform() * count);
}

} // namespace sealed
