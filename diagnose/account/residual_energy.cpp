#include "diagnose/account/residual_energy.hpp"

#include "diagnose/weigh/blocks.hpp"
#include "diagnose/weigh/normal_draws.hpp"
#include "diagnose/weigh/scatter.hpp"
#include "run/results/normal_distribution.hpp"
#include "solve/parallel.hpp"
#include "solve/strain_energy.hpp"
#include "words/directions.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double allowed_residual = 0.02; // eps: forces out of balance, of the elastic ones
constexpr int admissible = 200;
constexpr double alike = 0.7; // correlation of shapes that are the same mode

// A measured shape with the rows of the model that answer it.
struct Shape {
  std::string name;
  double omega = 0;
  VectorXd y;                    // its largest motion is one
  std::vector<Index> rows;       // of AffineModes::marked
  std::vector<double> direction; // sign
};

class Expansion {
public:
  explicit Expansion(const NominalState& state, const std::vector<int>& coordinates)
      : names_(state.built.model.components) {
    const AffineModel model = state.model->with({});
    K_ = model.K(coordinates, coordinates);
    M_ = model.M(coordinates, coordinates);
    marked_ = model.marked(Eigen::all, coordinates);
    KM_ = K_.ldlt().solve(M_);
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> pairs(K_, M_);
    lambda_ = pairs.eigenvalues();
    modes_ = pairs.eigenvectors();
    const MatrixXd u = state.model->basis()(Eigen::all, coordinates);
    for (MatrixXd& part : component_stiffness(state.built.model, u)) parts_.push_back(part);
  }

  const std::vector<std::string>& components() const { return names_; }

  // ln of the residual's energy over the strain energy, per component; of those without stiffness
  // nothing.
  VectorXd places(const Shape& s) const {
    MatrixXd c(s.y.size(), K_.cols());
    for (Index i = 0; i < c.rows(); ++i)
      c.row(i) = s.direction[std::size_t(i)] * marked_.row(s.rows[std::size_t(i)]);
    const double lambda = s.omega * s.omega;
    const MatrixXd A = MatrixXd::Identity(K_.rows(), K_.cols()) - lambda * KM_;
    const MatrixXd residual = A.transpose() * K_ * A;
    const MatrixXd fit = c.transpose() * c / (shape_sigma * shape_sigma);
    const VectorXd seen = c.transpose() * s.y / (shape_sigma * shape_sigma);
    const double energy = energy_like(c, s.y);
    const VectorXd q = MatrixXd(fit + residual / (allowed_residual * allowed_residual * energy))
                           .ldlt()
                           .solve(seen);
    const VectorXd R = A * q;
    VectorXd value(Index(parts_.size()));
    for (Index k = 0; k < value.size(); ++k) {
      const MatrixXd& part = parts_[std::size_t(k)];
      constexpr double least = 1e-9;
      const double strain = q.dot(part * q);
      value[k] = strain > least * energy ? std::log(R.dot(part * R) / strain + least) : 0;
    }
    return value;
  }

private:
  // K-energy of the nominal mode most like a shape, of its size.
  double energy_like(const MatrixXd& c, const VectorXd& y) const {
    double most = -1, energy = 1;
    const MatrixXd all = c * modes_;
    // A mode that moves no channel shows what rounding mixed into it, which may be like any shape.
    constexpr double seen = 1e-6;
    const double least = seen * all.colwise().squaredNorm().maxCoeff();
    for (Index i = 0; i < lambda_.size(); ++i) {
      const double along = all.col(i).dot(y), own = all.col(i).squaredNorm();
      if (!(own > least) || along * along / own < most) continue;
      most = along * along / own;
      energy = lambda_[i] * std::pow(along / own, 2);
    }
    return energy;
  }

  std::vector<std::string> names_;
  VectorXd lambda_;
  MatrixXd modes_; // of the reduced model, M-orthonormal
  MatrixXd K_, M_, KM_, marked_;
  std::vector<MatrixXd> parts_;
};

// Row of AffineModes::marked that a channel shows, with its sign; -1 = no such sensor.
std::pair<Index, double> row_of(const NominalState& state, const std::string& channel) {
  if (!is_translation(channel)) return {-1, 1};
  const int axis = axis_of_channel(channel);
  for (std::size_t s = 0; s < state.built.sensors.size(); ++s)
    if (state.built.sensors[s].name == sensor_of_channel(channel)) {
      Index along = 0;
      state.axes[s].row(axis).cwiseAbs().maxCoeff(&along);
      return {6 * Index(s) + along, state.axes[s](axis, along)};
    }
  return {-1, 1};
}

