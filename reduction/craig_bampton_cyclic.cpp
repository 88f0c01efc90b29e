#include "reduction/craig_bampton.hpp"
#include "reduction/fixed_interface.hpp"
#include "solve/model_error.hpp"
#include "solve/parallel.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <memory>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// One family: u = Psi D' a + X C f + Phi q over its unknowns, with a the DOFs of the axis nodes and
// f forces at the wall nodes.
struct Family {
  HarmonicSystem system;
  std::shared_ptr<const FixedInterface> blocks;
  MatrixXd D;     // axis DOFs x boundary unknowns
  MatrixXd C;     // loads on the rings x wall DOFs
  MatrixXd loads; // unknowns x loads
  Index first = 0;

  Index modes() const { return blocks->lambda.size(); }
};

// Columns of (a, f, q) in which the family moves: all, but for one that no boundary node feels and
// whose own modes are at rest.
std::vector<int> moved_columns(const Family& f, const MatrixXd& q, Index before) {
  std::vector<int> columns;
  const auto own = q.middleRows(before + f.first, f.modes());
  for (int c = 0; c < q.cols(); ++c)
    if (f.D.cols() > 0 || f.C.cols() > 0 || own.col(c).norm() > 1e-14 * q.col(c).norm())
      columns.push_back(c);
  return columns;
}

class Reducer {
public:
  Reducer(const CyclicModel& model, const std::vector<int>& boundary, double cutoff,
          bool all_harmonics)
      : model_(std::make_shared<CyclicModel>(model)), boundary_(boundary), cutoff_(cutoff),
        all_harmonics_(all_harmonics) {
    for (std::size_t i = 0; i < boundary.size(); ++i) {
      const int ring = model.place(boundary[i]).ring;
      std::vector<int>& nodes = ring < 0 ? axis_ : wall_;
      std::vector<int>& columns = ring < 0 ? axis_columns_ : wall_columns_;
      nodes.push_back(boundary[i]);
      for (int d = 0; d < 6; ++d) columns.push_back(6 * static_cast<int>(i) + d);
      if (ring >= 0) rings_.push_back(ring);
    }
    std::sort(rings_.begin(), rings_.end());
    rings_.erase(std::unique(rings_.begin(), rings_.end()), rings_.end());
  }

  Reduction reduction() {
    find_families();
    gather_matrices();
    const auto T = std::make_shared<const MatrixXd>(coordinates());
    Reduction r{.element = empty_superelement(model_->model(), boundary_, modes_),
                .lambda = lambda_,
                .field = {},
                .field_at = {},
                .proved = true,
                .reason = ""};
    double unreduced = 0;
    for (const Family& f : *families_) {
      unreduced = std::max(unreduced, f.blocks->unreduced);
      r.proved = r.proved && f.blocks->proved;
      if (!f.blocks->proved)
        r.reason = "harmonic " + std::to_string(f.system.harmonic.n) + ": " + f.blocks->reason;
    }
    Superelement& s = r.element;
    const Index n = s.boundary();
    s.K = T->transpose() * K_ * *T;
    s.K.topLeftCorner(n, n) = without_grounding(s.K.topLeftCorner(n, n), s.nodes, unreduced);
    s.K.topRightCorner(n, modes_).setZero(); // K Psi is a force at the boundary, where Phi rests
    s.K.bottomRows(modes_).setZero();
    s.K.diagonal().tail(modes_) = lambda_;
    s.M = T->transpose() * M_ * *T;
    s.M = ((s.M + s.M.transpose()) / 2).eval();
    s.M.bottomRightCorner(modes_, modes_).setIdentity();
    add_recovery(r, T);
    return r;
  }

private:
  Index axis_dofs() const { return 6 * Index(axis_.size()); }
  Index wall_dofs() const { return 6 * Index(wall_.size()); }

