// The shipped verification cases with another mesh, for the tests that solve bellows.
#pragma once

#include "io/case_file.hpp"
#include "model/run.hpp"

namespace plica::test {

inline Bellows& bellows_of(Case& data) {
  return std::get<Bellows>(data.parts.front().body);
}

// cases/verification/<name>.yaml; a mesh of no counts leaves the one of the file.
inline Case verification_case(const std::string& name, const MeshDensity& mesh = {},
                              int modes = 0) {
  Case data =
      read_case(std::string(PLICA_SOURCE_DIR) + "/cases/verification/" + name + ".yaml").data;
  if (mesh.around > 0) bellows_of(data).mesh = mesh;
  if (modes > 0) data.analyses.modes->count = modes;
  return data;
}

inline Case without_modes(Case data) {
  data.analyses.modes.reset();
  return data;
}

inline Results run_silently(const Case& data) {
  return run(data, [](const std::string&) {});
}

inline double error(double value, double reference) {
  return value / reference - 1;
}

} // namespace plica::test
