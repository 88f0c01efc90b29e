// What stress is linear in: the modal coordinates and, of ends that move against each other, their
// own displacement, which strains the part as in statics.
#pragma once

#include "run/analyses/response.hpp"

namespace plica {

class StressCoordinates {
public:
  StressCoordinates(const DampedModes& modes, const Excitations* excited);

  const Eigen::MatrixXd& fields() const { return fields_; } // all DOFs x coordinates
  // Per unit of the excitation, frequencies (above 0) x coordinates.
  Eigen::MatrixXcd operator()(const ExcitedColumns& excited, const Eigen::VectorXd& hertz) const;
  // Of ends that move: what moves is no acceleration alone.
  bool strains(const ExcitedColumns& excited) const;

private:
  ModalResponse response_;
  Eigen::MatrixXd fields_;
  std::vector<int> own_; // of the loads: their coordinate, or -1
};

// Rows of coordinates whose outer products, over the frequencies and inputs, are their one-sided
// cross densities: (frequency x inputs) x coordinates.
Eigen::MatrixXcd spectral_rows(const Excitation& e, const StressCoordinates& coordinates,
                               const Eigen::VectorXd& hertz);

// Integral of f^n Re(density) over the frequencies, the density straight between them.
Eigen::MatrixXd covariance(const Eigen::MatrixXcd& rows, const Eigen::VectorXd& hertz, double n);

} // namespace plica
