#include "diagnose/gap/predictor.hpp"

#include "solve/parallel.hpp"
#include "solve/statics.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Complex = std::complex<double>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double strong = 0.12; // of the highest: below what counts as strong in a measurement
constexpr Index most_modes = 40;

// Modes of one reduced model, with what excites and shows them.
struct FamilyModes {
  VectorXd lambda, zeta;
  MatrixXd gamma;    // modes x 3: by translations of the base
  MatrixXd marked;   // 6 rows per sensor x modes
  MatrixXd likeness; // nominal modes x modes: squared M-product
  VectorXd stretch;  // of the softening group, m
  double omega(Index i) const { return std::sqrt(lambda[i]); }
};

// How much of the stuck stiffness sliders keep at an amplitude (real part) and lose (imaginary).
Complex kept_by_sliders(const Softening& s, double amplitude) {
  constexpr int count = 9;
  JointLaw law;
  for (int i = 0; i < count; ++i) {
    const double place = (i + 0.5) / count - 0.5;
    const double distance = s.distance * std::pow(std::max(1., s.spread), place);
    law.sliders.push_back({.stiffness = 1. / count, .slip_force = distance / count});
  }
  return describing_function(law, amplitude, 1).gain;
}

// Between both caps, without spring mounts.
std::optional<EndStiffness> end_stiffness_of(const NominalState& state, const MatrixXd& K) {
  const Case& data = state.data;
  if (data.caps.size() != 2) return std::nullopt;
  std::vector<Index> rows;
  const std::vector<int>& boundary = state.model->boundary();
  for (const Cap& cap : data.caps) {
    const auto at = std::find(boundary.begin(), boundary.end(), state.built.cap_nodes.at(cap.name));
    if (at == boundary.end()) return std::nullopt;
    for (int d = 0; d < 6; ++d) rows.push_back(6 * (at - boundary.begin()) + d);
  }
  std::vector<Index> others;
  for (Index i = 0; i < K.rows(); ++i)
    if (std::find(rows.begin(), rows.end(), i) == rows.end()) others.push_back(i);
  MatrixXd condensed = K(rows, rows);
  const Eigen::LDLT<MatrixXd> inner(K(others, others));
  condensed -= K(rows, others) * inner.solve(MatrixXd(K(others, rows)));
  for (const BushingElement& b : state.built.model.bushings) {
    if (b.node2 >= 0) continue;
    for (std::size_t c = 0; c < 2; ++c)
      if (b.node1 == state.built.cap_nodes.at(data.caps[c].name))
        condensed.block<6, 6>(6 * Index(c), 6 * Index(c)) -= ground_bushing_matrix(b.bushing);
  }
  try {
    return end_stiffness(Matrix6(condensed.bottomRightCorner<6, 6>()));
  } catch (const std::runtime_error&) {
    return std::nullopt; // so soft that nothing holds the ends together
  }
}

double along(const EndStiffness& k, StaticDirection direction) {
  switch (direction) {
  case StaticDirection::axial:
    return k.axial;
  case StaticDirection::transverse_x:
    return k.transverse_x;
  case StaticDirection::transverse_z:
    return k.transverse_z;
  case StaticDirection::bending_x:
    return k.bending_x;
  case StaticDirection::bending_z:
    return k.bending_z;
  case StaticDirection::torsion:
    break;
  }
  return k.torsion;
}

// Peaks of a model in the order of measured ones: increasing, each at most once while there are
// enough, the sum of |ln f - ln f'| least.
std::vector<Index> paired(const std::vector<double>& measured, const std::vector<double>& model,
                          bool first) {
  const std::size_t m = measured.size(), n = model.size();
  std::vector<Index> pairs(m, 0);
  if (n == 0) return std::vector<Index>(m, -1);
  if (n <= m || first) {
    for (std::size_t i = 0; i < m; ++i) pairs[i] = Index(std::min(i, n - 1));
    return pairs;
  }
  std::vector<std::vector<double>> cost(m + 1, std::vector<double>(n + 1, 0));
  constexpr double far = 1e9;
  for (std::size_t i = 1; i <= m; ++i)
    for (std::size_t j = 0; j <= n; ++j) {
      cost[i][j] = far;
      if (j < i) continue;
      const double pair = cost[i - 1][j - 1] + std::abs(std::log(measured[i - 1] / model[j - 1]));
      cost[i][j] = std::min(pair, j > i ? cost[i][j - 1] : far);
    }
  std::size_t j = n;
  for (std::size_t i = m; i > 0; --i) {
    while (j > i && cost[i][j] == cost[i][j - 1]) --j;
    pairs[i - 1] = Index(--j);
  }
  return pairs;
}

} // namespace

