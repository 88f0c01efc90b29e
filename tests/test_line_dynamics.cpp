// What excites a line and what damps it, in whole runs: dashpots at mounts, several inputs at once,
// sine on random, transients, orders of an engine; one mass between two mounts in closed form.
#include "io/files/files.hpp"
#include "io/input/case_file.hpp"
#include "solve/shock_spectrum.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tube_case.hpp"

#include <complex>
#include <numbers>

namespace plica::test {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using std::numbers::pi;
constexpr Complex i_(0, 1);

constexpr double k_left = 4e4, k_right = 1e4, weight = 2, zeta = 0.03, half_bar = 2 * EA / L;

// Of a spring with its damper and half of the bar in a row.
Complex in_a_row(Complex spring) {
  return 1. / (1. / spring + 1 / half_bar);
}

double first_frequency() {
  return std::sqrt((in_a_row(k_left) + in_a_row(k_right)).real() / weight) / (2 * pi);
}

// Absolute acceleration of the mass over that of both mounts, modal damping.
Complex over_base(double hertz) {
  const double w = 2 * pi * hertz, w0 = 2 * pi * first_frequency();
  return 1. + w * w / Complex(w0 * w0 - w * w, 2 * zeta * w0 * w);
}

Case shaken(double modal) {
  Case data = mass_between(k_left, k_right, weight, modal);
  data.analyses.response = Response{.bases = {1}, .band = {1, 80}, .points = 60};
  return data;
}

void expect_response(const ResponseResult& r, const std::function<Complex(double)>& exact,
                     double tolerance) {
  for (Index i = 0; i < r.hertz.size(); ++i) {
    const Complex wanted = exact(r.hertz[i]);
    EXPECT_LT(std::abs(r.acceleration(i, 1) - wanted), tolerance * std::abs(wanted))
        << r.excitation << " at " << r.hertz[i] << " Hz";
  }
}

TEST(DampedMounts, a_dashpot_at_one_mount_is_in_base_motion_moved_ends_and_modes) {
  constexpr double c = 120;
  Case data = shaken(0);
  data.mount[0].damping.emplace();
  data.mount[0].damping->dashpot = {0, c, 0, 0, 0, 0};
  data.analyses.response->motions = {motion_of("left", 1), motion_of("right", 1)};
  const Results results = run_silently(data);
  const auto left = [&](double hertz) { return in_a_row(k_left + i_ * (2 * pi * hertz * c)); };
  const Complex right = in_a_row(k_right);
  const auto over = [&](Complex force, double hertz) {
    const double w = 2 * pi * hertz;
    return force / (left(hertz) + right - weight * w * w);
  };
  ASSERT_EQ(results.responses.size(), 3u);
  expect_response(
      results.responses[0], [&](double f) { return over(left(f) + right, f); }, 1e-5);
  expect_response(
      results.responses[1], [&](double f) { return over(left(f), f); }, 1e-5);
  expect_response(
      results.responses[2], [&](double f) { return over(right, f); }, 1e-5);
  // m s^2 + 1 / (1 / (k + c s) + 1 / half) + k_right' = 0, by Newton's method from the undamped
  // one.
  Complex s = i_ * (2 * pi * first_frequency());
  for (int step = 0; step < 60; ++step) {
    const auto value = [&](Complex x) { return weight * x * x + in_a_row(k_left + c * x) + right; };
    const Complex h = 1e-7 * s;
    s -= value(s) * 2. * h / (value(s + h) - value(s - h));
  }
  ASSERT_TRUE(results.complex_modes.complete) << results.complex_modes.reason;
  const auto axial = std::min_element(results.modes.begin(), results.modes.end(),
                                      [&](const ModeResult& a, const ModeResult& b) {
                                        return std::abs(a.frequency - first_frequency()) <
                                               std::abs(b.frequency - first_frequency());
                                      });
  EXPECT_NEAR(*axial->damped_frequency, std::abs(s) / (2 * pi), 1e-5 * std::abs(s));
  EXPECT_NEAR(axial->damping, -s.real() / std::abs(s), 1e-5);
}

TEST(DampedMounts, loss_factors_that_are_coupled_are_complex_stiffness) {
  constexpr double eta = 0.4;
  Case data = shaken(0);
  data.analyses.damping.loss_factors = {{"mount.left", eta}};
  data.analyses.damping.coupled = true;
  data.analyses.response->motions = {motion_of("left", 1)};
  const Results results = run_silently(data);
  const Complex left = in_a_row(k_left * Complex(1, eta)), right = in_a_row(k_right);
  const auto over = [&](Complex force, double hertz) {
    const double w = 2 * pi * hertz;
    return force / (left + right - weight * w * w);
  };
  expect_response(
      results.responses.at(0), [&](double f) { return over(left + right, f); }, 1e-5);
}

TEST(Together, inputs_add_with_their_amplitudes_and_phases) {
  Case data = shaken(zeta);
  Response& r = *data.analyses.response;
  r.level = 3;
  r.forces = {{.name = "tap", .at = "tube.point[2]", .direction = 1, .amplitude = 7, .random = {}}};
  r.together = {{.name = "both",
                 .inputs = {{"y", 1, 0}, {"tap", 0.5, 1.2}},
                 .correlation = InputCorrelation::none,
                 .coherence = {},
                 .spectra = {}}};
  const Results results = run_silently(data);
  ASSERT_EQ(results.responses.size(), 3u);
  const auto &base = results.responses[0].acceleration, &tap = results.responses[1].acceleration;
  const Eigen::MatrixXcd sum = 3 * base + 3.5 * std::polar(1., 1.2) * tap;
  EXPECT_LT((results.responses[2].acceleration - sum).norm(), 1e-12 * sum.norm());
}

// White inputs at both mounts: independent, one signal, one signal against the other, half
// coherent.
TEST(Together, random_inputs_by_their_coherence) {
  Case data = shaken(zeta);
  Response& r = *data.analyses.response;
  r.bases.clear();
  BaseNoise noise;
  noise.level = 0.4;
  r.random = noise;
  r.motions = {motion_of("left", 1), motion_of("right", 1)};
  Together both{.name = "none",
                .inputs = {{"left_y", 1, 0}, {"right_y", 2, 0}},
                .correlation = InputCorrelation::none,
                .coherence = {},
                .spectra = {}};
  r.together = {both};
  both.name = "full";
  both.correlation = InputCorrelation::full;
  r.together.push_back(both);
  both.name = "against";
  both.inputs[1].phase = pi;
  r.together.push_back(both);
  both.name = "half";
  both.inputs[1].phase = 0;
  both.correlation = InputCorrelation::none;
  both.coherence = {{"left_y", "right_y", 0.5, 0.7}};
  r.together.push_back(both);
  both.name = "matrix";
  both.coherence.clear();
  const double cross = 0.5 * 0.4 * 2;
  for (const double f : {1., 80.})
    both.spectra.push_back({f,
                            {0.4, cross * std::cos(0.7), cross * std::cos(0.7), 1.6},
                            {0, cross * std::sin(0.7), -cross * std::sin(0.7), 0}});
  r.together.push_back(both);
  const Results results = run_silently(data);
  ASSERT_EQ(results.responses.size(), 7u);
  const auto &a = results.responses[0].acceleration, &b = results.responses[1].acceleration;
  const std::array<Complex, 5> coherence{0, 1, -1, std::polar(0.5, 0.7), std::polar(0.5, 0.7)};
  for (std::size_t k = 0; k < coherence.size(); ++k) {
    const RandomResult& random = *results.responses[2 + k].random;
    for (Index i = 0; i < a.rows(); ++i) {
      const double wanted = 0.4 * (std::norm(a(i, 1)) + 4 * std::norm(b(i, 1)) +
                                   2 * (a(i, 1) * 2. * coherence[k] * std::conj(b(i, 1))).real());
      EXPECT_NEAR(random.density(i, 1), wanted, 1e-9 * (std::norm(a(i, 1)) + std::norm(b(i, 1))))
          << results.responses[2 + k].excitation;
    }
  }
}

TEST(Tones, ride_on_a_random_input_where_they_are_worst) {
  Case data = shaken(zeta);
  Response& r = *data.analyses.response;
  BaseNoise noise;
  noise.level = 0.2;
  r.random = noise;
  r.tones = {{.of = "y", .band = {10, 60}, .acceleration = 4, .force = {}}};
  const Results results = run_silently(data);
  const RandomResult& random = *results.responses.at(0).random;
  ASSERT_EQ(random.tones.size(), 1u);
  const ToneResult& tone = random.tones[0];
  double worst = 0;
  for (double f = 10; f <= 60; f += 0.001) worst = std::max(worst, std::abs(over_base(f)));
  EXPECT_NEAR(tone.sine[1], 4 * worst, 4e-3 * worst);
  EXPECT_NEAR(tone.rms[1], std::hypot(random.bands[0].rms[1], tone.sine[1] / std::sqrt(2)), 1e-9);
}

Transient drop(double peak, double duration) {
  Transient t;
  t.name = "drop";
  t.of = "y";
  t.pulse.emplace().acceleration = peak;
  t.pulse->duration = duration;
  return t;
}

TEST(Transients, of_a_shock_are_the_shock_response_of_the_mass) {
  Case data = shaken(zeta);
  data.analyses.transients = {drop(50, 0.011)};
  data.analyses.transients[0].spectrum = SpectrumRequest{{5, 500}, 6, 10};
  const Results results = run_silently(data);
  const TransientResult& t = results.transients.at(0);
  // The mass is the oscillator of a shock spectrum of its own frequency and damping.
  Eigen::VectorXd own(1);
  own << first_frequency();
  const double spectrum = shock_spectrum(t.input, t.step, own, zeta).maximax()[0];
  EXPECT_NEAR(std::abs(t.extremes[1].value), spectrum, 0.002 * spectrum);
  EXPECT_LT(std::abs(t.acceleration(t.acceleration.rows() - 1, 1)), 0.1 * spectrum);
  ASSERT_TRUE(t.spectra);
  EXPECT_NEAR(t.spectra->hertz[6], 10, 1e-9);
  EXPECT_GT(t.spectra->input.maxCoeff(), 50 * 1.5) << "a half sine reaches 1.65 at Q = 10";
  EXPECT_LT(t.spectra->input.maxCoeff(), 50 * 1.77);
}

// Maxwell's branch at one mount and half of the bar in a row: z against the base, F of the branch.
Eigen::VectorXd by_runge_kutta(double g, double tau, double peak, double duration, double step,
                               Index count) {
  const double right = in_a_row(k_right).real(), both = k_left + half_bar;
  const auto base = [&](double t) { return t < duration ? peak * std::sin(pi * t / duration) : 0; };
  const auto acceleration = [&](const Eigen::Vector3d& y, double t) {
    const double q = (half_bar * y[0] - y[2]) / both;
    return -(half_bar * (y[0] - q) + right * y[0]) / weight - base(t);
  };
  const auto rate = [&](const Eigen::Vector3d& y, double t) {
    return Eigen::Vector3d(y[1], acceleration(y, t),
                           (g * k_left * half_bar * y[1] / both - y[2] / tau) /
                               (1 + g * k_left / both));
  };
  Eigen::Vector3d y = Eigen::Vector3d::Zero();
  Eigen::VectorXd absolute(count);
  const double h = step / 4;
  for (Index i = 0; i < count; ++i) {
    absolute[i] = acceleration(y, double(i) * step) + base(double(i) * step);
    for (int k = 0; k < 4; ++k) {
      const double t = double(i) * step + k * h;
      const Eigen::Vector3d a = rate(y, t), b = rate(y + h / 2 * a, t + h / 2),
                            c = rate(y + h / 2 * b, t + h / 2), d = rate(y + h * c, t + h);
      y += h / 6 * (a + 2 * b + 2 * c + d);
    }
  }
  return absolute;
}

// What damping of each mode by itself misses: the branch stiffens the mount, too.
TEST(Transients, with_a_maxwell_branch_are_those_of_its_equation) {
  constexpr double g = 0.8, tau = 0.01, peak = 30, duration = 0.02;
  Case data = shaken(0);
  data.mount[0].damping.emplace();
  data.mount[0].damping->maxwell = {{.share = g, .time = tau}};
  data.analyses.transients = {drop(peak, duration)};
  const Results results = run_silently(data);
  const TransientResult& r = results.transients.at(0);
  const Eigen::VectorXd exact =
      by_runge_kutta(g, tau, peak, duration, r.step, r.acceleration.rows());
  EXPECT_LT((r.acceleration.col(1) - exact).cwiseAbs().maxCoeff(),
            1e-4 * exact.cwiseAbs().maxCoeff());
  for (const std::string& w : results.warnings)
    EXPECT_EQ(w.find("each mode by itself"), std::string::npos) << w;
}

TEST(RunUps, orders_follow_the_response_over_the_speed) {
  Case data = shaken(zeta);
  Response& r = *data.analyses.response;
  r.forces = {{.name = "tap", .at = "tube.point[2]", .direction = 1, .amplitude = 7, .random = {}}};
  RunUp up;
  up.name = "full_load";
  up.table = {{0, 5}, {20, 25}};
  EngineOrder second, half;
  second.order = 2;
  second.of = "y";
  second.table = {{5, 1}, {25, 3}};
  half.order = 0.5;
  half.of = "tap";
  half.force = 12;
  up.orders = {second, half, second};
  up.orders[2].phase = pi / 2;
  data.analyses.run_ups = {up};
  const Results results = run_silently(data);
  const RunUpResult& u = results.run_ups.at(0);
  ASSERT_EQ(u.orders.size(), 2u);
  EXPECT_EQ(u.orders[1].order, 2);
  for (Index i = 0; i < u.speed.size(); ++i) {
    const double amplitude = 1 + (u.speed[i] - 5) / 10;
    const Complex wanted = amplitude * Complex(1, 1) * over_base(2 * u.speed[i]);
    EXPECT_LT(std::abs(u.orders[1].acceleration(i, 1) - wanted), 1e-5 * std::abs(wanted));
    EXPECT_NEAR(u.overall(i, 1),
                std::sqrt((std::norm(u.orders[0].acceleration(i, 1)) + std::norm(wanted)) / 2),
                1e-4 * std::abs(wanted));
  }
  const auto through =
      std::find_if(u.crossings.begin(), u.crossings.end(), [&](const OrderCrossing& c) {
        return c.order == 2 && std::abs(c.frequency - first_frequency()) < 1e-4 * c.frequency;
      });
  ASSERT_NE(through, u.crossings.end());
  EXPECT_NEAR(through->speed, first_frequency() / 2, 1e-3);
  // 2 Hz/s of the order over 0.9 (2 zeta f)^2.
  EXPECT_NEAR(*through->haste, 2 / (0.9 * std::pow(2 * zeta * first_frequency(), 2)), 1e-3);
}

// A cantilever along x with a weight at a third of it.
Case cantilever(bool by_points) {
  BeamPart beam;
  beam.points = {{0, 0, 0}, {0.6, 0, 0}};
  beam.elements = by_points ? 24 : 12;
  if (by_points) beam.points.insert(beam.points.begin() + 1, Triple{0.21, 0, 0});
  beam.section.shape = BeamShape::solid;
  beam.section.radius = 0.012;
  beam.section.material = "steel";
  if (!by_points) beam.places = {{"weight", {0.21, 0, 0}}};
  Case data;
  data.name = "cantilever";
  data.materials["steel"] = {.E = 2e11, .nu = 0.3, .rho = 7850};
  data.parts = {
      {"beam", beam},
      {"weight", PointMass{.at = by_points ? "beam.point[2]" : "beam.weight", .mass = 1}}};
  data.caps = {{.name = "clamp", .of = {"beam.start"}}};
  data.mount = {{.cap = "clamp"}};
  data.analyses.modes = Modes{.count = 4};
  data.analyses.error_bars = false;
  return data;
}

TEST(LinePlaces, a_weight_sits_between_the_nodes_of_even_steps) {
  const Results points = run_silently(cantilever(true)), places = run_silently(cantilever(false));
  for (std::size_t j = 0; j < 4; ++j)
    EXPECT_NEAR(places.modes[j].frequency, points.modes[j].frequency,
                1e-3 * points.modes[j].frequency);
}

TEST(LinePlaces, a_sensor_on_the_skin_of_a_beam_is_on_it_wherever_along) {
  Case data = cantilever(false);
  data.sensors = {{.name = "skin", .at = {0.333, 0, 0.012}}};
  data.analyses.damping.modal = 0.01;
  data.analyses.response = Response{.bases = {2}, .band = {5, 50}, .points = 10};
  const Results results = run_silently(data);
  const SensorResult& s = results.sensors.at(0);
  EXPECT_LT((results.mesh.nodes[std::size_t(s.node)] - Eigen::Vector3d(0.333, 0, 0.012)).norm(),
            1e-9);
  EXPECT_LT(s.distance, 1e-9);
}

// A case file with a signal beside it.
constexpr const char* signal_case = R"(case: road
parts:
  pipe: {type: beam, points: [[0, 0, 0], [0, 0.5, 0]], elements: 4,
         section: {shape: pipe, material: steel, radius: 20 mm, thickness: 1 mm}}
materials: {steel: {E: 200 GPa, nu: 0.3, rho: 7850 kg/m3}}
caps: {left: {of: pipe.start}, right: {of: pipe.end, mass: 1 kg}}
mount: {left: rigid}
sensors: [{name: tip, at: [0, 0.5, 0]}]
analyses:
  modes: {count: 6}
  damping: {modal: 2 %}
  error_bars: false
  response: {base: [z], band: [5, 500]}
  transients:
    - {name: road, of: z, signal: {file: road.csv CHANNEL}}
)";

