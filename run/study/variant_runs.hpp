// Runs of many variants of one case, each with other numbers at some paths. What variants have in
// common is computed once: superelements that do not change, and assemblies that change at their
// ends alone (assembly_study.hpp). Results do not depend on which variants ran before.
#pragma once

#include "reduction/substructures.hpp"
#include "run/results/results.hpp"
#include "run/study/assembly_study.hpp"

namespace plica {

using Changes = std::map<std::string, std::string>; // path of the case file: new value

class VariantRuns {
public:
  // `headline`: modes with their proof, mass and static stiffness are all that is asked.
  explicit VariantRuns(bool headline) : headline_(headline) {}

  // `variant`: the case with `changes` in it. Throws as run() does; several threads may ask.
  Results run(const Case& variant, const Changes& changes, const StageListener& stage);

private:
  struct Assembly {
    std::string others; // changes beyond its ends
    std::mutex mutex;   // who comes first makes it
    bool made = false;
    std::unique_ptr<const AssemblyStudy> study;
  };
  std::shared_ptr<Assembly> assembly_of(const Changes& changes);

  bool headline_;
  ReductionMemory memory_;
  std::mutex mutex_;
  std::deque<std::shared_ptr<Assembly>> assemblies_; // the last used first
};

} // namespace plica
