// A model that has no answer, through no fault of the program: nothing has mass, a mechanism, a
// degree of freedom without stiffness and mass, a stiffness that is not positive. Says why in the
// words of the model, and which sections of a case are likely to hold the cause.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace plica {

struct ModelError : std::runtime_error {
  explicit ModelError(const std::string& what, std::vector<std::string> in = {"parts"})
      : std::runtime_error(what), sections(std::move(in)) {}

  std::vector<std::string> sections; // the first that a case has is where to look
};

} // namespace plica
