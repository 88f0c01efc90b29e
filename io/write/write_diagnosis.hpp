// What `plica diagnose` leaves behind: diagnosis.json, diagnosis_ledger.csv,
// diagnosis_readings.csv, diagnosis_hypotheses.csv, diagnosis_where.csv, diagnosis.html. SI units,
// Hz; in the ledger the unit that stands beside a number.
#pragma once

#include "diagnose/results/diagnosis.hpp"
#include "io/files/json_text.hpp"
#include "io/files/output_folder.hpp"

namespace plica {

std::vector<std::string> diagnosis_files();
void write_diagnosis(const Diagnosis& d, const std::string& title, const std::string& plica_version,
                     OutputFolder& out);

// Effects, how alike they are, mimics, and the smallest that would be found.
Json identifiability_json(const Diagnosis& d);
Json ledger_json(const Ledger& ledger);
std::string diagnosis_json(const Diagnosis& d, const std::string& plica_version);

} // namespace plica
