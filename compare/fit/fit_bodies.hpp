// Moments of inertia among the parameters of a fit.
//
// Of a body none of Jxx, Jyy, Jzz is above the sum of the other two, and twice a product is at most
// the moment about the axis it leaves out: 2 |Jxy| <= Jzz. A search within bounds of single numbers
// knows nothing of this; what it asks for is moved to where a body is, and the residuals hold it.
#pragma once

#include "model/description/case.hpp"

#include <Eigen/Core>

namespace plica {

class FitBodies {
public:
  FitBodies(const Case& data, const FitRequest& request);

  // Moves the values of the parameters of bodies, in the order of the request. What is not a
  // parameter stays: where that leaves no body, the values stay, too.
  void settle(Eigen::VectorXd& values) const;

private:
  struct Body {
    Sextuple inertia;             // as the case has it
    std::array<int, 6> parameter; // that sets each; -1 = none
  };
  std::vector<Body> bodies_;
};

} // namespace plica
