// What scatter adds along other axes: a sensor that is turned a little, a table that moves a little
// across. It adds in squares to what the structure itself shows there: nothing beside a large
// response, all there is beside none.
#pragma once

#include <Eigen/Core>

namespace plica {

// Of log readings (reading.hpp: with cross_floor) along other axes.
class CrossLaw {
public:
  CrossLaw() = default;
  // `expected`: mean of the admissible specimens where the structure itself shows `nominal`.
  CrossLaw(double power, double nominal, double expected);
  // The mean where the structure shows `own` and the errors of the test add so many times what they
  // add at the nominal structure, in squares.
  double mean(double own, double times) const;
  // Standard deviation there beyond that at the nominal structure: the logarithm of a normal
  // variable about zero scatters widely.
  double further_deviation(double own, double times) const;

private:
  double deviation(double times) const;

  double sigma_ = 0, shift_ = 0, variance_ = 0; // variance: of the log reading as it stands
};

struct CrossScatter {
  Eigen::Index reading = 0; // its place in the list
  double power = 0;         // mean square that scatter adds at the nominal structure,
  double by_test = 0;       // and that part of it which turned sensors and the table add
  CrossLaw law = {};

  // How many times the latter it is where they add `there`; 1 where that part is not known.
  double times(double there) const { return by_test > 0 ? there / by_test : 1; }
};

} // namespace plica
