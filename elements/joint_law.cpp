#include "elements/joint_law.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plica {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;

// Force and slope of the piecewise-linear curve.
std::array<double, 2> on_curve(const std::vector<std::array<double, 2>>& curve, double x) {
  std::size_t i = 1;
  while (i + 1 < curve.size() && curve[i][0] < x) ++i;
  const double slope = (curve[i][1] - curve[i - 1][1]) / (curve[i][0] - curve[i - 1][0]);
  return {curve[i - 1][1] + slope * (x - curve[i - 1][0]), slope};
}

void require(bool good, const char* what) {
  if (!good) throw std::invalid_argument(what);
}

// Closed form: th = acos(1 - 2 x_s / A), k_eq = k_t (th - sin(2 th) / 2) / pi,
// h = 4 mu (1 - x_s / A) / (pi A).
void add_slider(const JenkinsSlider& s, double A, DescribingFunction& f) {
  const double slip = s.slip_force / s.stiffness;
  if (A <= slip) {
    f.gain += s.stiffness;
    return;
  }
  const double c = 1 - 2 * slip / A, sine = std::sqrt(1 - c * c);
  f.gain += Complex(s.stiffness / pi * (std::acos(c) - sine * c),
                    4 * s.slip_force * (1 - slip / A) / (pi * A));
  f.slope += Complex(-4 * s.stiffness / pi * sine * slip / (A * A),
                     4 * s.slip_force / pi * (2 * slip / A - 1) / (A * A));
}

// Curve and smoothed Coulomb friction. Derivative by A: of f over x = A cos, x' = -w A sin.
void add_sampled(const JointLaw& law, double A, double omega, DescribingFunction& f) {
  constexpr int samples = 256;
  const JointLaw own{.curve = law.curve, .coulomb = law.coulomb, .offset = law.offset};
  Complex force = 0, by_amplitude = 0;
  for (int k = 0; k < samples; ++k) {
    const double c = std::cos(2 * pi * k / samples), s = std::sin(2 * pi * k / samples);
    const ElasticForce now = elastic_force(own, A * c, -omega * A * s);
    const Complex turn = 2. / samples * Complex(c, -s);
    force += now.force * turn;
    by_amplitude += (now.by_motion * c - now.by_velocity * omega * s) * turn;
  }
  f.gain += force / A;
  f.slope += (by_amplitude - force / A) / A;
}

} // namespace

double JointLaw::stuck_stiffness() const {
  double k = elastic_force(*this, 0, 0).by_motion;
  for (const JenkinsSlider& s : sliders) k += s.stiffness;
  return k;
}

bool JointLaw::is_odd() const {
  if (offset != 0) return false;
  if (curve.empty()) return true;
  double largest = 0;
  for (const auto& p : curve) largest = std::max(largest, std::abs(p[1]));
  return std::all_of(curve.begin(), curve.end(), [&](const auto& p) {
    return std::abs(on_curve(curve, -p[0])[0] + p[1]) < 1e-9 * largest;
  });
}

JointLaw in_series(JointLaw law, int n) {
  law.stiffness *= n;
  law.cubic *= double(n) * n * n;
  for (auto& p : law.curve) p[0] /= n;
  for (JenkinsSlider& s : law.sliders) s.stiffness *= n;
  law.coulomb.velocity /= n;
  law.offset /= n;
  return law;
}

double force_at_offset(const JointLaw& law, const JenkinsSlider& s) {
  return std::clamp(s.stiffness * law.offset, -s.slip_force, s.slip_force);
}

ElasticForce elastic_force(const JointLaw& law, double x, double velocity) {
  const double o = law.offset, whole = o + x;
  ElasticForce f{law.stiffness * x + law.cubic * x * (x * x + 3 * o * whole),
                 law.stiffness + 3 * law.cubic * whole * whole, 0};
  if (!law.curve.empty()) {
    const auto [force, slope] = on_curve(law.curve, whole);
    f.force += o == 0 ? force : force - on_curve(law.curve, o)[0];
    f.by_motion += slope;
  }
  if (law.coulomb.force > 0) {
    const double t = std::tanh(velocity / law.coulomb.velocity);
    f.force += law.coulomb.force * t;
    f.by_velocity = law.coulomb.force / law.coulomb.velocity * (1 - t * t);
  }
  return f;
}

namespace {

// Integral of x^p from a to b.
double power_integral(double p, double a, double b) {
  if (std::abs(p + 1) < 1e-9) return std::log(b / a);
  return (std::pow(b, p + 1) - (a > 0 ? std::pow(a, p + 1) : 0)) / (p + 1);
}

} // namespace

