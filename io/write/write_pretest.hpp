// What `plica diagnose --pretest` leaves behind: pretest.json and pretest.html.
#pragma once

#include "diagnose/pretest.hpp"
#include "io/files/output_folder.hpp"

namespace plica {

std::vector<std::string> pretest_files();
void write_pretest(const Pretest& p, const std::string& title, const std::string& plica_version,
                   OutputFolder& out);

std::string pretest_text(const Pretest& p);

} // namespace plica
