// Seconds of what a line asks of sixty modes: complex stiffness, damped springs, transients, orders
// in time. 20 channels; the best of several, processor time of the process beside it.
#include "solve/dissipation.hpp"
#include "solve/sparse_factor.hpp"
#include "solve/swept_sine.hpp"
#include "solve/transient_response.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <numbers>
#include <random>

namespace {

using namespace plica;
using Eigen::MatrixXd;
using Eigen::VectorXd;
constexpr int modes = 60, channels = 20;
constexpr double pi = std::numbers::pi;

void report(const char* what, int times, const std::function<void()>& work) {
  double best = 1e9, busy = 1e9;
  for (int i = 0; i < times; ++i) {
    const std::clock_t cpu = std::clock();
    const auto begin = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    best = std::min(best, taken.count());
    busy = std::min(busy, double(std::clock() - cpu) / CLOCKS_PER_SEC);
  }
  std::printf("%-62s %8.1f ms, processor %8.1f ms\n", what, 1e3 * best, 1e3 * busy);
}

ModalModel model(int loads) {
  std::mt19937 random(3);
  const auto noise = [&] { return double(random()) / double(std::mt19937::max()) - 0.5; };
  ModalModel m{VectorXd(modes), VectorXd::Constant(modes, 0.01), VectorXd::Zero(modes),
               MatrixXd(channels, modes), MatrixXd(modes, loads)};
  for (int j = 0; j < modes; ++j) m.lambda[j] = std::pow(2 * pi * (8 + 9. * j), 2);
  for (double& x : m.output.reshaped()) x = noise();
  for (double& x : m.input.reshaped()) x = noise();
  return m;
}

// Of parts that store shares of the energy of every mode, coupling neighbours.
MatrixXd loss(const ModalModel& m) {
  std::mt19937 random(5);
  MatrixXd B(modes, modes / 2);
  for (double& x : B.reshaped()) x = double(random()) / double(std::mt19937::max()) - 0.5;
  const VectorXd omega = m.lambda.cwiseSqrt();
  return 0.01 * omega.asDiagonal() * (B * B.transpose()) * omega.asDiagonal();
}

} // namespace

int main() {
  set_threads(0);
  const VectorXd omega = 2 * pi * VectorXd::LinSpaced(4901, 10, 500);
  const ModalModel plain = model(1), sprung = model(13);
  Dissipation coupled, springs;
  coupled.loss = loss(plain);
  for (int k = 0; k < 12; ++k)
    springs.springs.push_back(
        {k + 1, [](std::complex<double> s) { return 1e4 * s * 0.01 / (1. + s * 0.01); }});
  report("complex stiffness, 4,901 frequencies", 9, [&] {
    if (!DissipativeResponse(plain, coupled)({{0, 1}}, omega).allFinite()) std::abort();
  });
  report("  of which the poles", 9, [&] { DissipativeResponse(plain, coupled); });
  report("twelve Maxwell springs, 4,901 frequencies", 9, [&] {
    if (!DissipativeResponse(sprung, springs)({{0, 1}}, omega).allFinite()) std::abort();
  });
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  MatrixXd signal(500'000, 1);
  for (double& x : signal.reshaped()) x = normal(random);
  report("transient of 100 s at 5 kHz", 5, [&] {
    if (!transient_acceleration(plain, signal, 2e-4).allFinite()) std::abort();
  });
  SweptLoad load{2e-4, VectorXd(500'000), VectorXd(500'000), MatrixXd::Ones(500'000, 1)};
  for (int i = 0; i < 500'000; ++i) {
    const double t = i * 2e-4;
    load.rate[i] = 2 * pi * (10 + 1.9 * t);
    load.phase[i] = 2 * pi * (10 * t + 0.95 * t * t);
  }
  report("an order of 100 s at 5 kHz, 2,000 moments", 5, [&] {
    if (!swept_acceleration(plain, Eigen::VectorXcd::Ones(1), load, 250).allFinite()) std::abort();
  });
}
