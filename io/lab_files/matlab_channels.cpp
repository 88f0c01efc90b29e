#include "io/lab_files/channels.hpp"
#include "io/matlab/matlab_file.hpp"

#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// Where abscissa and values of one function stand.
struct Place {
  std::string abscissa, values;
};

class MatlabChannels {
public:
  explicit MatlabChannels(const ChannelRequest& r) : r_(r), file_(r.path) {}

  ChannelTable read() {
    VectorXd abscissa;
    std::vector<ChannelColumn> columns;
    std::vector<std::string> notes;
    for (const Place& place : places()) {
      at_ = place;
      MatrixXcd values = wanted(at_.values, "values");
      const VectorXd own = abscissa_beside(values);
      if (!values.allFinite() || !own.allFinite())
        bad_channels(r_, "variables", "hold numbers that are not finite", "finite numbers");
      if (columns.empty())
        abscissa = own;
      else if (own.size() != abscissa.size() || !own.isApprox(abscissa, 1e-9))
        bad_channels(r_, "variables", at_.values + " has another abscissa than those before it",
                     "functions over one abscissa, or values that name one of them");
      add(values, columns, notes);
    }
    ChannelTable table = assembled(abscissa, std::move(columns), r_);
    for (const std::string& note : notes) table.warnings.push_back(r_.path.string() + ": " + note);
    return table;
  }

private:
  InputProblem at(const std::string& key) const {
    return {r_.path.string(), 0, r_.key + (r_.key.empty() ? "" : ".") + "variables." + key, "", ""};
  }

  // A function as Simcenter Testlab exports it: a structure with x_values, y_values and
  // function_record. It is named alone; where nothing is named, all of the file are taken.
  bool is_function(const std::string& name) const {
    return file_.has_numbers(name + ".y_values.values");
  }
  static Place place_in(const std::string& name) {
    return {name + ".x_values", name + ".y_values.values"};
  }
  std::vector<Place> places() const {
    const MatlabVariables& v = r_.variables;
    if (!v.values.empty() && v.abscissa.empty() && is_function(v.values))
      return {place_in(v.values)};
    std::vector<Place> all;
    if (v.values.empty())
      for (const std::string& name : file_.names())
        if (is_function(name)) all.push_back(place_in(name));
    return all.empty() ? std::vector<Place>{{v.abscissa, v.values}} : all;
  }

  MatrixXcd wanted(const std::string& name, const char* key) const {
    std::string all;
    for (const std::string& n : file_.names()) all += (all.empty() ? "" : ", ") + n;
    if (name.empty())
      bad_channels(r_, std::string("variables.") + key, "is not given",
                   "a variable of the file: " + all);
    return file_.matrix(name);
  }

  // Turns the values where they lie along the other side.
  VectorXd abscissa_beside(MatrixXcd& values) const {
    if (r_.rate > 0) {
      if (values.cols() > values.rows()) values.transposeInPlace();
      return times_at(r_.rate, values.rows());
    }
    const VectorXd abscissa = abscissa_for(values) * shown_per_stored(at_.abscissa) *
                              abscissa_unit(unit_beside(at_.abscissa), r_, at("abscissa"));
    if (values.rows() != abscissa.size() && values.cols() == abscissa.size())
      values.transposeInPlace();
    if (values.rows() != abscissa.size())
      bad_channels(r_, "variables.values",
                   "has " + std::to_string(values.rows()) + " rows for an abscissa of " +
                       std::to_string(abscissa.size()),
                   "one row for each");
    return abscissa;
  }

  // One number a value: a variable, or a structure that says where it begins and by what it grows,
  // `start_value` (or `start`; else from zero) and `increment`, as Simcenter Testlab writes them.
  VectorXd abscissa_for(const MatrixXcd& values) const {
    const std::string& name = at_.abscissa;
    if (name.empty() || !file_.has_numbers(name + ".increment")) {
      const MatrixXcd x = wanted(name, "abscissa");
      return VectorXcd::Map(x.data(), x.size()).real();
    }
    const auto number = [&](const char* field) {
      const MatrixXcd x = file_.matrix(name + field);
      if (x.size() != 1)
        bad_channels(r_, "variables.abscissa",
                     name + field + " holds " + std::to_string(x.size()) + " numbers", "one");
      return x(0, 0).real();
    };
    double start = 0;
    for (const char* field : {".start", ".start_value"})
      if (file_.has_numbers(name + field)) start = number(field);
    Index count = std::max(values.rows(), values.cols());
    if (file_.has_numbers(name + ".number_of_values")) {
      const double stated = number(".number_of_values");
      if (stated != double(values.rows()) && stated != double(values.cols()))
        bad_channels(r_, "variables.abscissa",
                     "states " + std::to_string(Index(stated)) + " values where " + at_.values +
                         " has " + std::to_string(values.rows()) + " x " +
                         std::to_string(values.cols()),
                     "as many as there are");
      count = Index(stated);
    }
    const double increment = number(".increment");
    return start + increment * VectorXd::LinSpaced(count, 0, double(count - 1)).array();
  }

  static std::string home_of(const std::string& name) {
    const auto point = name.rfind('.');
    return point == std::string::npos ? "" : name.substr(0, point + 1);
  }

  // Text of H_unit or H_units beside H, of run.unit or run.units beside run.H; the label of
  // a quantity.
  std::string unit_beside(const std::string& name) const {
    const std::string home = home_of(name);
    for (const char* ending : {"_unit", "_units"})
      if (const auto text = file_.text_if(name + ending)) return *text;
    if (!home.empty() && name == at_.values)
      for (const char* field : {"unit", "units", "quantity.label"})
        if (const auto text = file_.text_if(home + field)) return *text;
    return file_.text_if(name + ".quantity.label").value_or("");
  }

  // Simcenter Testlab stores numbers in SI ("Data saved by Testlab in MKS") whatever the label of
  // their quantity says, and beside it the factor that makes numbers in the unit of the label.
  double shown_per_stored(const std::string& name) const {
    for (const std::string& home : {name + ".", home_of(name)}) {
      const std::string field = home + "quantity.unit_transformation.factor";
      if (home.empty() || !file_.has_numbers(field)) continue;
      const MatrixXcd factor = file_.matrix(field);
      if (factor.size() == 1 && factor(0, 0).real() > 0) return factor(0, 0).real();
      bad_channels(r_, "variables", field + " is no factor", "a number above zero");
    }
    return 1;
  }

  void add(const MatrixXcd& values, std::vector<ChannelColumn>& columns,
           std::vector<std::string>& notes) const {
    const ColumnUnit unit = column_unit(unit_beside(at_.values), r_, at("values"));
    double factor = unit.factor * shown_per_stored(at_.values);
    constexpr double rounding = 1e-9; // of the factor of the file
    if (std::abs(factor - 1) < rounding) factor = 1;
    for (Index c = 0; c < values.cols(); ++c)
      columns.push_back({"column " + std::to_string(columns.size() + 1), factor * values.col(c),
                         factor, unit.powers, unit.quantity, unit.problem});
    if (!unit.note.empty()) notes.push_back(unit.note);
  }

  const ChannelRequest& r_;
  MatlabReader file_;
  Place at_; // of the function that is read
};

} // namespace

ChannelTable matlab_channels(const ChannelRequest& r) {
  try {
    return MatlabChannels(r).read();
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& e) {
    bad_channels(r, "", e.what(), "a MATLAB file that matio reads");
  }
}

} // namespace plica
