// Strokes and histories of movement of an end.
#include "run/analyses/life.hpp"

#include "life/rainflow.hpp"
#include "words/directions.hpp"
#include "words/units.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// What the end does (ux uy uz rx ry rz) by one of each shift: shifts with the end kept parallel,
// turns by a moment alone.
Matrix66 end_motions(const Matrix1212& K) {
  const Eigen::Matrix3d parallel = K.block<3, 3>(6, 6).inverse();
  const Matrix66 C = K.block<6, 6>(6, 6).inverse();
  Matrix66 motions = Matrix66::Zero();
  for (Index k = 0; k < 6; ++k) {
    const int dof = dof_of_static_test[std::size_t(k)];
    if (dof < 3)
      motions.block<3, 1>(0, k) = parallel.col(dof) / parallel(dof, dof);
    else
      motions.col(k) = C.col(dof) / C(dof, dof);
  }
  return motions;
}

std::string words_of(const EndShift& shift, bool reversed) {
  std::string text;
  const auto all = shift.all();
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k] == 0) continue;
    std::string name = end_shift_names[k];
    std::replace(name.begin(), name.end(), '_', ' ');
    const std::string size = k < 3 ? short_number(1e3 * all[k]) + " mm"
                                   : short_number(all[k] * 180 / std::numbers::pi) + " deg";
    text += (text.empty() ? "" : ", ") + std::string(reversed ? "+-" : "") + size + " " + name;
  }
  return text;
}

} // namespace

StaticStress LifeCount::add_movements(const BuiltCase& built, Route& route,
                                      const std::array<int, 2>& caps, const Matrix1212& K) {
  MatrixXd unit = MatrixXd::Zero(12, 6);
  unit.bottomRows<6>().setIdentity();
  const StressField field = recover_stress(built.model, route.follow(caps, unit));
  const MatrixXd plane = plane_of(field);
  const Matrix66 motions = end_motions(K);
  StaticStress strokes{.field = {}, .names = {}, .kind = StressKind::stroke};
  MatrixXd Q(6, Index(life_.strokes.size()));
  for (const LifeStroke& stroke : life_.strokes) {
    const auto shift = stroke.shift.all();
    const VectorXd q = motions * Eigen::Matrix<double, 6, 1>::Map(shift.data());
    add_stroke(stroke, plane, q);
    Q.col(Index(strokes.names.size())) = q;
    strokes.names.push_back(stroke.name + ": " + words_of(stroke.shift, stroke.reversed));
  }
  strokes.field = combined(field, Q);
  for (const LifeHistory& history : life_.histories) {
    if (!moves_end(history)) continue;
    MatrixXd q = MatrixXd::Zero(history.signals[0].signal.samples.size(), 6);
    std::string what;
    for (const LifeSignal& s : history.signals) {
      q.col(dof_of_static_test[std::size_t(end_shift_index(s.of))]) = s.signal.samples;
      what += (what.empty() ? "" : ", ") + s.of;
    }
    std::replace(what.begin(), what.end(), '_', ' ');
    add_history(history, what, plane, q);
  }
  return strokes;
}

void LifeCount::add_stroke(const LifeStroke& stroke, const MatrixXd& plane, const VectorXd& q) {
  DutyMap duty = new_duty(DutyKind::stroke, stroke.name, words_of(stroke.shift, stroke.reversed),
                          stroke.count, "cycles");
  const VectorXd far = plane * q;
  const auto sites = int(duty.damage.rows());
#pragma omp parallel for schedule(static)
  for (int site = 0; site < sites; ++site) {
    const Vector3d rest = state_.segment<3>(3 * Index(site)), to = far.segment<3>(3 * Index(site));
    const Vector3d from = stroke.reversed ? Vector3d(-to) : Vector3d::Zero();
    if (life_.measure == StressMeasure::signed_von_mises) {
      const double mean = (signed_von_mises(rest + from) + signed_von_mises(rest + to)) / 2;
      count(duty, site, 0, {plane_von_mises(to - from), mean}, stroke.count);
      continue;
    }
    for (Index d = 0; d < directions_.rows(); ++d)
      count(duty, site, d,
            {std::abs(directions_.row(d).dot(to - from)),
             directions_.row(d).dot(rest + (to + from) / 2)},
            stroke.count);
  }
  duties_.push_back(std::move(duty));
}

void LifeCount::add_history(const LifeHistory& history, const std::string& what,
                            const MatrixXd& plane, const MatrixXd& q) {
  DutyMap duty = new_duty(DutyKind::history, history.name, what, history.repeats, "repeats");
  duty.counted = worst_sites(plane, q.transpose() * q / double(q.rows()));
  std::vector<double> cycles(duty.counted.size(), 0);
  const auto counted = int(duty.counted.size());
#pragma omp parallel for schedule(dynamic)
  for (int i = 0; i < counted; ++i) {
    const int site = duty.counted[std::size_t(i)];
    const MatrixXd own = plane.middleRows<3>(3 * Index(site));
    const Vector3d rest = state_.segment<3>(3 * Index(site));
    for (Index d = 0; d < directions_.rows(); ++d) {
      double closed = 0;
      Rainflow flow([&](const RainflowCycle& c) {
        count(duty, site, d, {c.range, c.mean}, history.repeats * c.count);
        closed += c.count;
      });
      const VectorXd row = (directions_.row(d) * own).transpose();
      for (Index k = 0; k < q.rows(); ++k)
        flow.add(life_.measure == StressMeasure::signed_von_mises
                     ? signed_von_mises(rest + own * q.row(k).transpose())
                     : directions_.row(d).dot(rest) + q.row(k).dot(row));
      flow.finish();
      cycles[std::size_t(i)] = std::max(cycles[std::size_t(i)], closed);
    }
  }
  for (const double c : cycles) duty.head.cycles = std::max(duty.head.cycles, c);
  spread(duty);
  duties_.push_back(std::move(duty));
}

} // namespace plica
