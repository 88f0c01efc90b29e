// What `plica diagnose --suppose` leaves behind: supposed.json.
#pragma once

#include "diagnose/results/diagnosis.hpp"
#include "io/files/json_text.hpp"
#include "io/files/output_folder.hpp"

namespace plica {

std::vector<std::string> supposition_files();
void write_supposition(const Ledger& ledger, const std::string& case_name,
                       const std::string& plica_version, OutputFolder& out);

} // namespace plica
