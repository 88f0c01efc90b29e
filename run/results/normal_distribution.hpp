// The standard normal distribution.
#pragma once

namespace plica {

// Share below z, and the z below which a share in (0, 1) lies.
double normal_share(double z);
double normal_quantile(double share);

} // namespace plica
