// Modes of free decays, against chains of masses whose modes are known in closed form.
#include "tests/chain_of_masses.hpp"
#include "tests/support/refusal.hpp"

#include "lab/identification/decay_fit.hpp"
#include "lab/identification/free_decays.hpp"
#include "lab/identification/mode_correlation.hpp"
#include "lab/signals/decay_window.hpp"
#include "lab/signals/decimation.hpp"
#include "words/input_error.hpp"

#include <gtest/gtest.h>

namespace plica::test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

void expect_modes(const Identification& found, const Chain& chain, double frequency, double damping,
                  double shape) {
  ASSERT_EQ(found.modes.size(), std::size_t(chain.masses));
  for (int j = 0; j < chain.masses; ++j) {
    const IdentifiedMode& m = found.modes[std::size_t(j)];
    EXPECT_NEAR(m.frequency / chain.frequency(j), 1, frequency) << j;
    EXPECT_NEAR(m.damping / chain.damping[std::size_t(j)], 1, damping) << j;
    EXPECT_GT(mac(m.shape, chain.shape(j).cast<std::complex<double>>()), 1 - shape) << j;
  }
}

// Without noise to rounding; half a second at rest before the blow is not of the decay.
TEST(FreeDecay, of_a_chain_is_exact_without_noise) {
  const Chain chain;
  const Identification found = identify_decays({let_go(chain, 0, 256, 6, 0.5)}, "", {});
  EXPECT_EQ(found.source, IdentifiedFrom::decays);
  expect_modes(found, chain, 1e-8, 1e-6, 1e-9);
  for (const IdentifiedMode& m : found.modes) EXPECT_GT(m.consistency, 0.999);
  EXPECT_LT(found.misfit, 1e-8);
}

TEST(FreeDecay, finds_the_modes_in_noise_and_calls_them_consistent) {
  const Chain chain;
  TimeRecord record = let_go(chain, 0, 256, 6, 0.5);
  add_white_noise(record.samples, 0.01, 1); // a tenth of the largest
  const Identification found = identify_decays({record}, "", {});
  expect_modes(found, chain, 5e-4, 0.05, 1e-3);
  for (const IdentifiedMode& m : found.modes) EXPECT_GT(m.consistency, 0.8);
}

// A blow on the middle mass of three does not move the second mode; one on the first does. Two
// decays together give all, and their participations say which blow drove what.
TEST(FreeDecay, of_several_hits_are_references_of_one_set) {
  Chain chain;
  chain.masses = 3;
  TimeRecord middle = let_go(chain, 1, 256, 6, 0.5), first = let_go(chain, 0, 256, 6, 0.7);
  add_white_noise(middle.samples, 0.005, 1);
  add_white_noise(first.samples, 0.005, 2);
  EXPECT_EQ(identify_decays({middle}, "", {}).modes.size(), 2U);
  const Identification found = identify_decays({middle, first}, "", {});
  expect_modes(found, chain, 5e-4, 0.05, 1e-3);
  const VectorXcd second = found.modes[1].participation;
  EXPECT_LT(std::abs(second[0]), 0.05 * std::abs(second[1]));
}

// Two blows in one record are two decays, cut apart before the second.
TEST(FreeDecay, of_two_hits_in_one_record_are_cut_apart) {
  const Chain chain;
  const TimeRecord one = let_go(chain, 0, 256, 5, 0.5), other = let_go(chain, 2, 256, 5, 0.5);
  TimeRecord both = one;
  both.samples.resize(one.samples.rows() * 2, chain.masses);
  both.samples << one.samples, other.samples;
  add_white_noise(both.samples, 0.003, 4);
  const std::vector<DecayWindow> windows = decay_windows(both, "");
  ASSERT_EQ(windows.size(), 2U);
  for (int w = 0; w < 2; ++w) {
    EXPECT_GE(windows[w].first, Index((0.5 + 5 * w) * 256));
    EXPECT_LE(windows[w].first, Index((0.5 + 5 * w) * 256) + 12);
  }
  EXPECT_LE(windows[0].first + windows[0].count, Index(5.5 * 256));
  expect_modes(identify_decays({both}, "", {}), chain, 5e-4, 0.05, 1e-3);
}