std::string problems(const std::string& channel, const std::string& csv) {
  const TemporaryFolder folder("line_signal");
  std::string text = signal_case;
  text.replace(text.find(" CHANNEL"), 8, channel);
  write_whole(folder.path / "road.yaml", text);
  write_whole(folder.path / "road.csv", csv);
  try {
    const CaseFile file = read_case((folder.path / "road.yaml").string());
    const SampledSignal& s = *file.data.analyses.transients[0].signal;
    return std::to_string(s.samples.size()) + " samples, step " + std::to_string(s.step) +
           ", last " + std::to_string(s.samples[s.samples.size() - 1]);
  } catch (const InputError& error) {
    std::string all;
    for (const InputProblem& p : error.problems()) all += p.key + " " + p.wrong + "\n";
    return all;
  }
}

TEST(Transients, a_signal_is_read_from_its_file_in_its_unit) {
  const std::string rows = "0,0\n0.001,1\n0.002,2\n";
  EXPECT_EQ(problems("", "time [s],road z [g]\n" + rows),
            "3 samples, step 0.001000, last 19.613300");
  EXPECT_EQ(problems(", factor: 2", "time [s],road z [m/s2]\n" + rows),
            "3 samples, step 0.001000, last 4.000000");
  EXPECT_NE(
      problems("", "time [s],road z [N]\n" + rows).find("signal.channel is in units of a force"),
      std::string::npos);
  EXPECT_NE(problems("", "time [s],a z [g],b z [g]\n0,0,1\n0.001,1,1\n").find("the file has 2"),
            std::string::npos);
  EXPECT_NE(problems(", channel: c.z", "time [s],a z [g],b z [g]\n0,0,1\n0.001,1,1\n")
                .find("'c.z' is none of the file"),
            std::string::npos);
  EXPECT_NE(problems("", "time [s],road z [g]\n0,0\n0.001,1\n0.005,1\n").find("not evenly spaced"),
            std::string::npos);
}

} // namespace
} // namespace plica::test
