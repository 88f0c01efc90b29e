// An assembly of superelements that is meshed and reduced once, and solved for many masses of its
// caps and springs of its mounts: what lies on the nodes of caps alone changes no superelement.
//
// Modes and static stiffness as run() gives them, labels by part of the rings: every mode is
// recovered at some sixty rings, and at what is no wall. Without shapes, places, responses, doubts.
#pragma once

#include "model/description/case.hpp"
#include "run/results/results.hpp"
#include "run/routes/route.hpp"

namespace plica {

class AssemblyStudy {
public:
  // Null for a case that has to be run as a whole: without analyses.reduction; with a state,
  // friction, dampers, loss factors, supports, stresses or anything over frequency or time; with
  // shells that are not of revolution. Throws as run().
  static std::unique_ptr<const AssemblyStudy> of(const Case& data, const StageListener& stage,
                                                 ReductionMemory* memory);
  ~AssemblyStudy();

  // None where the ends of the variant are joined in another way. It may differ from the case at
  // paths of is_of_ends() (model/shape/renewed_ends.hpp) and in analyses.modes. Several threads may
  // ask.
  std::optional<Results> run(const Case& variant, const StageListener& stage) const;

private:
  struct Kept;
  explicit AssemblyStudy(std::unique_ptr<const Kept> kept);
  std::unique_ptr<const Kept> kept_;
};

} // namespace plica
