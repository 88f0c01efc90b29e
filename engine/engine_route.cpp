#include "engine/engine_route.hpp"

#include "engine/memory_of_ranks.hpp"
#include "engine/orders.hpp"
#include "engine/shared_direct.hpp"
#include "engine/shared_reductions.hpp"
#include "io/files/fnv.hpp"
#include "mesh/machine_memory.hpp"
#include "run/routes/built_reduced.hpp"
#include "run/routes/memory_need.hpp"
#include "run/stages.hpp"
#include "solve/model_error.hpp"
#include "solve/stopwatch.hpp"
#include "words/input_error.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

namespace plica {
namespace {

using Eigen::MatrixXd;

// Of the nodes, the elements and the rows between DOFs.
std::uint64_t fingerprint_of(const Model& model) {
  Fnv1a print;
  for (const Eigen::Vector3d& x : model.mesh.nodes) print.add(x.data(), sizeof(double) * 3);
  for (const ShellQuad& q : model.mesh.quads) {
    print.add(q.nodes.data(), sizeof(q.nodes));
    print.add(q.directors.data(), sizeof(double) * 12);
    print.add(q.thickness.data(), sizeof(double) * 4);
  }
  for (const ShellTriangle& t : model.mesh.triangles) print.add(t.nodes.data(), sizeof(t.nodes));
  for (const Constraint& row : model.constraints)
    for (const ConstraintTerm& term : row.terms) print.add(&term.factor, sizeof(double));
  const int elements = element_count(model);
  print.add(&elements, sizeof elements);
  return print.hash();
}

class EngineRoute : public Route {
public:
  EngineRoute(const BuiltCase& built, const Ranks& ranks, const EngineSettings& settings,
              const StageListener& stage, Timing& timing)
      : ranks_(ranks), stage_(stage), timing_(timing),
        model_((stage(stages::assembly), built), ranks, settings.mumps, settings.log) {
    watch_.lap(timing_, "assembly");
  }

  ~EngineRoute() override { tell(ranks_, Order::done); } // they end their factors with ours
  EngineRoute(const EngineRoute&) = delete;
  EngineRoute& operator=(const EngineRoute&) = delete;

  std::string name() const override {
    return fmt::format("full mesh: engine, {} rank{}", ranks_.size(),
                       ranks_.size() == 1 ? "" : "s");
  }
  double mass() const override { return model_.mass(); }
  int unknowns() const override { return model_.unknowns(); }

  std::optional<Matrix1212> end_stiffness(const std::array<int, 2>& caps) override {
    stage_(stages::statics);
    watch_ = Stopwatch();
    tell(ranks_, Order::end_stiffness);
    ranks_.broadcast(std::vector<int>(caps.begin(), caps.end()));
    auto K = model_.end_stiffness(caps);
    watch_.lap(timing_, "statics");
    return K;
  }

  MatrixXd follow(const std::array<int, 2>& caps, const MatrixXd& motion) override {
    tell(ranks_, Order::follow);
    ranks_.broadcast(std::vector<int>(caps.begin(), caps.end()));
    return model_.follow(caps, ranks_.broadcast(motion));
  }

  ModalSolution modes(const ModesRequest& request, const Loads& loads,
                      const std::vector<int>& sensors) override {
    stage_(stages::modes);
    tell(ranks_, Order::modes);
    ranks_.broadcast(std::vector<int>{request.count, request.proof});
    ranks_.broadcast(MatrixXd(Eigen::RowVector2d(request.band[0], request.band[1])));
    ranks_.broadcast(loads.base);
    return model_.modes(request, {.base = loads.base, .force = loads.force}, sensors);
  }

private:
  const Ranks& ranks_;
  const StageListener& stage_;
  Timing& timing_;
  Stopwatch watch_;
  DistributedModel model_;
};

// One order of the first rank. False: it was the last.
bool answer(DistributedModel& model, const Case& data, const BuiltCase& built, const Ranks& ranks) {
  switch (tell(ranks, {})) {
  case Order::end_stiffness: {
    const std::vector<int> caps = ranks.broadcast(std::vector<int>{});
    model.end_stiffness({caps[0], caps[1]});
    return true;
  }
  case Order::follow: {
    const std::vector<int> caps = ranks.broadcast(std::vector<int>{});
    model.follow({caps[0], caps[1]}, ranks.broadcast(MatrixXd()));
    return true;
  }
  case Order::modes: {
    const std::vector<int> asked = ranks.broadcast(std::vector<int>{});
    const MatrixXd band = ranks.broadcast(MatrixXd());
    model.modes({.count = asked[0], .band = {band(0, 0), band(0, 1)}, .proof = asked[1] != 0},
                {.base = ranks.broadcast(std::vector<int>{}), .force = {}}, {});
    return true;
  }
  case Order::direct:
    answer_direct(data, built, ranks);
    return true;
  case Order::part_fields: // of superelements, which this model is not made of
  case Order::done:
    return false;
  }
  return false;
}

// A route over superelements that are reduced by all ranks; the others end with it.
class ReducedEngineRoute : public Route {
public:
  ReducedEngineRoute(const BuiltCase& built, const SeenCase* seen, const Analyses& analyses,
                     const Ranks& ranks, const EngineSettings& settings, const StageListener& stage,
                     Timing& timing)
      : ranks_(ranks), reductions_(ranks) {
    stage(stages::reduction);
    CutModel pieces = cut_for_ranks(built, analyses, seen != nullptr, ranks);
    bool others_wait = false;
    const PartReducer reduce = [&](const auto& parts, const PartReductionRequest& request) {
      auto reductions = reductions_.reduce(parts, request);
      others_wait = true;
      settings.log(fmt::format("{} reductions, of each rank: {}", parts.size(),
                               fmt::join(reductions_.shares(), ", ")));
      return reductions;
    };
    try {
      route_ = reduced_route(built, std::move(pieces), analyses, stage, timing,
                             {.seen = seen, .reduce = reduce});
    } catch (...) {
      if (others_wait) tell(ranks_, Order::done);
      throw;
    }
  }

