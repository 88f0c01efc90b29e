#include "response.hpp"

#include <numbers>

namespace sealed {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

constexpr double shift_frequency = 0.002, shift_damping = 0.04; // of an assembly

// A stiffness that grows with frequency and has loss: solved directly in the space of the modes.
VectorXcd rubber_motion(const Assembly& a, const MatrixXd& rubber, const VectorXd& drive,
                        double w) {
  MatrixXcd z = rubber * (Complex(1, 0.3) * std::pow(w / (2 * pi * 1000), 0.5) - 1.);
  for (Eigen::Index i = 0; i < drive.size(); ++i) {
    const double wi = a.modes.w[i];
    z(i, i) += Complex(wi * wi - w * w, 2 * a.zeta[i] * wi * w);
  }
  return z.partialPivLu().solve(VectorXcd(-drive.cast<Complex>()));
}

} // namespace

VectorXd table_motion(const Bench& bench, int base) {
  const auto& m = bench.table.at(base);
  return bench.test.R * VectorXd::Map(m.data(), 6);
}

VectorXcd modal_motion(const Assembly& a, const VectorXcd& drive, double w) {
  VectorXcd q(drive.size());
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    const double wi = a.modes.w[i];
    q[i] = -drive[i] / Complex(wi * wi - w * w, 2 * a.zeta[i] * wi * w);
  }
  return q;
}

Assembly assemble_anew(const Bench& bench, Draws draws) {
  Structure s = bench.test;
  if (s.rubber.size() > 0) s.K += s.rubber;
  Assembly a{modes_of(s), bench.zeta};
  if (a.zeta.size() < a.modes.w.size()) throw std::runtime_error("more modes than dampings");
  a.zeta.conservativeResize(a.modes.w.size());
  for (Eigen::Index i = 0; i < a.modes.w.size(); ++i) {
    a.modes.w[i] *= 1 + shift_frequency * draws.normal();
    a.zeta[i] *= 1 + shift_damping * draws.normal();
  }
  return a;
}

// Axes and gains, and what strangers do to a probe.
VectorXcd read_probes(const Bench& bench, const VectorXcd& acceleration, double f) {
  VectorXcd channels(3 * Eigen::Index(bench.probes.size()));
  Eigen::Index first = 0;
  for (const Probe& p : bench.probes) {
    VectorXcd read = (p.reading * p.rows) * acceleration;
    read *= std::polar(1., -2 * pi * f * p.delay);
    if (p.resonance > 0) {
      const double x = f / p.resonance;
      read /= Complex(1 - x * x, 2 * 0.02 * x);
    }
    channels.segment(first, 3) = read;
    first += 3;
  }
  return channels;
}

MatrixXcd linear_response(const Bench& bench, const Assembly& a, int base,
                          const VectorXd& frequencies) {
  const VectorXd table = table_motion(bench, base);
  const VectorXd drive = a.modes.phi.transpose() * (bench.test.M * table);
  MatrixXd rubber;
  if (bench.test.rubber.size() > 0)
    rubber = a.modes.phi.transpose() * bench.test.rubber * a.modes.phi;
  MatrixXcd response(frequencies.size(), 3 * Eigen::Index(bench.probes.size()));
  for (Eigen::Index l = 0; l < frequencies.size(); ++l) {
    const double w = 2 * pi * frequencies[l];
    const VectorXcd q =
        rubber.size() > 0 ? rubber_motion(a, rubber, drive, w) : modal_motion(a, drive, w);
    const VectorXcd acceleration = table.cast<Complex>() - w * w * (a.modes.phi * q);
    response.row(l) = read_probes(bench, acceleration, frequencies[l]).transpose();
  }
  return response;
}

double scale_nonlinear(Bench& bench, const std::vector<int>& bases, const VectorXd& frequencies) {
  if (bench.test.nonlinear.empty()) return 0;
  Assembly a{modes_of(bench.test), bench.zeta};
  double force = 0;
  std::vector<double> motion;
  for (const NonlinearSpring& spring : bench.test.nonlinear) {
    double x = 0;
    for (const int base : bases) {
      const VectorXd drive = a.modes.phi.transpose() * (bench.test.M * table_motion(bench, base));
      const VectorXd row = a.modes.phi.transpose() * spring.row;
      for (const double f : frequencies) {
        const VectorXcd q = modal_motion(a, drive, 2 * pi * f);
        x = std::max(x, 5 * std::abs(row.cast<Complex>().dot(q)));
      }
    }
    motion.push_back(x);
  }
  std::map<int, double> most; // force in each joint
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const NonlinearSpring& spring = bench.test.nonlinear[i];
    most[spring.joint] = std::max(most[spring.joint], spring.stiffness * motion[i]);
  }
  for (NonlinearSpring& spring : bench.test.nonlinear) {
    const double x = most[spring.joint] / spring.stiffness;
    if (spring.law == Law::bouc_wen) force = std::max(force, spring.slip * most[spring.joint]);
    if (spring.law == Law::cubic) spring.stiffness /= x * x;
    spring.slip *= x;
  }
  return force;
}

} // namespace sealed
