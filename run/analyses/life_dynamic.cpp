// What acts by excitations: histories, random excitations, sweeps, dwells.
#include "run/analyses/life.hpp"

#include "run/analyses/dissipation.hpp"
#include "solve/transient_response.hpp"
#include "words/input_error.hpp"
#include "words/units.hpp"

#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::Vector3cd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::numbers::pi;

std::string item_key(const char* list, std::size_t i) {
  return std::string("analyses.life.") + list + "[" + std::to_string(i) + "]";
}

double amplitude_of(const std::optional<double>& acceleration, const std::optional<double>& force) {
  return acceleration ? *acceleration : *force;
}

// Largest von Mises stress over a cycle of an in-plane stress.
double amplitude_of_cycle(const Vector3cd& s) {
  const auto form = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return a[0] * b[0] + a[1] * b[1] - (a[0] * b[1] + a[1] * b[0]) / 2 + 3 * a[2] * b[2];
  };
  const Eigen::Vector3d c = s.real(), d = s.imag();
  const double cc = form(c, c), dd = form(d, d);
  return std::sqrt(std::max(0., (cc + dd) / 2 + std::hypot((cc - dd) / 2, form(c, d))));
}

// Frequencies of a band, crowded round the modes.
VectorXd grid_of(const std::array<double, 2>& band, const DampedModes& modes) {
  Response band_alone;
  band_alone.band = band;
  band_alone.points = 400;
  return response_grid(band_alone, modes);
}

void require_damping(const std::array<double, 2>& band, const std::string& key,
                     const DampedModes& modes) {
  for (int j = 0; j < modes.solution.modes; ++j) {
    const double f = frequency_of(modes, j);
    if (f >= band[0] && f <= band[1] && !(damping_of(modes, j) > 0))
      input_error(key, "meets mode " + std::to_string(j + 1) + ", which has no damping",
                  "give analyses.damping");
  }
}

constexpr std::array all_methods{SpectralMethod::dirlik, SpectralMethod::tovo_benasciutti,
                                 SpectralMethod::alpha_075, SpectralMethod::narrow_band};
constexpr std::array method_names{"narrow band", "Dirlik", "Tovo-Benasciutti", "alpha 0.75"};

// Moments of a stress from the moment matrices of the coordinates.
using MomentMatrices = std::array<MatrixXd, 6>;
constexpr std::array moment_orders{0., 0.75, 1., 1.5, 2., 4.};

SpectralMoments moments_of(const MomentMatrices& C, const MatrixXd& own,
                           const Eigen::RowVector3d& direction) {
  std::array<double, 6> m{};
  for (std::size_t k = 0; k < m.size(); ++k) {
    const Eigen::Matrix3d S = own * C[k] * own.transpose();
    m[k] = direction.isZero(0) ? S(0, 0) + S(1, 1) - S(0, 1) + 3 * S(2, 2)
                               : (direction * S * direction.transpose()).value();
  }
  return {.m0 = m[0], .m075 = m[1], .m1 = m[2], .m15 = m[3], .m2 = m[4], .m4 = m[5]};
}

VectorXd density_of(const MatrixXcd& rows, const VectorXd& hertz, const MatrixXd& own,
                    const Eigen::RowVector3d& direction) {
  const Index inputs = rows.rows() / hertz.size();
  const MatrixXcd s = rows * own.transpose(); // x 3
  VectorXd density = VectorXd::Zero(hertz.size());
  for (Index r = 0; r < s.rows(); ++r) {
    const auto a = s.row(r);
    density[r / inputs] += direction.isZero(0)
                               ? std::norm(a[0]) + std::norm(a[1]) -
                                     (a[0] * std::conj(a[1])).real() + 3 * std::norm(a[2])
                               : std::norm((a * direction.transpose()).value());
  }
  return density;
}

} // namespace

std::string sweep_words(const LifeSweep& s, const std::string& title, const std::string& unit) {
  return title + ", " + short_number(amplitude_of(s.acceleration, s.force)) + " " + unit + ", " +
         short_number(s.band[0]) + " to " + short_number(s.band[1]) + " Hz at " +
         short_number(s.octaves_per_minute) + " octaves/min";
}