  ~ReducedEngineRoute() override { tell(ranks_, Order::done); }
  ReducedEngineRoute(const ReducedEngineRoute&) = delete;
  ReducedEngineRoute& operator=(const ReducedEngineRoute&) = delete;

  std::string name() const override {
    return fmt::format("{}; engine, {} rank{}", route_->name(), ranks_.size(),
                       ranks_.size() == 1 ? "" : "s");
  }
  double mass() const override { return route_->mass(); }
  int unknowns() const override { return route_->unknowns(); }
  std::optional<Reduced> reduced() const override { return route_->reduced(); }
  std::optional<Matrix1212> end_stiffness(const std::array<int, 2>& caps) override {
    return route_->end_stiffness(caps);
  }
  MatrixXd follow(const std::array<int, 2>& caps, const MatrixXd& motion) override {
    return route_->follow(caps, motion);
  }
  ModalSolution modes(const ModesRequest& request, const Loads& loads,
                      const std::vector<int>& sensors) override {
    return route_->modes(request, loads, sensors);
  }

  // Collective: the pieces, where every node has the memory for its ranks.
  static CutModel cut_for_ranks(const BuiltCase& built, const Analyses& analyses, bool seen,
                                const Ranks& ranks) {
    CutModel pieces = cut_between_caps(built, analyses.symmetry != Symmetry::off);
    const double unknowns = double(dof_count(built.model));
    require_memory_of_nodes(memory_of_superelements(pieces, unknowns, analyses, seen), unknowns,
                            ranks);
    return pieces;
  }

private:
  const Ranks& ranks_;
  SharedReductions reductions_;
  std::unique_ptr<Route> route_;
};

// What the first rank does in ReducedEngineRoute, on the others: it recovers no fields of the
// whole.
void serve_reductions(const Case& data, const BuiltCase& built, const Ranks& ranks) {
  CutModel pieces = ReducedEngineRoute::cut_for_ranks(built, data.analyses, true, ranks);
  const DifferentParts parts = different_parts(std::move(pieces.parts));
  SharedReductions reductions(ranks);
  reductions.reduce(parts.different, part_reduction_request(data.analyses));
  for (;;) switch (tell(ranks, {})) {
    case Order::part_fields:
      reductions.answer_fields();
      continue;
    case Order::direct:
      answer_direct(data, built, ranks);
      continue;
    default:
      return;
    }
}

} // namespace

bool agree_on_model(const Ranks& ranks, const BuiltCase* built, const std::string& trouble) {
  const std::string own =
      built ? fmt::format("mesh {:016x}", fingerprint_of(built->model)) : "trouble " + trouble;
  const std::vector<std::string> all = ranks.everyones(own);
  if (all[0].starts_with("trouble")) return false;
  for (std::size_t r = 1; r < all.size(); ++r) {
    if (all[r].starts_with("trouble")) end_all(fmt::format("rank {}: {}", r, all[r].substr(8)));
    if (all[r] != all[0])
      end_all(fmt::format("rank {} has another mesh than rank 0: the ranks must read "
                          "the same case and geometry",
                          r));
  }
  return true;
}

std::unique_ptr<Route> engine_route(const BuiltCase& built, const SeenCase* seen,
                                    const Analyses& analyses, const Ranks& ranks,
                                    const EngineSettings& settings, const StageListener& stage,
                                    Timing& timing) {
  if (analyses.reduction)
    return std::make_unique<ReducedEngineRoute>(built, seen, analyses, ranks, settings, stage,
                                                timing);
  return std::make_unique<EngineRoute>(built, ranks, settings, stage, timing);
}

void serve(const Case& data, const BuiltCase& built, const Ranks& ranks,
           const EngineSettings& settings) {
  const auto with_all = [](const auto& work) { // what the first rank says is not said again
    try {
      return work();
    } catch (const InputError&) {
    } catch (const TooLarge&) {
    } catch (const std::runtime_error&) { // ModelError is one
    } catch (const std::logic_error&) {
    }
    return true;
  };
  if (data.analyses.reduction) {
    with_all([&] {
      serve_reductions(data, built, ranks);
      return true;
    });
    return;
  }
  std::optional<DistributedModel> model;
  with_all([&] {
    model.emplace(built, ranks, settings.mumps, settings.log);
    return true;
  });
  while (model && with_all([&] { return answer(*model, data, built, ranks); })) continue;
}

} // namespace plica
