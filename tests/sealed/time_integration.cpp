// Stepped sine in time. Every mode is advanced exactly under a force that is linear within a step
//   q'' + 2 zeta w q' + w^2 q = -d a(t) - sum_j b_j g_j
// while the nonlinear forces g at the end of the step are found by iteration; modes far above the
// lines follow without inertia. 96 steps a cycle, 48 cycles to settle from the state of the line
// before; the first harmonic of g in four more then drives all modes.
#include "response.hpp"

#include <numbers>

namespace sealed {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

constexpr double moving = 3; // modes up to this many times the highest line have inertia
constexpr int steps = 96, settling = 48, measured = 4;

// q, q' after a step: A (q, q') + B0 p(start) + B1 p(end).
struct Propagator {
  Eigen::ArrayXd a11, a12, a21, a22, b01, b02, b11, b12;
};

Propagator propagator(const Assembly& a, Eigen::Index modes, double dt) {
  Propagator p;
  for (auto* x : {&p.a11, &p.a12, &p.a21, &p.a22, &p.b01, &p.b02, &p.b11, &p.b12}) x->resize(modes);
  for (Eigen::Index i = 0; i < modes; ++i) {
    const double w = a.modes.w[i], z = a.zeta[i], s = z * w, wd = w * std::sqrt(1 - z * z);
    const double e = std::exp(-s * dt), c = e * std::cos(wd * dt), d = e * std::sin(wd * dt) / wd;
    p.a11[i] = c + s * d;
    p.a12[i] = d;
    p.a21[i] = -w * w * d;
    p.a22[i] = c - s * d;
    // A particular solution for p0 + (p1 - p0) t / dt is u + v t; what is left is free motion.
    const auto answer = [&](double p0, double p1) {
      const double v = (p1 - p0) / (dt * w * w), u = (p0 - 2 * s * v) / (w * w);
      return std::array{-p.a11[i] * u - p.a12[i] * v + u + v * dt,
                        -p.a21[i] * u - p.a22[i] * v + v};
    };
    const auto start = answer(1, 0), end = answer(0, 1);
    p.b01[i] = start[0];
    p.b02[i] = start[1];
    p.b11[i] = end[0];
    p.b12[i] = end[1];
  }
  return p;
}

struct Motion {
  Eigen::ArrayXd q, v;
  VectorXd x, z, g; // of the springs
};

double force_of(const NonlinearSpring& spring, double x, double x0, double z0, double& z) {
  if (spring.law == Law::stop) {
    const double over = std::abs(x) - spring.slip;
    return over > 0 ? std::copysign(spring.stiffness * over, x) : 0;
  }
  if (spring.law == Law::cubic) return spring.stiffness * x * x * x;
  const double dx = x - x0;
  const auto slope = [&](double at) {
    const double r = std::abs(at) / spring.slip;
    return 1 - (dx * at > 0 ? r * std::sqrt(r) : 0);
  };
  const double half = z0 + dx / 2 * slope(z0); // midpoint rule
  z = std::clamp(z0 + dx * slope(half), -spring.slip, spring.slip);
  return spring.stiffness * (z - x);
}

class Stepper {
public:
  Stepper(const Bench& bench, const Assembly& assembly, const VectorXd& drive, const MatrixXd& rows,
          double highest)
      : springs_(bench.test.nonlinear), assembly_(assembly) {
    while (modes_ < drive.size() && assembly.modes.w[modes_] < moving * 2 * pi * highest) ++modes_;
    const auto rest = drive.size() - modes_, count = rows.rows();
    drive_ = drive.head(modes_);
    rows_ = rows.leftCols(modes_);
    const MatrixXd soft =
        rows.rightCols(rest) * assembly.modes.w.tail(rest).cwiseAbs2().cwiseInverse().asDiagonal();
    residual_drive_ = soft * drive.tail(rest);
    residual_ = soft * rows.rightCols(rest).transpose();
    state_ = {Eigen::ArrayXd::Zero(modes_), Eigen::ArrayXd::Zero(modes_), VectorXd::Zero(count),
              VectorXd::Zero(count), VectorXd::Zero(count)};
  }

