// Seconds to count ten million samples of noise by rainflow, one by one.
#include "life/rainflow.hpp"

#include <chrono>
#include <cstdio>
#include <random>

int main() {
  constexpr int samples = 10'000'000;
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  std::vector<float> noise(samples);
  for (float& x : noise) x = normal(random);
  double cycles = 0;
  const auto begin = std::chrono::steady_clock::now();
  plica::Rainflow counter([&](const plica::RainflowCycle& c) { cycles += c.count; });
  for (const float x : noise) counter.add(double(x));
  counter.finish();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  std::printf("rainflow: %d samples, %.0f cycles, %.2f s\n", samples, cycles, taken.count());
}
