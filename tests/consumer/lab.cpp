// The mode of a synthetic response is found, to show that identification links and runs.
#include "plica/lab/identification/identify.hpp"

#include <cstdio>
#include <numbers>

int main() {
  using namespace plica;
  constexpr double natural = 50, damping = 0.02;
  FrfSet set;
  set.hertz = Eigen::VectorXd::LinSpaced(400, 30, 70);
  set.references = {"hammer"};
  set.responses = {"tip.x"};
  Eigen::MatrixXcd H(400, 1);
  for (Eigen::Index i = 0; i < 400; ++i) {
    const double w = 2 * std::numbers::pi * set.hertz[i], w0 = 2 * std::numbers::pi * natural;
    H(i, 0) = 1.0 / std::complex<double>(w0 * w0 - w * w, 2 * damping * w0 * w);
  }
  set.quantity = FrfQuantity::receptance;
  set.H = {H};
  const Identification found = identify(set, {});
  if (found.modes.size() != 1) return 1;
  std::printf("%.3f Hz, %.3f %%\n", found.modes[0].frequency, 100 * found.modes[0].damping);
  return std::abs(found.modes[0].frequency - natural) < 1e-3 ? 0 : 1;
}