// A hammer that stays for 30 ms, half a period of the first mode: its channel tells when it left.
TEST(FreeDecay, begins_when_the_hammer_has_left) {
  const Chain chain;
  const double rate = 512, contact = 0.03;
  const Index samples = 3072, start = 200, length = Index(contact * rate);
  TimeRecord record = record_of(chain, rate, MatrixXd::Zero(samples, chain.masses));
  VectorXd force = VectorXd::Zero(samples);
  for (Index n = 0; n <= length; ++n)
    force[start + n] = std::sin(std::numbers::pi * double(n) / double(length));
  for (int j = 0; j < chain.masses; ++j) {
    const std::complex<double> l = chain.pole(j), mu = std::exp(l / rate), b = (mu - 1.) / l;
    std::complex<double> z = 0;
    for (Index n = 0; n < samples; ++n) {
      record.samples.row(n) += (l * z).imag() / l.imag() * chain.shape(j).transpose();
      z = mu * z + b * chain.shape(j)[0] * force[n];
    }
  }
  add_white_noise(record.samples, 1e-5, 3);
  record.channels.push_back("hammer");
  record.samples.conservativeResize(Eigen::NoChange, chain.masses + 1);
  record.samples.col(chain.masses) = force;
  const std::vector<DecayWindow> windows = decay_windows(record, "hammer");
  ASSERT_EQ(windows.size(), 1U);
  EXPECT_NEAR(double(windows[0].first), double(start + length), 1.5);
  expect_modes(identify_decays({record}, "hammer", {}), chain, 1e-3, 0.05, 1e-3);
}

// Sampled at forty times the highest mode: the rate is lowered by a filter that leaves the poles.
TEST(FreeDecay, keeps_its_poles_at_a_lower_rate) {
  const Chain chain;
  const TimeRecord record = let_go(chain, 0, 1600, 4);
  const Decimated low = decimated(record.samples, 1600, 50);
  EXPECT_EQ(low.factor, 8);
  EXPECT_EQ(low.rate, 200);
  const Index tail = 8; // of the first samples, behind the blow itself
  const ModalFit fit = fit_decays({low.samples.bottomRows(low.samples.rows() - tail)}, low.rate,
                                  {chain.pole(0), chain.pole(1), chain.pole(2), chain.pole(3)});
  for (int j = 0; j < chain.masses; ++j)
    EXPECT_LT(std::abs(fit.modes[std::size_t(j)].lambda - chain.pole(j)),
              1e-8 * std::abs(chain.pole(j)));
  TimeRecord noisy = let_go(chain, 0, 1600, 4, 0.2);
  add_white_noise(noisy.samples, 0.02, 5);
  expect_modes(identify_decays({noisy}, "", {}), chain, 1e-3, 0.1, 2e-3);
}

// The stated standard deviations are those of a hundred trials, within 25 %.
TEST(FreeDecay, states_its_own_scatter) {
  Chain chain;
  chain.masses = 3;
  const int trials = 100;
  MatrixXd f(trials, 3), z(trials, 3), sf(trials, 3), sz(trials, 3), s(trials, 3), ss(trials, 3);
  for (int t = 0; t < trials; ++t) {
    TimeRecord record = let_go(chain, 0, 100, 6, 0.5);
    add_white_noise(record.samples, 0.02, 1000 + unsigned(t));
    const Identification found = identify_decays({record}, "", {.high = 44, .highest_order = 12});
    ASSERT_EQ(found.modes.size(), 3U) << t;
    for (int j = 0; j < 3; ++j) {
      const IdentifiedMode& m = found.modes[std::size_t(j)];
      f(t, j) = m.frequency;
      z(t, j) = m.damping;
      sf(t, j) = m.sigma_frequency;
      sz(t, j) = m.sigma_damping;
      // The component that is not the largest and not zero.
      const Index c = 0;
      s(t, j) = m.shape[c].real();
      ss(t, j) = m.sigma_shape[c];
    }
  }
  for (int j = 0; j < 3; ++j) {
    RecordProperty("scatter over stated, frequency " + std::to_string(j + 1),
                   std::to_string(deviation(f.col(j)) / sf.col(j).mean()));
    RecordProperty("scatter over stated, damping " + std::to_string(j + 1),
                   std::to_string(deviation(z.col(j)) / sz.col(j).mean()));
    EXPECT_NEAR(deviation(f.col(j)) / sf.col(j).mean(), 1, 0.25) << j;
    EXPECT_NEAR(deviation(z.col(j)) / sz.col(j).mean(), 1, 0.25) << j;
    EXPECT_LT(std::abs(f.col(j).mean() - chain.frequency(j)), 0.4 * sf.col(j).mean()) << j;
  }
  // Of the first and last mode the middle mass is the largest, so that the first one scatters.
  for (const int j : {0, 2}) EXPECT_NEAR(deviation(s.col(j)) / ss.col(j).mean(), 1, 0.25) << j;
}