  // First harmonic of the forces of the springs, over a table of `level` cos(w t).
  VectorXcd line(double frequency, double level) {
    const double dt = 1 / frequency / steps;
    const Propagator p = propagator(assembly_, modes_, dt);
    compliance_ = rows_ * p.b11.matrix().asDiagonal() * rows_.transpose() + residual_;
    VectorXcd sum = VectorXcd::Zero(state_.g.size());
    for (int n = 0; n < steps * (settling + measured); ++n) {
      const double phase = 2 * pi * (n % steps) / steps, next = phase + 2 * pi / steps;
      advance(p, level * std::cos(phase), level * std::cos(next));
      if (n >= steps * settling)
        sum += std::polar(2. / (steps * measured), -next) * state_.g.cast<Complex>();
    }
    return sum / level;
  }

private:
  void advance(const Propagator& p, double a0, double a1) {
    const Eigen::ArrayXd p0 = -a0 * drive_.array() - (rows_.transpose() * state_.g).array();
    const Eigen::ArrayXd p1 = -a1 * drive_.array();
    const Eigen::ArrayXd q = p.a11 * state_.q + p.a12 * state_.v + p.b01 * p0 + p.b11 * p1;
    const Eigen::ArrayXd v = p.a21 * state_.q + p.a22 * state_.v + p.b02 * p0 + p.b12 * p1;
    const VectorXd free = rows_ * q.matrix() - a1 * residual_drive_;
    VectorXd g = state_.g, z = state_.z, x = free;
    for (int pass = 0; pass < 4; ++pass) {
      x = free - compliance_ * g;
      for (Eigen::Index j = 0; j < g.size(); ++j)
        g[j] = force_of(springs_[std::size_t(j)], x[j], state_.x[j], state_.z[j], z[j]);
    }
    const Eigen::ArrayXd reaction = (rows_.transpose() * g).array();
    state_ = {q - p.b11 * reaction, v - p.b12 * reaction, x, z, g};
  }

  const std::vector<NonlinearSpring>& springs_;
  const Assembly& assembly_;
  Eigen::Index modes_ = 0;
  VectorXd drive_, residual_drive_;
  MatrixXd rows_, residual_, compliance_;
  Motion state_;
};

// Largest linear motion of a spring against its slip, gap or cubic scale.
double reach(const Bench& bench, const VectorXcd& x, double level) {
  double most = 0;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const NonlinearSpring& s = bench.test.nonlinear[std::size_t(j)];
    const double small = s.law == Law::stop ? 0.5 : s.law == Law::cubic ? 0.1 : 0.03;
    most = std::max(most, level * std::abs(x[j]) / s.slip / small);
  }
  return most;
}

} // namespace

MatrixXcd nonlinear_response(const Bench& bench, const Assembly& assembly, int base, double level,
                             const VectorXd& frequencies) {
  MatrixXcd response = linear_response(bench, assembly, base, frequencies);
  if (bench.test.nonlinear.empty()) return response;
  const VectorXd table = table_motion(bench, base);
  const VectorXd drive = assembly.modes.phi.transpose() * (bench.test.M * table);
  MatrixXd rows(Eigen::Index(bench.test.nonlinear.size()), drive.size());
  for (Eigen::Index j = 0; j < rows.rows(); ++j)
    rows.row(j) = bench.test.nonlinear[std::size_t(j)].row.transpose() * assembly.modes.phi;
  Stepper stepper(bench, assembly, drive, rows, frequencies[frequencies.size() - 1]);
  for (Eigen::Index l = frequencies.size() - 1; l >= 0; --l) { // down, as peaks that soften go
    const double w = 2 * pi * frequencies[l];
    const VectorXcd x = rows * modal_motion(assembly, drive, w);
    if (reach(bench, x, level) < 1) continue;
    const VectorXcd force = stepper.line(frequencies[l], level);
    const VectorXcd q = modal_motion(assembly, drive + rows.transpose() * force, w);
    const VectorXcd acceleration = table.cast<Complex>() - w * w * (assembly.modes.phi * q);
    response.row(l) = read_probes(bench, acceleration, frequencies[l]).transpose();
  }
  return response;
}

} // namespace sealed
