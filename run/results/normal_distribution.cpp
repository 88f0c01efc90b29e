#include "run/results/normal_distribution.hpp"

#include <boost/math/distributions/normal.hpp>

namespace plica {

double normal_share(double z) {
  return boost::math::cdf(boost::math::normal(), z);
}

double normal_quantile(double share) {
  return boost::math::quantile(boost::math::normal(), share);
}

} // namespace plica
