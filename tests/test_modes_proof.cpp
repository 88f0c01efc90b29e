// The proof that no mode is missing, against an independent count, in twenty-two varied models.
//
// Referee: negative pivots of a simplicial LDL' factor (Sylvester), which shares no step with the
// proof by a supernodal factor and that by Schur complement. Every mode is withheld in turn, and
// each time the proof must say so.
#include "tests/small_models.hpp"

#include "solve/modes.hpp"

#include <cstring>
#include <gtest/gtest.h>
#include <numeric>

namespace plica::test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Solved {
  System system;
  BaseFactor base;
  ModeSet modes;
};

Solved solve(const Model& model, const ModesRequest& request) {
  System system = assemble(model);
  BaseFactor base = factor_below_spectrum(system.K, system.M);
  ModeSet modes = find_modes(system.K, system.M, request, base);
  return {std::move(system), std::move(base), std::move(modes)};
}

const SmallModel& model_named(const std::string& name) {
  static const std::vector<SmallModel> models = small_models();
  return *std::find_if(models.begin(), models.end(), [&](auto& m) { return m.name == name; });
}

constexpr int asked = 12;

class EveryModel : public testing::TestWithParam<SmallModel> {};
INSTANTIATE_TEST_SUITE_P(Models, EveryModel, testing::ValuesIn(small_models()),
                         [](const auto& p) { return p.param.name; });

TEST_P(EveryModel, both_counts_equal_the_number_found_in_every_gap) {
  Solved s = solve(GetParam().make(), {.count = asked});
  const SparseMatrix &K = s.system.K, &M = s.system.M;
  ASSERT_LT(K.rows(), 5000);
  ASSERT_TRUE(s.modes.proof.passed) << s.modes.proof.reason;
  const VectorXd& lambda = s.modes.lambda;
  int gaps = 0;
  for (Eigen::Index m = std::max(1, GetParam().rigid_modes); m < lambda.size(); ++m) {
    if (lambda[m] - lambda[m - 1] < 1e-3 * lambda[m]) continue; // a pair, or as good as one
    const double sigma = (lambda[m] + lambda[m - 1]) / 2;
    const InertiaCount signs = count_below(K, M, sigma, s.modes.Phi, s.base.factor);
    const InertiaCount schur = count_below_by_schur(K, M, sigma, s.modes.Phi, s.base.factor);
    const InertiaCount referee = count_below_ldlt(K, M, sigma);
    EXPECT_EQ(signs.below.value_or(-1), m) << signs.reason;
    EXPECT_EQ(schur.below.value_or(-1), m) << schur.reason;
    EXPECT_EQ(referee.below.value_or(-1), m) << referee.reason;
    ++gaps;
  }
  EXPECT_GE(gaps, 1);
  EXPECT_EQ(s.modes.proof.inertia_count, s.modes.proof.found);
  EXPECT_EQ(count_below_ldlt(K, M, s.modes.proof.sigma).below.value_or(-1), s.modes.proof.found);
}

TEST_P(EveryModel, every_withheld_mode_is_noticed) {
  Solved s = solve(GetParam().make(), {.count = asked});
  ASSERT_TRUE(s.modes.proof.passed) << s.modes.proof.reason;
  const int n = static_cast<int>(s.modes.lambda.size()), keep = n / 2;
  for (int withheld = 0; withheld < keep; ++withheld) {
    std::vector<int> rest(n);
    std::iota(rest.begin(), rest.end(), 0);
    rest.erase(rest.begin() + withheld);
    const ModesProof proof = prove_complete(s.system.K, s.system.M, s.modes.lambda(rest),
                                            s.modes.Phi(Eigen::all, rest), keep, s.base.factor);
    EXPECT_TRUE(proof.made);
    EXPECT_FALSE(proof.passed) << "mode " << withheld + 1 << " of " << n << " was withheld";
    EXPECT_FALSE(proof.reason.empty());
    EXPECT_EQ(proof.inertia_count, proof.found + 1);
  }
}

