// Discrete Fourier transforms of real signals; the only source file that includes FFTW is
// fourier.cpp.
//
//   X_k = sum_n x_n e^{-2 pi i k n / N},   k = 0 .. N/2
#pragma once

#include <Eigen/Core>
#include <memory>

namespace plica {

// Transforms of one length, planned once. Not to be used by two threads at a time.
class Fourier {
public:
  explicit Fourier(int length); // throws std::invalid_argument below 1
  ~Fourier();
  Fourier(Fourier&&) noexcept;
  Fourier& operator=(Fourier&&) noexcept;

  int length() const { return length_; }
  Eigen::VectorXcd forward(const Eigen::VectorXd& x); // length -> length/2 + 1
  Eigen::VectorXd inverse(const Eigen::VectorXcd& X); // with 1/N, so that inverse(forward(x)) = x

private:
  struct Plans;
  int length_;
  std::unique_ptr<Plans> plans_;
};

// Analytic signal x + i H(x) of a real signal (Hilbert transform along the whole record).
Eigen::VectorXcd analytic_signal(const Eigen::VectorXd& x);

} // namespace plica
