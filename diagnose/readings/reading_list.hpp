// The list that readings are collected in.
#pragma once

#include "diagnose/readings/reading.hpp"
#include "lab/measured/entries.hpp"

namespace plica {

class ReadingList {
public:
  explicit ReadingList(const Measured& measured) : measured_(measured) {}

  // With its logarithm, unless it is a cross response, whether it is held out, and its state in its
  // name. What is not above zero is left out, unless it is a component of a shape.
  void add(Reading reading);

  TestReadings all;

private:
  const Measured& measured_;
};

std::string at_level(const TestRun& run); // ", 5 m/s2"; empty for zero
// "at mid in y, base y, 5 m/s2": where the peaks of a response are seen.
std::string where_seen(const TestRun& run);

} // namespace plica
