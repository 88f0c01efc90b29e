// Elements that decks have and Model has not, as matrices: membranes and plates of three and four
// nodes, panels in shear, trusses, beams with released ends or a taper. Each in the units of its
// deck, global axes, six DOFs a node.
#pragma once

#include "elements/shell_section.hpp"
#include "io/decks/deck_eccentric_beam.hpp"
#include "model/description/deck_model.hpp"
#include "solve/model.hpp"

namespace plica {

// Constant-strain triangle in its plane, without bending; mass of its translations alone.
MatrixElement membrane_triangle(const std::vector<int>& nodes, const Eigen::Matrix3d& x,
                                const ShellSection& section, double thickness);

// Bending and transverse shear of a wall of three or four nodes without its membrane (columns of
// x), as MITC3+ or MITC4 less their membrane; full mass.
MatrixElement plate_alone(const std::vector<int>& nodes, const Eigen::MatrixXd& x,
                          const ShellSection& section, double thickness);

// A panel that bears nothing but shear flow along its four edges, which forces along its diagonals
// take to its corners: Garvey, Quarterly J. Mech. Appl. Math. 4 (1951) 139-155. In the plane of
// the diagonals the flow goes as 1 / p^2, p the distance from the line through the two points where
// opposite edges meet, and its energy per area is q^2 / (2 G t) (1 + 2 cot^2 a / (1 + nu)), a the
// angle between the lines through them. On a rectangle G t area gamma^2 / 2 with the mean strain of
// the corners. A quarter of the mass at each corner. Throws std::invalid_argument for a panel with
// a corner that points inward.
MatrixElement shear_panel(const std::vector<int>& nodes, const Eigen::Matrix<double, 3, 4>& x,
                          double G, double nu, double thickness, double mass_per_area);

// EA/L along the line between the nodes, GJ/L about it; the mass of the translations half at either
// end, as Nastran and Abaqus have it, or consistent.
enum class TrussMass { lumped, consistent };
MatrixElement truss(const std::vector<int>& nodes, const Eigen::Vector3d& x1,
                    const Eigen::Vector3d& x2, double EA, double GJ, double mass_per_length,
                    TrussMass kind = TrussMass::lumped);

// A beam that twists about the line between its ends and bears along another one.
MatrixElement beam_beside_its_line(const std::vector<Eigen::Vector3d>& nodes,
                                   const BeamElement& beam, const Eccentricity& eccentricity);

// A beam with released DOFs at its ends, which are condensed with the static shapes; `released` in
// the local axes, 0..5 of node 1 and 6..11 of node 2, after the offsets.
MatrixElement released_beam(const std::vector<Eigen::Vector3d>& nodes, const BeamElement& beam,
                            const Eigen::Vector3d& up, const std::vector<int>& released,
                            const Eccentricity& eccentricity = {});

// A section along a beam: straight between stations, which go from 0 to 1 of its length.
struct BeamStation {
  double x = 0;
  BeamProperties section;
  Eccentricity eccentricity = {};
};
using Taper = std::vector<BeamStation>;

// A beam whose section varies: sixteen short ones, each with the section in its middle, condensed
// with the static shapes of the whole.
MatrixElement tapered_beam(const std::vector<Eigen::Vector3d>& nodes, const BeamElement& beam,
                           const Taper& taper);

// Says how many shells have walls that are not isotropic, and what that means.
void note_laminates(DeckModel& deck);

// k between single DOFs of nodes, along columns of their axes: k (u1 - u2)^2 / 2, or of one alone.
struct SpringEnd {
  int node = 0;
  Eigen::Matrix<double, 6, 1> direction = Eigen::Matrix<double, 6, 1>::Zero();
};
Eigen::MatrixXd spring_matrix(const std::vector<SpringEnd>& ends, double k);
Eigen::Matrix<double, 6, 1> along(const Eigen::Matrix3d& axes, int dof);

} // namespace plica