// The answers of one state under given values.
class StateAnswers {
public:
  StateAnswers(const Predictor& predictor, std::size_t state,
               const Predictor::Coefficients& coefficients, const TestSetup& setup,
               const VectorXd& values)
      : predictor_(predictor), own_(predictor.states_[state]), coefficients_(coefficients),
        setup_(setup) {
    if (predictor.softening_ < 0) return;
    Index first = 0;
    for (int h = 0; h < predictor.softening_; ++h)
      first += Index(predictor.together_[std::size_t(h)]->parameters.size());
    const Hypothesis& h = *predictor.together_[std::size_t(predictor.softening_)];
    softening_ = h.softening(values.segment(first, Index(h.parameters.size())));
  }

  // False: no stable structure.
  bool answer(const Reading& reading, double& value) {
    value = none;
    switch (reading.kind) {
    case ReadingKind::mass:
      value = std::log(mass());
      return true;
    case ReadingKind::stiffness:
      value = static_stiffness(reading);
      return true;
    default:
      return dynamic(reading, value);
    }
  }

  const FamilyModes* linear_modes() {
    if (!linear_) linear_ = modes(1);
    return *linear_ ? &**linear_ : nullptr;
  }

  int nominal_mode(const Reading& reading) {
    if (reading.run < 0) return -1;
    const FamilyModes* m = linear_modes();
    const TestRun& run = predictor_.test_.runs[std::size_t(reading.run)];
    if (!m) return -1;
    Index own = 0;
    if (run.base < 0) {
      own = nominal_of_kind(reading);
      return int(own);
    }
    own = peak_modes(*m, run)[std::size_t(reading.peak)];
    if (own < 0) return -1;
    Index nominal = 0;
    m->likeness.col(own).maxCoeff(&nominal);
    return int(nominal);
  }

  // Accelerations of all sensors per unit of the commanded base, part axes: 3 rows each, a column
  // per frequency.
  Eigen::MatrixXcd motion(const FamilyModes& m, const VectorXd& zeta, int base,
                          const std::vector<double>& omega) const {
    const Vector3d d = setup_.base.col(base);
    const VectorXd gamma = m.gamma * d;
    Eigen::MatrixXcd q(m.lambda.size(), Index(omega.size()));
    for (Index k = 0; k < q.cols(); ++k) {
      const double w = omega[std::size_t(k)];
      for (Index i = 0; i < q.rows(); ++i)
        q(i, k) = w * w * gamma[i] / Complex(m.lambda[i] - w * w, 2 * zeta[i] * m.omega(i) * w);
    }
    const auto sensors = Index(own_.nominal->built.sensors.size());
    MatrixXd rows(3 * sensors, m.lambda.size());
    for (Index s = 0; s < sensors; ++s) {
      rows.middleRows<3>(3 * s) = m.marked.middleRows<3>(6 * s);
      const std::string& name = own_.nominal->built.sensors[std::size_t(s)].name;
      if (const auto moved = setup_.moved.find(name); moved != setup_.moved.end())
        for (Index i = 0; i < rows.cols(); ++i)
          rows.col(i).segment<3>(3 * s) +=
              Vector3d(m.marked.block<3, 1>(6 * s + 3, i)).cross(moved->second);
    }
    Eigen::MatrixXcd u = rows * q;
    for (Index s = 0; s < sensors; ++s) u.middleRows<3>(3 * s).colwise() += d.cast<Complex>();
    return u;
  }

  // One sensor's own axis of such motions.
  Eigen::RowVectorXcd reading_of(const Eigen::MatrixXcd& motion, int sensor, int axis) const {
    const BuiltSensor& own = own_.nominal->built.sensors[std::size_t(sensor)];
    Eigen::Matrix3d reading = own_.nominal->axes[std::size_t(sensor)];
    if (const auto turned = setup_.reading.find(own.name); turned != setup_.reading.end())
      reading = turned->second * reading;
    return reading.row(axis).cast<Complex>() * motion.middleRows<3>(3 * Index(sensor));
  }

