// First frequency of a clamped strip, to show that the installed solver links and runs.
#include "plica/mesh/plate.hpp"
#include "plica/solve/couplings.hpp"
#include "plica/solve/modes.hpp"

#include <cstdio>

int main() {
  using namespace plica;
  Model model;
  append(model.mesh, mesh_plate({{{0, 0, 0}, {1, 0, 0}, {1, 0.1, 0}, {0, 0.1, 0}}}, 20, 2, 1e-3),
         "strip", 0);
  model.shells.push_back({{.E = 200e9, .nu = 0.3, .rho = 8000}, MembraneStrain::displacement});
  add_support(model, model.mesh.sets["strip.edge4"], {0, 1, 2, 3, 4, 5}, "clamp");
  const System system = assemble(model);
  BaseFactor base = factor_below_spectrum(system.K, system.M);
  ModesRequest request;
  request.count = 1;
  const ModeSet modes = find_modes(system.K, system.M, request, base);
  const double f = frequency(modes.lambda[0]); // Euler beam: 0.8076 Hz, plate a little above
  std::printf("%.4f Hz\n", f);
  return modes.proof.passed && f > 0.80 && f < 0.83 ? 0 : 1;
}
