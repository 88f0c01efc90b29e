// Inertias in a fit stay those of bodies.
#include "compare/fit/fit.hpp"
#include "compare/fit/fit_bodies.hpp"
#include "model/description/case_checks.hpp"
#include "model/description/case_path.hpp"
#include "run/analyses/run.hpp"
#include "run/study/error_bars.hpp"
#include "tests/fit_parameter.hpp"
#include "tests/tube_case.hpp"

#include <gtest/gtest.h>

namespace plica {
namespace {

using Eigen::VectorXd;
using test::fit_parameter;

bool reads_inertias(const Case& data) {
  for (const InputProblem& p : check_case(data, {}, ""))
    if (p.key.find("inertia") != std::string::npos) return false;
  return true;
}

// The data ask for more about the axis than about both others together, which no body has.
TEST(Fit, tries_and_writes_no_inertia_that_the_reader_refuses) {
  Case start = test::tube(0.8);
  std::get<BeamPart>(start.parts.front().body).elements = 4;
  start.mount[1].kind = MountKind::free;
  start.caps[1].mass = 2;
  start.caps[1].inertia = {2e-3, 2e-3, 2e-3, 0, 0, 0};
  start.analyses.modes = Modes{.count = 8};
  Case asked = start;
  asked.caps[1].inertia = {1.5e-3, 3.2e-3, 1.5e-3, 0, 0, 0};
  const Results r = run(for_headline(asked), [](const std::string&) {});
  Measured measured;
  for (const ModeResult& mode : r.modes) {
    const bool torsion = mode.shape == "torsion", across = mode.shape == "transverse";
    if (!torsion && !across) continue;
    MeasuredMode entry;
    entry.frequency = mode.frequency;
    entry.sigma = 1e-3 * mode.frequency;
    entry.shape = torsion ? MeasuredShape::torsion : MeasuredShape::transverse;
    if (across) entry.direction = mode.direction == "x" ? Axis::x : Axis::z;
    entry.order = mode.order;
    if (entry.order <= 2) measured.modes.push_back(entry);
  }
  FitRequest request;
  request.parameters = {fit_parameter("caps.right.inertia[0]", 1e-4, 2e-2),
                        fit_parameter("caps.right.inertia[1]", 1e-4, 2e-2)};
  request.parameters.front().paths.push_back("caps.right.inertia[2]");
  ASSERT_TRUE(reads_inertias(start));
  ASSERT_FALSE(reads_inertias(asked));
  FitSettings settings;
  settings.refused = [](const Case& design) { return !reads_inertias(design); };
  const FitResult fit = fit_case(start, request, {measured, {}}, settings);
  const VectorXd values{{fit.parameters[0].value, fit.parameters[1].value}};
  EXPECT_TRUE(reads_inertias(with_design(start, request, values))) << values.transpose();
  EXPECT_NEAR(values[1] / (2 * values[0]), 1, 1e-3); // as far as bodies go
  EXPECT_LT(fit.cost, fit.start_cost);
  for (const FitSample& s : fit.samples)
    ASSERT_TRUE(reads_inertias(with_design(start, request, s.design))) << s.design.transpose();
}

TEST(Fit, moves_an_inertia_that_no_body_has_to_the_nearest) {
  Case data = test::tube(0.8);
  data.caps[1].inertia = {2, 2, 2, 0, 0, 0};
  const auto settled = [&](const std::vector<int>& free, VectorXd values) {
    FitRequest request;
    for (int i : free)
      request.parameters.push_back(
          fit_parameter("caps.right.inertia[" + std::to_string(i) + "]", 0, 9));
    FitBodies(data, request).settle(values);
    return values;
  };
  EXPECT_NEAR(settled({1}, VectorXd{{5}})[0], 4, 1e-6);
  EXPECT_NEAR(settled({1}, VectorXd{{3}})[0], 3, 0);
  EXPECT_NEAR(settled({0}, VectorXd{{-1}})[0], 0, 1e-6); // 2 <= -1 + 2 does not hold
  EXPECT_NEAR(settled({0, 1, 2}, VectorXd{{1, 5, 2}})[1], 3, 1e-6);
  EXPECT_NEAR(settled({3}, VectorXd{{-1.5}})[0], -1, 1e-6);
}

} // namespace
} // namespace plica