void LifeCount::add_dynamic(const DampedModes& modes, const Excitations& excited) {
  if (!needs_response(life_)) return;
  const StressCoordinates coordinates(modes, &excited);
  const auto plane =
      std::make_shared<const MatrixXd>(plane_of(recover_stress(model_, coordinates.fields())));
  const auto named = [&](const std::string& of, const std::string& key) -> const Excitation& {
    return excitation_named(of, key + ".of", excited);
  };
  for (std::size_t i = 0; i < life_.histories.size(); ++i)
    if (!moves_end(life_.histories[i]))
      add_excited_history(life_.histories[i], item_key("histories", i), *plane, modes, excited);
  if (!life_.random.empty()) {
    const VectorXd hertz = response_grid(*case_.analyses.response, modes);
    for (std::size_t i = 0; i < life_.random.size(); ++i)
      add_random(life_.random[i], named(life_.random[i].of, item_key("random", i)), coordinates,
                 plane, hertz);
  }
  for (std::size_t i = 0; i < life_.sweeps.size(); ++i) {
    const LifeSweep& s = life_.sweeps[i];
    const std::string key = item_key("sweeps", i);
    if (s.friction) continue;
    require_damping(s.band, key, modes);
    add_sweep(s, named(s.of, key), coordinates, *plane, modes);
  }
  for (std::size_t i = 0; i < life_.dwells.size(); ++i) {
    const std::string key = item_key("dwells", i);
    add_dwell(life_.dwells[i], named(life_.dwells[i].of, key), key, coordinates, *plane, modes);
  }
}

void LifeCount::add_excited_history(const LifeHistory& history, const std::string& key,
                                    const MatrixXd& plane, const DampedModes& modes,
                                    const Excitations& excited) {
  constexpr double most = 2e8; // samples of all coordinates
  const SampledSignal& first = history.signals[0].signal;
  const Index samples = first.samples.size(), columns = modes.solution.u.cols();
  if (double(samples) * double(columns) > most)
    input_error(key, "has more samples than fit: " + std::to_string(samples), "a shorter record");
  MatrixXd load = MatrixXd::Zero(samples, Index(excited.loads.base.size()));
  std::string what;
  for (std::size_t i = 0; i < history.signals.size(); ++i) {
    const LifeSignal& s = history.signals[i];
    const std::string place = key + ".signals[" + std::to_string(i) + "].of";
    const Excitation& e = excitation_named(s.of, place, excited);
    what += (what.empty() ? "" : ", ") + title_of(e);
    if (e.source == Source::ends)
      input_error(place, "moves ends against each other, whose movement no acceleration tells",
                  "the movement itself: axial, lateral_x, ...");
    for (const ExcitedColumn& part : e.parts)
      load.col(part.column) += part.factor.real() * s.signal.samples;
  }
  ModalModel modal = modal_model(modes, {});
  modal.input = modes.solution.input.leftCols(load.cols());
  modal.zeta += first_order_damping(modes.dissipation, modes.solution);
  const MatrixXd q = transient_coordinates(modal, load, first.step);
  const double fastest = 0.5 / first.step;
  if (modes.solution.modes > 0 && frequency_of(modes, 0) > fastest)
    input_error(key, "is sampled too slowly for the first mode", "a higher sampling rate");
  add_history(history, what, plane.leftCols(q.cols()), q);
}

void LifeCount::add_random(const LifeRandom& asked, const Excitation& e,
                           const StressCoordinates& coordinates,
                           const std::shared_ptr<const MatrixXd>& plane, const VectorXd& hertz) {
  DutyMap duty =
      new_duty(DutyKind::random, asked.name,
               title_of(e) + ", " + method_names[std::size_t(asked.method)], asked.duration, "s");
  const MatrixXcd rows = spectral_rows(e, coordinates, hertz);
  MomentMatrices C;
  for (std::size_t k = 0; k < C.size(); ++k) C[k] = covariance(rows, hertz, moment_orders[k]);
  duty.counted = worst_sites(*plane, C[0]);
  const auto counted = int(duty.counted.size());
#pragma omp parallel for schedule(dynamic)
  for (int i = 0; i < counted; ++i) {
    const int site = duty.counted[std::size_t(i)];
    const MatrixXd own = plane->middleRows<3>(3 * Index(site));
    for (Index d = 0; d < directions_.rows(); ++d) {
      const SpectralMoments m = moments_of(C, own, directions_.row(d));
      if (!(m.m0 > 0)) continue;
      const SpectralDamage rate = damage_rate(asked.method, m, life_.curve);
      duty.damage(site, d) = float(rate.per_second * asked.duration);
      if (!rate.at_most) duty.certain(site, d) = duty.damage(site, d);
      duty.bounds(site, d) = static_cast<unsigned char>(rate.at_most + 2 * rate.at_least);
      duty.range(site, d) = float(2 * three_sigma(m));
      duty.mean(site, d) = float(directions_.row(d).dot(state_.segment<3>(3 * Index(site))));
    }
  }
  spread(duty);
  duty.random = [=, this](int site, int d) {
    const MatrixXd own = plane->middleRows<3>(3 * Index(site));
    const Eigen::RowVector3d direction = directions_.row(d);
    const SpectralMoments m = moments_of(C, own, direction);
    RandomStress r{.rms = m.rms(),
                   .up_crossings = m.up_crossings(),
                   .expected_peak = std::nan(""),
                   .damages = {},
                   .hertz = hertz,
                   .density = density_of(rows, hertz, own, direction)};
    if (m.up_crossings() * asked.duration > std::exp(0.5))
      r.expected_peak = expected_peak(m, asked.duration);
    for (const SpectralMethod method : all_methods)
      r.damages.emplace_back(method_names[std::size_t(method)],
                             damage_rate(method, m, life_.curve).per_second * asked.duration);
    return r;
  };
  duties_.push_back(std::move(duty));
}

