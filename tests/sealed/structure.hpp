// A structure as one small dense system, put together piece by piece.
//
// Unknowns u are displacements in the frame of the room. On a table that moves with u_b,
// u = R u_b + v; what stands on the table is a spring on v, what belongs to the structure does not
// feel R (K R = 0), so both enter K. Then M v'' + K v = -M R a_b over the unknowns not held.
#pragma once

#include <Eigen/Dense>
#include <map>
#include <string>
#include <vector>

namespace sealed {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

enum class Law { bouc_wen, stop, cubic };

// Force over one relative displacement x = row . v, beyond what K holds.
//   bouc_wen  stiffness (z - x), dz = dx (1 - (1 + sgn(dx z)) / 2 |z / slip|^1.5)
//   stop      stiffness (|x| - slip) beyond the gap `slip`
//   cubic     stiffness x^3
struct NonlinearSpring {
  Law law = Law::bouc_wen;
  VectorXd row;
  double stiffness = 0, slip = 0;
  int joint = 0; // springs of one joint slip at one force
};

struct Structure {
  MatrixXd K, M, R;
  std::map<std::string, MatrixXd> places; // rows over the unknowns: six, or three, at a place
  std::vector<int> held;
  std::vector<NonlinearSpring> nonlinear;
  double weighed = 0; // kg, what the scale sees
  MatrixXd rubber;    // added to K times (1 + i loss) (f / 1 kHz)^power; empty = none
};

int add_unknowns(Structure& s, int count);

// A rigid body at a place of six rows, or a point mass at one of three.
void add_mass(Structure& s, const MatrixXd& rows, double mass, const Vector3d& inertia = {0, 0, 0},
              const Vector3d& offset = {0, 0, 0});
// Springs, one for each row; between two places give the difference of their rows.
void add_springs(Structure& s, const MatrixXd& rows, const VectorXd& stiffness);
// A mass on a spring in every direction of a place of three rows (a parasitic oscillator).
void add_oscillator(Structure& s, const MatrixXd& rows, double mass, double frequency);
void add_beam(Structure& s, const MatrixXd& a, const MatrixXd& b, double length, double EA,
              double EI, double GJ); // along y, rigid in shear, massless

// What stands on the table at six unknowns: they are held no longer, but by springs.
void stand_on_springs(Structure& s, const std::string& place, double translation, double rotation);

struct Modes {
  VectorXd w;   // rad/s
  MatrixXd phi; // over all unknowns, zero where held
};
Modes modes_of(const Structure& s);

} // namespace sealed
