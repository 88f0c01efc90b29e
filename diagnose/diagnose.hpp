// Diagnosis of the gap between a case and its test (docs/diagnosis.md).
#pragma once

#include "diagnose/readings/readings.hpp"
#include "diagnose/results/diagnosis.hpp"
#include "diagnose/results/settings.hpp"
#include "model/description/case.hpp"

namespace plica {

// Throws InputError as build() does, and with a key of the test when that has nothing that the
// model answers.
Diagnosis diagnose(const Case& data, const TestData& test, const DiagnosisSettings& settings);

} // namespace plica
