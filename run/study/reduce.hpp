// A case as a superelement with its certificate.
#pragma once

#include "model/description/case.hpp"
#include "reduction/certificate.hpp"
#include "reduction/superelement.hpp"
#include "run/results/state_results.hpp"
#include "run/stages.hpp"

#include <map>

namespace plica {

// What reduce_case() is asked for, the superelement of a whole case.
struct SuperelementRequest {
  double cutoff = 0;                     // Hz; 0 = reduction_cutoff() of the case
  std::vector<std::string> boundary;     // names of caps and sensors; none = all caps
  double least_interface_mass = 0;       // modes with a smaller share are left out
  std::vector<std::string> recover = {}; // sensors that become recovery rows; none = all
};

struct ModesLeftOut {
  int count = 0;
  double largest = 0, sum = 0; // shares of the interface mass
  double lowest = 0;           // the lowest of them, Hz
};

struct ReducedCase {
  Superelement element;
  Certificate certificate;
  std::string route; // how it was reduced
  double cutoff = 0; // Hz
  double asked = 0;  // highest frequency that the case asks for, Hz
  ModesLeftOut left_out;
  std::optional<StateResult> state; // around which it was reduced
  bool proved = false;
  std::string reason;
  std::map<std::string, double> timing;
  double peak_memory = 0;
};

// Around a state, that of the case on its mount, the part is taken at its place there, with the
// stress it has; its end forces are part of what rigid rotations raise. Every cap that is held,
// sprung or loaded must then be of the boundary, and no weight may act.
//
// The mount is left away, masses of caps and interlock belong to the part. Boundary: caps first,
// then sensors. Sensors become recovery rows of motion and stress, base motions and the forces of
// the response load vectors. With analyses.reduction the parts between caps are reduced first and
// the superelement is one of superelements. Throws InputError for a case without caps or a name
// that is not there, and as build().
ReducedCase reduce_case(const Case& data, const SuperelementRequest& request,
                        const StageListener& stage);

} // namespace plica
