// Mean curves of published tests that a case can name: the equation of Langer (J. Basic Eng. 84,
// 1962, 389-402)
//   N = factor (e_a - limit)^-exponent,  e_a the strain amplitude in percent,
// with the range that was tested and the scatter that was found. Every number stands in the source
// that is printed with it.
#pragma once

#include <vector>

namespace plica {

struct PublishedTests {
  const char* name;   // as a case calls it
  const char* title;  // printed beside every life
  const char* source; // likewise
  double factor = 0, exponent = 0;
  double limit = 0;            // percent
  double scale = 1;            // of the strain of a cycle before it meets the equation
  double fewest = 0, most = 0; // cycles: the range that was tested
  double deviation = 0;        // standard deviation of log10 of the cycles
};

enum class PublishedSteel { pipe_304L, pipe_304L_butt_weld };

const std::vector<PublishedTests>& published_tests(); // in the order of PublishedSteel
const PublishedTests& tests_of(PublishedSteel steel);

} // namespace plica
