// Hand formulas for unreinforced U bellows: EJMA 10th edition, the same in ASME VIII-1 App. 26 and
// EN 13445-3 cl. 14. For comparison with the shell model; nothing in a run depends on them.
//
//   Dm  = Db + w + n t            mean diameter; Db inside diameter of the root
//   tp  = t sqrt(Db / Dm)         ply thinned by forming
//   C1  = 2 rm / w,   C2 = 1.82 rm / sqrt(Dm tp)
//   f   = 1.7 Dm E tp^3 n / (w^3 Cf)          axial stiffness of one convolution; K = f / N
//   S3  = P w / (2 n tp),  S4 = P / (2 n) (w / tp)^2 Cp          by pressure P
//   S5  = E tp^2 e / (2 w^3 Cf),  S6 = 5 E tp e / (3 w^2 Cd)     by movement e per convolution
//   St  = 0.7 (S3 + S4) + S5 + S6
//   S1  = P (Db + n t) / (2 n t),  S2 = P q Dm Kr / (2 Ac),  Ac = n tp (0.571 q + 2 w)
//
// S1 circumferential membrane stress of the straight end without a collar (that the convolutions
// help to hold a short one is left out, on the safe side), S2 of a convolution, Kr its pitch opened
// by movement over q; S3, S5 membrane and S4, S6 bending stress along the meridian; SI units. Cp,
// Cf, Cd are polynomials in C1 at thirteen values of C2, linear in between; valid for 0 <= C1 <= 1
// and 0.2 <= C2 <= 4, outside of which is an error.
//
// Limits. The coefficients are as cited in secondary sources, checked against two published
// worksheets and a finite element model, not against the standard itself; Cp at C1 <= 0.3 and
// C2 >= 1.6 lies 5-9 % below the finite element value: little confidence there. "1.7" replaces
// pi / (2 (1 - nu^2)) = 1.726 at nu = 0.3. The axial stiffness of shells is 0.97 to
// 1.13 times f (EjmaSweepSlow, 90 bellows; docs/life.md). n plies act as n times one ply, free to
// slip.
#pragma once

#include "model/description/parts.hpp"

#include <variant>

namespace plica {

struct EjmaBellows {
  double inner_diameter = 0; // Db, m
  double depth = 0;          // w, m: root to crown, mid-surface to mid-surface
  double pitch = 0;          // q, m
  double torus_radius = 0;   // rm, m: mean of root and crown arc radius; 0 = q / 4
  double thickness = 0;      // t of one ply before forming, m
  int plies = 1;             // n
  int convolutions = 1;      // N
  double E = 0, nu = 0.3;    // Pa
  bool thinned = true;       // false: tp = t
  double tangent = 0;        // Lt, m, of the shorter straight end; 0 = none
};

// The bellows of a case as the formulas take it, its wall as drawn or thinned; or why they do not
// apply. A bond other than 1 counts as plies that slip.
std::variant<EjmaBellows, std::string> ejma_bellows(const Bellows& bellows,
                                                    const Material& material);

double ejma_length(const EjmaBellows& bellows);     // L = N q, m
double ejma_metal_area(const EjmaBellows& bellows); // Ac of one convolution, m2
double ejma_mean_diameter(const EjmaBellows& bellows);
double ejma_ply(const EjmaBellows& bellows); // tp

struct EjmaFactors {
  double C1 = 0, C2 = 0, Cp = 0, Cf = 0, Cd = 0;
};

// Both throw std::invalid_argument outside the range of the coefficients.
EjmaFactors ejma_factors(double C1, double C2);
EjmaFactors ejma_factors(const EjmaBellows& bellows);

// f, N/m.
double ejma_convolution_stiffness(const EjmaBellows& bellows, const EjmaFactors& factors);

struct EjmaStress {
  double S1 = 0, S2 = 0, S3 = 0, S4 = 0, S5 = 0, S6 = 0, St = 0; // Pa; S1 0 without straight ends
};

// `pressure` in Pa, `movement` of one convolution along the axis in m.
EjmaStress ejma_stress(const EjmaBellows& bellows, const EjmaFactors& factors, double pressure,
                       double movement, double Kr = 1);

// Movement of one end against the other, from one end position to the other one, and what it does
// to one convolution at its mean diameter:
//   ex = |x| / N,   ey = 3 Dm |y| / (N (N q + x)),   et = Dm |theta| / (2 N)
// both ends parallel for y, bent evenly by theta; e is their sum, as if all met in one place.
struct EjmaMovement {
  double axial = 0;   // x, m, extension > 0
  double lateral = 0; // y, m
  double angular = 0; // theta, rad
};
struct EjmaEquivalent {
  double axial = 0, lateral = 0, angular = 0; // m per convolution
  double sum() const { return axial + lateral + angular; }
};
// Throws std::invalid_argument where x takes up the whole length.
EjmaEquivalent ejma_equivalent(const EjmaBellows& bellows, const EjmaMovement& movement);

// Limiting pressures, Pa, both ends held:
//   column    Psc = 0.34 pi Ct f / (N^2 q), Ct = 1: no rotation of the ends
//   in plane  Psi = 1.3 Ac Sy / (Kr Dm q sqrt(a)),  a = 1 + 2 d^2 + sqrt(1 - 2 d^2 + 4 d^4),
//             d = K4 / (3 K2), K2 = S2 / P, K4 = S4 / P, Sy the yield stress of the formed wall
// The column formula holds for long bellows; a margin is inside: the elastic column of the same
// stiffness buckles at 2 pi f / (N^2 q).
double ejma_column_squirm(const EjmaBellows& bellows, const EjmaFactors& factors);
double ejma_in_plane_squirm(const EjmaBellows& bellows, const EjmaFactors& factors, double yield,
                            double Kr = 1);

// The bellows as a beam without shear, EI = K L Dm^2 / 8. K: axial stiffness of the bellows, N/m.
double ejma_angular_stiffness(double K, double mean_diameter);                // K Dm^2/8, Nm/rad
double ejma_lateral_stiffness(double K, double mean_diameter, double length); // 1.5 K (Dm/L)^2

// Torsion, Nm/rad: EJMA puts all at the root, pi G n t Db^3 / (4 N (0.571 q + 2 w)), 35 % low for
// deep convolutions.
double ejma_torsion_stiffness(const EjmaBellows& bellows);

// Natural frequency i of the clamped bellows, Hz. M: its mass.
// Axial: chain of 2N half convolutions, (2N/pi) sin(i pi / 4N) sqrt(K/M), i = 1 .. 2N-1; the C_i
// tabled by EJMA are these (times sqrt(1000) for N/mm and kg).
double ejma_axial_frequency(int i, int convolutions, double K, double M);

// Lateral: clamped Euler beam, beta_i^2 / (2 pi sqrt(8)) (Dm/L) sqrt(K/M). EJMA leaves out the
// rotary inertia m' Rm^2/2, which makes it 60 % too high on a stubby bellows. The correction
// divides by sqrt(1 + (Rm^2/2) int phi'^2 / int phi^2), phi the Euler mode (12.30 / L^2 for i = 1):
// within 1 % of a shell model for i = 1, 2-3 % for i = 2, for eight convolutions or more.
struct LateralFrequency {
  double ejma = 0, with_rotary_inertia = 0;
};
LateralFrequency ejma_lateral_frequency(int i, double mean_diameter, double length, double K,
                                        double M);

} // namespace plica
