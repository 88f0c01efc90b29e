// Fatigue curves that were published and that a case can name, over the strain amplitude e_a in
// percent: either the median of tests, by the equation of Langer (J. Basic Eng. 84, 1962, 389-402)
//   N = factor (e_a - limit)^-exponent,
// with the range that was tested and the scatter that was found, or a design curve of a code by its
// points, straight in a log-log plot, with what is inside of it. Every number stands in the source
// that is printed with it.
#pragma once

#include <array>
#include <vector>

namespace plica {

struct PublishedTests {
  const char* name;   // as a case calls it
  const char* title;  // printed beside every life
  const char* source; // likewise
  double factor = 0, exponent = 0;
  double limit = 0;             // percent
  double scale = 1;             // of the strain of a cycle before it meets the equation
  double fewest = 0, most = 0;  // cycles: the range that was tested, or that the points span
  double deviation = 0;         // standard deviation of log10 of the cycles; 0: a design curve
  const char* inside = nullptr; // of a design curve: the margins that it has
  std::vector<std::array<double, 2>> points = {}; // of a design curve: cycles, e_a

  bool is_design() const { return !points.empty(); }
};

enum class PublishedSteel {
  pipe_304L,
  pipe_304L_butt_weld,
  austenitic_asme_III,
  rcc_mrx_316LN,
  rcc_mrx_316LN_450C,
  rcc_mrx_316LN_500C,
  rcc_mrx_316LN_550C,
  rcc_mrx_316LN_600C,
  rcc_mrx_316LN_650C
};

const std::vector<PublishedTests>& published_tests(); // in the order of PublishedSteel
const PublishedTests& tests_of(PublishedSteel steel);

} // namespace plica