  int sensor_named(const std::string& name) const {
    const auto& sensors = own_.nominal->built.sensors;
    for (std::size_t i = 0; i < sensors.size(); ++i)
      if (sensors[i].name == name) return int(i);
    return -1;
  }

private:
  // A peak of a run: the modes at its amplitude, and which of them it is.
  struct Peak {
    const FamilyModes* modes = nullptr;
    VectorXd zeta;
    Index mode = 0;
    Eigen::MatrixXcd near, around; // motions within its width, and where cross responses are sought
  };
  static constexpr int half_steps = 4; // near: from -2 to 2 damping ratios off

  static MatrixXd matrix(const MatrixXd& A, const std::vector<MatrixXd>& dA, const VectorXd& c) {
    MatrixXd sum = A;
    for (std::size_t k = 0; k < dA.size(); ++k) sum += c[Index(k)] * dA[k];
    return sum;
  }

  std::optional<double> stiffness_at(StaticDirection direction, double kept) const {
    VectorXd c = coefficients_.rig;
    if (predictor_.softening_ >= 0) {
      const double present =
          predictor_.together_[std::size_t(predictor_.softening_)]->group_present;
      double& group = c[predictor_.first_change_];
      group = (group + present) * kept - present;
    }
    const auto k = end_stiffness_of(*own_.nominal, matrix(own_.family.K, own_.family.dK, c));
    if (!k) return std::nullopt;
    return along(*k, direction);
  }

  // A group that slips answers by what it keeps at the stroke; without one, by what is left when
  // all slides. Its stretch follows from the energy it has of the whole: dk/d(kept) = u' K_group u.
  double static_stiffness(const Reading& reading) const {
    const auto stuck = stiffness_at(reading.direction, 1);
    if (!stuck) return none;
    if (predictor_.softening_ < 0) return std::log(*stuck);
    constexpr double less = 0.9;
    const auto softer = stiffness_at(reading.direction, less);
    if (!softer) return none;
    const double k = predictor_.together_[std::size_t(predictor_.softening_)]->group_stiffness;
    const double stretch =
        reading.stroke * std::sqrt(std::max(0., (*stuck - *softer) / (1 - less)) / k);
    const double kept =
        reading.stroke > 0
            ? 1 - softening_.share * (1 - kept_by_sliders(softening_, stretch).real())
            : 1 - softening_.share;
    const auto value = stiffness_at(reading.direction, kept);
    return value ? std::log(*value) : none;
  }

  double mass() const {
    double sum = own_.family.mass;
    for (std::size_t k = 0; k < own_.family.d_mass.size(); ++k)
      sum += coefficients_.rig[Index(k)] * own_.family.d_mass[k];
    return sum;
  }

  // `kept`: share of the softening group's stuck stiffness.
  std::optional<FamilyModes> modes(double kept) const {
    const ReducedFamily& f = own_.family;
    VectorXd c = coefficients_.all;
    const Index group = predictor_.first_change_;
    double present = 0;
    if (predictor_.softening_ >= 0) {
      present = predictor_.together_[std::size_t(predictor_.softening_)]->group_present;
      c[group] = (c[group] + present) * kept - present;
    }
    const std::vector<int>& free = own_.free;
    const MatrixXd K = matrix(f.K, f.dK, c)(free, free), M = matrix(f.M, f.dM, c)(free, free);
    const Eigen::LLT<MatrixXd> definite(K);
    if (definite.info() != Eigen::Success) return std::nullopt;
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> pairs(M, K);
    if (pairs.info() != Eigen::Success) return std::nullopt;
    const VectorXd& theta = pairs.eigenvalues(); // 1 / lambda, increasing
    const Index n = theta.size();
    Index count = 0;
    while (count < std::min(n, most_modes) && theta[n - 1 - count] > 1e-12 * theta[n - 1]) ++count;
    if (count == 0) return std::nullopt;
    FamilyModes m;
    m.lambda = theta.tail(count).reverse().cwiseInverse();
    const MatrixXd q = pairs.eigenvectors().rightCols(count).rowwise().reverse() *
                       m.lambda.cwiseSqrt().asDiagonal();
    MatrixXd load = f.load;
    for (std::size_t k = 0; k < f.d_load.size(); ++k) load += c[Index(k)] * f.d_load[k];
    m.gamma = q.transpose() * load(free, Eigen::all);
    m.marked = f.marked(Eigen::all, free) * q;
    m.likeness = (f.nominal(free, Eigen::all).transpose() * (f.M(free, free) * q)).array().square();
    const VectorXd& zeta = own_.nominal->zeta;
    const double otherwise = zeta.mean();
    m.zeta.resize(count);
    for (Index i = 0; i < count; ++i) {
      const double known = m.likeness.col(i).sum();
      const double mixed = m.likeness.col(i).dot(zeta) + std::max(0., 1 - known) * otherwise;
      m.zeta[i] = setup_.damping * mixed / std::max(1., known);
    }
    if (predictor_.softening_ >= 0) {
      const MatrixXd group_K = f.dK[std::size_t(group)](free, free);
      const double k = predictor_.together_[std::size_t(predictor_.softening_)]->group_stiffness;
      m.stretch = (q.cwiseProduct(group_K * q)).colwise().sum().transpose();
      m.stretch = (m.stretch.cwiseMax(0) / k).cwiseSqrt();
    }
    return m;
  }

