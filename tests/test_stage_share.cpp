// How far a diagnosis says it is.
#include "changed_beam.hpp"
#include "diagnose/results/stage_share.hpp"
#include "solve/parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace plica {
namespace {

TEST(StageShare, goes_from_its_beginning_to_its_end_whatever_thread_works) {
  std::vector<double> told;
  DiagnosisSettings settings;
  settings.advance = [&](double share) { told.push_back(share); };
  StageShare behind(settings, 0.2, 0.6, 8);
  in_parallel(8, [&](int) { behind.one_is_done(); });
  ASSERT_EQ(told.size(), 8U);
  for (std::size_t i = 0; i < told.size(); ++i)
    EXPECT_NEAR(told[i], 0.2 + 0.05 * double(i + 1), 1e-12);
}

// Softer and heavier at once than the case says, and weighed: singles, sets, a next measurement.
TEST(StageShare, of_a_whole_diagnosis_never_goes_back) {
  Case nominal = changed_beam::coarsely_meshed(changed_beam::beam_of(3, 0.6, 0.03, 0.005, true));
  changed_beam::add_masses(nominal);
  Case truth = nominal;
  std::get<PointMass>(truth.parts[3].body).mass = 0.2;
  truth.materials["steel"].E *= 0.8;
  Measured m;
  changed_beam::add_modes(m, "");
  m.weighings = {{.value = 1, .sigma = 0.0005, .repeats = {}}};
  changed_beam::take_readings(m, changed_beam::read_by(truth, m));
  std::vector<double> told;
  std::vector<std::string> stages;
  DiagnosisSettings settings;
  settings.stage = [&](const std::string& name, double share) {
    stages.push_back(name);
    told.push_back(share);
  };
  settings.advance = [&](double share) { told.push_back(share); };
  const Diagnosis d = diagnose(nominal, {.data = m, .responses = {}}, settings);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.front(), 0);
  EXPECT_LT(told.back(), 1);
  EXPECT_NE(std::find(stages.begin(), stages.end(), "sets of 2 effects"), stages.end());
  EXPECT_GT(told.size(), 3 * stages.size()) << "within stages, too";
  const auto within = [&](double begins, double ends) {
    return std::count_if(told.begin(), told.end(), [&](double share) {
      return share > begins + 1e-9 && share < ends + 1e-9;
    });
  };
  EXPECT_EQ(within(share::bases, share::signatures), d.hypotheses) << "as each is reduced";
  EXPECT_EQ(within(share::signatures, share::fits), d.hypotheses + 1) << "and the next stage";
}

} // namespace
} // namespace plica
