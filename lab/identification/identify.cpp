#include "lab/identification/identify.hpp"

#include "lab/identification/circle_fit.hpp"
#include "lab/identification/identification_warnings.hpp"
#include "lab/identification/modal_fit.hpp"
#include "lab/identification/mode_correlation.hpp"
#include "lab/identification/peak_picking.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double rms(const std::vector<MatrixXcd>& list) {
  double square = 0;
  for (const MatrixXcd& H : list) square += H.squaredNorm();
  return std::sqrt(square);
}

int usual_order(const FrfSet& set) {
  const int order = set.H.size() == 1 ? 40 : set.H.size() == 2 ? 30 : 24;
  return std::clamp(static_cast<int>(set.hertz.size()) / 2, 2, order);
}

// A pole that no response needs, that the fit moved out of the band, or that is known to no better
// than its own size, is one of the noise.
bool is_noise(const FittedMode& m, const FrfSet& set) {
  const double f = m.frequency();
  if (f < set.hertz[0] || f > set.hertz[set.hertz.size() - 1]) return true;
  if (m.damping() > 0.5 || m.sigma_damping() > 0.5 * m.damping()) return true;
  return (m.residue.cwiseAbs().array() < 5 * m.sigma_residue.array()).all();
}

std::vector<Complex> poles_of(const ModalFit& fit, const FrfSet& set) {
  std::vector<Complex> kept;
  for (const FittedMode& m : fit.modes)
    if (!is_noise(m, set)) kept.push_back(m.lambda);
  return kept;
}

// Poles that share half a bandwidth after the fit are one, unless the references tell them apart.
std::vector<Complex> without_twins(const std::vector<Complex>& poles) {
  std::vector<Complex> kept;
  for (const Complex& p : poles)
    if (std::none_of(kept.begin(), kept.end(), [&](const Complex& q) {
          return std::abs(p - q) < 0.1 * std::min(-p.real(), -q.real());
        }))
      kept.push_back(p);
  return kept;
}

ModalFit fit_significant(const FrfSet& set, std::vector<Complex> poles) {
  ModalFit fit = fit_modes(set, poles);
  for (int round = 0; round < 4; ++round) {
    poles = without_twins(poles_of(fit, set));
    if (poles.size() == fit.modes.size()) break;
    fit = fit_modes(set, poles);
  }
  return fit;
}

// Reference that is also a response, as its index among these; -1 where none is.
int driven_response(const FrfSet& set, std::size_t reference) {
  const auto found =
      std::find(set.responses.begin(), set.responses.end(), set.references[reference]);
  return found == set.responses.end() ? -1 : static_cast<int>(found - set.responses.begin());
}

// R = phi phi' / (2 i w_d) of a mass-normalised real mode.
bool mass_normalise(const FrfSet& set, const FittedMode& m, IdentifiedMode& mode) {
  if (set.quantity == FrfQuantity::transmissibility) return false;
  int at = -1, reference = -1;
  double largest = 0;
  for (std::size_t i = 0; i < set.references.size(); ++i) {
    const int o = driven_response(set, i);
    if (o < 0) continue;
    const double size = std::abs(m.residue(o, Index(i)));
    if (size > largest) {
      largest = size;
      at = o;
      reference = static_cast<int>(i);
    }
  }
  if (at < 0) return false;
  const Complex square = m.residue(at, reference) * Complex(0, 2 * m.lambda.imag());
  if (square.real() <= 0) return false; // the drive point answers the wrong way round
  const Complex phi = std::sqrt(square);
  const Complex scale = mode.shape[at] == 0. ? 0. : phi / mode.shape[at];
  mode.shape *= scale;
  mode.sigma_shape *= std::abs(scale);
  return true;
}

