#include "model/shape/constraint_clash.hpp"
#include "reduction/cyclic_modes.hpp"
#include "run/routes/route.hpp"
#include "run/stages.hpp"
#include "solve/effective_mass.hpp"
#include "solve/mode_labels.hpp"
#include "solve/model_error.hpp"
#include "solve/static_correction.hpp"
#include "solve/stopwatch.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Base motion and rigid bodies live in these.
constexpr std::array rigid_harmonics{Harmonic{0, false}, Harmonic{0, true}, Harmonic{1, false},
                                     Harmonic{1, true}};

MatrixXd padded(const MatrixXd& rows, const std::vector<int>& free, Eigen::Index all) {
  MatrixXd q = MatrixXd::Zero(all, rows.cols());
  q(free, Eigen::all) = rows;
  return q;
}

class CyclicRoute : public Route {
public:
  CyclicRoute(const BuiltCase& built, CyclicModel model, const StageListener& stage, Timing& timing)
      : built_(built), model_(std::move(model)), stage_(stage), timing_(timing),
        unknowns_(eliminate_constraints(built.model).size()) {}

  std::string name() const override {
    return "rotational symmetry, " + std::to_string(model_.around()) + " sectors";
  }
  int unknowns() const override { return unknowns_; }

  double mass() const override {
    const HarmonicSystem s = model_.system({0, false});
    const VectorXd along = model_.rigid_motions(s).col(1);
    return along.dot(symmetric_product(s.M, along).col(0));
  }

  std::optional<Matrix1212> end_stiffness(const std::array<int, 2>& caps) override {
    stage_(stages::statics);
    Matrix1212 K = Matrix1212::Zero();
    const CyclicModel& part = without_mount();
    ends_.clear();
    solved_caps_.reset();
    for (const Harmonic& h : rigid_harmonics) {
      End end{.system = part.system(h), .unknowns = {}, .inner = std::nullopt};
      for (int side : {0, 1})
        for (const AxisUnknown& a : end.system.axis) {
          if (a.node != caps[side]) continue;
          if (a.number < 0) return std::nullopt;
          end.unknowns.push_back({a.number, side, a.direction});
        }
      std::sort(end.unknowns.begin(), end.unknowns.end(),
                [](const auto& a, const auto& b) { return a.number < b.number; });
      const SparseMatrix inner = restrict_to(
          end.system.K, complement(static_cast<int>(end.system.K.rows()), end.boundary()));
      end.inner.emplace(inner);
      if (!end.inner->factorise(inner).ok)
        throw ModelError("static stiffness: the part is a mechanism when both caps are held");
      const MatrixXd condensed = condense(end.system.K, end.boundary(), *end.inner);
      const MatrixXd D = end.directions();
      K += D * condensed * D.transpose();
      ends_.push_back(std::move(end));
    }
    solved_caps_ = caps;
    watch_.lap(timing_, "statics");
    return K;
  }

  MatrixXd follow(const std::array<int, 2>& caps, const MatrixXd& motion) override {
    if (solved_caps_ != caps && !end_stiffness(caps))
      throw std::logic_error("a support holds one of the caps that are to move");
    MatrixXd u = MatrixXd::Zero(dof_count(built_.model), motion.cols());
    for (const End& end : ends_)
      u += model_.expand(end.system, follow_boundary(end.system.K, end.boundary(), *end.inner,
                                                     end.directions().transpose() * motion));
    return u;
  }

