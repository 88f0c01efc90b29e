#include "model/results.hpp"

namespace plica {

std::map<std::string, double> headline(const Results& results) {
  std::map<std::string, double> numbers;
  numbers["mass"] = results.model.mass;
  if (results.statics) numbers["k_axial"] = results.statics->k_axial;
  for (const ModeResult& mode : results.modes) {
    if (mode.shape != "axial" && mode.shape != "transverse" && mode.shape != "torsion") continue;
    const auto [place, is_new] = numbers.try_emplace("f_" + mode.shape, mode.frequency);
    if (!is_new && mode.frequency < place->second) place->second = mode.frequency;
  }
  return numbers;
}

} // namespace plica
