// Equivalent thin-walled pipe and chain of connectors: beams and springs in place of shells
// (Broman, Jonsson and Hermann, IJPVP 77 (2000) 445-453).
//
// A layer of stiffness k along the axis and c about it, mean radius R, mass m' per length:
//
//   EA = k L,  GJ = c L,  EI = EA R^2 / 2,  G A_s = 0.53 GJ / R^2 or rigid,
//   rotary inertia per length m' R^2 / 2 across, m' R^2 about the axis
//
// L is the length that the modulus is made for. Made for the whole length but used on the
// convoluted part alone, a pipe is stiffer than k by their ratio. The Poisson ratio E / (2 G) - 1
// of such a material may be negative; nothing here needs it. A chain of n connectors of k has k /
// n.
#pragma once

#include "elements/beam_section.hpp"
#include "elements/bushing.hpp"
#include "model/description/case.hpp"

#include <vector>

namespace plica {

// Layers of one stretch in parallel; from left to right along y.
struct PipeStretch {
  double from = 0, to = 0; // y
  int elements = 0;
  std::vector<BeamProperties> layers = {};
  double mass_at_end = 0; // end cap, at `to`
};

std::vector<PipeStretch> pipe_stretches(const EquivalentPipe& pipe, const Material& material);

// Force and moment by the relative motion of the two nodes of a connector; columns ux uy uz rx ry
// rz, the pipe along y; of a tabulated force the slope at rest.
Matrix6 connector_law(const ConnectorSpring& spring);
bool resists_every_motion(const ConnectorSpring& spring); // its law is positive definite

} // namespace plica