void LifeCount::add_sweep(const LifeSweep& asked, const Excitation& e,
                          const StressCoordinates& coordinates, const MatrixXd& plane,
                          const DampedModes& modes) {
  DutyMap duty = new_duty(DutyKind::sweep, asked.name, sweep_words(asked, title_of(e), e.unit),
                          asked.count, "sweeps");
  const VectorXd hertz = grid_of(asked.band, modes);
  const MatrixXcd q = amplitude_of(asked.acceleration, asked.force) * coordinates(e.parts, hertz);
  if (const double last = frequency_of(modes, modes.solution.modes - 1); last < asked.band[1])
    warnings_.push_back("life, sweep " + asked.name + ": the modes end at " +
                        std::to_string(std::lround(last)) +
                        " Hz: above, only their static part is counted");
  duty.counted =
      worst_sites(plane, q.real().transpose() * q.real() + q.imag().transpose() * q.imag());
  const double octaves_per_second = asked.octaves_per_minute / 60;
  const auto counted = int(duty.counted.size());
#pragma omp parallel for schedule(dynamic)
  for (int i = 0; i < counted; ++i) {
    const int site = duty.counted[std::size_t(i)];
    const MatrixXcd s = q * plane.middleRows<3>(3 * Index(site)).transpose(); // frequencies x 3
    for (Index d = 0; d < directions_.rows(); ++d)
      for (Index k = 0; k < hertz.size(); ++k) {
        const double before = k > 0 ? hertz[k] - hertz[k - 1] : 0;
        const double after = k + 1 < hertz.size() ? hertz[k + 1] - hertz[k] : 0;
        const double cycles = (before + after) / 2 / (octaves_per_second * std::numbers::ln2);
        count_amplitude(duty, site, d, s.row(k).transpose(), asked.count * cycles);
      }
  }
  duty.head.cycles =
      (hertz[hertz.size() - 1] - hertz[0]) / (octaves_per_second * std::numbers::ln2);
  spread(duty);
  duties_.push_back(std::move(duty));
}

void LifeCount::count_amplitude(DutyMap& duty, int site, Index d, const Vector3cd& s,
                                double cycles) const {
  const Eigen::Vector3d rest = state_.segment<3>(3 * Index(site));
  if (life_.measure == StressMeasure::signed_von_mises)
    count(duty, site, d, {2 * amplitude_of_cycle(s), signed_von_mises(rest)}, cycles);
  else
    count(duty, site, d,
          {2 * std::abs((directions_.row(d) * s).value()), directions_.row(d).dot(rest)}, cycles);
}

void LifeCount::add_dwell(const LifeDwell& asked, const Excitation& e, const std::string& key,
                          const StressCoordinates& coordinates, const MatrixXd& plane,
                          const DampedModes& modes) {
  if (asked.mode > modes.solution.modes)
    input_error(key + ".mode",
                "is not among the " + std::to_string(modes.solution.modes) +
                    " modes that were found",
                "one of them, or more of them in analyses.modes");
  const double f = asked.mode > 0 ? frequency_of(modes, asked.mode - 1) : asked.frequency;
  require_damping({f, f}, key, modes);
  const double cycles = asked.cycles > 0 ? asked.cycles : asked.duration * f;
  const double amplitude = amplitude_of(asked.acceleration, asked.force);
  DutyMap duty = new_duty(DutyKind::dwell, asked.name,
                          title_of(e) + ", " + short_number(amplitude) + " " + e.unit + " at " +
                              short_number(f) + " Hz",
                          cycles, "cycles");
  const VectorXcd q = amplitude * coordinates(e.parts, VectorXd::Constant(1, f)).row(0).transpose();
  const VectorXcd s = plane * q;
  const auto sites = int(duty.damage.rows());
#pragma omp parallel for schedule(static)
  for (int site = 0; site < sites; ++site)
    for (Index d = 0; d < directions_.rows(); ++d)
      count_amplitude(duty, site, d, s.segment<3>(3 * Index(site)), cycles);
  duties_.push_back(std::move(duty));
}

} // namespace plica