  Vector3d base_of(const TestRun& run) const { return setup_.base.col(run.base); }

  // How high a mode stands in the channel of the run, up to a factor.
  VectorXd strengths(const FamilyModes& m, const TestRun& run) const {
    const int sensor = sensor_named(run.sensor);
    VectorXd s(m.lambda.size());
    for (Index i = 0; i < s.size(); ++i) {
      const double in =
          m.gamma.row(i).dot(run.axis == run.base ? base_of(run) : Vector3d::Unit(run.axis));
      const double out = sensor < 0 || run.axis != run.base
                             ? in
                             : (own_.nominal->axes[std::size_t(sensor)] *
                                m.marked.block<3, 1>(6 * Index(sensor), i))[run.axis];
      s[i] = std::abs(in * out) / m.zeta[i];
    }
    return s;
  }

  // Modes of a run's measured peaks.
  std::vector<Index> peak_modes(const FamilyModes& m, const TestRun& run) const {
    const VectorXd s = strengths(m, run);
    const double least = strong * s.maxCoeff();
    std::vector<Index> candidates;
    std::vector<double> hertz;
    for (Index i = 0; i < s.size(); ++i) {
      if (!(s[i] >= least)) continue;
      const double f = m.omega(i) / (2 * std::numbers::pi);
      // Two modes within their widths show one peak.
      if (!candidates.empty() &&
          f / hertz.back() - 1 < 0.5 * (m.zeta[i] + m.zeta[candidates.back()])) {
        if (s[i] > s[candidates.back()]) {
          candidates.back() = i;
          hertz.back() = f;
        }
        continue;
      }
      candidates.push_back(i);
      hertz.push_back(f);
    }
    std::vector<Index> result;
    for (Index pair : paired(run.peaks, hertz, run.first))
      result.push_back(pair < 0 ? -1 : candidates[std::size_t(pair)]);
    return result;
  }

  // The share of stiffness kept at which sliders and resonance agree about the amplitude.
  struct Slipping {
    double kept = 1, damping = 0;
  };
  // Modes over a few shares of stiffness kept, solved once.
  const std::vector<FamilyModes>* table() {
    if (!table_tried_) {
      table_tried_ = true;
      constexpr int points = 6;
      std::vector<FamilyModes> all;
      for (int i = 0; i < points; ++i) {
        shares_.push_back(1 - softening_.share * 0.98 * i / (points - 1));
        if (auto m = modes(shares_.back()))
          all.push_back(std::move(*m));
        else
          return nullptr;
      }
      table_ = std::move(all);
    }
    return table_.empty() ? nullptr : &table_;
  }

