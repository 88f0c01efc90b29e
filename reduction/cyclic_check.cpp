#include "reduction/cyclic_model.hpp"
#include "solve/element_view.hpp"
#include "words/short_text.hpp"

#include <cmath>
#include <map>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Matrix6x6 = Eigen::Matrix<double, 6, 6>;

constexpr double same_within = 1e-9; // relative

// Rotation of the six DOFs about y that takes x towards z.
Matrix6x6 turn(double angle) {
  Eigen::Matrix3d R;
  R << std::cos(angle), 0, -std::sin(angle), 0, 1, 0, std::sin(angle), 0, std::cos(angle);
  Matrix6x6 T = Matrix6x6::Zero();
  T.topLeftCorner<3, 3>() = T.bottomRightCorner<3, 3>() = R;
  return T;
}

bool unchanged_by(const MatrixXd& turn, const MatrixXd& A) {
  const MatrixXd turned = turn * A * turn.transpose();
  return (turned - A).norm() <= same_within * A.norm();
}

std::string node_text(int node) {
  return "node " + std::to_string(node + 1);
}

} // namespace

// Builds the symmetric view step by step; each step returns what breaks it, or nothing.
class SymmetryCheck {
public:
  explicit SymmetryCheck(const Model& model) : model_(model) { view_.model_ = &model; }

  std::variant<CyclicModel, std::string> result() {
    for (const auto step : {&SymmetryCheck::rings, &SymmetryCheck::axis, &SymmetryCheck::quads,
                            &SymmetryCheck::axis_elements, &SymmetryCheck::constraints}) {
      const std::string broken = (this->*step)();
      if (!broken.empty()) return broken;
    }
    return std::move(view_);
  }

private:
  std::string rings() {
    const std::vector<Ring>& rings = model_.mesh.rings;
    if (rings.empty() || model_.mesh.quads.empty() || !model_.mesh.triangles.empty())
      return "it is no shell of revolution";
    const int N = view_.around_ = static_cast<int>(rings.front().nodes.size());
    view_.rings_ = static_cast<int>(rings.size());
    view_.place_.assign(model_.mesh.nodes.size(), {});
    if (N < 5) return "it has fewer than five sectors";
    for (int i = 0; i < view_.rings_; ++i) {
      if (static_cast<int>(rings[i].nodes.size()) != N)
        return "its rings do not all have " + std::to_string(N) + " nodes";
      for (int j = 0; j < N; ++j) {
        const int node = rings[i].nodes[j];
        const Eigen::Vector3d place = (turn(2 * M_PI * j / N).topLeftCorner<3, 3>() *
                                       Eigen::Vector3d(rings[i].radius, rings[i].y, 0));
        if ((model_.mesh.nodes[node] - place).norm() > same_within * place.norm())
          return node_text(node) + " is off its ring";
        if (view_.place_[node].ring >= 0) return node_text(node) + " lies on two rings";
        view_.place_[node] = {i, j};
      }
    }
    return "";
  }

  std::string axis() {
    for (int node = 0; node < static_cast<int>(model_.mesh.nodes.size()); ++node) {
      if (view_.place_[node].ring >= 0) continue;
      const Eigen::Vector3d& x = model_.mesh.nodes[node];
      if (std::hypot(x.x(), x.z()) > same_within * model_.mesh.rings.front().radius)
        return node_text(node) + " lies neither on a ring nor on the axis";
      view_.axis_nodes_.push_back(node);
    }
    return "";
  }

