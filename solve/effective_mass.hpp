// Effective masses of modes in the six rigid-body directions.
//
//   Gamma_ij = phi_i' M r_j (phi_i' M phi_i = 1),   m_ij = Gamma_ij^2,   sum_i m_ij = r_j' M r_j
//
// over the free DOFs: what is held takes its share of the consistent mass out of the sum. r_1..3
// are translations, r_4..6 rotations about the centre of mass of the free part.
#pragma once

#include "solve/assembly.hpp"

namespace plica {

struct FreeMass {
  double mass = 0;                   // kg, of the translations (mean of the three)
  Eigen::Vector3d centre{0, 0, 0};   // m
  Eigen::MatrixXd R;                 // rigid-body motions about the centre, free DOFs x 6
  Eigen::Matrix<double, 6, 1> total; // r_j' M r_j
};

// `free`: numbers of the free DOFs among the independent ones; M: mass over the free DOFs.
FreeMass free_mass(const Model& model, const DofMap& map, const std::vector<int>& free,
                   const SparseMatrix& M);

// Mass of all elements, whatever is held, kg.
double total_mass(const Model& model);

// M u for fields over all DOFs (six rows a node), element by element: no matrix is assembled.
Eigen::MatrixXd mass_product(const Model& model, const Eigen::MatrixXd& u);

// Mass and r_j' M r_j about the centre of mass, from r' M r about the origin; the participations
// phi' M r (one row per mode) are referred to the centre too.
struct CentralMass {
  double mass = 0;
  Eigen::Matrix<double, 6, 1> total;
};
CentralMass refer_to_centre(const Eigen::Matrix<double, 6, 6>& about_origin,
                            Eigen::MatrixXd& participation);

} // namespace plica
