// What `plica diagnose --pretest` leaves behind: pretest.json and report.html.
#pragma once

#include "diagnose/pretest.hpp"

#include <filesystem>
#include <string>

namespace plica {

void write_pretest(const Pretest& p, const std::string& title, const std::string& plica_version,
                   const std::filesystem::path& folder);

std::string pretest_text(const Pretest& p);

} // namespace plica
