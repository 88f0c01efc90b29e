#include "lab/signals/fourier.hpp"

#include <fftw3.h>

#include <stdexcept>
#include <type_traits>

namespace plica {
namespace {

struct Free {
  void operator()(void* memory) const { fftw_free(memory); }
};
struct Destroy {
  void operator()(fftw_plan_s* plan) const { fftw_destroy_plan(plan); }
};
using Plan = std::unique_ptr<fftw_plan_s, Destroy>;

static_assert(std::is_same_v<fftw_plan, fftw_plan_s*>);

} // namespace

struct Fourier::Plans {
  std::unique_ptr<double, Free> real;
  std::unique_ptr<fftw_complex, Free> complex;
  Plan forward, inverse;
};

Fourier::Fourier(int length) : length_(length), plans_(std::make_unique<Plans>()) {
  if (length < 1) throw std::invalid_argument("a Fourier transform needs at least one sample");
  const int lines = length / 2 + 1;
  plans_->real.reset(fftw_alloc_real(std::size_t(length)));
  plans_->complex.reset(fftw_alloc_complex(std::size_t(lines)));
  // FFTW_ESTIMATE chooses without timing, so that the same signal gives the same bits every time.
  plans_->forward.reset(
      fftw_plan_dft_r2c_1d(length, plans_->real.get(), plans_->complex.get(), FFTW_ESTIMATE));
  plans_->inverse.reset(
      fftw_plan_dft_c2r_1d(length, plans_->complex.get(), plans_->real.get(), FFTW_ESTIMATE));
}

Fourier::~Fourier() = default;
Fourier::Fourier(Fourier&&) noexcept = default;
Fourier& Fourier::operator=(Fourier&&) noexcept = default;

Eigen::VectorXcd Fourier::forward(const Eigen::VectorXd& x) {
  if (x.size() != length_) throw std::invalid_argument("signal and transform differ in length");
  Eigen::Map<Eigen::VectorXd>(plans_->real.get(), length_) = x;
  fftw_execute(plans_->forward.get());
  const auto* result = reinterpret_cast<const std::complex<double>*>(plans_->complex.get());
  return Eigen::Map<const Eigen::VectorXcd>(result, length_ / 2 + 1);
}

Eigen::VectorXd Fourier::inverse(const Eigen::VectorXcd& X) {
  if (X.size() != length_ / 2 + 1)
    throw std::invalid_argument("spectrum and transform differ in length");
  auto* place = reinterpret_cast<std::complex<double>*>(plans_->complex.get());
  Eigen::Map<Eigen::VectorXcd>(place, X.size()) = X;
  fftw_execute(plans_->inverse.get());
  return Eigen::Map<const Eigen::VectorXd>(plans_->real.get(), length_) / double(length_);
}

Eigen::VectorXcd analytic_signal(const Eigen::VectorXd& x) {
  const int n = static_cast<int>(x.size());
  Fourier transform(n);
  Eigen::VectorXcd X = transform.forward(x);
  // -i for positive frequencies turns a cosine into a sine.
  X *= std::complex<double>(0, -1);
  X[0] = 0;
  if (n % 2 == 0) X[n / 2] = 0;
  const Eigen::VectorXd quadrature = transform.inverse(X);
  Eigen::VectorXcd analytic(n);
  analytic.real() = x;
  analytic.imag() = quadrature;
  return analytic;
}

} // namespace plica
