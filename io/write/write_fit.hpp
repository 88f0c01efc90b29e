// What `plica fit` leaves behind: fit.json, fit.csv (parameters), designs.csv, fitted.yaml (paths
// and values to put into the case or a variant), fit.html.
#pragma once

#include "compare/fit/fit.hpp"
#include "io/files/output_folder.hpp"

namespace plica {

std::vector<std::string> fit_files();
void write_fit(const FitResult& fit, const std::string& title, OutputFolder& out);

std::string fitted_yaml(const FitResult& fit);
std::string fit_json(const FitResult& fit, const std::string& title);

// Designs of an earlier fit.json, values of the parameters of this request: its best and, where it
// holds them, its good designs. Throws InputError when the file is none or has other parameters.
std::vector<Eigen::VectorXd> read_designs(const std::string& path, const FitRequest& request);

} // namespace plica
