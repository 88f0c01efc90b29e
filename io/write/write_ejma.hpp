// What `plica ejma` leaves behind: ejma.txt as on the terminal, ejma.csv and ejma.json in SI units.
#pragma once

#include "io/files/output_folder.hpp"
#include "run/study/ejma_sheet.hpp"

namespace plica {

std::vector<std::string> ejma_files();
void write_ejma(const std::vector<EjmaSheet>& sheets, const std::string& case_name,
                OutputFolder& out);

std::string ejma_text(const std::vector<EjmaSheet>& sheets);
// One row a number: bellows, group, quantity, meaning, unit, formula, shells, shells/formula, bound
// of a life.
std::string ejma_csv(const std::vector<EjmaSheet>& sheets);
// {"case", "bellows": [{"name", "refused", "curve", "remarks", "lines": [{"group", "quantity",
// "meaning", "unit", "formula", "shells", "ratio", "formula_bound", "shells_bound"}]}]}
std::string ejma_json(const std::vector<EjmaSheet>& sheets, const std::string& case_name);

} // namespace plica