  Slipping slipping(const TestRun& run, int peak, double level) {
    // Of the peak's mode at each share: ln omega, motion per level at unit damping, zeta, energy
    // share of the group per unit of kept stiffness.
    const auto& all = *table();
    std::vector<std::array<double, 4>> rows;
    const double present = predictor_.together_[std::size_t(predictor_.softening_)]->group_present;
    const double stuck = coefficients_.all[predictor_.first_change_] + present;
    const double k = predictor_.together_[std::size_t(predictor_.softening_)]->group_stiffness;
    for (const FamilyModes& m : all) {
      const Index i = peak_modes(m, run)[std::size_t(peak)];
      if (i < 0) return {};
      const double stretch =
          std::abs(m.gamma.row(i).dot(base_of(run))) * m.stretch[i] / (2 * m.lambda[i]);
      rows.push_back({std::log(m.omega(i)), stretch, m.zeta[i],
                      stuck * k * m.stretch[i] * m.stretch[i] / m.lambda[i]});
    }
    const auto at = [&](double kept, std::size_t what) {
      const double step = shares_[0] - shares_[1];
      const double x =
          step > 0 ? std::clamp((shares_[0] - kept) / step, 0., double(rows.size()) - 1.000001) : 0;
      const auto i = std::size_t(x);
      return rows[i][what] + (x - double(i)) * (rows[i + 1][what] - rows[i][what]);
    };
    Softening own = softening_;
    constexpr int along_the_pipe = 1;
    if (run.base != along_the_pipe) own.distance *= own.across;
    const auto state_at = [&](double amplitude) {
      const Complex gain = kept_by_sliders(own, amplitude);
      const double kept = 1 - softening_.share * (1 - gain.real());
      const double lost = softening_.share * gain.imag();
      return Slipping{kept, at(kept, 3) * lost / 2};
    };
    double low = std::log(1e-12), high = std::log(1.);
    for (int i = 0; i < 50; ++i) {
      const double middle = (low + high) / 2, amplitude = std::exp(middle);
      const Slipping s = state_at(amplitude);
      const double answer = level * at(s.kept, 1) / (at(s.kept, 2) + s.damping);
      (answer > amplitude ? low : high) = middle;
    }
    return state_at(std::exp(low));
  }

  // The peaks of a run. False: no stable structure. Runs that differ in nothing the model feels
  // share them.
  bool find_peaks(int number) {
    if (const auto known = peaks_.find(number); known != peaks_.end()) return true;
    const TestRun& run = predictor_.test_.runs[std::size_t(number)];
    if (predictor_.softening_ < 0) // the level is not felt
      for (const auto& [other, peaks] : peaks_) {
        const TestRun& like = predictor_.test_.runs[std::size_t(other)];
        if (like.base == run.base && like.sensor == run.sensor && like.axis == run.axis &&
            like.first == run.first && same_order(like, run)) {
          peaks_[number] = peaks;
          return true;
        }
      }
    std::vector<Peak> found;
    if (predictor_.softening_ < 0) {
      const FamilyModes* m = linear_modes();
      if (!m) return false;
      for (Index i : peak_modes(*m, run)) found.push_back({m, m->zeta, i, {}, {}});
    } else {
      if (!table()) return false;
      const double level = run.level > 0 ? run.level : default_level();
      for (std::size_t p = 0; p < run.peaks.size(); ++p) {
        const Slipping s = slipping(run, int(p), level);
        auto m = modes(s.kept);
        if (!m) return false;
        kept_.push_back(std::make_unique<FamilyModes>(std::move(*m)));
        Peak peak{
            kept_.back().get(), kept_.back()->zeta, peak_modes(*kept_.back(), run)[p], {}, {}};
        if (peak.mode >= 0) peak.zeta[peak.mode] += s.damping;
        found.push_back(std::move(peak));
      }
    }
    for (Peak& peak : found) respond(peak, run);
    peaks_[number] = std::move(found);
    return true;
  }

  double default_level() const {
    const auto& response = own_.nominal->data.analyses.response;
    return response ? response->level : 1;
  }

  bool dynamic(const Reading& reading, double& value) {
    const TestRun& run = predictor_.test_.runs[std::size_t(reading.run)];
    if (run.base < 0) return labelled(reading, value);
    if (!find_peaks(reading.run)) return false;
    const Peak& peak = peaks_.at(reading.run)[std::size_t(reading.peak)];
    if (peak.mode < 0) return true;
    const double omega = peak.modes->omega(peak.mode), zeta = peak.zeta[peak.mode];
    if (reading.kind == ReadingKind::damping) {
      value = std::log(zeta);
      return true;
    }
    const int sensor = sensor_named(reading.sensor);
    if (reading.kind == ReadingKind::frequency) {
      value =
          std::log(sensor < 0 || run.axis != run.base ? omega / (2 * std::numbers::pi)
                                                      : summit(peak, sensor, reading.axis).first);
      return true;
    }
    if (sensor < 0) return true;
    if (reading.kind == ReadingKind::amplitude) {
      value = std::log(summit(peak, sensor, reading.axis).second);
      return true;
    }
    if (reading.at_run >= 0) return cross_resonance(reading, run, sensor, value);
    const double main = summit(peak, sensor, run.base).second;
    const double cross =
        std::max(reading_of(peak.around, sensor, reading.axis).cwiseAbs().maxCoeff(),
                 reading_of(peak.near, sensor, reading.axis).cwiseAbs().maxCoeff());
    value = std::log(cross / main + cross_floor);
    return true;
  }

