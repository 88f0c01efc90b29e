#include "run/routes/route.hpp"

#include "solve/stopwatch.hpp"
#include "words/input_error.hpp"

#include <algorithm>

namespace plica {

void require_held(bool free_body) {
  if (free_body)
    input_error("analyses",
                "nothing holds the part, or a piece of it that nothing joins to the rest (joints "
                "with friction count as slipping), so it has no "
                "steady response",
                "a mount or supports that leave no rigid motion free");
}

std::unique_ptr<Route> choose_route(const BuiltCase& built, const Analyses& analyses,
                                    const StageListener& stage, Timing& timing) {
  const Symmetry symmetry = analyses.symmetry;
  if (analyses.reduction)
    return reduced_route(built, reduction_cutoff(analyses), symmetry, stage, timing);
  if (symmetry == Symmetry::off) return full_route(built, "as the case asks", stage, timing);
  Stopwatch watch;
  stage("symmetry");
  SymmetricView view = symmetric_view(built.model, symmetry);
  watch.lap(timing, "symmetry");
  if (auto* model = std::get_if<CyclicModel>(&view))
    return cyclic_route(built, std::move(*model), stage, timing);
  return full_route(built, std::get<std::string>(view), stage, timing);
}

SymmetricView symmetric_view(const Model& model, Symmetry asked) {
  if (asked == Symmetry::off) return std::string("as the case asks");
  const bool massless = std::any_of(model.shells.begin(), model.shells.end(),
                                    [](const ShellProperties& s) { return s.section.rho == 0; });
  SymmetricView view =
      massless ? "a wall has no density, so most harmonics have no mass" : cyclic_model(model);
  if (const auto* reason = std::get_if<std::string>(&view); reason && asked == Symmetry::required)
    input_error("analyses.symmetry",
                "is required, but the part does not repeat around its axis: " + *reason,
                "mend that, or let symmetry be automatic");
  return view;
}

} // namespace plica