// ||K phi - lambda M phi|| against the elastic size ||K phi|| + |shift| ||M phi||.
TEST_P(EveryModel, residuals_are_small_and_modes_orthonormal) {
  const Solved s = solve(GetParam().make(), {.count = asked});
  const MatrixXd KPhi = symmetric_product(s.system.K, s.modes.Phi);
  const MatrixXd MPhi = symmetric_product(s.system.M, s.modes.Phi);
  for (Eigen::Index i = 0; i < s.modes.lambda.size(); ++i) {
    const double lambda = s.modes.lambda[i];
    const double size = (std::abs(lambda) + std::abs(s.base.sigma)) * MPhi.col(i).norm();
    EXPECT_LT((KPhi.col(i) - lambda * MPhi.col(i)).norm() / size, 1e-6) << "mode " << i + 1;
    EXPECT_NEAR(lambda, s.modes.Phi.col(i).dot(KPhi.col(i)),
                1e-7 * (lambda + std::abs(s.base.sigma)));
    EXPECT_GE(lambda, s.modes.lambda[std::max<Eigen::Index>(i - 1, 0)]);
  }
  const MatrixXd gram = s.modes.Phi.transpose() * MPhi;
  EXPECT_LT((gram - MatrixXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff(), 1e-10);
}

TEST_P(EveryModel, rigid_modes_are_those_of_the_mount_and_the_shift_is_negative_for_them) {
  const Solved s = solve(GetParam().make(), {.count = asked});
  const int rigid = GetParam().rigid_modes;
  const double elastic = s.modes.lambda[rigid];
  EXPECT_EQ((s.modes.lambda.array().abs() < 1e-8 * elastic).count(), rigid);
  if (rigid == 0) {
    EXPECT_EQ(s.base.sigma, 0);
    return;
  }
  EXPECT_LT(s.base.sigma, -1e-3 * elastic) << "scaled to the lowest elastic mode";
  EXPECT_GT(s.base.sigma, -elastic);
}

// A shift four times as far gives the same elastic modes.
TEST(Modes, free_body_does_not_depend_on_the_shift) {
  for (const char* name : {"plate_square_free", "tube_free", "bellows_free_caps", "beam_free"}) {
    const Solved s = solve(model_named(name).make(), {.count = 14});
    BaseFactor far{SparseFactor(s.system.K), 4 * s.base.sigma};
    ASSERT_TRUE(far.factor.factorise(shifted(s.system.K, s.system.M, far.sigma)).ok);
    LanczosSettings settings;
    settings.count = 14;
    const EigenPairs pairs = lanczos(s.system.M, far.factor, far.sigma, settings);
    for (int i = 6; i < 14; ++i)
      EXPECT_NEAR(pairs.values[i] / s.modes.lambda[i], 1, 1e-8) << name << ", mode " << i + 1;
    for (int i = 0; i < 6; ++i) EXPECT_LT(std::abs(pairs.values[i]), 1e-8 * s.modes.lambda[6]);
  }
}

// The six rigid modes are one group: asked for any of them, all come, and the count is made above.
TEST(Modes, a_free_body_asked_for_few_modes_gives_the_rigid_ones_whole) {
  for (const char* name : {"plate_square_free", "tube_free", "bellows_free_caps", "beam_free"})
    for (int count = 1; count <= 6; ++count) {
      const Solved s = solve(model_named(name).make(), {.count = count});
      EXPECT_TRUE(s.modes.proof.passed) << name << ", " << count << ": " << s.modes.proof.reason;
      EXPECT_EQ(s.modes.lambda.size(), 6) << name << ", " << count;
    }
}

TEST(Modes, any_count_odd_or_even_is_complete_and_never_cuts_a_pair) {
  for (const char* name : {"bellows_two", "tube_clamped", "plate_square_supported"}) {
    const Model model = model_named(name).make();
    const Solved longest = solve(model, {.count = 24});
    for (int count = 1; count <= 20; ++count) {
      const Solved s = solve(model, {.count = count});
      const auto found = s.modes.lambda.size();
      ASSERT_TRUE(s.modes.proof.passed) << name << ", " << count << ": " << s.modes.proof.reason;
      EXPECT_TRUE(found == count || found == count + 1) << name << ", " << count << ": " << found;
      for (Eigen::Index i = 0; i < found; ++i)
        EXPECT_NEAR(s.modes.lambda[i] / longest.modes.lambda[i], 1, 1e-9);
      EXPECT_GT(longest.modes.lambda[found] / s.modes.lambda[found - 1], 1 + 1e-5)
          << name << ", " << count << " modes cut a pair";
    }
  }
}

TEST(Modes, lanczos_finds_the_same_modes_from_any_start_vector) {
  for (const char* name : {"bellows_two", "tube_clamped", "soft_comb"}) {
    const Solved s = solve(model_named(name).make(), {.count = 16});
    SparseFactor factor(s.system.K);
    ASSERT_TRUE(factor.factorise(s.system.K).ok);
    for (unsigned seed = 1; seed <= 8; ++seed) {
      LanczosSettings settings;
      settings.count = 16;
      settings.seed = seed;
      const EigenPairs pairs = lanczos(s.system.M, factor, 0, settings);
      ASSERT_TRUE(pairs.converged) << pairs.reason;
      for (int i = 0; i < 16; ++i)
        EXPECT_NEAR(pairs.values[i] / s.modes.lambda[i], 1, 1e-9) << name << ", seed " << seed;
    }
  }
}

TEST(Modes, a_band_gives_every_mode_in_it_and_no_other) {
  const Model model = model_named("bellows_two").make();
  const Solved all = solve(model, {.count = 40});
  VectorXd hertz = all.modes.lambda.unaryExpr(&frequency);
  const auto parts_a_pair = [&](int i) { return hertz[i] / hertz[i - 1] < 1 + 1e-6; };
  for (auto [first, last] : {std::pair{0, 1}, {0, 9}, {3, 12}, {5, 30}}) {
    if (first > 0 && parts_a_pair(first)) ++first;
    if (parts_a_pair(last + 1)) ++last;
    const double low = first == 0 ? 0 : (hertz[first - 1] + hertz[first]) / 2;
    const double high = (hertz[last] + hertz[last + 1]) / 2;
    const Solved s = solve(model, {.band = {low, high}});
    ASSERT_TRUE(s.modes.proof.passed) << s.modes.proof.reason;
    const auto expected = ((hertz.array() >= low) && (hertz.array() <= high)).count();
    ASSERT_EQ(s.modes.lambda.size(), expected) << low << " to " << high << " Hz";
    for (Eigen::Index i = 0; i < expected; ++i) {
      const double f = frequency(s.modes.lambda[i]);
      EXPECT_TRUE(f >= low && f <= high);
    }
  }
}

TEST(Modes, a_band_without_modes_is_empty_and_proved) {
  const Solved first = solve(model_named("bellows_two").make(), {.count = 1});
  const double f = frequency(first.modes.lambda[0]);
  const Solved s = solve(model_named("bellows_two").make(), {.band = {0.1 * f, 0.5 * f}});
  EXPECT_EQ(s.modes.lambda.size(), 0);
  EXPECT_TRUE(s.modes.proof.passed) << s.modes.proof.reason;
}

TEST(Modes, one_and_two_threads_assemble_the_same_bits_and_find_the_same_frequencies) {
  for (const char* name :
       {"bellows_three", "tube_distributing_mass", "plate_with_body", "portal"}) {
    const Model model = model_named(name).make();
    set_threads(1);
    const Solved one = solve(model, {.count = asked});
    set_threads(2);
    const Solved two = solve(model, {.count = asked});
    set_threads(0);
    for (const auto& [a, b] :
         {std::pair{&one.system.K, &two.system.K}, {&one.system.M, &two.system.M}}) {
      ASSERT_EQ(a->nonZeros(), b->nonZeros());
      EXPECT_EQ(std::memcmp(a->valuePtr(), b->valuePtr(), sizeof(double) * a->nonZeros()), 0)
          << name;
    }
    ASSERT_EQ(one.modes.lambda.size(), two.modes.lambda.size());
    for (Eigen::Index i = 0; i < one.modes.lambda.size(); ++i)
      EXPECT_NEAR(frequency(two.modes.lambda[i]) / frequency(one.modes.lambda[i]), 1, 1e-9) << name;
  }
}

} // namespace
} // namespace plica::test