double SegalmanIwan::pm() const {
  const double stiffness = power_integral(chi, smallest, 1),
               force = power_integral(chi + 1, smallest, 1);
  return F_S * (1 + beta) / (K_T * (beta + force / stiffness));
}
double SegalmanIwan::R() const {
  return K_T / ((1 + beta) * power_integral(chi, smallest, 1) * std::pow(pm(), chi + 1));
}
double SegalmanIwan::S() const {
  return K_T * beta / (1 + beta);
}

std::vector<JenkinsSlider> sliders_of(const SegalmanIwan& iwan, int count) {
  require(iwan.K_T > 0, "K_T of an Iwan model must be above zero");
  require(iwan.F_S > 0, "F_S of an Iwan model must be above zero");
  require(iwan.smallest >= 0 && iwan.smallest < 1,
          "the smallest slip displacement of an Iwan model must lie below pm");
  require(iwan.chi > (iwan.smallest > 0 ? -2 : -1) && iwan.chi <= 0,
          "chi of an Iwan model must lie in (-1, 0], or (-2, 0] with a smallest slip displacement");
  require(iwan.beta >= 0, "beta of an Iwan model must not be negative");
  require(count > 0, "an Iwan model needs a slider");
  // A step between a and b has the stiffness and the slip force of its density, so that stiffness
  // at rest and slip force are exact.
  const double pm = iwan.pm(), R = iwan.R();
  const double first = iwan.smallest > 0 ? iwan.smallest : 1e-4; // of pm: below, one step
  std::vector<JenkinsSlider> sliders;
  double a = iwan.smallest * pm;
  for (int i = 0; i < count; ++i) {
    const double share = iwan.smallest > 0 ? double(i + 1) / count
                         : count == 1      ? 1
                                           : double(i) / (count - 1);
    const double b = pm * std::pow(first, 1 - share);
    sliders.push_back({R * power_integral(iwan.chi, a, b), R * power_integral(iwan.chi + 1, a, b)});
    a = b;
  }
  if (iwan.beta > 0) sliders.push_back({iwan.S(), iwan.S() * pm});
  return sliders;
}

double first_loading(const JointLaw& law, double displacement) {
  double force = elastic_force(law, displacement, 0).force;
  for (const JenkinsSlider& s : law.sliders) {
    const double before = force_at_offset(law, s);
    force += std::clamp(before + s.stiffness * displacement, -s.slip_force, s.slip_force) - before;
  }
  return force;
}

double first_loading_slope(const JointLaw& law, double displacement) {
  double slope = elastic_force(law, displacement, 0).by_motion;
  for (const JenkinsSlider& s : law.sliders)
    if (std::abs(force_at_offset(law, s) + s.stiffness * displacement) <= s.slip_force)
      slope += s.stiffness;
  return slope;
}

VectorXd period_forces(const JointLaw& law, const VectorXd& x, const VectorXd& velocity) {
  const Index steps = x.size();
  VectorXd force(steps);
  for (Index k = 0; k < steps; ++k) force[k] = elastic_force(law, x[k], velocity[k]).force;
  // A slider repeats itself after the first period, whatever it starts from.
  for (const JenkinsSlider& s : law.sliders) {
    const double at_offset = force_at_offset(law, s);
    double f = std::clamp(at_offset + s.stiffness * x[0], -s.slip_force, s.slip_force);
    for (Index k = 1; k < 2 * steps; ++k) {
      const Index now = k % steps, before = (k - 1) % steps;
      f = std::clamp(f + s.stiffness * (x[now] - x[before]), -s.slip_force, s.slip_force);
      if (k >= steps) force[now] += f - at_offset;
    }
  }
  return force;
}

DescribingFunction describing_function(const JointLaw& law, double amplitude, double omega) {
  const double A2 = amplitude * amplitude, o2 = law.offset * law.offset;
  DescribingFunction f{Complex(law.stiffness + law.cubic * (0.75 * A2 + 3 * o2), 0),
                       Complex(1.5 * law.cubic * amplitude, 0)};
  for (const JenkinsSlider& s : law.sliders) add_slider(s, amplitude, f);
  if (!law.curve.empty() || law.coulomb.force > 0) add_sampled(law, amplitude, omega, f);
  return f;
}

double loop_energy(const JointLaw& law, double amplitude) {
  double energy = 0;
  for (const JenkinsSlider& s : law.sliders) {
    const double slip = s.slip_force / s.stiffness;
    if (amplitude > slip) energy += 4 * s.slip_force * (amplitude - slip);
  }
  return energy;
}

} // namespace plica
