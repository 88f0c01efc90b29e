// Steady heat conduction along the shells of a part.
//
//   div(k t grad T) + h_b (T_b - T) + h_a (T_a - T) = 0
//
// over the mid-surface: t thickness, k(T) conductivity, h the coefficient of the gas on either side
// and half of the wall in series, 1/h = 1/film + t/(2 k); edges without a temperature let no heat
// through. Isoparametric shells with one temperature per node; what the gas takes is lumped at the
// nodes, so that no temperature leaves the range of what is given. k(T) by repeated substitution.
// T is that of the mid-surface; the faces differ from each other by (q_b + q_a) t / (2 k), q_b what
// enters from below, q_a what leaves above.
#pragma once

#include "solve/model.hpp"

#include <functional>
#include <map>
#include <optional>

namespace plica {

struct WallFilm {
  double gas = 0;         // degC
  double coefficient = 0; // W/(m2 K)
};

struct HeatLoads {
  std::map<int, double> held;           // temperature by node, degC
  std::optional<WallFilm> below, above; // gas against and along the directors
};

struct WallTemperature {
  Eigen::VectorXd at; // per node of the mesh, degC; not a number where the part has no shell
  double across = 0;  // largest difference between the faces, K
  double through = 0; // heat that comes in where it comes in, W
};

// Throws std::runtime_error where a piece of the wall has neither a temperature nor gas.
WallTemperature conducted_temperature(const Model& model, int component,
                                      const std::function<double(double)>& conductivity,
                                      const HeatLoads& loads);

} // namespace plica