  // Rings and sides of the corners of a quad, and its sector; -1 = not between two neighbours.
  int sector_of(const ShellQuad& quad, CyclicModel::BeltPlace& belt) const {
    const int N = view_.around_;
    std::array<int, 4> step{};
    int low = view_.rings_, high = -1;
    for (int a = 0; a < 4; ++a) {
      const CyclicModel::NodePlace& place = view_.place_[quad.nodes[a]];
      belt.ring[a] = place.ring;
      step[a] = place.step;
      low = std::min(low, place.ring);
      high = std::max(high, place.ring);
    }
    if (low < 0 || high != low + 1) return -1;
    for (int first : step) {
      bool between = true;
      for (int a = 0; a < 4; ++a) {
        belt.side[a] = (step[a] - first + N) % N;
        between = between && belt.side[a] <= 1;
      }
      if (between && belt.side != std::array<int, 4>{}) return first;
    }
    return -1;
  }

  std::string quads() {
    const int N = view_.around_;
    std::map<int, const ShellQuad*> first; // by left ring: the quad of sector 0
    std::vector<std::vector<int>> of_sector(N);
    std::vector<CyclicModel::BeltPlace> belts(model_.mesh.quads.size());
    for (std::size_t e = 0; e < belts.size(); ++e) {
      const int sector = sector_of(model_.mesh.quads[e], belts[e]);
      if (sector < 0) return "a quad does not lie between two neighbouring rings and steps";
      of_sector[sector].push_back(static_cast<int>(e));
    }
    for (int j = 0; j < N; ++j) {
      if (of_sector[j].size() != of_sector[0].size())
        return "its sectors differ in number of quads";
      const Eigen::Matrix3d back = turn(-2 * M_PI * j / N).topLeftCorner<3, 3>();
      for (std::size_t k = 0; k < of_sector[j].size(); ++k) {
        const CyclicModel::BeltPlace &own = belts[of_sector[j][k]], &zero = belts[of_sector[0][k]];
        const ShellQuad &a = model_.mesh.quads[of_sector[j][k]],
                        &b = model_.mesh.quads[of_sector[0][k]];
        if (own.ring != zero.ring || own.side != zero.side || a.section != b.section ||
            (a.thickness - b.thickness).norm() > same_within * b.thickness.norm() ||
            (back * a.directors - b.directors).norm() > same_within)
          return "the wall of sector " + std::to_string(j + 1) + " differs from that of the first";
      }
    }
    view_.sector_.resize(of_sector[0].size());
    bool mirrored = true;
#pragma omp parallel for schedule(static) reduction(&& : mirrored)
    for (int k = 0; k < static_cast<int>(of_sector[0].size()); ++k) {
      const int e = of_sector[0][k];
      view_.sector_[k] = with_matrices(belts[e], e);
      mirrored = mirrored && is_mirrored(view_.sector_[k]);
    }
    return mirrored ? "" : "a sector is not its own mirror image";
  }

  CyclicModel::Belt with_matrices(const CyclicModel::BeltPlace& place, int quad) const {
    CyclicModel::Belt belt{place, {}, {}};
    Matrix24 B = Matrix24::Zero();
    for (int a = 0; a < 4; ++a)
      B.block<6, 6>(6 * a, 6 * a) = cyclic_components(belt.side[a], view_.around_);
    ElementView{model_}.visit(quad, [&](const auto&, const auto& K, const auto& M) {
      if constexpr (std::is_same_v<std::decay_t<decltype(K)>, Matrix24>) {
        belt.K = B.transpose() * K * B;
        belt.M = B.transpose() * M * B;
      }
    });
    return belt;
  }