  // The harmonics that are taken; of a pair the cosine one is solved.
  void find_families() {
    std::vector<Harmonic> solved{{0, false}, {0, true}, {1, false}};
    if (all_harmonics_ || !wall_.empty())
      for (int n = 2; n < model_->harmonics(); ++n) {
        solved.push_back({n, false});
        if (!model_->is_pair(n)) solved.push_back({n, true});
      }
    families_->resize(solved.size());
    in_parallel(int(solved.size()), [&](int i) {
      Family f = placed(model_->system(solved[i]));
      std::vector<int> numbers;
      for (const auto& [number, column] : unknowns(f.system)) numbers.push_back(number);
      f.blocks = std::make_shared<FixedInterface>(fixed_interface(
          f.system.K, f.system.M, numbers, cutoff_, f.loads, model_->rigid_motions(f.system)));
      (*families_)[i] = std::move(f);
    });
    for (std::size_t i = 0; i < solved.size(); ++i) {
      if (!model_->is_pair(solved[i].n)) continue;
      Family sine = placed(model_->quarter_turned((*families_)[i].system));
      sine.blocks = (*families_)[i].blocks;
      families_->push_back(std::move(sine));
    }
    for (Family& f : *families_) {
      f.first = modes_;
      modes_ += f.modes();
    }
  }

  // Boundary unknowns on the axis in increasing order, each with its column over the axis DOFs.
  std::vector<std::pair<int, VectorXd>> unknowns(const HarmonicSystem& system) const {
    std::vector<std::pair<int, VectorXd>> found;
    for (std::size_t i = 0; i < axis_.size(); ++i)
      for (const AxisUnknown& a : system.axis) {
        if (a.node != axis_[i]) continue;
        VectorXd column = VectorXd::Zero(axis_dofs());
        column.segment<6>(6 * Index(i)) = a.direction;
        found.emplace_back(a.number, column);
      }
    std::sort(found.begin(), found.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    return found;
  }

  Family placed(HarmonicSystem system) const {
    Family f;
    const auto own = unknowns(system);
    f.D.resize(axis_dofs(), Index(own.size()));
    for (std::size_t k = 0; k < own.size(); ++k) f.D.col(Index(k)) = own[k].second;
    const auto count = 6 * Index(rings_.size());
    f.C = MatrixXd::Zero(count, wall_dofs());
    f.loads.resize(system.K.rows(), count);
    const Eigen::SparseMatrix<double> Tt = system.T.transpose();
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      f.loads.middleCols(6 * Index(r), 6) = MatrixXd(Tt.middleCols(6 * rings_[r], 6));
      for (std::size_t i = 0; i < wall_.size(); ++i)
        if (const auto place = model_->place(wall_[i]); place.ring == rings_[r])
          f.C.block<6, 6>(6 * Index(r), 6 * Index(i)) =
              model_->components(system.harmonic, place.step).transpose();
    }
    f.system = std::move(system);
    return f;
  }

  // Matrices over (a, f, q), and the motion of the wall nodes by them.
  void gather_matrices() {
    const Index na = axis_dofs(), nw = wall_dofs(), all = na + nw + modes_;
    K_ = M_ = MatrixXd::Zero(all, all);
    wall_motion_ = MatrixXd::Zero(nw, all);
    for (const Family& f : *families_) {
      const FixedInterface& b = *f.blocks;
      MatrixXd U(b.Psi.rows(), na + nw + f.modes()); // shapes over the unknowns of the family
      U << b.Psi * f.D.transpose(), b.X * f.C, b.Phi;
      MatrixXd m = U.transpose() * symmetric_product(f.system.M, U);
      m.topLeftCorner(na, na) = f.D * b.M_bb * f.D.transpose();
      m.bottomRightCorner(f.modes(), f.modes()).setIdentity();
      const MatrixXd at_wall = f.C.transpose() * (f.loads.transpose() * U);
      std::vector<Index> to;
      for (Index i = 0; i < U.cols(); ++i) to.push_back(i < na + nw ? i : i + f.first);
      for (Index i = 0; i < U.cols(); ++i) {
        wall_motion_.col(to[i]) += at_wall.col(i);
        for (Index j = 0; j < U.cols(); ++j) M_(to[i], to[j]) += m(i, j);
      }
      K_.topLeftCorner(na, na) += f.D * b.K_bb * f.D.transpose();
      K_.diagonal().segment(na + nw + f.first, f.modes()) = b.lambda;
    }
    // K X is a unit force at the wall nodes.
    K_.block(na, na, nw, nw) = wall_motion_.middleCols(na, nw);
    K_.block(na, na + nw, nw, modes_) = wall_motion_.rightCols(modes_);
    K_.block(na + nw, na, modes_, nw) = wall_motion_.rightCols(modes_).transpose();
  }