IdentifiedMode described(const FrfSet& set, const FittedMode& m) {
  IdentifiedMode mode;
  mode.frequency = m.frequency();
  mode.damping = m.damping();
  mode.sigma_frequency = m.sigma_frequency();
  mode.sigma_damping = m.sigma_damping();
  const Eigen::JacobiSVD<MatrixXcd> svd(m.residue, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const VectorXd s = svd.singularValues();
  mode.rank = s.size() > 1 && s[0] > 0 ? s[1] / s[0] : 0;
  mode.shape = turned_real(svd.matrixU().col(0));
  mode.participation = svd.matrixV().col(0).conjugate();
  mode.collinearity = phase_collinearity(mode.shape);
  const VectorXd scatter =
      (m.sigma_residue.cwiseAbs2() * mode.participation.cwiseAbs2()).cwiseSqrt();
  mode.sigma_shape = s[0] > 0 ? VectorXd(scatter / s[0]) : scatter;
  mode.mass_normalised = mass_normalise(set, m, mode);
  if (!mode.mass_normalised) {
    const double largest = mode.shape.cwiseAbs().maxCoeff();
    mode.shape /= largest;
    mode.sigma_shape /= largest;
  }
  return mode;
}

// What the mode alone gives, relative to all.
double share_of(const ModalFit& fit, std::size_t mode, const FrfSet& set) {
  ModalFit alone = fit;
  alone.modes = {fit.modes[mode]};
  alone.lower.setZero();
  alone.upper.setZero();
  return rms(synthesise(alone, set.quantity, set.hertz)) / rms(set.H);
}

// Peak and circle in the response in which the mode is largest, within two bandwidths.
void add_single_estimates(const FrfSet& set, const FittedMode& m, IdentifiedMode& mode) {
  mode.peak_frequency = mode.peak_damping = mode.circle_frequency = mode.circle_damping = nan;
  Index o = 0, i = 0;
  m.residue.cwiseAbs().maxCoeff(&o, &i);
  mode.strongest = set.responses[o] + " by " + set.references[i];
  const VectorXcd h = set.H[i].col(o);
  const double reach =
      std::max(2 * mode.damping * mode.frequency, 3 * (set.hertz[1] - set.hertz[0]));
  for (const PickedPeak& p : pick_peaks(set.hertz, h.cwiseAbs(), 1.05, 0))
    if (std::abs(p.frequency - mode.frequency) < reach &&
        !(std::abs(mode.peak_frequency - mode.frequency) <=
          std::abs(p.frequency - mode.frequency))) {
      mode.peak_frequency = p.frequency;
      mode.peak_damping = p.damping;
    }
  std::vector<int> lines;
  for (int f = 0; f < set.hertz.size(); ++f)
    if (std::abs(set.hertz[f] - mode.frequency) < reach) lines.push_back(f);
  const VectorXd hertz = set.hertz(lines);
  const VectorXcd values = h(lines);
  const CircleFit circle = fit_circle(hertz, values, set.quantity, DampingModel::viscous);
  if (!circle.good || circle.misfit > 0.2) return;
  mode.circle_frequency = circle.frequency;
  mode.circle_damping = circle.damping;
}

int orders_that_show(const std::vector<DiagramPole>& diagram, const IdentifiedMode& mode) {
  std::vector<int> orders;
  for (const DiagramPole& p : diagram)
    if (p.stability == Stability::all &&
        std::abs(p.pole.frequency() - mode.frequency) < 0.5 * mode.damping * mode.frequency &&
        (orders.empty() || orders.back() != p.order))
      orders.push_back(p.order);
  return static_cast<int>(orders.size());
}

// Estimates from one reference at a time: where they differ, the references were not measured on
// the same structure, and no single fit knows how well.
void widen_by_references(const FrfSet& set, const ModalFit& fit,
                         std::vector<IdentifiedMode>& modes) {
  if (set.H.size() < 2 || modes.empty()) return;
  std::vector<Complex> poles;
  for (const FittedMode& m : fit.modes) poles.push_back(m.lambda);
  std::vector<std::vector<double>> f(modes.size()), z(modes.size());
  for (std::size_t i = 0; i < set.H.size(); ++i) {
    FrfSet alone = set;
    alone.references = {set.references[i]};
    alone.H = {set.H[i]};
    if (!set.sigma.empty()) alone.sigma = {set.sigma[i]};
    const ModalFit one = fit_modes(alone, poles);
    for (std::size_t r = 0; r < modes.size(); ++r) {
      const double all = fit.modes[r].residue.colwise().norm().maxCoeff();
      if (fit.modes[r].residue.col(Index(i)).norm() < 0.1 * all) continue; // hardly driven
      f[r].push_back(one.modes[r].frequency());
      z[r].push_back(one.modes[r].damping());
    }
  }
  const auto error_of_mean = [](const std::vector<double>& x) {
    double mean = 0, square = 0;
    for (double v : x) mean += v / double(x.size());
    for (double v : x) square += (v - mean) * (v - mean);
    return x.size() < 2 ? 0 : std::sqrt(square / double(x.size() - 1) / double(x.size()));
  };
  for (std::size_t r = 0; r < modes.size(); ++r) {
    modes[r].sigma_frequency = std::max(modes[r].sigma_frequency, error_of_mean(f[r]));
    modes[r].sigma_damping = std::max(modes[r].sigma_damping, error_of_mean(z[r]));
  }
}

// A line of width B widens a resonance of half-power width W: damping is high by (B / W)^2 / 2 of
// it.
void widen_by_resolution(const FrfSet& set, IdentifiedMode& mode) {
  const double width = 2 * mode.damping * mode.frequency;
  const double bias = mode.damping * std::pow(set.resolution / width, 2) / 2;
  mode.sigma_damping = std::hypot(mode.sigma_damping, bias);
}

} // namespace

Identification identify(const FrfSet& given, const IdentifySettings& settings) {
  Identification found;
  const double high = settings.high > 0 ? settings.high : given.hertz[given.hertz.size() - 1];
  // At 0 Hz an accelerance says nothing.
  const double low = std::max(settings.low, given.quantity == FrfQuantity::receptance ? 0. : 1e-9);
  found.set = within(given, low, high);
  const FrfSet& set = found.set;
  const int order = settings.highest_order > 0 ? settings.highest_order : usual_order(set);
  found.diagram = stabilisation(lscf(set, order));
  std::vector<Complex> poles;
  for (const StableGroup& g : stable_groups(found.diagram)) poles.push_back(g.pole.lambda);
  const ModalFit fit = fit_significant(set, poles);
  found.synthesised = fit.H;
  found.misfit = 0;
  std::vector<MatrixXcd> difference = fit.H;
  for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= set.H[i];
  found.misfit = rms(set.H) > 0 ? rms(difference) / rms(set.H) : 0;
  found.frac.resize(Index(set.responses.size()), Index(set.H.size()));
  for (std::size_t i = 0; i < set.H.size(); ++i)
    found.frac.col(Index(i)) = frac(set.H[i], fit.H[i]);
  MatrixXcd shapes(Index(set.responses.size()), Index(fit.modes.size()));
  for (std::size_t r = 0; r < fit.modes.size(); ++r) {
    IdentifiedMode mode = described(set, fit.modes[r]);
    mode.share = share_of(fit, r, set);
    mode.orders = orders_that_show(found.diagram, mode);
    add_single_estimates(set, fit.modes[r], mode);
    shapes.col(Index(r)) = mode.shape;
    found.modes.push_back(std::move(mode));
  }
  widen_by_references(set, fit, found.modes);
  for (IdentifiedMode& m : found.modes) widen_by_resolution(set, m);
  found.auto_mac = mac_matrix(shapes, shapes);
  found.warnings = identification_warnings(found);
  return found;
}

} // namespace plica
