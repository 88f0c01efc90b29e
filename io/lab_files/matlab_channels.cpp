#include "io/lab_files/channels.hpp"
#include "io/matlab/matlab_file.hpp"

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

class MatlabChannels {
public:
  explicit MatlabChannels(const ChannelRequest& r) : r_(r), file_(r.path) {}

  ChannelTable read() {
    MatrixXcd values = wanted(r_.variables.values, "values");
    VectorXd abscissa;
    if (r_.rate > 0) {
      if (values.cols() > values.rows()) values.transposeInPlace();
      abscissa = times_at(r_.rate, values.rows());
    } else {
      abscissa = abscissa_for(values) *
                 abscissa_unit(unit_beside(r_.variables.abscissa), r_, at("abscissa"));
    }
    if (values.rows() != abscissa.size() && values.cols() == abscissa.size())
      values.transposeInPlace();
    if (values.rows() != abscissa.size())
      bad_channels(r_, "variables.values",
                   "has " + std::to_string(values.rows()) + " rows for an abscissa of " +
                       std::to_string(abscissa.size()),
                   "one row for each");
    if (!values.allFinite() || !abscissa.allFinite())
      bad_channels(r_, "variables", "hold numbers that are not finite", "finite numbers");
    return with_units(abscissa, values);
  }

private:
  InputProblem at(const std::string& key) const {
    return {r_.path.string(), 0, r_.key + (r_.key.empty() ? "" : ".") + "variables." + key, "", ""};
  }

  MatrixXcd wanted(const std::string& name, const char* key) const {
    std::string all;
    for (const std::string& n : file_.names()) all += (all.empty() ? "" : ", ") + n;
    if (name.empty())
      bad_channels(r_, std::string("variables.") + key, "is not given",
                   "a variable of the file: " + all);
    return file_.matrix(name);
  }

  // One number a value: a variable, or a structure that says where it begins and by what it grows,
  // `start_value` (or `start`; else from zero) and `increment`, as Simcenter Testlab writes them.
  VectorXd abscissa_for(const MatrixXcd& values) const {
    const std::string& name = r_.variables.abscissa;
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
                     "states " + std::to_string(Index(stated)) + " values where " +
                         r_.variables.values + " has " + std::to_string(values.rows()) + " x " +
                         std::to_string(values.cols()),
                     "as many as there are");
      count = Index(stated);
    }
    const double increment = number(".increment");
    return start + increment * VectorXd::LinSpaced(count, 0, double(count - 1)).array();
  }

  // Text of H_unit or H_units beside H, of run.unit or run.units beside run.H; the label of
  // a quantity.
  std::string unit_beside(const std::string& name) const {
    const auto point = name.rfind('.');
    const std::string home = point == std::string::npos ? "" : name.substr(0, point + 1);
    for (const char* ending : {"_unit", "_units"})
      if (const auto text = file_.text_if(name + ending)) return *text;
    if (!home.empty() && name == r_.variables.values)
      for (const char* field : {"unit", "units", "quantity.label"})
        if (const auto text = file_.text_if(home + field)) return *text;
    return file_.text_if(name + ".quantity.label").value_or("");
  }

  ChannelTable with_units(const VectorXd& abscissa, const MatrixXcd& values) const {
    const ColumnUnit unit = column_unit(unit_beside(r_.variables.values), r_, at("values"));
    std::vector<ChannelColumn> columns;
    for (Index c = 0; c < values.cols(); ++c)
      columns.push_back({"column " + std::to_string(c + 1), unit.factor * values.col(c),
                         unit.factor, unit.powers, unit.quantity, unit.problem});
    ChannelTable table = assembled(abscissa, std::move(columns), r_);
    if (!unit.note.empty()) table.warnings.push_back(r_.path.string() + ": " + unit.note);
    return table;
  }

  const ChannelRequest& r_;
  MatlabReader file_;
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
