// Words and numbers that the summary, the tables and the report share, so that all say the same.
#pragma once

#include "run/results/results.hpp"

#include <string>
#include <vector>

namespace plica {

// "axial 1", "transverse 1 in x", "torsion 2", "shell n=3 m=1" (n waves around, m half waves
// along), "rigid in z"; what is not counted is left out. "transverse 1 in x (bracket)" where
// several modes would be called the same.
std::string mode_label(const ModeResult& mode);

// `digits` significant digits, and never fewer than the integer ones: 54365, 116.2, 2.1e-09.
// "-" for what is not finite.
std::string significant(double value, int digits);

// To this many significant digits: 12972 gives 13000.
double rounded(double value, int digits);

// Digits after the point that show `value` with `digits` significant ones; for whole columns.
int decimals_for(double value, int digits);

// With a sign and a fixed number of decimals: "+3.2"; "0.0" has none. "-" for what is not finite.
std::string with_sign(double value, int decimals);

// Thousands apart: 125856 gives "125 856" with the separator " ".
std::string grouped(long long value, const std::string& separator);

// "height 95 %, plies 5 %": paths of the tolerances with at least 1 % of the variance, largest
// first.
std::string shares_text(const ErrorBars& errors, const ErrorBar& bar);

// "y", or "force_tap": what the files of a response are named after.
std::string response_name(const ResponseResult& response);

// "Base moved in y", "Force tap"
std::string response_title(const ResponseResult& response);

// "m/s2 per N"; of several inputs together "m/s2".
std::string response_unit(const ResponseResult& response, const std::string& of);

// Lowest and highest value of a compared quantity over the nominal run and the variants.
std::array<double, 2> spread_over_variants(const Results& results, const MeasuredComparison& row);

// Headline numbers of the part without a state; empty where it was not run.
std::map<std::string, double> headline_at_rest(const Results& results);

// Throws std::invalid_argument when a mode shape has not one row of translations per mesh node.
void require_one_row_per_node(const Results& results);

// What the mesh (and the cut-off) still misses of a number, in percent with its sign; "-" where it
// is not known.
std::string mesh_error_percent(double value, const MeshError& error);
// Of a mode; "-" also for a rigid one.
std::string mesh_error_percent(const ModeResult& mode, const MeshError& error);

// Unit of a static stiffness by its place in stiffness_names.
std::string stiffness_unit(std::size_t which);

// The proof of completeness as one plain sentence, its verdict and the rest; numbers as `number`
// writes them.
struct ProofWords {
  std::string verdict, rest; // "Proved", ", no mode is missing: ..."
};
ProofWords proof_words(const Verification& verification,
                       std::string (*number)(double value, int digits) = significant);

struct ShownUnit {
  double factor = 1; // shown number = SI number * factor
  std::string unit;
};

// Stiffness from 10 000 N/m (Nm/rad) on is shown in kN/m (kNm/rad); all else as it is.
ShownUnit shown_unit(double value, const std::string& unit);

struct HeadlineQuantity {
  std::string key, name, unit; // "k_axial", "axial stiffness", "N/m"
};

// Every headline quantity that the nominal results or a variant have, stiffness first, mass last.
std::vector<HeadlineQuantity> headline_quantities(const Results& results);

// Decimals of a measured value in the unit shown: four digits, and always the first of its sigma.
int decimals_of(const MeasuredComparison& row, double factor);

double relative_deviation(const MeasuredComparison& row); // computed / measured - 1
double sigma_deviation(const MeasuredComparison& row);    // (computed - measured) / sigma

} // namespace plica
