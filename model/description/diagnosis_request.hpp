// What a case says of its diagnosis: which effects may be behind a gap, how large they may be, how
// far off the model is where nothing has changed.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plica {

// What is known of a parameter of an effect beforehand, in SI. Either keeps the shape of its prior.
struct PriorRequest {
  std::string effect, parameter;
  std::vector<double> between;    // [low, high] that it cannot leave; empty = as the library has it
  std::optional<double> widening; // factor of the width of its prior
};

struct DiagnosisRequest {
  std::vector<std::string> effects; // that are tried; empty = all of the library
  std::vector<std::string> without; // that are not
  std::vector<std::string> places;  // where effects may sit, by how their paths begin; empty = all
  std::vector<PriorRequest> priors;
  bool fit_baseline = false; // the section `fit` adjusts the case to the baseline first
  // Relative standard deviations. Of each frequency of the model, the same before and after; none:
  // 2 % beside a baseline (lab/measured/measured.hpp), else what a drawing's tolerances leave.
  std::optional<double> model_error;
  double correlation = 1;           // of that error in a baseline and after
  std::optional<double> remounting; // scatter of a frequency when the specimen is mounted anew;
                                    // none: 0.4 %, or what several baselines show
  double change_error = 0.1;        // of what an effect changes, in terms of the change
};

// Effects that somebody supposes, at stated numbers, all at once; at most six.
struct SupposedEffect {
  std::string effect, place, way;           // as a diagnosis names them; way: empty = there is one
  std::map<std::string, std::string> value; // of each parameter: "20 g"; a plain number is SI
};
struct Supposition {
  std::vector<SupposedEffect> effects;
};

} // namespace plica