  ModalSolution modes(const ModesRequest& request, const Loads& loads,
                      const std::vector<int>& sensors) override {
    stage_(stages::modes);
    CyclicModes found = find_cyclic_modes(model_, built_.held_nodes, request);
    ModalSolution solution;
    solution.timing = found.timing;
    solution.proof = found.proof;
    solution.modes = static_cast<int>(found.modes.size());
    solution.rounding.resize(solution.modes);
    for (int i = 0; i < solution.modes; ++i)
      solution.rounding[i] = found.modes[std::size_t(i)].rounding;
    for (const CyclicFamily& family : found.families) {
      solution.free_body = solution.free_body || family.shift < 0;
      solution.with_mass +=
          (model_.is_pair(family.system.harmonic.n) ? 2 : 1) * dofs_with_mass(family.M);
    }
    if (!loads.base.empty()) require_held(solution.free_body, built_);
    watch_ = Stopwatch();
    Columns columns(Eigen::Index(loads.base.size()));
    MatrixXd about_origin = MatrixXd::Zero(6, 6); // r' M r of the free part
    for (int f = 0; f < int(found.families.size()); ++f) {
      CyclicFamily& family = found.families[f];
      const int n = family.system.harmonic.n;
      add_family(found, f, family, loads, columns, about_origin);
      if (!model_.is_pair(n)) continue;
      family.system = model_.quarter_turned(std::move(family.system));
      add_family(found, f, family, loads, columns, about_origin);
    }
    columns.write(solution);
    const CentralMass free = refer_to_centre(about_origin, solution.participation);
    solution.mass = free.mass;
    solution.free_mass = free.total;
    // The convention for pairs, for the participation and the input as for the shapes.
    const Eigen::Index n = solution.modes;
    MatrixXd rows(6 + Eigen::Index(loads.base.size()), n);
    rows << solution.participation.transpose(), solution.input.topRows(n).transpose();
    MatrixXd u = solution.u.leftCols(n);
    orient_modes(built_.model, sensors, solution.lambda.head(n), rows, u);
    solution.u.leftCols(n) = u;
    solution.participation = rows.topRows(6).transpose();
    solution.input.topRows(n) = rows.bottomRows(rows.rows() - 6).transpose();
    return solution;
  }

private:
  struct EndUnknown {
    int number = 0, side = 0;
    Eigen::Matrix<double, 6, 1> direction;
  };
  struct End { // one harmonic between the two caps
    HarmonicSystem system;
    std::vector<EndUnknown> unknowns; // increasing number
    std::optional<SparseFactor> inner;

    std::vector<int> boundary() const {
      std::vector<int> numbers;
      for (const EndUnknown& u : unknowns) numbers.push_back(u.number);
      return numbers;
    }
    MatrixXd directions() const { // 12 x unknowns
      MatrixXd D = MatrixXd::Zero(12, Eigen::Index(unknowns.size()));
      for (std::size_t k = 0; k < unknowns.size(); ++k)
        D.block<6, 1>(6 * unknowns[k].side, Eigen::Index(k)) = unknowns[k].direction;
      return D;
    }
  };

  // Modes and pseudo-modes of all families, sorted when written.
  struct Columns {
    explicit Columns(Eigen::Index loads) : loads_(loads) {}

    struct Column {
      double lambda = 0, residual = 0;
      bool pseudo = false;
      VectorXd u, input;
      Eigen::Matrix<double, 6, 1> participation;
    };
    std::vector<Column> all;

    void write(ModalSolution& solution) {
      std::stable_sort(all.begin(), all.end(), [](const Column& a, const Column& b) {
        return std::pair(a.pseudo, a.lambda) < std::pair(b.pseudo, b.lambda);
      });
      const auto count = static_cast<Eigen::Index>(all.size());
      solution.lambda.resize(count);
      solution.u.resize(count > 0 ? all[0].u.size() : 0, count);
      solution.input.resize(count, loads_);
      solution.residual.resize(solution.modes);
      solution.participation.resize(solution.modes, 6);
      for (Eigen::Index j = 0; j < count; ++j) {
        solution.lambda[j] = all[j].lambda;
        solution.u.col(j) = all[j].u;
        solution.input.row(j) = all[j].input.transpose();
        if (j >= solution.modes) continue;
        solution.residual[j] = all[j].residual;
        solution.participation.row(j) = all[j].participation.transpose();
      }
    }

  private:
    Eigen::Index loads_;
  };

  // A spring mount is not the part. Left away before assembly: subtracted, a stiff one would leave
  // its rounding in place of the part.
  const CyclicModel& without_mount() {
    const auto to_ground = [](const BushingElement& b) { return b.node2 < 0; };
    const auto& springs = built_.model.bushings;
    if (!part_ && std::any_of(springs.begin(), springs.end(), to_ground)) {
      unmounted_ = std::make_unique<Model>(built_.model);
      std::erase_if(unmounted_->bushings, to_ground);
      part_ = std::get<CyclicModel>(cyclic_model(*unmounted_));
    }
    return part_ ? *part_ : model_;
  }

