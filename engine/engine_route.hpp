// A run on the first rank, and what the others do for it.
//
// The first rank runs the analyses (run/analyses/run_by_route.hpp) on a route whose answers all
// ranks compute together: it tells the others what it was asked, they do the same. A model that has
// no answer is an error of the same words on every rank; the others then wait for the next order.
#pragma once

#include "engine/distributed_model.hpp"
#include "model/description/case.hpp"

namespace plica {

struct EngineSettings {
  MumpsSettings mumps;
  std::function<void(const std::string&)> log = [](const std::string&) {}; // first rank
};

// Every rank has built the case, or says why not (`trouble`); then all agree. Ends all ranks when
// one has another mesh or trouble that the first has not; the trouble of the first rank is the
// caller's to say. False: the first rank has trouble.
bool agree_on_model(const Ranks& ranks, const BuiltCase* built, const std::string& trouble);

// On the first rank, after agree_on_model(): of the full mesh or, where the analyses ask for them,
// of superelements that are reduced over ranks. `seen`: as RouteSettings has it.
std::unique_ptr<Route> engine_route(const BuiltCase& built, const SeenCase* seen,
                                    const Analyses& analyses, const Ranks& ranks,
                                    const EngineSettings& settings, const StageListener& stage,
                                    Timing& timing);

// On the others: answers until the route of the first rank ends.
void serve(const Case& data, const BuiltCase& built, const Ranks& ranks,
           const EngineSettings& settings);

} // namespace plica