std::vector<Shape> shapes_of(const NominalState& state, const Measured& measured) {
  std::vector<Shape> all;
  for (const MeasuredMode& m : measured.modes) {
    if (!m.vector || !m.state.empty()) continue;
    Shape s{.name = "mode at " + std::to_string(int(std::lround(m.frequency))) + " Hz",
            .omega = 2 * std::numbers::pi * m.frequency,
            .y = {},
            .rows = {},
            .direction = {}};
    std::vector<double> y;
    for (std::size_t i = 0; i < m.vector->channels.size(); ++i) {
      const auto [row, sign] = row_of(state, m.vector->channels[i]);
      if (row < 0) continue;
      s.rows.push_back(row);
      s.direction.push_back(sign);
      y.push_back(m.vector->real[i]);
    }
    if (y.size() < fewest_channels) continue;
    s.y = Eigen::Map<VectorXd>(y.data(), Index(y.size()));
    s.y /= s.y.cwiseAbs().maxCoeff();
    all.push_back(std::move(s));
  }
  return all;
}

// The same mode of an admissible specimen, as it would be measured; false where none is like it.
bool seen_of(const AffineModes& m, Shape& s, NormalDraws& normal) {
  Index best = -1;
  double most = alike;
  VectorXd found;
  for (Index i = 0; i < m.lambda.size(); ++i) {
    VectorXd y(s.y.size());
    for (Index r = 0; r < y.size(); ++r)
      y[r] = s.direction[std::size_t(r)] * m.marked(s.rows[std::size_t(r)], i);
    const double correlation = std::abs(y.dot(s.y)) / (y.norm() * s.y.norm());
    if (correlation > most) {
      most = correlation;
      best = i;
      found = y;
    }
  }
  if (best < 0) return false;
  Index largest = 0;
  found.cwiseAbs().maxCoeff(&largest);
  s.y = found / found[largest];
  for (double& y : s.y) y += shape_sigma * normal();
  s.omega = m.omega(best);
  return true;
}

} // namespace

std::vector<LocatedGap> residual_energy(const Nominal& nominal, const TestReadings& test,
                                        const Measured& measured) {
  const NominalState& state = nominal.states.front();
  const std::vector<Shape> shapes = shapes_of(state, measured);
  if (shapes.empty() || state.built.model.components.size() < 2) return {};
  const std::vector<Hypothesis> varied = scatter(nominal.structure(measured));
  std::vector<const Hypothesis*> together;
  for (const Hypothesis& h : varied) together.push_back(&h);
  const Predictor predict(nominal, test, together);
  const Expansion expansion(state, Predictor(nominal, test, {}).coordinates());

  std::vector<LocatedGap> found;
  for (const Shape& shape : shapes) {
    const VectorXd own = expansion.places(shape);
    std::vector<std::optional<VectorXd>> healthy(admissible);
    in_parallel(admissible, [&](int k) {
      NormalDraws normal(unsigned(k) + 1);
      VectorXd z(predict.parameters());
      for (double& x : z) x = normal();
      const auto modes = predict.modes(predict.values_of(z));
      Shape seen = shape;
      if (modes && seen_of(*modes, seen, normal)) healthy[std::size_t(k)] = expansion.places(seen);
    });
    for (Index c = 0; c < own.size(); ++c) {
      double mean = 0, square = 0, count = 0;
      for (const auto& h : healthy)
        if (h) {
          mean += (*h)[c];
          square += (*h)[c] * (*h)[c];
          ++count;
        }
      constexpr double fewest = 50;
      if (count < fewest) continue;
      mean /= count;
      const double sigma = std::sqrt(std::max(0., square / count - mean * mean));
      if (!(sigma > 1e-9)) continue;
      LocatedGap gap;
      gap.component = expansion.components()[std::size_t(c)];
      gap.band = shape.name;
      gap.of_energy = true;
      gap.z = (own[c] - mean) / sigma;
      found.push_back(gap);
    }
  }
  std::vector<double> p;
  for (const LocatedGap& gap : found) p.push_back(1 - normal_share(gap.z));
  mark_significant(found, p);
  return found;
}

} // namespace plica