// The same structure 1 % softer in one of three decays: no single fit knows that.
TEST(FreeDecay, states_what_the_decays_differ_by) {
  Chain chain, softer;
  softer.f0 *= 0.99;
  std::vector<TimeRecord> records;
  for (int d = 0; d < 3; ++d) {
    records.push_back(let_go(d == 2 ? softer : chain, 0, 100, 4, 0.5));
    records.back().name = "hit " + std::to_string(d + 1);
    add_white_noise(records.back().samples, 0.002, 20 + unsigned(d));
  }
  const Identification found = identify_decays(records, "", {.highest_order = 15});
  ASSERT_FALSE(found.modes.empty());
  const IdentifiedMode& first = found.modes[0];
  EXPECT_GT(first.sigma_frequency, 0.3 * 0.01 * chain.frequency(0));
  EXPECT_LT(first.sigma_frequency, 0.01 * chain.frequency(0));
  EXPECT_TRUE(std::any_of(found.warnings.begin(), found.warnings.end(), [](const std::string& w) {
    return w.find("hit 3") != std::string::npos;
  }));
}

TEST(FreeDecay, refuses_what_no_mode_follows_from) {
  const Chain chain;
  const TimeRecord good = let_go(chain, 0, 256, 6, 0.5);
  const auto refused = [](const TimeRecord& record, const IdentifySettings& settings = {}) {
    return keyed_error_of([&] { identify_decays({record}, "", settings); });
  };
  TimeRecord steady = good;
  steady.samples.setZero();
  add_white_noise(steady.samples, 1, 1);
  EXPECT_NE(refused(steady).find("file: does not decay"), std::string::npos) << refused(steady);
  TimeRecord clipped = good;
  clipped.samples = clipped.samples.cwiseMin(0.08).cwiseMax(-0.08).eval();
  EXPECT_NE(refused(clipped).find("channels: m1.x is clipped"), std::string::npos);
  TimeRecord brief = good;
  brief.samples = good.samples.middleRows(128, 40).eval();
  EXPECT_NE(refused(brief).find("file: has 40 samples"), std::string::npos);
  TimeRecord torn = good;
  torn.samples(700, 2) = std::nan("");
  EXPECT_NE(refused(torn).find("m3.x has no number at row 701"), std::string::npos);
  TimeRecord dead = good;
  dead.samples.col(1).setZero();
  EXPECT_NE(refused(dead).find("channels: m2.x never moves"), std::string::npos);
  EXPECT_NE(refused(good, {.high = 200}).find("rate: of 256 Hz is too low"), std::string::npos);
  Chain one;
  one.masses = 1;
  const TimeRecord slow = let_go(one, 0, one.frequency(0) / 0.47, 6, 0.5);
  EXPECT_NE(refused(slow).find("rate: is too low"), std::string::npos) << refused(slow);
  TimeRecord other = good;
  other.channels[0] = "p.x";
  EXPECT_NE(keyed_error_of([&] {
              identify_decays({good, other}, "", {});
            }).find("channels: differ"),
            std::string::npos);
  TimeRecord faster = good;
  faster.rate = 300;
  EXPECT_NE(keyed_error_of([&] {
              identify_decays({good, faster}, "", {});
            }).find("rate: is 300 Hz"),
            std::string::npos);
}

} // namespace
} // namespace plica::test
