// Modes of responses to noise that nobody measured, against chains of masses known in closed form.
#include "tests/chain_of_masses.hpp"
#include "tests/support/refusal.hpp"

#include "lab/identification/mode_correlation.hpp"
#include "lab/identification/output_only.hpp"
#include "lab/signals/harmonics.hpp"
#include "words/input_error.hpp"

#include <gtest/gtest.h>

namespace plica::test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

bool says(const Identification& found, const std::string& words) {
  return std::any_of(found.warnings.begin(), found.warnings.end(),
                     [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

// The estimate lies within four of its own standard deviations, which are small.
TEST(OutputOnly, finds_the_modes_of_a_chain) {
  const Chain chain;
  TimeRecord record = shaken(chain, 128, 40000, 1);
  add_white_noise(record.samples, 0.002, 2);
  const Identification found = identify_output(record, {.highest_order = 12});
  EXPECT_EQ(found.source, IdentifiedFrom::output);
  ASSERT_EQ(found.modes.size(), 4U);
  for (int j = 0; j < 4; ++j) {
    const IdentifiedMode& m = found.modes[std::size_t(j)];
    EXPECT_LT(std::abs(m.frequency - chain.frequency(j)), 4 * m.sigma_frequency) << j;
    EXPECT_LT(std::abs(m.damping - chain.damping[std::size_t(j)]), 4 * m.sigma_damping) << j;
    EXPECT_LT(m.sigma_frequency, 2e-3 * m.frequency) << j;
    EXPECT_LT(m.sigma_damping, 0.25 * m.damping) << j;
    EXPECT_GT(mac(m.shape, chain.shape(j).cast<std::complex<double>>()), 0.995) << j;
    EXPECT_GT(m.share, 0);
  }
  EXPECT_FALSE(says(found, "harmonic"));
  EXPECT_LT(found.misfit, 0.1);
}

// Scatter of a hundred records over what each states, frequency, damping, shape: within 25 %. The
// scatter of a hundred itself is known to 7 %.
TEST(OutputOnly, states_its_own_scatter) {
  Chain chain;
  chain.masses = 2;
  chain.damping = {0.02, 0.03};
  const int trials = 100;
  MatrixXd f(trials, 2), z(trials, 2), sf(trials, 2), sz(trials, 2), s(trials, 2), ss(trials, 2);
  for (int t = 0; t < trials; ++t) {
    TimeRecord record = shaken(chain, 100, 8000, 1000 + unsigned(t));
    record.samples.col(1) *= 0.8; // a gain, so that the same component is always the largest
    add_white_noise(record.samples, 0.003, 5000 + unsigned(t));
    const Identification found = identify_output(record, {.high = 44, .highest_order = 10});
    ASSERT_EQ(found.modes.size(), 2U) << t;
    for (int j = 0; j < 2; ++j) {
      const IdentifiedMode& m = found.modes[std::size_t(j)];
      f(t, j) = m.frequency;
      z(t, j) = m.damping;
      sf(t, j) = m.sigma_frequency;
      sz(t, j) = m.sigma_damping;
      s(t, j) = m.shape[1].real();
      ss(t, j) = m.sigma_shape[1];
    }
  }
  for (int j = 0; j < 2; ++j) {
    const double frequency = deviation(f.col(j)) / sf.col(j).mean();
    const double damping = deviation(z.col(j)) / sz.col(j).mean();
    const double shape = deviation(s.col(j)) / ss.col(j).mean();
    RecordProperty("scatter over stated, frequency " + std::to_string(j + 1),
                   std::to_string(frequency));
    RecordProperty("scatter over stated, damping " + std::to_string(j + 1),
                   std::to_string(damping));
    RecordProperty("scatter over stated, shape " + std::to_string(j + 1), std::to_string(shape));
    EXPECT_NEAR(frequency, 1, 0.25) << j;
    EXPECT_NEAR(damping, 1, 0.25) << j;
    EXPECT_LT(std::abs(f.col(j).mean() - chain.frequency(j)), 0.4 * sf.col(j).mean()) << j;
    EXPECT_LT(std::abs(z.col(j).mean() - chain.damping[std::size_t(j)]), 0.6 * sz.col(j).mean())
        << j;
    EXPECT_NEAR(shape, 1, 0.25) << j;
  }
}

// A motor at 17 Hz on the structure: the sine is found, and called what it is.
TEST(OutputOnly, warns_of_the_harmonic_of_a_machine) {
  const Chain chain;
  TimeRecord record = shaken(chain, 128, 40000, 3);
  const double size = record.samples.norm() / std::sqrt(double(record.samples.size()));
  for (Index n = 0; n < record.samples.rows(); ++n)
    record.samples.row(n).array() +=
        size * std::sin(2 * std::numbers::pi * 17 * double(n) / 128 + 0.3);
  const Identification found = identify_output(record, {.highest_order = 12});
  bool sine = false;
  for (const std::string& w : found.warnings)
    if (w.find("harmonic of a machine") != std::string::npos) {
      EXPECT_NE(w.find("at 17 Hz"), std::string::npos) << w;
      sine = true;
    }
  EXPECT_TRUE(sine);
  EXPECT_EQ(found.modes.size(), 4U);
}

TEST(Kurtosis, of_a_sine_is_one_and_a_half_and_of_noise_three) {
  const double rate = 100;
  VectorXd sine(20000), noise(20000);
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal(0, 1);
  for (Index n = 0; n < sine.size(); ++n) {
    sine[n] = std::sin(2 * std::numbers::pi * 13 * double(n) / rate);
    noise[n] = normal(random);
  }
  EXPECT_NEAR(band_kurtosis(sine, rate, 12, 14).value, 1.5, 1e-6);
  EXPECT_TRUE(is_sine(band_kurtosis(sine, rate, 12, 14)));
  const BandKurtosis k = band_kurtosis(noise, rate, 10, 15);
  EXPECT_NEAR(k.value, 3, 4 * k.sigma);
  EXPECT_FALSE(is_sine(k));
  VectorXd wanders(20000); // a machine whose speed changes by a tenth
  for (Index n = 0; n < wanders.size(); ++n)
    wanders[n] = std::sin(2 * std::numbers::pi *
                          (13 * double(n) / rate + 5 * std::sin(0.1 * double(n) / rate)));
  EXPECT_TRUE(is_sine(band_kurtosis(wanders, rate, 11, 15)));
}

TEST(OutputOnly, refuses_what_no_mode_follows_from) {
  const Chain chain;
  const TimeRecord good = shaken(chain, 128, 1200, 1);
  const auto refused = [](const TimeRecord& record, const IdentifySettings& settings = {}) {
    return keyed_error_of([&] { identify_output(record, settings); });
  };
  EXPECT_NE(refused(good).find("file: is too short"), std::string::npos) << refused(good);
  TimeRecord clipped = shaken(chain, 128, 20000, 1);
  const double limit = 0.5 * clipped.samples.cwiseAbs().maxCoeff();
  clipped.samples = clipped.samples.cwiseMin(limit).cwiseMax(-limit).eval();
  EXPECT_NE(refused(clipped).find("is clipped"), std::string::npos);
  EXPECT_NE(refused(shaken(chain, 128, 20000, 1), {.high = 60}).find("rate: of 128 Hz is too low"),
            std::string::npos);
}

// One channel gives frequency and damping, and says that it gives no shape.
TEST(OutputOnly, of_one_channel_has_no_shape) {
  const Chain chain;
  TimeRecord record = shaken(chain, 128, 40000, 6);
  record.samples = record.samples.leftCols(1).eval();
  record.channels.resize(1);
  const Identification found = identify_output(record, {.highest_order = 15});
  ASSERT_GE(found.modes.size(), 3U);
  EXPECT_LT(std::abs(found.modes[0].frequency - chain.frequency(0)),
            4 * found.modes[0].sigma_frequency);
  EXPECT_TRUE(says(found, "one channel: no shape"));
}

} // namespace
} // namespace plica::test
