#include "run/routes/symmetric_view.hpp"

#include "words/input_error.hpp"

#include <algorithm>

namespace plica {

SymmetricView symmetric_view(const Model& model, Symmetry asked) {
  if (asked == Symmetry::off) return std::string("as the case asks");
  const bool massless = std::any_of(model.shells.begin(), model.shells.end(),
                                    [](const ShellProperties& s) { return s.section.rho == 0; });
  SymmetricView view = massless ? "a wall has no density of its own, so most harmonics have no mass"
                                : cyclic_model(model);
  if (const auto* reason = std::get_if<std::string>(&view); reason && asked == Symmetry::required)
    input_error("analyses.symmetry",
                "is required, but the part does not repeat around its axis: " + *reason,
                "mend that, or let symmetry be automatic");
  return view;
}

} // namespace plica
