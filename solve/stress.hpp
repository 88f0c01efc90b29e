// Stress of shells and beams from displacements, and the measures read off it.
//
// Shells: in-plane stress on both faces in global axes, recovered at the corners of every element
// turned with the normal of the facet there into the director, and averaged over those that meet in
// a node with the same director and thickness: a kink or a step of the wall keeps a value for each
// side. Without the turn the mean of two facets that meet at an angle a is short by 1 - cos a of
// the stress across the edge. Beams: axial stress of the outermost fibres at both ends of every
// element.
//
// Everything is linear in the displacements, so a field of many columns serves modes, static shapes
// and, by superposition, harmonic and random responses.
#pragma once

#include "solve/model.hpp"

#include <array>
#include <complex>

namespace plica {

enum class Face { below, above }; // against and along the directors

struct StressField {
  // Row 12 point + 6 face + component (xx yy zz xy yz zx), Pa. Points in the order of their nodes.
  Eigen::MatrixXd shell;
  std::vector<int> node_of_point;
  // Of each point: unit director, thickness (m), section of the model.
  std::vector<Eigen::Vector3d> director;
  std::vector<double> thickness;
  std::vector<int> section;
  Eigen::MatrixXd beam;         // row: fibre, Pa
  std::vector<int> node_of_row; // where that fibre is
};

// u: all DOFs x columns.
StressField recover_stress(const Model& model, const Eigen::MatrixXd& u);

// The points and fibres alone, without a column.
StressField stress_points(const Model& model);

// Of other displacements: the columns of `field` times Q.
StressField combined(const StressField& field, const Eigen::MatrixXd& Q);

// Of a model at a state: one column.
StressField stress_of_state(const Model& model);

// Von Mises stress of one tensor (xx yy zz xy yz zx).
double von_mises(const Eigen::Ref<const Eigen::Matrix<double, 6, 1>>& stress);

// Largest von Mises stress over a cycle of Re(stress e^{i w t}): the largest root of the quadratic
// form of von Mises in the phase.
double von_mises_of_cycle(const Eigen::Ref<const Eigen::Matrix<std::complex<double>, 6, 1>>& s);

// Root of the mean square of von Mises stress under stationary coordinates q with the covariance C:
// sum_jk C_jk s_j' A s_k, s the columns of `stress` (6 x coordinates), A the form of von Mises
// (Segalman, Fulcher, Reese & Field, IMAC 1998).
double von_mises_rms(const Eigen::Ref<const Eigen::MatrixXd>& stress, const Eigen::MatrixXd& C);

// One number per node (the larger side of a kink) and face, and the largest with its place.
struct StressPeaks {
  Eigen::VectorXd below, above; // per node, Pa
  double largest = 0;
  int node = -1;
  Face face = Face::above;
  double largest_beam = 0; // magnitude of the axial stress
  int beam_node = -1;
};

// `shell`: from the rows of a point, per face, as a 6 x columns block; `beam`: from one row.
template <class ShellMeasure, class BeamMeasure>
StressPeaks stress_peaks(const StressField& field, int nodes, ShellMeasure&& shell,
                         BeamMeasure&& beam) {
  StressPeaks peaks{.below = Eigen::VectorXd::Zero(nodes), .above = Eigen::VectorXd::Zero(nodes)};
  for (std::size_t point = 0; point < field.node_of_point.size(); ++point)
    for (Face face : {Face::below, Face::above}) {
      const int node = field.node_of_point[point];
      const double value =
          shell(field.shell.middleRows<6>(12 * Eigen::Index(point) + 6 * int(face)));
      double& at_node = (face == Face::below ? peaks.below : peaks.above)[node];
      at_node = std::max(at_node, value);
      if (value <= peaks.largest) continue;
      peaks.largest = value;
      peaks.node = node;
      peaks.face = face;
    }
  for (Eigen::Index row = 0; row < field.beam.rows(); ++row)
    if (const double value = beam(field.beam.row(row)); value > peaks.largest_beam) {
      peaks.largest_beam = value;
      peaks.beam_node = field.node_of_row[row];
    }
  return peaks;
}

} // namespace plica
