// The wall of the short bellows, and one specimen of it reduced once: the sealed suite's own road
// from geometry to matrices.
//
// Two sources: bricks of CalculiX (its shells are expanded bricks; written as bricks here so that
// every node is known), and Plica's shells on a finer mesh. Either gives matrices over free
// unknowns, with the ends and the middle root as rigid bodies, and rows that read named places off.
#pragma once

#include "solve/assembly.hpp"

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace sealed {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct WallShape { // of tests/sealed/short_bellows.yaml, m
  int convolutions = 8;
  double root_radius = 0.040, height = 0.006, pitch = 0.006, cuff = 0.004;
  double thickness = 0.0004; // both plies
  double E = 193e9, nu = 0.3, rho = 8000;
  double length() const { return 2 * cuff + convolutions * pitch; }
  double crown(int k) const { return cuff + (k - 0.5) * pitch; } // y, k from 1
  double root(int k) const { return cuff + (k - 1) * pitch; }
};

enum class Road { calculix, mesh };

// What one specimen of the wall is. Global scatter of E and density is put on the reduced matrices.
struct WallSpecimen {
  Road road = Road::mesh;
  double bond = 0.5;
  double thinning = 0;                             // exponent p of t (r_root / r)^p
  double thickness = 1;                            // factor
  std::array<double, 8> E{1, 1, 1, 1, 1, 1, 1, 1}; // factor per convolution
  int dent = 0;                                    // convolution with a weak sector, 0 = none
  double dent_angle = 0,
         dent_loss = 0; // its middle, from x towards z; E (1 - loss) within 45 degrees
  int refine = 1;       // finer mesh, to show convergence
};

// Factor on E at a place of the wall; the field is linear between the middles of convolutions.
double stiffness_factor(const WallShape& shape, const WallSpecimen& s, double y, double angle);
double thickness_at(const WallShape& shape, const WallSpecimen& s, double radius);
double bending_factor(double bond); // two equal plies

// Reads six or three numbers off the unknowns.
using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// Free unknowns: 6 of the left end, 6 of the ring in the middle root, 6 of the right end, the rest.
constexpr int rigid_unknowns = 18;

struct FullWall {
  plica::SparseMatrix K, M;           // lower triangles
  std::map<std::string, Rows> loaded; // places at which something may be fixed
  std::map<std::string, Rows> read;   // patches of nodes round a sensor, three rows each
  std::map<std::string, std::array<double, 2>> spacing; // of these nodes, along and around, m
  double mass = 0;
};

FullWall brick_wall(const WallShape& shape, const WallSpecimen& s,
                    const std::filesystem::path& folder);
FullWall shell_wall(const WallShape& shape, const WallSpecimen& s);

struct ReducedWall {
  MatrixXd K, M;                          // the first rigid_unknowns as they are
  std::map<std::string, MatrixXd> places; // and "<sensor>.spacing"
  double mass = 0;
};

// Modes with the rigid bodies held, their static shapes, and those of forces at the loaded places.
ReducedWall reduce(const FullWall& wall, int modes = 60);

// The same from a file when it is there.
ReducedWall cached_wall(const WallShape& shape, const WallSpecimen& s,
                        const std::filesystem::path& folder, const std::string& name);

} // namespace sealed
