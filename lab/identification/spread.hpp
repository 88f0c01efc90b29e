// What identifications of one structure, each of a part of the data, say about a mode.
//
//   s^2 = sum_i w_i max(0, (x_i - x)^2 - sigma_i^2) / sum_i w_i,     w_i = |R_i|^2
//
// x the value of all parts together, x_i +/- sigma_i that of part i (one input, one decay) alone,
// R_i the residues of the mode in it: what a part hardly shows counts for little, and what it knows
// no better than that not at all. Where two modes of the whole look alike, lie within 10 % and no
// part has both, they are one that the parts have at different frequencies.
#pragma once

#include "lab/identification/identification.hpp"
#include "lab/identification/modal_fit.hpp"

namespace plica {

// A mode of one part alone.
struct PartialMode {
  double frequency = 0, sigma_frequency = 0, damping = 0, sigma_damping = 0;
  Eigen::VectorXcd shape;
  double size = 0; // norm of its residues
};

struct PartialIdentification {
  std::string name;
  std::vector<PartialMode> modes;
};

// `fit`: of data of one reference.
PartialIdentification partial_identification(const std::string& name, const ModalFit& fit);

// Adds the spread to the standard deviations of the modes; warns where it is more than three times
// what was stated before, and more than a tenth of half the bandwidth.
void widen_by_parts(const std::vector<PartialIdentification>& parts,
                    std::vector<IdentifiedMode>& modes, std::vector<std::string>& warnings);

} // namespace plica
