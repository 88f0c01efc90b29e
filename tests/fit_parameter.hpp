// A parameter of a fit: one path, its bounds, and whether it moves on a logarithmic scale.
#pragma once

#include "model/description/case.hpp"

#include <string>

namespace plica::test {

inline FitParameter fit_parameter(const std::string& path, double low, double high,
                                  bool log_scale = false) {
  FitParameter p;
  p.paths = {path};
  p.bounds = {low, high};
  p.log_scale = log_scale;
  return p;
}

} // namespace plica::test
