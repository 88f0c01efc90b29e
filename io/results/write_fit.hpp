// What `plica fit` leaves behind: fit.json, fit.csv (parameters), designs.csv, fitted.yaml (paths
// and values to put into the case or a variant), fit.html.
#pragma once

#include "diagnose/fit.hpp"
#include "io/output/output_folder.hpp"

namespace plica {

std::vector<std::string> fit_files();
void write_fit(const FitResult& fit, const std::string& title, OutputFolder& out);

std::string fit_text(const FitResult& fit);
std::string fitted_yaml(const FitResult& fit);
std::string fit_json(const FitResult& fit, const std::string& title);

// "at most 0.065", "1.2 to 1.4"
std::string constraint_limits(const FittedConstraint& constraint);

// "a joint change of a (0.71) and b (-0.70): 0.3 sigma over the whole range of the bounds"
std::string open_text(const OpenDirection& open);

// Designs of an earlier fit.json, values of the parameters of this request: its best and, where it
// holds them, its good designs. Throws InputError when the file is none or has other parameters.
std::vector<Eigen::VectorXd> read_designs(const std::string& path, const FitRequest& request);

} // namespace plica
