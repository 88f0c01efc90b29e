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
      const MatrixXcd x = wanted(r_.variables.abscissa, "abscissa");
      abscissa = VectorXcd::Map(x.data(), x.size()).real() *
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

  // Text of H_unit or H_units beside H, of run.unit or run.units beside run.H.
  std::string unit_beside(const std::string& name) const {
    const auto point = name.rfind('.');
    const std::string home = point == std::string::npos ? "" : name.substr(0, point + 1);
    for (const char* ending : {"_unit", "_units"})
      if (const auto text = file_.text_if(name + ending)) return *text;
    if (!home.empty() && name == r_.variables.values)
      for (const char* field : {"unit", "units"})
        if (const auto text = file_.text_if(home + field)) return *text;
    return "";
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
