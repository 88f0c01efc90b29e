// A case as a superelement with its certificate.
#pragma once

#include "model/case.hpp"
#include "reduction/certificate.hpp"
#include "reduction/superelement.hpp"

#include <functional>
#include <map>

namespace plica {

struct ReducedCase {
  Superelement element;
  Certificate certificate;
  std::string route; // how it was reduced
  double cutoff = 0; // Hz
  bool proved = false;
  std::string reason;
  std::map<std::string, double> timing;
  double peak_memory = 0;
};

// Boundary: the caps of the case in their order. The mount is left away, masses of caps and
// interlock belong to the part. Sensors become recovery rows. `cutoff` 0: twice the upper end of
// the response band, or 1000 Hz. Throws InputError for a case without caps, and as build().
ReducedCase reduce_case(const Case& data, double cutoff,
                        const std::function<void(const std::string&)>& stage);

} // namespace plica
