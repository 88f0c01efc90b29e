#include "life/published_curves.hpp"

#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Points = std::vector<std::array<double, 2>>;

// Hannes, Svensson, Anderson and Dahlberg: Experimental study of weld fatigue strength reduction
// for a stainless steel piping component, Fatigue Design 2017 (Procedia Engineering, 2018). Table 1
// and section 5.2: constants, Kf = 1.79; 5.3: standard deviation of ln N 0.36, of both series.
//
// Range: "the recorded maximum strain amplitude was approximately in the range 0.2-0.4 %" (section
// 5), whose upper end on the plain curve is 591 (0.4 - 0.056)^-2.07 = 5 380 cycles; a run-out at
// 11000 blocks of 453 cycles, of which at least 25 % counted (5.1): 1.25 million.
PublishedTests pipe(const char* name, const char* title, double factor, double exponent,
                    double scale) {
  return {.name = name,
          .title = title,
          .source = "Hannes, Svensson, Anderson, Dahlberg, Fatigue Design 2017, table 1: seamless "
                    "TP 304 L pipe of 60 mm, wall of 3 mm under water at 70 bar, bending of "
                    "variable amplitude at room temperature, to leakage",
          .factor = factor,
          .exponent = exponent,
          .limit = 0.056,
          .scale = scale,
          .fewest = 5400,
          .most = 1.25e6,
          .deviation = 0.36 / std::numbers::ln10};
}

PublishedTests design(const char* name, const char* title, const char* source, const char* inside,
                      Points points) {
  const double fewest = points.front()[0], most = points.back()[0];
  return {.name = name,
          .title = title,
          .source = source,
          .fewest = fewest,
          .most = most,
          .inside = inside,
          .points = std::move(points)};
}

// ASME BPVC III, Appendix I, figure I-9.2M (austenitic steels, nickel-chromium-iron), MPa for E =
// 195 GPa, straight in a log-log plot; as tabulated in fatigue/SN.fee of the public repository
// piping-asme-fatigue of Seamplex. Margins: Beswick, McLennan, Currie and Courtin, PVP 2025:
// "factors of 12 on life and 2 on stress/strain". Half of the range that is allowed, so that the
// points count as amplitudes of strain.
PublishedTests asme_austenitic() {
  constexpr double E = 195e3; // MPa
  Points points{{1e1, 6000}, {2e1, 4300}, {5e1, 2748}, {1e2, 1978},  {2e2, 1440}, {5e2, 974},
                {1e3, 745},  {2e3, 590},  {5e3, 450},  {1e4, 368},   {2e4, 300},  {5e4, 235},
                {1e5, 196},  {2e5, 168},  {5e5, 142},  {1e6, 126},   {2e6, 113},  {5e6, 102},
                {1e7, 99},   {1e8, 97.1}, {1e9, 95.8}, {1e10, 94.4}, {1e11, 93.7}};
  for (auto& point : points) point[1] *= 100 / E;
  return design("austenitic_asme_III", "austenitic steel, ASME III",
                "ASME BPVC section III, appendix I, figure I-9.2M, as tabulated in "
                "piping-asme-fatigue (Seamplex), fatigue/SN.fee",
                "factors of 12 on cycles and 2 on stress, and a mean stress, are inside",
                std::move(points));
}

// RCC-MRx, X2CrNiMo17-12-2(N): range of strain in percent; as tabulated in
// fatrcc/materials/Cycles_X2CrNiMo17.csv of the public repository Fatigue-RCC-MRx (L. A.
// Fernandez; RCC-MRx, AFCEN, 2022), whose last row, at 10^9, is not smooth and left out.
PublishedTests rcc_mrx(const char* name, const char* title, const std::array<double, 20>& ranges) {
  constexpr std::array<double, 20> cycles{10,  20,  40,  100, 200, 400, 1e3, 2e3, 4e3, 1e4,
                                          2e4, 4e4, 1e5, 2e5, 4e5, 1e6, 5e6, 1e7, 5e7, 1e8};
  Points points;
  for (std::size_t i = 0; i < cycles.size(); ++i) points.push_back({cycles[i], ranges[i] / 2});
  return design(name, title,
                "RCC-MRx 2022, X2CrNiMo17-12-2(N), as tabulated in Fatigue-RCC-MRx (Fernandez), "
                "Cycles_X2CrNiMo17.csv",
                "the margins of that code are inside", std::move(points));
}

std::vector<PublishedTests> all_tests() {
  return {
      pipe("304L_pipe", "304 L pipe, plain", 591, 2.07, 1),
      pipe("304L_pipe_butt_weld", "304 L pipe, butt weld as welded", 416, 2.22, 1.79),
      asme_austenitic(),
      rcc_mrx("316LN_rcc_mrx", "316 L(N), RCC-MRx, 20 °C",
              {4.291, 2.755, 1.931, 1.331, 1.057, 0.863, 0.698, 0.59,  0.498, 0.399,
               0.341, 0.301, 0.267, 0.25,  0.238, 0.225, 0.203, 0.192, 0.169, 0.165}),
      rcc_mrx("316LN_rcc_mrx_450C", "316 L(N), RCC-MRx, 450 °C",
              {2.552, 1.931, 1.485, 1.08,  0.869, 0.715, 0.578, 0.488, 0.412, 0.33,
               0.282, 0.249, 0.221, 0.207, 0.197, 0.186, 0.168, 0.159, 0.14,  0.136}),
      rcc_mrx("316LN_rcc_mrx_500C", "316 L(N), RCC-MRx, 500 °C",
              {2.459, 1.841, 1.403, 1.007, 0.805, 0.659, 0.532, 0.449, 0.38,  0.304,
               0.26,  0.229, 0.203, 0.19,  0.181, 0.171, 0.154, 0.146, 0.129, 0.125}),
      rcc_mrx("316LN_rcc_mrx_550C", "316 L(N), RCC-MRx, 550 °C",
              {2.361, 1.748, 1.316, 0.933, 0.741, 0.605, 0.487, 0.412, 0.348, 0.278,
               0.238, 0.21,  0.186, 0.174, 0.166, 0.157, 0.141, 0.134, 0.118, 0.115}),
      rcc_mrx("316LN_rcc_mrx_600C", "316 L(N), RCC-MRx, 600 °C",
              {2.26,  1.652, 1.231, 0.859, 0.678, 0.552, 0.445, 0.376, 0.317, 0.254,
               0.217, 0.192, 0.17,  0.159, 0.151, 0.143, 0.129, 0.122, 0.108, 0.105}),
      rcc_mrx("316LN_rcc_mrx_650C", "316 L(N), RCC-MRx, 650 °C",
              {2.155, 1.553, 1.139, 0.787, 0.618, 0.502, 0.404, 0.342, 0.289, 0.231,
               0.198, 0.174, 0.154, 0.145, 0.138, 0.13,  0.117, 0.111, 0.098, 0.095}),
  };
}

} // namespace

const std::vector<PublishedTests>& published_tests() {
  static const std::vector<PublishedTests> all = all_tests();
  return all;
}

const PublishedTests& tests_of(PublishedSteel steel) {
  return published_tests()[std::size_t(steel)];
}

} // namespace plica