  bool cross_resonance(const Reading& reading, const TestRun& run, int sensor, double& value) {
    if (!find_peaks(reading.at_run)) return false;
    const Peak& peak = peaks_.at(reading.at_run).front();
    if (peak.mode < 0) return true;
    const double omega = peak.modes->omega(peak.mode), zeta = peak.zeta[peak.mode];
    std::vector<double> near;
    for (int i = -half_steps; i <= half_steps; ++i) {
      near.push_back(omega * (1 + zeta * 0.5 * i));
      near.push_back(omega * (1 + resonance_window * i / half_steps));
    }
    const Eigen::MatrixXcd own = motion(*peak.modes, peak.zeta, run.base, near);
    const double cross = reading_of(own, sensor, reading.axis).cwiseAbs().maxCoeff();
    value = std::log(cross / summit(peak, sensor, reading.axis).second + cross_floor);
    return true;
  }

  // Whether measured peaks choose among a model's in the same way, nearly.
  static bool same_order(const TestRun& a, const TestRun& b) {
    if (a.peaks.size() != b.peaks.size()) return false;
    for (std::size_t i = 0; i < a.peaks.size(); ++i)
      if (a.peaks[i] > 0 && std::abs(std::log(a.peaks[i] / b.peaks[i])) > 0.02) return false;
    return true;
  }

  void respond(Peak& peak, const TestRun& run) const {
    if (peak.mode < 0 || own_.nominal->built.sensors.empty()) return;
    const double omega = peak.modes->omega(peak.mode), zeta = peak.zeta[peak.mode];
    std::vector<double> near, around;
    for (int i = -half_steps; i <= half_steps; ++i) near.push_back(omega * (1 + zeta * 0.5 * i));
    constexpr int steps = 8;
    for (int i = -steps; i <= steps; ++i) around.push_back(omega * (1 + cross_window * i / steps));
    for (Index j = 0; j < peak.modes->lambda.size(); ++j)
      if (const double w = peak.modes->omega(j); std::abs(w / omega - 1) <= cross_window)
        for (double x : {-1., 0., 1.}) around.push_back(w * (1 + x * peak.zeta[j]));
    peak.near = motion(*peak.modes, peak.zeta, run.base, near);
    peak.around = motion(*peak.modes, peak.zeta, run.base, around);
  }

  // Frequency in Hz and height of the peak of a channel near its mode: a parabola through
  // 1 / height^2, exact for one mode.
  std::pair<double, double> summit(const Peak& peak, int sensor, int axis) const {
    const double omega = peak.modes->omega(peak.mode), zeta = peak.zeta[peak.mode];
    const Eigen::RowVectorXd h = reading_of(peak.near, sensor, axis).cwiseAbs();
    Index best = 0;
    double height = h.maxCoeff(&best), x = 0.5 * double(best - half_steps);
    if (best > 0 && best < h.size() - 1) {
      const auto inverse = [&](Index i) { return 1 / (h[i] * h[i]); };
      const double a = inverse(best - 1), b = inverse(best), c = inverse(best + 1);
      if (const double curve = a - 2 * b + c; curve > 0) {
        const double shift = (a - c) / (2 * curve);
        x += 0.5 * shift;
        const double least = b - (a - c) * (a - c) / (8 * curve);
        if (least > 0) height = 1 / std::sqrt(least);
      }
    }
    return {omega * (1 + zeta * x) / (2 * std::numbers::pi), height};
  }

  // The nominal mode of that kind, direction and order; -1 = none.
  Index nominal_of_kind(const Reading& reading) const {
    constexpr std::array shapes{"axial", "transverse", "torsion", "shell", "mode"};
    const std::string shape = shapes[static_cast<std::size_t>(reading.shape)];
    const std::string axis = reading.axis < 0 ? "" : std::string(1, "xyz"[reading.axis]);
    int order = 0;
    const auto& labels = own_.nominal->labels;
    for (std::size_t j = 0; j < labels.size(); ++j) {
      const bool same = reading.shape == MeasuredShape::other ||
                        (labels[j].shape == shape && (axis.empty() || labels[j].direction == axis));
      if (same && ++order == reading.order) return Index(j);
    }
    return -1;
  }

