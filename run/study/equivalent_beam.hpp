// A bellows of shells as an equivalent pipe and as a chain of connectors, computed from the static
// behaviour and the mass of the shells, nothing fitted; and what the simplification costs.
//
// From the stiffness between the end caps, less the compliance of straight cuffs: EA = k L, GJ = c
// L, EI = b L, with L the convoluted length and b the moment per rotation of a free end; R of the
// pipe is sqrt(2 EI / EA), its wall has their mass, and their radius of gyration. A bellows is
// rigid in shear. A liner is the inner layer with its own numbers.
#pragma once

#include "model/description/case.hpp"
#include "run/results/results.hpp"
#include "run/stages.hpp"

namespace plica {

// A mode of the shells beside those of the two simple models, paired by shape and order.
struct SimplifiedMode {
  std::string shape; // axial | transverse | torsion
  int order = 1;
  double shell = 0;                      // Hz
  std::optional<double> pipe, connector; // none: the simple model has no such mode
};

// Stiffness that one held end feels when the other is moved harmonically, amplitude of the reaction
// there over the motion here (N/m, Nm/rad), damping 1 %.
struct TransferStiffness {
  double hertz = 0;
  // axial, transverse, bending, torsion
  std::array<double, 4> shell{}, pipe{}, connector{};
};

struct EquivalentBeam {
  Case pipe, connector; // the whole case with that part in place of the bellows and its liner
  StaticStiffness shell_static, pipe_static, connector_static;
  double mass = 0, pipe_mass = 0, connector_mass = 0;
  double ejma_axial = 0; // hand formula, N/m; 0 where it does not apply
  std::vector<SimplifiedMode> modes;
  std::vector<TransferStiffness> transfer;
  std::vector<std::string> remarks;
};

// Throws InputError for a case that is not one bellows, with or without a liner, between two caps.
EquivalentBeam equivalent_beam(const Case& data, const StageListener& stage);

} // namespace plica