  // -M r and forces over the free unknowns of a family.
  MatrixXd loads_of(const CyclicFamily& family, const Loads& loads, const MatrixXd& Mr) const {
    MatrixXd F(Eigen::Index(family.free.size()), Eigen::Index(loads.base.size()));
    const bool forces =
        std::any_of(loads.base.begin(), loads.base.end(), [](int b) { return b < 0; });
    MatrixXd gathered;
    if (forces) gathered = model_.gather(family.system, loads.force);
    for (Eigen::Index k = 0; k < F.cols(); ++k) {
      if (loads.base[k] >= 0)
        F.col(k) = -Mr.col(loads.base[k]);
      else
        F.col(k) = gathered.col(k)(family.free);
    }
    return F;
  }

  void add_family(const CyclicModes& found, int f, const CyclicFamily& family, const Loads& loads,
                  Columns& columns, MatrixXd& about_origin) const {
    const HarmonicSystem& s = family.system;
    const MatrixXd r = model_.rigid_motions(s);
    const MatrixXd Mr = symmetric_product(s.M, r)(family.free, Eigen::all);
    about_origin += r(family.free, Eigen::all).transpose() *
                    symmetric_product(family.M, r(family.free, Eigen::all));
    std::vector<int> kept;
    for (const CyclicMode& m : found.modes)
      if (m.family == f && m.sine == s.harmonic.sine) kept.push_back(m.column);
    const MatrixXd Phi = family.Phi.cols() > 0 ? MatrixXd(family.Phi(Eigen::all, kept))
                                               : MatrixXd(family.K.rows(), 0);
    const VectorXd lambda = kept.empty() ? VectorXd(0) : VectorXd(family.lambda(kept));
    const MatrixXd F = loads_of(family, loads, Mr), active = acting(F, loads);
    MatrixXd X(F.rows(), 0);
    if (active.cols() > 0) {
      SparseFactor factor(family.K);
      factor.factorise(family.K);
      X = factor.solve(active);
    }
    const ModalBasis basis = add_static_correction(family.K, family.M, lambda, Phi, X);
    if (basis.lambda.size() == 0) return;
    const MatrixXd u = model_.expand(s, padded(basis.Phi, family.free, s.K.rows()));
    const MatrixXd input = basis.Phi.transpose() * F;
    const MatrixXd own_Mr =
        symmetric_product(family.M, r(family.free, Eigen::all)); // of the free part alone
    const MatrixXd participation = basis.Phi.transpose() * own_Mr;
    for (Eigen::Index j = 0; j < basis.lambda.size(); ++j)
      columns.all.push_back(
          {.lambda = basis.lambda[j],
           .residual = j < basis.modes ? family.residual[kept[std::size_t(j)]] : 0,
           .pseudo = j >= basis.modes,
           .u = u.col(j),
           .input = input.row(j).transpose(),
           .participation = participation.row(j).transpose()});
  }

  // Loads that act on this harmonic at all: gathering leaves rounding of those that do not.
  static MatrixXd acting(const MatrixXd& F, const Loads& loads) {
    std::vector<int> columns;
    for (Eigen::Index k = 0; k < F.cols(); ++k) {
      const double size = loads.base[k] >= 0 ? 0 : 1e-10 * loads.force.col(k).norm();
      if (F.col(k).norm() > size) columns.push_back(int(k));
    }
    return F(Eigen::all, columns);
  }

  const BuiltCase& built_;
  CyclicModel model_;
  std::unique_ptr<Model> unmounted_; // without its spring mount, where it has one
  std::optional<CyclicModel> part_;  // of that; refers to it
  const StageListener& stage_;
  Timing& timing_;
  Stopwatch watch_;
  int unknowns_;
  std::vector<End> ends_; // of the solved caps
  std::optional<std::array<int, 2>> solved_caps_;
};

} // namespace

std::unique_ptr<Route> cyclic_route(const BuiltCase& built, CyclicModel model,
                                    const StageListener& stage, Timing& timing) {
  return std::make_unique<CyclicRoute>(built, std::move(model), stage, timing);
}

} // namespace plica
