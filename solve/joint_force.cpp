#include "solve/joint_force.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plica {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

// Forces and tangents of one joint over the samples of a period.
//
// Sliders start from first loading up to the sample of the largest motion: one that sticks there
// always sticks, the others come back to it after a period. From one turn of the motion to the next
// each sticks until it has gone its way and slips from there on. While it sticks after a turn where
// it slipped, f = f(turn) + k (x - x(turn)), f(turn) being the slip force.
class Samples {
public:
  Samples(const JointLaw& law, const VectorXd& x, const HarmonicBasis& basis)
      : x_(x.array() + law.offset), basis_(basis), count_(x.size()), force_(law.stiffness * x),
        slope_(VectorXd::Constant(x.size(), law.stiffness)) {
    if (!law.sliders.empty()) add_sliders(law.sliders);
    double at_offset = 0;
    for (const JenkinsSlider& s : law.sliders) at_offset += force_at_offset(law, s);
    force_.array() -= at_offset;
  }

  void add(Index k, const ElasticForce& f) {
    force_[k] += f.force;
    slope_[k] += f.by_motion;
  }

  VectorXd force() const { return basis_.to_harmonics * force_; }
  MatrixXd by_motion() const {
    MatrixXd K = (basis_.to_harmonics * slope_.asDiagonal()) * basis_.to_time;
    for (std::size_t b = 0; b < turns_.size() && memory_.size() > 0; ++b)
      K.noalias() -= memory_.col(Index(b)) * basis_.to_time.row(turns_[b] % count_);
    return K;
  }

private:
  struct Slider {
    double stiffness, limit, force;
    int turn;    // at which it slipped last
    double left; // way until it slips
  };

  void add_sliders(const std::vector<JenkinsSlider>& all) {
    Index start = 0;
    const double largest = x_.cwiseAbs().maxCoeff(&start);
    double always = 0;
    std::vector<Slider> slipping;
    for (const JenkinsSlider& s : all) {
      if (s.stiffness * largest <= s.slip_force)
        always += s.stiffness;
      else
        slipping.push_back(
            {s.stiffness, s.slip_force, std::copysign(s.slip_force, x_[start]), 0, 0});
    }
    force_ += always * x_;
    slope_.array() += always;
    if (slipping.empty()) return;
    find_turns(start);
    memory_ = MatrixXd::Zero(basis_.size(), Index(turns_.size()));
    for (std::size_t b = 0; b + 1 < turns_.size(); ++b) stretch(int(b), slipping);
  }

  double at(Index k) const { return x_[k % count_]; }

  // Samples at which the motion turns, from `start` round to it, counted on beyond the period.
  void find_turns(Index start) {
    turns_ = {start};
    double direction = 0;
    for (Index k = start + 1; k <= start + count_; ++k) {
      const double step = at(k) - at(k - 1);
      if (step * direction < 0) turns_.push_back(k - 1);
      if (step != 0) direction = step;
    }
    turns_.push_back(start + count_);
  }

  // Sum of to_harmonics over the samples begin .. end - 1.
  auto sum_to(Index k) const {
    const Index periods = k / count_;
    return VectorXd(basis_.sums.col(k % count_) + double(periods) * basis_.sums.col(count_));
  }

  // From turn b to the next.
  void stretch(int b, std::vector<Slider>& sliders) {
    const Index begin = turns_[std::size_t(b)], end = turns_[std::size_t(b) + 1];
    const double from = at(begin), direction = at(end) >= from ? 1 : -1;
    double stuck = 0, held = 0, slipped = 0; // sums of k and f of those that stick, of slip forces
    for (Slider& s : sliders) {
      s.left = (s.limit - direction * s.force) / s.stiffness;
      stuck += s.stiffness;
      held += s.force;
    }
    std::sort(sliders.begin(), sliders.end(),
              [](const Slider& a, const Slider& c) { return a.left < c.left; });
    const VectorXd first = sum_to(begin + 1);
    std::size_t next = 0;
    for (Index k = begin + 1; k <= end; ++k) {
      const double way = direction * (at(k) - from);
      for (; next < sliders.size() && sliders[next].left < way; ++next) {
        Slider& s = sliders[next];
        memory_.col(s.turn) += s.stiffness * (sum_to(k) - first);
        stuck -= s.stiffness;
        held -= s.force;
        slipped += s.limit;
        s.force = direction * s.limit;
        s.turn = b + 1;
      }
      force_[k % count_] += direction * (slipped + stuck * way) + held;
      slope_[k % count_] += stuck;
    }
    const double way = direction * (at(end) - from);
    for (; next < sliders.size(); ++next) {
      Slider& s = sliders[next];
      memory_.col(s.turn) += s.stiffness * (sum_to(end + 1) - first);
      s.force += direction * s.stiffness * way;
    }
  }

  const VectorXd x_; // from rest
  const HarmonicBasis& basis_;
  Index count_;
  VectorXd force_, slope_;
  std::vector<Index> turns_;
  MatrixXd memory_; // unknowns x turns
};

