#include "solve/random_response.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

// Value at f of the power law through two points; the straight line where one of them is zero.
double between(double f1, double s1, double f2, double s2, double f) {
  if (s1 <= 0 || s2 <= 0 || f1 <= 0) return s1 + (s2 - s1) * (f - f1) / (f2 - f1);
  return s1 * std::pow(f / f1, std::log(s2 / s1) / std::log(f2 / f1));
}

// Integral of that law from f1 to f2.
double area(double f1, double s1, double f2, double s2) {
  if (s1 <= 0 || s2 <= 0 || f1 <= 0) return (s1 + s2) / 2 * (f2 - f1);
  const double octaves = std::log(f2 / f1), grown = std::log(s2 / s1) + octaves; // of f S
  const double mean = std::abs(grown) < 1e-6 ? 1 + grown / 2 : std::expm1(grown) / grown;
  return f1 * s1 * octaves * mean;
}

} // namespace

double density_at(const SpectralDensity& input, double hertz) {
  const auto& t = input.table;
  if (t.empty() || hertz < t.front()[0] || hertz > t.back()[0]) return 0;
  const auto above = std::find_if(t.begin(), t.end(), [&](const auto& p) { return p[0] >= hertz; });
  if ((*above)[0] == hertz) return (*above)[1];
  const auto& [f1, s1] = *(above - 1);
  return between(f1, s1, (*above)[0], (*above)[1], hertz);
}

Eigen::MatrixXd response_density(const SpectralDensity& input, const Eigen::VectorXd& hertz,
                                 const Eigen::MatrixXcd& response) {
  const Eigen::VectorXd S = hertz.unaryExpr([&](double f) { return density_at(input, f); });
  return S.asDiagonal() * response.cwiseAbs2();
}

Eigen::VectorXcd cross_density(const SpectralDensity& input, const Eigen::VectorXd& hertz,
                               const Eigen::MatrixXcd& response, int a, int b) {
  const Eigen::VectorXd S = hertz.unaryExpr([&](double f) { return density_at(input, f); });
  return S.cast<std::complex<double>>().cwiseProduct(
      response.col(a).cwiseProduct(response.col(b).conjugate()));
}

double rms(const Eigen::VectorXd& hertz, const Eigen::VectorXd& density, double low, double high) {
  double sum = 0;
  for (Eigen::Index i = 1; i < hertz.size(); ++i) {
    double f1 = hertz[i - 1], s1 = density[i - 1], f2 = hertz[i], s2 = density[i];
    if (f2 <= low || f1 >= high) continue;
    const double from = std::max(f1, low), to = std::min(f2, high);
    const double s_from = between(f1, s1, f2, s2, from), s_to = between(f1, s1, f2, s2, to);
    sum += area(from, s_from, to, s_to);
  }
  return std::sqrt(sum);
}

} // namespace plica
