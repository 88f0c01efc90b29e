// A strip reduced to two of its corners, to show that reduction links and runs.
#include "plica/mesh/plate.hpp"
#include "plica/reduction/craig_bampton.hpp"

#include <cstdio>

int main() {
  using namespace plica;
  Model model;
  append(model.mesh, mesh_plate({{{0, 0, 0}, {1, 0, 0}, {1, 0.1, 0}, {0, 0.1, 0}}}, 20, 2, 1e-3),
         "strip", 0);
  model.shells.push_back({{.E = 200e9, .nu = 0.3, .rho = 8000}, MembraneStrain::displacement});
  const Reduction strip = craig_bampton(model, {0, 20}, 20);
  const Eigen::Index motions = 12, modes = strip.lambda.size();
  std::printf("%d modes below 20 Hz\n", int(modes));
  return strip.proved && modes > 0 && strip.element.K.rows() == motions + modes ? 0 : 1;
}
