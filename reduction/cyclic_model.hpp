// Rotational symmetry: a model whose shells repeat N times around the y axis falls into independent
// problems of one sector, one per circumferential harmonic n = 0..N/2.
//
// On the node at angle t_j = 2 pi j / N of ring i the displacement is
//   even components u_r, u_y, phi_t  = a cos(n t_j)          family "cosine"
//   odd components  u_t, phi_r, phi_y = b sin(n t_j)
// or, turned by a quarter wave, a sin(n t_j) and -b cos(n t_j) ("sine"). Because the sector is its
// own mirror image, a and b are real and both families have the same matrices for 0 < n < N/2; for
// n = 0 and n = N/2 the cosine family holds the even and the sine family the odd components alone.
// The energy of the whole part is the sum of the sectors, so the matrices are those of the full
// mesh in these coordinates: nothing is approximated (Thomas, IJNME 14 (1979) 81-102).
//
// Nodes on the axis (rigid caps, interlock) take part in n = 0 (u_y; phi_y) and n = 1 (u_x, phi_z;
// u_z, phi_x) only. Angles run from x towards z.
#pragma once

#include "solve/assembly.hpp"

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace plica {

struct Harmonic {
  int n = 0;
  bool sine = false;
};

// An unknown on the axis: its node and how its six DOFs follow.
struct AxisUnknown {
  int node = 0;
  Eigen::Matrix<double, 6, 1> direction; // of the global DOFs
  int number = -1;                       // among the independent unknowns; -1: it follows others
};

// K and M of one harmonic over its independent unknowns.
struct HarmonicSystem {
  Harmonic harmonic;
  SparseMatrix K, M;             // lower triangles, the same pattern
  Eigen::SparseMatrix<double> T; // all coordinates of the harmonic x independent ones
  std::vector<int> coordinate;   // of each independent unknown
  std::vector<AxisUnknown> axis; // after the 6 x rings coordinates
};

// Directions of the six components on the node at step j of N, as columns over its global DOFs.
Eigen::Matrix<double, 6, 6> cyclic_components(int step, int around);

class CyclicModel {
public:
  int around() const { return around_; }
  int harmonics() const { return around_ / 2 + 1; }
  const Model& model() const { return *model_; }

  // True when both families have the same matrices.
  bool is_pair(int n) const { return n > 0 && 2 * n < around_; }

  HarmonicSystem system(const Harmonic& harmonic) const;

  // The sine family of a cosine one with the same matrices (0 < n < N/2).
  HarmonicSystem quarter_turned(HarmonicSystem cosine) const;

  // All DOFs (six per node) from independent unknowns, and forces the other way, column by column.
  Eigen::MatrixXd expand(const HarmonicSystem& system, const Eigen::MatrixXd& q) const;
  void add_expanded(const HarmonicSystem& system, const Eigen::MatrixXd& q,
                    Eigen::MatrixXd& u) const;
  // The six DOFs of chosen nodes alone.
  Eigen::MatrixXd expand(const HarmonicSystem& system, const Eigen::MatrixXd& q,
                         const std::vector<int>& nodes) const;
  Eigen::MatrixXd gather(const HarmonicSystem& system, const Eigen::MatrixXd& force) const;

  // Rigid motions about the origin that the harmonic holds, independent unknowns x 6; zero columns
  // for the others.
  Eigen::MatrixXd rigid_motions(const HarmonicSystem& system) const;

  struct NodePlace {
    int ring = -1, step = 0; // ring -1: on the axis
  };
  NodePlace place(int node) const { return place_[node]; }

  // The six DOFs of the node at a step by the six components of its ring.
  Eigen::Matrix<double, 6, 6> components(const Harmonic& harmonic, int step) const;

  struct BeltPlace { // rings and sides (0 or 1) of the corners of a quad
    std::array<int, 4> ring{}, side{};
  };
  struct Belt : BeltPlace { // one quad of the sector
    Matrix24 K, M;          // in the components (u_r u_y phi_t u_t phi_r phi_y) of each corner
  };

private:
  friend class SymmetryCheck;

  double weight(const Harmonic& h, int component, int step) const;
  bool active(const Harmonic& h, int component) const;
  std::vector<AxisUnknown> axis_unknowns(const Harmonic& h) const;
  // What a dependent coordinate is of others, by their numbers; none: it is independent.
  using Terms = std::vector<std::pair<int, double>>;
  Terms by_axis(const std::vector<AxisUnknown>& axis, int node, int dof, double factor) const;
  std::optional<Terms> ring_follows(const HarmonicSystem& system, int ring, int component) const;
  std::optional<Terms> axis_follows(const HarmonicSystem& system, const AxisUnknown& unknown) const;
  void follow(HarmonicSystem& system) const;

  const Model* model_ = nullptr;
  int around_ = 0, rings_ = 0; // steps round, rings along
  std::vector<Belt> sector_;
  std::vector<NodePlace> place_; // per node of the model
  std::vector<int> axis_nodes_;
  std::vector<std::vector<int>> rows_of_; // constraints by dependent node
};

// The symmetric view of a model, which must outlive it; or, in words, what breaks the symmetry.
std::variant<CyclicModel, std::string> cyclic_model(const Model& model);

} // namespace plica
