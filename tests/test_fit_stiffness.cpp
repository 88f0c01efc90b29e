// Dynamic stiffness of a rig in a fit: tables written by closed forms give back what they were
// written with; what a measured.yaml says of them.
#include "compare/fit/fit.hpp"
#include "io/files/files.hpp"
#include "io/input/measured_file.hpp"
#include "io/tables/fit_words.hpp"
#include "tests/fit_parameter.hpp"
#include "tests/sliding_chain.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tube_case.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <fmt/format.h>
#include <numbers>

namespace plica::test {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

// A measured.yaml of one table, read.
TestData rig_test(const TemporaryFolder& folder, const std::string& table, const std::string& entry,
                  const std::string& more = "") {
  write_whole(folder.path / "rig.csv", table);
  write_whole(folder.path / "measured.yaml",
              "specimen: part\nstiffness: [{file: rig.csv" + entry + "}]\n" + more);
  TestData test;
  test.data = read_measured((folder.path / "measured.yaml").string());
  return test;
}

const FittedParameter& fitted_parameter(const FitResult& fit, const std::string& path) {
  return *std::find_if(fit.parameters.begin(), fit.parameters.end(),
                       [&](const FittedParameter& p) { return p.path == path; });
}

// k21 = EA* k / sin(k L), k11 = EA* k cot(k L), k^2 = m w^2 / EA*, EA* = EA (1 + i eta).
TEST(FitStiffness, of_a_rod_gives_back_its_modulus_mass_and_loss) {
  constexpr double m = 2, eta = 0.05;
  std::string table = "frequency [Hz],y storage [N/mm],y loss [N/mm],y driving point magnitude "
                      "[N/m],y driving point loss angle [deg]\n";
  for (double hertz = 20; hertz < 900; hertz += 40) { // through the first resonance between ends
    const Complex E = EA * Complex(1, eta), k = 2 * pi * hertz * std::sqrt(m / E);
    const Complex k21 = E * k / std::sin(k * L), k11 = E * k / std::tan(k * L);
    table += fmt::format("{},{},{},{},{}\n", hertz, k21.real() / 1e3, k21.imag() / 1e3,
                         std::abs(k11), std::arg(k11) * 180 / pi);
  }
  const TemporaryFolder folder("fit_stiffness");
  const TestData test = rig_test(folder, table, ", ends: [left, right], sigma: 2 %");
  Case data = tube(1.6);
  BeamPart& rod = std::get<BeamPart>(data.parts[0].body);
  rod.elements = 100;
  rod.section.EA = 5e6;
  data.analyses.damping.loss_factors = {{.of = "tube", .value = 0.02}};
  data.analyses.damping.coupled = true;
  FitRequest request;
  const std::string modulus = "parts.tube.section.EA", mass = "parts.tube.section.mass_per_length",
                    loss = "analyses.damping.loss_factors[0].value";
  request.parameters = {fit_parameter(modulus, 2e6, 8e6), fit_parameter(mass, 1, 4),
                        fit_parameter(loss, 0.001, 0.3)};
  const FitResult fit = fit_case(data, request, test, {});
  ASSERT_TRUE(fit.converged) << fit.reason;
  EXPECT_TRUE(fit.targets.empty());
  ASSERT_EQ(fit.stiffness.size(), 4);
  EXPECT_EQ(fit.stiffness[0].name, "y storage");
  EXPECT_EQ(fit.stiffness[3].name, "y driving point loss angle");
  for (const FittedStiffness& s : fit.stiffness) {
    EXPECT_EQ(s.numbers, 22) << s.name;
    EXPECT_EQ(s.sigma, 0.02) << s.name;
    EXPECT_GT(s.start, 0.05) << s.name;
    EXPECT_LT(s.value, 0.01) << s.name;
  }
  for (const auto& [path, wanted] : {std::pair{modulus, EA}, std::pair{mass, m}, {loss, eta}}) {
    const FittedParameter& p = fitted_parameter(fit, path);
    print_for_table("fit to k11 and k21 of a rod, " + path, p.value, wanted, 0.005);
    EXPECT_NEAR(p.value / wanted, 1, 0.005) << path;
    ASSERT_TRUE(p.sigma) << path;
    EXPECT_LT(*p.sigma / p.value, 0.05) << path;
  }
  EXPECT_NE(fit_text(fit).find("y driving point magnitude"), std::string::npos);
}

// A slider beside a spring, slowly: k = K + k_t H(X / x_s), H of Jenkins' element. Two of them in a
// row share the motion.
Complex sliding(double K, double k_t, double force, double X) {
  const double slip = force / k_t;
  if (X <= slip) return K + k_t;
  const double theta = std::acos(1 - 2 * slip / X);
  return {K + k_t / pi * (theta - std::sin(2 * theta) / 2), 4 * force * (X - slip) / (pi * X * X)};
}

TEST(FitStiffness, over_the_amplitude_gives_back_spring_and_slider) {
  std::string table = "frequency [Hz],amplitude [mm],y storage [N/mm],y loss angle [deg]\n";
  for (const double X : {1e-5, 1e-4, 2e-4, 5e-4, 1e-3, 3e-3}) {
    const Complex k = sliding(2e4, 6e4, 3, X / 2) / 2.;
    table += fmt::format("0.02,{},{},{}\n", 1e3 * X, k.real() / 1e3, std::arg(k) * 180 / pi);
  }
  const TemporaryFolder folder("fit_stiffness");
  TestData test = rig_test(folder, table, "");
  Case data = sliding_chain();
  ConnectorChain& chain = std::get<ConnectorChain>(data.parts[0].body);
  chain.spring.axial = 1.2e4;
  chain.friction->axial->sliders = {{3e4, 8}};
  FitRequest request;
  const std::string spring = "parts.chain.spring.axial",
                    stuck = "parts.chain.friction.axial.sliders[0].stiffness",
                    force = "parts.chain.friction.axial.sliders[0].slip_force";
  request.parameters = {fit_parameter(spring, 5e3, 1e5, true), fit_parameter(stuck, 1e4, 2e5, true),
                        fit_parameter(force, 0.5, 20, true)};
  const FitResult fit = fit_case(data, request, test, {});
  ASSERT_TRUE(fit.converged) << fit.reason;
  ASSERT_EQ(fit.stiffness.size(), 12);
  EXPECT_EQ(fit.stiffness[2].name, "y storage at 0.1 mm");
  for (const auto& [path, wanted] : {std::pair{spring, 2e4}, std::pair{stuck, 6e4}, {force, 3.}}) {
    print_for_table("fit to loops of a slider, " + path, fitted_parameter(fit, path).value, wanted,
                    0.005);
    EXPECT_NEAR(fitted_parameter(fit, path).value / wanted, 1, 0.005) << path;
  }
  // Of named ones those alone: one storage leaves the force open.
  request.targets = {{.quantity = "y storage at 0.01 mm", .sigma = 0.01}};
  const FitResult one = fit_case(data, request, test, {});
  ASSERT_EQ(one.stiffness.size(), 1);
  EXPECT_EQ(one.stiffness[0].sigma, 0.01);
  EXPECT_FALSE(one.open.empty());
  request.targets = {{.quantity = "z storage"}};
  EXPECT_THROW(fit_case(data, request, test, {}), std::invalid_argument);
  // Held out, it is said and not fitted.
  request.targets.clear();
  test.data.hold_out = {"stiffness[0]"};
  EXPECT_THROW(fit_case(data, request, test, {}), std::invalid_argument);
}

TEST(FitStiffness, entries_of_a_test_are_refused_with_their_place) {
  const TemporaryFolder folder("fit_stiffness");
  const std::string table = "frequency [Hz],y storage [N/mm]\n10,50\n";
  const auto error = [&](const std::string& csv, const std::string& entry,
                         const std::string& more = "") {
    return error_of([&] { rig_test(folder, csv, entry, more); });
  };
  EXPECT_EQ(error(table, ""), "no error");
  EXPECT_NE(error(table, ", ends: [a]").find("measured.yaml:2: stiffness[0].ends: are not two"),
            std::string::npos);
  EXPECT_NE(error(table, ", ends: [a, a]").find("ends: are not two"), std::string::npos);
  EXPECT_NE(error(table, ", sigma: 0").find("stiffness[0].sigma"), std::string::npos);
  EXPECT_NE(error(table, ", state: hot").find("stiffness[0].state: there is no state 'hot'"),
            std::string::npos);
  const std::string both = error("frequency [Hz],y stiff\n10,50\n", ", end: [a, b]");
  EXPECT_NE(both.find("rig.csv:1: y stiff"), std::string::npos) << both;
  EXPECT_NE(both.find("stiffness[0].end"), std::string::npos) << both; // all at once
  EXPECT_NE(error(table, ", state: new", "states: [{name: old, baseline: true}, {name: new}]\n")
                .find("stiffness[0]: no baseline has a dynamic stiffness"),
            std::string::npos);
  std::filesystem::remove(folder.path / "rig.csv");
  write_whole(folder.path / "measured.yaml", "specimen: part\nstiffness: [{file: rig.csv}]\n");
  EXPECT_THROW(read_measured((folder.path / "measured.yaml").string()), InputError);
}

} // namespace
} // namespace plica::test