  // A mode known by its kind: the one most like the nominal mode of that kind.
  bool labelled(const Reading& reading, double& value) {
    const FamilyModes* m = linear_modes();
    if (!m) return false;
    const Index nominal = nominal_of_kind(reading);
    if (nominal < 0) return true;
    Index most = 0;
    m->likeness.row(nominal).maxCoeff(&most);
    value =
        std::log(reading.kind == ReadingKind::damping ? m->zeta[most]
                                                      : m->omega(most) / (2 * std::numbers::pi));
    return true;
  }

  const Predictor& predictor_;
  const Predictor::StateFamily& own_;
  const Predictor::Coefficients& coefficients_;
  const TestSetup& setup_;
  Softening softening_;
  std::optional<std::optional<FamilyModes>> linear_;
  std::map<int, std::vector<Peak>> peaks_;
  std::vector<std::unique_ptr<FamilyModes>> kept_;
  bool table_tried_ = false;
  std::vector<double> shares_;
  std::vector<FamilyModes> table_;
};

namespace {

// What a hypothesis does to the model of a state.
std::vector<ModelChange> changes_in(const NominalState& state, const Hypothesis& h) {
  std::vector<ModelChange> all = h.changes;
  for (const auto& change : h.case_changes)
    all.push_back({[&data = state.data, change](Model& model) {
                     Case changed = data;
                     change(changed);
                     model = build(changed).model;
                   },
                   Follow::nominal});
  return all;
}

} // namespace

std::vector<PreparedChange> prepared_changes(const NominalState& state, const Hypothesis& h) {
  std::vector<PreparedChange> made;
  for (const ModelChange& change : changes_in(state, h))
    made.push_back(state.model->prepare(change));
  return made;
}

std::vector<PreparedChange> PreparedChanges::of(const NominalState& state, const Hypothesis& h) {
  const bool costly = std::any_of(h.changes.begin(), h.changes.end(),
                                  [](const ModelChange& c) { return c.follow == Follow::modes; });
  if (!costly) return prepared_changes(state, h);
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = known_.find({&state, &h}); known != known_.end()) return known->second;
  }
  std::vector<PreparedChange> made = prepared_changes(state, h);
  const std::lock_guard lock(mutex_);
  return known_.try_emplace({&state, &h}, std::move(made)).first->second;
}

Predictor::Predictor(const Nominal& nominal, const TestReadings& test,
                     const std::vector<const Hypothesis*>& together, PreparedChanges* prepared)
    : test_(test), together_(together) {
  int changes = 0;
  std::vector<int> released;
  for (std::size_t h = 0; h < together.size(); ++h) {
    if (together[h]->softening) {
      softening_ = int(h);
      first_change_ = changes;
    }
    changes += int(together[h]->changes.size() + together[h]->case_changes.size());
    parameters_ += int(together[h]->parameters.size());
    for (const std::string& cap : together[h]->released)
      released.push_back(nominal.states.front().built.cap_nodes.at(cap));
  }
  const int count = int(together.size());
  std::vector<std::vector<PreparedChange>> parts(nominal.states.size() * together.size());
  in_parallel(int(parts.size()), [&](int i) {
    const NominalState& state = nominal.states[std::size_t(i / count)];
    const Hypothesis& h = *together[std::size_t(i % count)];
    parts[std::size_t(i)] = prepared ? prepared->of(state, h) : prepared_changes(state, h);
  });
  for (std::size_t s = 0; s < nominal.states.size(); ++s) {
    const NominalState& state = nominal.states[s];
    std::vector<PreparedChange> made;
    for (std::size_t h = 0; h < together.size(); ++h)
      for (PreparedChange& change : parts[s * together.size() + h])
        made.push_back(std::move(change));
    StateFamily own{.nominal = &state, .family = state.model->with(made), .free = {}};
    const std::vector<int>& boundary = state.model->boundary();
    for (int i = 0; i < int(own.family.K.rows()); ++i) {
      const int node = i < own.family.boundary ? boundary[std::size_t(i / 6)] : -1;
      const auto& held = state.built.held_nodes;
      const bool is_held = node >= 0 && std::find(held.begin(), held.end(), node) != held.end() &&
                           std::find(released.begin(), released.end(), node) == released.end();
      if (!is_held) own.free.push_back(i);
    }
    states_.push_back(std::move(own));
  }
  for (const Reading& r : test.readings)
    for (std::size_t s = 0; s < nominal.states.size(); ++s)
      if (nominal.states[s].name == r.state) state_of_reading_.push_back(int(s));
}

