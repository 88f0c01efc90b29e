#include "solve/random_response.hpp"

#include "words/short_text.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::MatrixXcd;

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

CrossSpectrum one_input(SpectralDensity density) {
  return {.densities = {std::move(density)}, .coherence = MatrixXcd::Ones(1, 1), .table = {}};
}

MatrixXcd spectrum_at(const CrossSpectrum& inputs, double hertz) {
  if (inputs.table.empty()) {
    const Eigen::VectorXd root =
        Eigen::VectorXd::NullaryExpr(Eigen::Index(inputs.densities.size()), [&](Eigen::Index k) {
          return std::sqrt(density_at(inputs.densities[std::size_t(k)], hertz));
        });
    return root.asDiagonal() * inputs.coherence * root.asDiagonal();
  }
  const auto& t = inputs.table;
  const auto n = t.front().second.rows();
  if (hertz < t.front().first || hertz > t.back().first) return MatrixXcd::Zero(n, n);
  const auto above =
      std::find_if(t.begin(), t.end(), [&](const auto& row) { return row.first >= hertz; });
  if (above->first == hertz) return above->second;
  const auto& [f1, S1] = *(above - 1);
  const double share = (hertz - f1) / (above->first - f1);
  return (1 - share) * S1 + share * above->second;
}

std::string not_a_spectrum(const MatrixXcd& S) {
  constexpr double rounding = 1e-9;
  const double largest = S.cwiseAbs().maxCoeff();
  if ((S - S.adjoint()).cwiseAbs().maxCoeff() > rounding * largest)
    return "is not Hermitian: entry (b, a) must be the conjugate of (a, b)";
  const double lowest =
      Eigen::SelfAdjointEigenSolver<MatrixXcd>(S, Eigen::EigenvaluesOnly).eigenvalues().minCoeff();
  if (lowest < -rounding * std::max(largest, 1e-300))
    return "is not positive: no signals have such coherences, it has the eigenvalue " +
           short_text(lowest / std::max(largest, 1e-300)) + " of its largest entry";
  return "";
}

MatrixXcd root_of_spectrum(const MatrixXcd& S) {
  if (S.rows() == 1) return S.cwiseSqrt();
  const Eigen::SelfAdjointEigenSolver<MatrixXcd> eigen(S);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
}

Eigen::VectorXcd cross_density(const CrossSpectrum& inputs, const Eigen::VectorXd& hertz,
                               const std::vector<MatrixXcd>& responses, int a, int b) {
  Eigen::VectorXcd density(hertz.size());
  const auto count = Eigen::Index(responses.size());
  Eigen::VectorXcd of_a(count), of_b(count);
  for (Eigen::Index i = 0; i < hertz.size(); ++i) {
    for (Eigen::Index k = 0; k < count; ++k) {
      of_a[k] = responses[std::size_t(k)](i, a);
      of_b[k] = responses[std::size_t(k)](i, b);
    }
    density[i] = (of_a.transpose() * spectrum_at(inputs, hertz[i]) * of_b.conjugate()).value();
  }
  return density;
}

Eigen::MatrixXd response_density(const CrossSpectrum& inputs, const Eigen::VectorXd& hertz,
                                 const std::vector<MatrixXcd>& responses) {
  const auto count = Eigen::Index(responses.size());
  const auto channels = responses.front().cols();
  Eigen::MatrixXd density(hertz.size(), channels);
  MatrixXcd H(count, channels);
  for (Eigen::Index i = 0; i < hertz.size(); ++i) {
    for (Eigen::Index k = 0; k < count; ++k) H.row(k) = responses[std::size_t(k)].row(i);
    // S_aa = h_a' S conj(h_a) = |L^H conj(h_a)|^2
    const MatrixXcd root = root_of_spectrum(spectrum_at(inputs, hertz[i]));
    density.row(i) = (root.transpose() * H).cwiseAbs2().colwise().sum();
  }
  return density;
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