bool is_linear(const JointLaw& law) {
  return law.cubic == 0 && law.curve.empty() && law.coulomb.force <= 0;
}

} // namespace

HarmonicBasis::HarmonicBasis(std::vector<int> harmonics, int samples)
    : orders(std::move(harmonics)) {
  if (orders.empty() || samples < 2 * (orders.back() + 1) + 1)
    throw std::invalid_argument("too few samples of a period for so many harmonics");
  const Index unknowns = 2 * Index(orders.size()) - (orders[0] == 0 ? 1 : 0);
  to_time = to_rate = MatrixXd::Zero(samples, unknowns);
  to_harmonics.resize(unknowns, samples);
  sums = MatrixXd::Zero(unknowns, samples + 1);
  for (std::size_t i = 0; i < orders.size(); ++i) {
    const int n = orders[i];
    const Index at = first(i);
    for (int k = 0; k < samples; ++k) {
      const double tau = 2 * pi * k / samples, c = std::cos(n * tau), s = std::sin(n * tau);
      to_time(k, at) = c;
      to_harmonics(at, k) = (n == 0 ? 1. : 2.) / samples * c;
      if (n == 0) continue;
      to_time(k, at + 1) = -s;
      to_rate(k, at) = -n * s;
      to_rate(k, at + 1) = -n * c;
      to_harmonics(at + 1, k) = -2. / samples * s;
    }
  }
  for (int k = 0; k < samples; ++k) sums.col(k + 1) = sums.col(k) + to_harmonics.col(k);
}

Complex amplitude(const HarmonicBasis& basis, const Eigen::Ref<const VectorXd>& unknowns,
                  std::size_t k) {
  const Index at = basis.first(k);
  return basis.orders[k] == 0 ? Complex(unknowns[at], 0) : Complex(unknowns[at], unknowns[at + 1]);
}

VectorXd unknowns(const HarmonicBasis& basis,
                  const Eigen::Ref<const Eigen::VectorXcd>& amplitudes) {
  VectorXd x(basis.size());
  for (std::size_t k = 0; k < basis.orders.size(); ++k) {
    const Index at = basis.first(k);
    x[at] = amplitudes[Index(k)].real();
    if (basis.orders[k] > 0) x[at + 1] = amplitudes[Index(k)].imag();
  }
  return x;
}

Index first_harmonic(const std::vector<int>& orders) {
  return std::find(orders.begin(), orders.end(), 1) - orders.begin();
}

std::vector<int> orders_up_to(int highest, bool odd) {
  std::vector<int> orders;
  for (int n = odd ? 1 : 0; n <= highest; n += odd ? 2 : 1) orders.push_back(n);
  return orders;
}

HarmonicForce harmonic_force(const JointLaw& law, const VectorXd& motion, double omega,
                             const HarmonicBasis& basis) {
  const VectorXd x = basis.to_time * motion;
  Samples samples(law, x, basis);
  HarmonicForce out;
  out.by_omega = VectorXd::Zero(basis.size());
  const JointLaw own{
      .cubic = law.cubic, .curve = law.curve, .coulomb = law.coulomb, .offset = law.offset};
  if (law.coulomb.force <= 0) {
    for (Index k = 0; k < x.size() && !is_linear(law); ++k)
      samples.add(k, elastic_force(own, x[k], 0));
    out.force = samples.force();
    out.by_motion = samples.by_motion();
    return out;
  }
  const VectorXd rate = basis.to_rate * motion;
  VectorXd viscous(x.size());
  for (Index k = 0; k < x.size(); ++k) {
    const ElasticForce f = elastic_force(own, x[k], omega * rate[k]);
    samples.add(k, f);
    viscous[k] = f.by_velocity;
  }
  out.force = samples.force();
  const MatrixXd damping = basis.to_harmonics * viscous.asDiagonal();
  out.by_motion = samples.by_motion() + omega * damping * basis.to_rate;
  out.by_omega = damping * rate;
  return out;
}

HarmonicForce linearised_force(const JointLaw& law, const VectorXd& motion, double omega) {
  const Complex x(motion[0], motion[1]);
  const double A = std::max(std::abs(x), 1e-300);
  const auto [g, slope] = describing_function(law, A, omega);
  const Complex force = g * x, along = slope * x / A; // by the amplitude, times d A / d x
  HarmonicForce out{Eigen::Vector2d(force.real(), force.imag()), MatrixXd(2, 2), VectorXd::Zero(2)};
  out.by_motion << g.real() + along.real() * x.real(), -g.imag() + along.real() * x.imag(),
      g.imag() + along.imag() * x.real(), g.real() + along.imag() * x.imag();
  if (law.coulomb.force > 0) {
    const double h = 1e-6 * omega;
    const Complex by_omega = (describing_function(law, A, omega + h).gain -
                              describing_function(law, A, omega - h).gain) /
                             (2 * h) * x;
    out.by_omega << by_omega.real(), by_omega.imag();
  }
  return out;
}

} // namespace plica
