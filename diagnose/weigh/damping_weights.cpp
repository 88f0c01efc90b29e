#include "diagnose/weigh/damping_weights.hpp"

#include "diagnose/predict/predictor.hpp"
#include "solve/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

bool feels_damping(const Reading& r) {
  return r.run >= 0 && (r.kind == ReadingKind::damping || r.kind == ReadingKind::amplitude ||
                        r.kind == ReadingKind::cross);
}

// What is seen of each mode, a column each: motion of the table along x, z and y that excites it,
// and motion of the observed places, both without units.
MatrixXd seen_of(const AffineModes& m, double mass) {
  MatrixXd seen(3 + m.marked.rows(), m.lambda.size());
  for (const auto& [row, axis] : {std::pair{0, 0}, {1, 2}, {2, 1}})
    seen.row(row) = m.gamma.col(axis).transpose() / std::sqrt(mass);
  seen.bottomRows(m.marked.rows()) = std::sqrt(mass) * m.marked;
  for (Index row = 0; row < m.marked.rows(); ++row)
    if (row % 6 >= 3) seen.row(3 + row).setZero(); // turning: has units
  return seen;
}

// Rotation of modes of one frequency after which the first alone shows what comes first in `seen`.
MatrixXd by_direction(MatrixXd seen) {
  const Index n = seen.cols();
  MatrixXd turned = MatrixXd::Identity(n, n);
  constexpr double shows = 0.1; // of the largest
  for (Index i = 0; i + 1 < n; ++i) {
    const VectorXd size = seen.rightCols(n - i).rowwise().norm();
    Index row = 0;
    while (row + 1 < size.size() && !(size[row] > shows * size.maxCoeff())) ++row;
    for (Index j = i + 1; j < n; ++j) {
      Eigen::JacobiRotation<double> one;
      one.makeGivens(seen(row, i), seen(row, j));
      seen.applyOnTheRight(i, j, one);
      turned.applyOnTheRight(i, j, one);
    }
  }
  return turned;
}

// Modes of one frequency, which a solver turns among each other as it likes, each along an axis.
void settle(AffineModes& m, double mass) {
  constexpr double alike = 1e-4; // of lambda
  const MatrixXd seen = seen_of(m, mass);
  for (Index first = 0, n = 1; first < m.lambda.size(); first += n) {
    for (n = 1; first + n < m.lambda.size() &&
                m.lambda[first + n] - m.lambda[first] < alike * m.lambda[first];)
      ++n;
    if (n == 1) continue;
    const MatrixXd Q = by_direction(seen.middleCols(first, n));
    m.gamma.middleRows(first, n) = (Q.transpose() * m.gamma.middleRows(first, n)).eval();
    m.marked.middleCols(first, n) = (m.marked.middleCols(first, n) * Q).eval();
    m.likeness.middleCols(first, n) = (m.likeness.middleCols(first, n) * Q).eval();
    m.zeta.segment(first, n) = (Q.cwiseAbs2().transpose() * m.zeta.segment(first, n)).eval();
  }
}

// Of each mode of a state the one of the first state that it is like, each taken once; those that
// are like none get numbers of their own, beyond `count`.
std::vector<Index> partners(const MatrixXd& first, const VectorXd& first_lambda,
                            const MatrixXd& own, const VectorXd& lambda, Index& count) {
  struct Likeness {
    double score;
    Index own, first;
  };
  std::vector<Likeness> all;
  constexpr double enough = 0.3, by_frequency = 4; // score: MAC less 4 (ln f / f)^2
  for (Index i = 0; i < own.cols(); ++i)
    for (Index j = 0; j < first.cols(); ++j) {
      const double mac = std::pow(own.col(i).dot(first.col(j)), 2) /
                         std::max(1e-300, own.col(i).squaredNorm() * first.col(j).squaredNorm());
      const double ratio = std::log(lambda[i] / first_lambda[j]) / 2;
      if (const double score = mac - by_frequency * ratio * ratio; score > enough)
        all.push_back({score, i, j});
    }
  std::stable_sort(all.begin(), all.end(),
                   [](const Likeness& a, const Likeness& b) { return a.score > b.score; });
  std::vector<Index> partner(std::size_t(own.cols()), -1);
  std::vector<bool> taken(std::size_t(first.cols()), false);
  for (const Likeness& l : all) {
    if (partner[std::size_t(l.own)] >= 0 || taken[std::size_t(l.first)]) continue;
    partner[std::size_t(l.own)] = l.first;
    taken[std::size_t(l.first)] = true;
  }
  for (Index& p : partner)
    if (p < 0) p = count++;
  return partner;
}

// Of the readings of one state, by its modes.
MatrixXd weights_of(const StateModel& model, const TestReadings& test, const AffineModes& modes) {
  const NominalState& state = *model.nominal;
  constexpr double step = 0.02;
  MatrixXd W = MatrixXd::Zero(Index(test.readings.size()), modes.lambda.size());
  in_parallel(int(modes.lambda.size()), [&](int m) {
    std::array<VectorXd, 2> y;
    for (int way = 0; way < 2; ++way) {
      Acting acting;
      acting.given = &modes;
      acting.mode_damping = VectorXd::Ones(modes.lambda.size());
      acting.mode_damping[m] = std::exp(way == 0 ? -step : step);
      StateAnswers answers(model, test, acting, Index(state.observed.size()));
      y[std::size_t(way)] = VectorXd::Zero(W.rows());
      for (Index i = 0; i < W.rows(); ++i) {
        const Reading& r = test.readings[std::size_t(i)];
        if (r.state == state.name && feels_damping(r))
          y[std::size_t(way)][i] =
              answers.answer(r).value_or(std::numeric_limits<double>::quiet_NaN());
      }
    }
    const VectorXd w = (y[1] - y[0]) / (2 * step);
    W.col(m) = w.array().isFinite().select(w, 0);
  });
  return W;
}

} // namespace

MatrixXd damping_weights(const Nominal& nominal, const TestReadings& test) {
  StateModels models(nominal);
  MatrixXd W(Index(test.readings.size()), 0), first;
  VectorXd first_lambda;
  for (std::size_t s = 0; s < nominal.states.size(); ++s) {
    const auto is_own = [&](const Reading& r) { return r.state == nominal.states[s].name; };
    if (s > 0 && std::none_of(test.readings.begin(), test.readings.end(), is_own)) continue;
    const StateModel& model = models.of(s, {});
    auto modes = model.free.modes(VectorXd());
    if (!modes) continue;
    settle(*modes, nominal.mass);
    const MatrixXd seen = seen_of(*modes, nominal.mass);
    if (s == 0) {
      first = seen;
      first_lambda = modes->lambda;
    }
    Index count = std::max(W.cols(), modes->lambda.size());
    const std::vector<Index> at = partners(first, first_lambda, seen, modes->lambda, count);
    W.conservativeResizeLike(MatrixXd::Zero(W.rows(), count));
    const MatrixXd own = weights_of(model, test, *modes);
    for (std::size_t m = 0; m < at.size(); ++m) W.col(at[m]) += own.col(Index(m));
  }
  return W;
}

} // namespace plica
