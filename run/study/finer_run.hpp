// The numbers of a run on a finer mesh, or with other numbers, beside those of the nominal one.
#pragma once

#include "run/results/results.hpp"

#include <limits>

namespace plica {

// The headline numbers and, of every duty of the life that does any damage, "damage_NAME", and
// "damage", that of all at the worst spot.
std::map<std::string, double> numbers_with_errors(const Results& results);

// Of StressResult, what a mesh error is of: the larger of shells and beams, Pa.
double shown_stress(const StressResult& stress);

// Each in the order of the nominal results; not a number = not met.
struct FinerRun {
  std::map<std::string, double> headline;  // as numbers_with_errors
  std::array<double, 6> statics{};         // as StaticStiffness::all()
  std::vector<double> modes, stresses;     // Hz, Pa
  std::vector<std::vector<double>> places; // rows of the stress tables: |von Mises|, Pa
};

// Modes are found again by their shapes, stresses by what they are of, rows by place, face and ply.
FinerRun numbers_of(const Results& fine, const Results& nominal);

// Of a run that met nothing.
FinerRun not_met(const Results& nominal);

// A mesh error for every number that has one, all zero.
void prepare_mesh_errors(const Results& nominal, ErrorBars& all);

// Adds to one member of every mesh error what the finer run changes, over `share` of what is
// missing in motions, `stress_share` in stresses and damages.
void add_differences(ErrorBars& all, const Results& nominal, const FinerRun& fine,
                     double MeshError::*member, double share, double stress_share);

} // namespace plica
