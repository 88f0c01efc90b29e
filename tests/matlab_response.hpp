// A test whose only response stands in a MATLAB file.
#pragma once

#include "lab/measured/measured.hpp"

namespace plica::test {

// One response of a force, in h.mat.
inline Measured test_by_force(const MatlabVariables& variables) {
  Measured m;
  m.frf.resize(1);
  m.frf[0].file = "h.mat";
  m.frf[0].force = "a.z";
  m.frf[0].channels = {"a.z"};
  m.frf[0].variables = variables;
  return m;
}

} // namespace plica::test
