// The shipped verification cases with another mesh, for the tests that solve bellows.
#pragma once

#include "io/input/case_file.hpp"
#include "model/shape/build_bellows.hpp"
#include "run/analyses/run.hpp"
#include "tests/support/verification_line.hpp"

#include <gtest/gtest.h>

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

// A soft liner beside the wall of bellows A.
inline void add_liner(Case& data, Attachment attachment) {
  data.parts.push_back({"liner", Interlock{.along = "bellows",
                                           .attachment = attachment,
                                           .EA = 2e3,
                                           .EI = 1,
                                           .GJ = 0.5,
                                           .mass = 0.1,
                                           .radius = 0.02}});
}

// A light one between the caps, with a slider beside it along the bellows, N.
inline Interlock sliding_liner(double slip_force) {
  Interlock liner{.along = "bellows",
                  .attachment = Attachment::caps,
                  .EA = 2e3,
                  .EI = 1,
                  .GJ = 0.5,
                  .mass = 0.05,
                  .radius = 0.02};
  liner.friction.emplace();
  liner.friction->axial.emplace();
  liner.friction->axial->sliders = {{.stiffness = 1e5, .slip_force = slip_force}};
  return liner;
}

// The bellows alone: what harmonic_model.hpp takes.
struct BareBellows {
  Mesh mesh;
  ShellProperties shell;
};

inline BareBellows bare_bellows(Case data) {
  const Bellows& bellows = bellows_of(data);
  return {bellows_mesh(bellows, bellows_meridian(bellows)), build(data).model.shells.front()};
}

// Holds a value against its reference and prints the line for the verification table.
inline void compare(const std::string& part, const std::string& what, double value,
                    double reference, double tolerance) {
  const double error = value / reference - 1;
  print_for_table(part + ", " + what, value, reference, tolerance);
  EXPECT_LE(std::abs(error), tolerance)
      << part << ", " << what << ": " << value << ", reference " << reference;
}

} // namespace plica::test
