// What a fit changes and what it is to meet: the `fit` section of a case.
#pragma once

#include "solve/joint_method.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plica {

// A number of the case that a fit may change, or several that share its value. What is written as
// text has the unit of that number; the reader turns it into the numbers below.
struct FitParameter {
  std::vector<std::string> paths;
  bool log_scale = false;
  std::vector<std::string> bounds_text, prior_text, physical_text;
  std::array<double, 2> bounds{};                // searched within
  std::optional<std::array<double, 2>> prior;    // value, standard deviation
  std::optional<std::array<double, 2>> physical; // range that makes sense; beyond it a warning
};

// A number that follows others: constant + sum of factors times numbers, in SI.
struct FitTie {
  std::string path;
  double constant = 0;
  std::map<std::string, std::string> of_text; // path: factor
  std::map<std::string, double> of;
};

// Limits of a sum of factors times numbers of the case or headline results (mass, k_axial,
// f_axial, f_transverse, f_torsion), in SI and Hz.
struct FitConstraint {
  std::string name;
  std::map<std::string, std::string> of_text;
  std::map<std::string, double> of;
  std::optional<double> min, max;
};

// A measured quantity that is met, by its name in the comparison, or all that belong to an entry of
// the measured data ("peaks[0]", "static[1]"). None listed = all of them.
struct FitTarget {
  std::string quantity;
  double sigma = 0; // standard deviation relative to the measured value, in place of the stated one
};

enum class FitSearch { local, global };

struct FitRequest {
  std::vector<FitParameter> parameters;
  std::vector<FitTie> ties;
  std::vector<FitTarget> targets;
  std::vector<FitConstraint> constraints;
  double default_sigma = 0.01; // relative, where the measured data state none
  FitSearch search = FitSearch::local;
  std::vector<double> hold_out_levels; // peaks at these levels of excitation are not fitted
  JointMethod level_method = JointMethod::describing_function; // of the levels during the fit
  int evaluations = 2000;                                      // of a global search
};

} // namespace plica