  // (a, f, q) by the coordinates of the superelement.
  MatrixXd coordinates() {
    const Index na = axis_dofs(), nw = wall_dofs(), n = 6 * Index(boundary_.size());
    MatrixXd T = MatrixXd::Zero(na + nw + modes_, n + modes_);
    for (Index i = 0; i < na; ++i) T(i, axis_columns_[i]) = 1;
    T.bottomRightCorner(modes_, modes_).setIdentity();
    lambda_ = K_.diagonal().tail(modes_);
    if (nw == 0) return T;
    // Forces that give the wall nodes the motion asked for: zero by all but their own columns.
    MatrixXd wanted = MatrixXd::Zero(nw, T.cols());
    for (Index i = 0; i < nw; ++i) wanted(i, wall_columns_[i]) = 1;
    wanted -= wall_motion_ * T;
    const MatrixXd F = wall_motion_.middleCols(na, nw);
    const VectorXd scale = F.diagonal().cwiseSqrt().cwiseInverse(); // m/N beside rad/Nm
    const MatrixXd balanced = scale.asDiagonal() * F * scale.asDiagonal();
    const Eigen::LLT<MatrixXd> flexibility(MatrixXd((balanced + balanced.transpose()) / 2));
    if (flexibility.info() != Eigen::Success)
      throw ModelError("the boundary nodes on the wall cannot be moved one by one");
    T.middleRows(na, nw) =
        scale.asDiagonal() * flexibility.solve(MatrixXd(scale.asDiagonal() * wanted));
    if (modes_ == 0) return T;
    const auto modal = T.rightCols(modes_);
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(
        MatrixXd(modal.transpose() * K_ * modal), MatrixXd(modal.transpose() * M_ * modal));
    lambda_ = solver.eigenvalues();
    T.rightCols(modes_) = (modal * solver.eigenvectors()).eval();
    return T;
  }

  void add_recovery(Reduction& r, const std::shared_ptr<const MatrixXd>& T) const {
    const Index na = axis_dofs(), nw = wall_dofs();
    const auto unknowns_of = [na, nw](const Family& f, const MatrixXd& q) {
      return MatrixXd(f.blocks->Psi * (f.D.transpose() * q.topRows(na)) +
                      f.blocks->X * (f.C * q.middleRows(na, nw)) +
                      f.blocks->Phi * q.middleRows(na + nw + f.first, f.modes()));
    };
    r.field = [model = model_, families = families_, unknowns_of, T, na, nw](const MatrixXd& c) {
      const MatrixXd q = *T * c;
      MatrixXd u = MatrixXd::Zero(dof_count(model->model()), c.cols());
      for (const Family& f : *families) {
        const std::vector<int> columns = moved_columns(f, q, na + nw);
        MatrixXd own = MatrixXd::Zero(u.rows(), Index(columns.size()));
        model->add_expanded(f.system, unknowns_of(f, q(Eigen::all, columns)), own);
        for (std::size_t k = 0; k < columns.size(); ++k) u.col(columns[k]) += own.col(Index(k));
      }
      return u;
    };
    r.field_at = [model = model_, families = families_, unknowns_of, T, na,
                  nw](const MatrixXd& c, const std::vector<int>& nodes) {
      const MatrixXd q = *T * c;
      MatrixXd u = MatrixXd::Zero(6 * Index(nodes.size()), c.cols());
      for (const Family& f : *families) {
        const std::vector<int> columns = moved_columns(f, q, na + nw);
        if (columns.empty()) continue;
        const MatrixXd own = model->expand(f.system, unknowns_of(f, q(Eigen::all, columns)), nodes);
        for (std::size_t k = 0; k < columns.size(); ++k) u.col(columns[k]) += own.col(Index(k));
      }
      return u;
    };
  }

  std::shared_ptr<const CyclicModel> model_;
  const std::vector<int>& boundary_;
  double cutoff_;
  bool all_harmonics_;
  std::vector<int> axis_, wall_;                 // boundary nodes
  std::vector<int> axis_columns_, wall_columns_; // their DOFs among the coordinates
  std::vector<int> rings_;                       // that hold wall nodes
  std::shared_ptr<std::vector<Family>> families_ = std::make_shared<std::vector<Family>>();
  Index modes_ = 0;
  MatrixXd K_, M_, wall_motion_; // over (a, f, q)
  VectorXd lambda_;
};

} // namespace

Reduction craig_bampton(const CyclicModel& model, const std::vector<int>& boundary, double cutoff,
                        bool all_harmonics) {
  check_boundary(model.model(), boundary);
  return Reducer(model, boundary, cutoff, all_harmonics).reduction();
}

} // namespace plica
