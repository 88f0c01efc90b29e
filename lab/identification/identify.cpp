#include "lab/identification/identify.hpp"

#include "lab/identification/band_ends.hpp"
#include "lab/identification/circle_fit.hpp"
#include "lab/identification/identification_warnings.hpp"
#include "lab/identification/mode_correlation.hpp"
#include "lab/identification/mode_of_fit.hpp"
#include "lab/identification/peak_picking.hpp"
#include "lab/identification/spread.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

double rms(const std::vector<MatrixXcd>& list) {
  double square = 0;
  for (const MatrixXcd& H : list) square += H.squaredNorm();
  return std::sqrt(square);
}

int usual_order(const FrfSet& set) {
  const int order = set.H.size() == 1 ? 40 : set.H.size() == 2 ? 30 : 24;
  return std::clamp(static_cast<int>(set.hertz.size()) / 2, 2, order);
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
  IdentifiedMode mode = mode_of(m);
  mode.mass_normalised = mass_normalise(set, m, mode);
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

struct Fitted {
  std::vector<DiagramPole> diagram;
  ModalFit fit;
};

Fitted fitted(const FrfSet& set, const IdentifySettings& settings) {
  const int order = settings.highest_order > 0 ? settings.highest_order : usual_order(set);
  Fitted f{.diagram = stabilisation(lscf(set, order)), .fit = {}};
  Poles poles;
  for (const StableGroup& g : stable_groups(f.diagram)) poles.push_back(g.pole.lambda);
  f.fit = fit_significant([&](const Poles& p) { return fit_modes(set, p); }, poles, set.hertz[0],
                          set.hertz[set.hertz.size() - 1]);
  return f;
}

// One reference at a time, each identified on its own.
std::vector<PartialIdentification> parts_of(const FrfSet& set, const IdentifySettings& settings) {
  std::vector<PartialIdentification> parts;
  for (std::size_t i = 0; set.H.size() > 1 && i < set.H.size(); ++i) {
    FrfSet alone = set;
    alone.references = {set.references[i]};
    alone.H = {set.H[i]};
    if (!set.sigma.empty()) alone.sigma = {set.sigma[i]};
    if (alone.H[0].isZero(0)) continue;
    parts.push_back(partial_identification(set.references[i], fitted(alone, settings).fit));
  }
  return parts;
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
  Fitted all = fitted(set, settings);
  found.diagram = std::move(all.diagram);
  const ModalFit& fit = all.fit;
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
  widen_by_band_ends(set, fit, found.modes);
  std::vector<std::string> spread;
  widen_by_parts(parts_of(set, settings), found.modes, spread);
  for (IdentifiedMode& m : found.modes) widen_by_resolution(set, m);
  found.auto_mac = mac_matrix(shapes, shapes);
  found.warnings = identification_warnings(found);
  found.warnings.insert(found.warnings.end(), spread.begin(), spread.end());
  return found;
}

} // namespace plica
