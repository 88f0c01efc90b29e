// What excites a run: motion of the base, of chosen ends, forces, each on its own and several at
// once, as columns of loads.
#pragma once

#include "run/results/results.hpp"
#include "run/routes/route.hpp"
#include "solve/random_response.hpp"

#include <complex>

namespace plica {

// A column of the loads and its share in an excitation; an imaginary one acts a quarter of a period
// ahead.
struct ExcitedColumn {
  int column = 0;
  std::complex<double> factor = 1;
};
using ExcitedColumns = std::vector<ExcitedColumn>;

struct Excitation {
  std::string name; // x y z rx ry rz, or the name of the motion, the force, the inputs together
  Source source = Source::base;
  std::string direction = {}; // of a force: x y z rx ry rz
  ExcitedColumns parts;       // per unit amplitude; several inputs together: as they are
  double amplitude = 1;
  std::string unit;                          // m/s2 rad/s2 N Nm; empty for several together
  std::vector<ExcitedColumns> random_inputs; // what `random` is the spectrum of; empty = not random
  CrossSpectrum random;
};

struct Excitations {
  std::vector<Excitation> list;
  Loads loads;             // one column each, then what acts ahead
  Eigen::MatrixXd stretch; // of built.dampers by what ends carry along: dampers x loads
};

// "base y", "motion engine_y", "force tap", "together start"
std::string title_of(const Excitation& e);

// Throws InputError for a force on a set that is not on the mesh.
Excitations excitations(const Response& asked, const BuiltCase& built);

// Throws InputError, at `key`, for a name that is none of those on their own.
const Excitation& excitation_named(const std::string& name, const std::string& key,
                                   const Excitations& excited);

} // namespace plica
