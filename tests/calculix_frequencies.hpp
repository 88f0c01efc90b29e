// What CalculiX finds for the deck of a whole, unreduced model.
#pragma once

#include "io/decks/write_abaqus.hpp"
#include "model/shape/build.hpp"
#include "tests/run_calculix.hpp"

#include <sstream>
#include <vector>

namespace plica::test {

// Eigenfrequencies in Hz, of what it has printed of a deck.
inline std::vector<double> frequencies_in(const std::string& printed) {
  std::istringstream stream(printed);
  std::vector<double> hertz;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream fields(line);
    double mode = 0, lambda = 0, omega = 0, f = 0, imaginary = 0;
    if (line.find("P A R T I C I P") != std::string::npos) break;
    if (fields >> mode >> lambda >> omega >> f >> imaginary) hertz.push_back(f);
  }
  return hertz;
}

// Of a case; empty where CalculiX is not installed, or breaks off.
inline std::vector<double> calculix_frequencies(const Case& data) {
  return frequencies_in(calculix_output(abaqus_model(data, build(data))));
}

} // namespace plica::test