  // Sides exchanged and odd components reversed give the same matrices.
  static bool is_mirrored(const CyclicModel::Belt& belt) {
    Matrix24 P = Matrix24::Zero();
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b)
        if (belt.ring[a] == belt.ring[b] && belt.side[a] != belt.side[b])
          P.block<6, 6>(6 * a, 6 * b).diagonal() << 1, 1, 1, -1, -1, -1;
    return unchanged_by(P, belt.K) && unchanged_by(P, belt.M);
  }

  std::string axis_elements() {
    const ElementView elements{model_};
    const Matrix6x6 R = turn(1);
    for (int e = static_cast<int>(model_.mesh.quads.size()); e < elements.size(); ++e) {
      for (int node : elements.nodes(e))
        if (view_.place_[node].ring >= 0)
          return "an element other than a shell sits on the wall at " + node_text(node);
      bool turns = true;
      elements.visit(e, [&](const auto&, const auto& K, const auto& M) {
        MatrixXd T = MatrixXd::Zero(K.rows(), K.rows());
        for (Eigen::Index i = 0; i < K.rows(); i += 6) T.block<6, 6>(i, i) = R;
        turns = unchanged_by(T, K) && unchanged_by(T, M);
      });
      if (!turns)
        return "an element on the axis at " + node_text(elements.nodes(e)[0]) +
               " is not the same in all directions";
    }
    return "";
  }

  // Rows of a dependent node: coefficients by the node they refer to, turned back by its step.
  std::map<std::pair<int, int>, Matrix6x6> coefficients(int node) const {
    std::map<std::pair<int, int>, Matrix6x6> blocks; // key: ring, or -1 - node on the axis; step
    for (int row : view_.rows_of_[node]) {
      const Constraint& c = model_.constraints[row];
      for (const ConstraintTerm& t : c.terms) {
        const CyclicModel::NodePlace& place = view_.place_[t.node];
        const std::pair key{place.ring < 0 ? -1 - t.node : place.ring, place.step};
        const auto [at, fresh] = blocks.try_emplace(key, Matrix6x6::Zero());
        at->second(c.dof, t.dof) += t.factor;
      }
    }
    return blocks;
  }

  // x and z together, of displacement and of rotation.
  bool directions_complete(int node) const {
    std::array<bool, 6> dependent{};
    for (int row : view_.rows_of_[node]) dependent[model_.constraints[row].dof] = true;
    return dependent[0] == dependent[2] && dependent[3] == dependent[5];
  }

  std::string constraints() {
    const int N = view_.around_;
    view_.rows_of_.resize(model_.mesh.nodes.size());
    for (std::size_t row = 0; row < model_.constraints.size(); ++row)
      view_.rows_of_[model_.constraints[row].node].push_back(static_cast<int>(row));
    for (int node : view_.axis_nodes_) {
      if (!directions_complete(node)) return node_text(node) + " is held in x or z alone";
      const auto blocks = coefficients(node);
      for (const auto& [key, C] : blocks) {
        const auto& [ring, step] = key;
        if (ring < 0) {
          if ((turn(1) * C * turn(1).transpose() - C).norm() > same_within * (1 + C.norm()))
            return "a coupling on the axis is not the same in all directions";
          continue;
        }
        const auto zero = blocks.find({ring, 0});
        const Matrix6x6 R = turn(2 * M_PI * step / N);
        if (zero == blocks.end() ||
            (R.transpose() * C * R - zero->second).norm() > same_within * (1 + C.norm()))
          return "a coupling does not tie a whole ring evenly";
      }
    }
    for (const Ring& ring : model_.mesh.rings) {
      const auto zero = coefficients(ring.nodes[0]);
      for (int j = 0; j < N; ++j) {
        const int node = ring.nodes[j];
        if (!directions_complete(node) ||
            view_.rows_of_[node].size() != view_.rows_of_[ring.nodes[0]].size())
          return "the ring at y = " + short_text(ring.y, 6) + " m is not held evenly";
        const Matrix6x6 R = turn(2 * M_PI * j / N);
        const auto blocks = coefficients(node);
        for (const auto& [key, C] : blocks) {
          const auto other = zero.find(key);
          if (key.first >= 0) return "a ring follows other nodes of the wall";
          if (other == zero.end() ||
              (R.transpose() * C * R - other->second).norm() > same_within * (1 + C.norm()))
            return "the ring at y = " + short_text(ring.y, 6) + " m is not tied evenly";
        }
      }
    }
    return "";
  }

  const Model& model_;
  CyclicModel view_;
};

std::variant<CyclicModel, std::string> cyclic_model(const Model& model) {
  return SymmetryCheck(model).result();
}

} // namespace plica
