#include "io/write/write_stiffness.hpp"

#include "io/report/stiffness.hpp"
#include "io/superelements/connector_tables.hpp"
#include "io/superelements/stiffness_hdf5.hpp"
#include "io/tables/stiffness_words.hpp"
#include "io/universal/writer.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plica {
namespace {

namespace fs = std::filesystem;

// Even steps need no list of frequencies.
void set_abscissa(UniversalFunction& f, const Eigen::VectorXd& hertz) {
  const double step = hertz.size() > 1 ? hertz[1] - hertz[0] : 1;
  f.x0 = hertz[0];
  f.dx = step;
  for (Eigen::Index k = 0; k < hertz.size(); ++k)
    f.even = f.even && std::abs(hertz[k] - (hertz[0] + double(k) * step)) < 1e-9 * (1 + hertz[k]);
  if (!f.even) {
    f.abscissa = hertz;
    f.x0 = f.dx = 0;
  }
}

// One term of one level: force on a coordinate by the motion of another. Ends are nodes 1 and 2.
UniversalFunction function_of(const EndDynamicStiffness& s, const StateStiffness& state,
                              std::size_t level, int row, int column) {
  UniversalFunction f;
  f.ids[0] = s.case_name.substr(0, 80);
  f.ids[1] = "Dynamic stiffness, " + level_name(state.over.levels[level]);
  f.ids[2] = state.name.substr(0, 80);
  f.type = FunctionType::frequency_response;
  f.load_case = int(level);
  const auto dof = [&](int c) {
    return UniversalDof{state.part.names[std::size_t(c / 6)].substr(0, 10), c / 6 + 1, c % 6 + 1};
  };
  f.response = dof(row);
  f.reference = dof(column);
  f.data_type = UniversalDataType::complex_double;
  set_abscissa(f, state.over.hertz);
  f.z = column % 6 < 3 ? state.over.levels[level].translation : state.over.levels[level].rotation;
  f.abscissa_axis = {.data_type = 18, .label = "Frequency", .unit = "Hz"};
  f.numerator = {.data_type = 13,
                 .length = row % 6 < 3 ? 0 : 1,
                 .force = 1,
                 .label = row % 6 < 3 ? "Force" : "Moment",
                 .unit = row % 6 < 3 ? "N" : "Nm"};
  f.denominator = {.data_type = 8,
                   .length = column % 6 < 3 ? 1 : 0,
                   .label = column % 6 < 3 ? "Displacement" : "Rotation",
                   .unit = column % 6 < 3 ? "m" : "rad"};
  const auto& at = state.over.at[level];
  f.real.resize(Eigen::Index(at.size()));
  f.imaginary.resize(f.real.size());
  for (std::size_t k = 0; k < at.size(); ++k) {
    f.real[Eigen::Index(k)] = at[k](row, column).real();
    f.imaginary[Eigen::Index(k)] = at[k](row, column).imag();
  }
  return f;
}

// A motion that was not found has no number; its functions are left away.
std::string universal_stiffness(const EndDynamicStiffness& s) {
  UniversalUnits units;
  units.description = "SI";
  std::string text = universal_text(units);
  const auto terms = terms_of(s);
  for (const StateStiffness& state : s.states)
    for (std::size_t level = 0; level < state.over.levels.size(); ++level)
      for (const auto& [row, column] : terms) {
        const UniversalFunction f = function_of(s, state, level, row, column);
        if (f.real.allFinite() && f.imaginary.allFinite()) text += universal_text(f);
      }
  return text;
}

} // namespace

std::vector<std::string> stiffness_files(bool measured) {
  std::vector<std::string> names{"stiffness.html",       "stiffness.csv", "transfer_stiffness.csv",
                                 "stiffness.uff",        "stiffness.h5",  "connector_abaqus.inp",
                                 "connector_nastran.bdf"};
  if (measured) names.emplace_back("stiffness_comparison.csv");
  return names;
}

void write_stiffness(const EndDynamicStiffness& s, const std::vector<StiffnessComparison>& compared,
                     bool millimetres, OutputFolder& out) {
  out.add("stiffness.csv", stiffness_csv(s));
  out.add("transfer_stiffness.csv", transfer_stiffness_csv(s));
  if (!compared.empty()) out.add("stiffness_comparison.csv", stiffness_comparison_csv(compared));
  out.add("stiffness.uff", universal_stiffness(s));
  out.add_by("stiffness.h5", [&](const fs::path& file) { write_stiffness_hdf5(s, file); });
  out.add("connector_abaqus.inp", abaqus_connector(s, millimetres));
  out.add("connector_nastran.bdf", nastran_bush(s, millimetres));
  out.add("stiffness.html", stiffness_report(s, compared));
}

} // namespace plica