VectorXd Predictor::values_of(const VectorXd& z) const {
  VectorXd values(z.size());
  Index i = 0;
  for (const Hypothesis* h : together_)
    for (const EffectParameter& p : h->parameters) {
      values[i] = plica::value_of(p.prior, z[i]);
      ++i;
    }
  return values;
}

Predictor::Coefficients Predictor::coefficients(const VectorXd& values) const {
  std::vector<double> all, rig;
  Index first = 0;
  for (const Hypothesis* h : together_) {
    const auto count = Index(h->parameters.size());
    const VectorXd c = h->coefficients ? h->coefficients(values.segment(first, count)) : VectorXd();
    for (double x : c) {
      all.push_back(x);
      rig.push_back(h->at_rig ? x : 0);
    }
    first += count;
  }
  return {Eigen::Map<VectorXd>(all.data(), Index(all.size())),
          Eigen::Map<VectorXd>(rig.data(), Index(rig.size()))};
}

TestSetup Predictor::setup(const VectorXd& values) const {
  TestSetup setup;
  Index first = 0;
  for (const Hypothesis* h : together_) {
    const auto count = Index(h->parameters.size());
    if (h->setup) h->setup(setup, values.segment(first, count));
    first += count;
  }
  return setup;
}

std::optional<VectorXd> Predictor::operator()(const VectorXd& values, bool fitted_only) const {
  const Coefficients c = coefficients(values);
  const TestSetup own_setup = setup(values);
  std::vector<std::unique_ptr<StateAnswers>> answers;
  for (std::size_t s = 0; s < states_.size(); ++s)
    answers.push_back(std::make_unique<StateAnswers>(*this, s, c, own_setup, values));
  VectorXd y = VectorXd::Constant(Index(test_.readings.size()), none);
  for (Index i = 0; i < y.size(); ++i)
    if (!(fitted_only && test_.readings[std::size_t(i)].held_out) &&
        !answers[std::size_t(state_of_reading_[std::size_t(i)])]->answer(
            test_.readings[std::size_t(i)], y[i]))
      return std::nullopt;
  return y;
}

std::vector<int> Predictor::nominal_modes() const {
  const Coefficients c = coefficients(VectorXd());
  const TestSetup plain;
  std::vector<int> modes;
  std::vector<std::unique_ptr<StateAnswers>> answers;
  for (std::size_t s = 0; s < states_.size(); ++s)
    answers.push_back(std::make_unique<StateAnswers>(*this, s, c, plain, VectorXd()));
  for (std::size_t i = 0; i < test_.readings.size(); ++i)
    modes.push_back(answers[std::size_t(state_of_reading_[i])]->nominal_mode(test_.readings[i]));
  return modes;
}

std::optional<Eigen::VectorXcd> Predictor::response(const VectorXd& values, const TestRun& run,
                                                    const VectorXd& hertz) const {
  const Coefficients c = coefficients(values);
  const TestSetup own_setup = setup(values);
  std::size_t s = 0;
  while (s + 1 < states_.size() && states_[s].nominal->name != run.state) ++s;
  StateAnswers answers(*this, s, c, own_setup, values);
  const FamilyModes* modes = answers.linear_modes();
  const int sensor = answers.sensor_named(run.sensor);
  if (!modes || sensor < 0 || run.base < 0) return std::nullopt;
  std::vector<double> omega;
  for (double f : hertz) omega.push_back(2 * std::numbers::pi * f);
  const Eigen::MatrixXcd motion = answers.motion(*modes, modes->zeta, run.base, omega);
  return Eigen::VectorXcd(answers.reading_of(motion, sensor, run.axis).transpose());
}

const Predictor& PredictorStore::of(const std::vector<const Hypothesis*>& together) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = known_.find(together); known != known_.end()) return *known->second;
  }
  auto made = std::make_unique<Predictor>(nominal_, test_, together, &prepared_);
  const std::lock_guard lock(mutex_);
  return *known_.try_emplace(together, std::move(made)).first->second;
}

} // namespace plica
