// Poly-reference least-squares complex frequency-domain estimation (pLSCF): poles and
// participations of a whole band at once.
//
// Right matrix fraction, real coefficients, z = exp(i pi (f - f_0) / (f_1 - f_0)):
//
//   H_o(f) = B_o(z) A(z)^-1,   A(z) = sum_k z^k A_k (inputs x inputs),  A_0 = I
//
// Reduced normal equations sum_o (T_o - S_o' R_o^-1 S_o) [A_0; ..; A_n] ~ 0; with A_0 fixed the
// poles that only fit noise come out unstable and are dropped. Guillaume et al., IMAC 2003; Peeters
// et al., Shock and Vibration 11 (2004) 395-409.
#pragma once

#include "lab/measured/frf_set.hpp"

namespace plica {

struct Pole {
  std::complex<double> lambda;    // 1/s, imaginary part above zero, real part below
  Eigen::VectorXcd participation; // per reference, unit length; of time signals the shape
  double frequency() const;       // |lambda| / 2 pi, Hz
  double damping() const;         // -Re lambda / |lambda|
};

struct PolesOfOrder {
  int order = 0;           // of the polynomial; order x references / 2 poles at most
  std::vector<Pole> poles; // stable ones in the band with damping below 50 %, by frequency
};

// Poles for every polynomial order from 2 to `highest`. Each response is weighted by 1 / its
// noise: one that holds nothing else would otherwise hide the poles of all.
// Throws std::invalid_argument for fewer lines than unknowns.
std::vector<PolesOfOrder> lscf(const FrfSet& set, int highest);

} // namespace plica
