// A specimen on its table: the structure with its effects and healthy scatter, and the sensors.
//
// Healthy scatter (standard deviations; every specimen has it, also those without effect):
//   E 1 %, density 0.5 %, wall thickness 1 %, smooth stiffness field over the convolutions 2 %,
//   mass of caps, liner, ring and attached masses 1 %, liner EA, EI, GJ and lap springs 5 %,
//   damping of each mode 12 %, sensors 0.7 mm each way off their place, 1 degree about each axis,
//   gains 1 %, every assembly (state and direction) 0.2 % in each frequency and 4 % in each
//   damping.
#pragma once

#include "draws.hpp"
#include "specimen.hpp"
#include "structure.hpp"

namespace sealed {

struct Probe {
  std::string name;
  MatrixXd rows;                   // of its true place, 3 x unknowns
  Matrix3d reading;                // what its three channels make of the motion there
  double delay = 0, resonance = 0; // s, Hz; strangers
};

struct Bench {
  Structure body; // as in the rig: without table, sensors and what the lab did not weigh
  Structure test;
  std::vector<Probe> probes;
  std::map<int, std::array<double, 6>> table; // base direction: what the table really does
  VectorXd zeta;                              // of each mode
};

// `set` are numbers that a state changes: "parts.extra.mass".
using State = std::map<std::string, double>;

Bench bellows_bench(const Specimen& s, const ReducedWall& wall, const State& state, Draws draws);
Bench beam_bench(const Specimen& s, const State& state, Draws draws);

// Common to both: probe with scatter and instrument effects; table; damping.
Probe probe_of(const Specimen& s, const std::string& name, const MatrixXd& rows,
               const Vector3d& normal, Draws& draws);
void add_table_and_damping(Bench& bench, const Specimen& s, double zeta, Draws& draws);
// An end on springs of six stiffnesses, N/m and Nm/rad, each 5 % off, whose foot the table holds:
// the place "foot.<end>". A compliance of that mount is in series with them.
void mount_on_springs(Structure& test, const Specimen& s, const std::string& end, VectorXd k,
                      Draws& draws);
// A sensor on a cap, `offset` from its reference.
MatrixXd rows_on_cap(const Structure& s, const std::string& end, const Vector3d& offset);
// Fixtures, compliant mounts, supports and strangers that name a place of the structure.
void add_surroundings(Structure& test, const Specimen& s);
// The friction of a joint between two places of six rows; `stiffness` of the six directions.
void add_friction(Structure& test, const Effect& e, const MatrixXd& relative,
                  const std::vector<std::pair<int, double>>& stiffness);

} // namespace sealed
