#include "io/lab_files/universal_results.hpp"

#include "io/universal/numbers.hpp"
#include "words/input_error.hpp"

#include <sstream>

namespace plica {
namespace {

class Results2414 {
public:
  Results2414(const UniversalText& set, const std::string& file)
      : file_(file), line_number_(set.line), stream_(set.text) {
    next();
  }

  std::optional<UniversalShape> shape() {
    s_.line = line_number_ - 1;
    next(); // label
    next(); // name
    s_.ids[0] = line_;
    constexpr int at_nodes = 1;
    if (whole(1)[0] != at_nodes) return std::nullopt;
    for (std::size_t k = 0; k < 5; ++k) {
      next();
      if (k > 0) s_.ids[k] = line_;
    }
    const std::vector<int> what = whole(6), ids = whole(6);
    s_.model_type = what[0];
    s_.analysis = UniversalAnalysisType(what[1]);
    s_.data_characteristic = what[2];
    s_.specific_data_type = what[3];
    s_.data_type = UniversalDataType(what[4]);
    if (what[4] < 1 || what[4] > 6 || what[5] < 1 || what[5] > 1000)
      fail("type of data or values per node are not those of the standard");
    next(); // creation
    const std::vector<double> first = numbers(6), second = numbers(6);
    if (s_.analysis == UniversalAnalysisType::normal_mode)
      describe(s_, UniversalNormalMode{ids[4], ids[5], first[1], first[3], first[4], first[5]});
    else
      describe(s_, UniversalComplexMode{
                       ids[4], ids[5], {second[0], second[1]}, {second[2], second[3]}, {}});
    s_.analysis = UniversalAnalysisType(what[1]);
    read_nodes(what[5]);
    return std::move(s_);
  }

private:
  void read_nodes(int per_node) {
    const int parts = is_complex(s_.data_type) ? 2 : 1;
    std::vector<double> values;
    while (next()) {
      std::istringstream fields(line_);
      int node = 0;
      if (!(fields >> node)) fail("'" + line_ + "' is no label of a node");
      s_.nodes.push_back(node);
      std::size_t wanted = values.size() + std::size_t(per_node * parts);
      while (values.size() < wanted) {
        const std::vector<double> more = numbers(1);
        values.insert(values.end(), more.begin(), more.end());
      }
      if (values.size() != wanted) fail("a node has more numbers than the set says");
    }
    const auto rows = Eigen::Index(s_.nodes.size());
    s_.real.resize(rows, per_node);
    if (parts == 2) s_.imaginary.resize(rows, per_node);
    for (Eigen::Index i = 0; i < rows; ++i)
      for (int j = 0; j < per_node; ++j) {
        const auto at = std::size_t((i * per_node + j) * parts);
        s_.real(i, j) = values[at];
        if (parts == 2) s_.imaginary(i, j) = values[at + 1];
      }
  }

  bool next() {
    ++line_number_;
    if (!std::getline(stream_, line_)) return false;
    while (!line_.empty() && (line_.back() == '\r' || line_.back() == ' ')) line_.pop_back();
    const auto first = line_.find_first_not_of(' ');
    return first == std::string::npos || line_.substr(first) != "-1";
  }
  std::vector<double> numbers(std::size_t least) {
    if (!next()) fail("ends early");
    std::vector<double> list;
    const char* at = line_.data();
    const char* const end = at + line_.size();
    universal::ScannedNumber number;
    universal::Scan scan = universal::scan_number(at, end, number);
    for (; scan == universal::Scan::number; scan = universal::scan_number(at, end, number))
      list.push_back(number.value);
    if (list.size() < least || scan != universal::Scan::end)
      fail("'" + line_ + "' does not hold " + std::to_string(least) + " numbers");
    return list;
  }
  std::vector<int> whole(std::size_t least) {
    if (!next()) fail("ends early");
    std::istringstream fields(line_);
    std::vector<int> list;
    for (int x = 0; fields >> x;) list.push_back(x);
    if (list.size() < least || !fields.eof())
      fail("'" + line_ + "' does not hold " + std::to_string(least) + " whole numbers");
    return list;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError({{file_, line_number_, "data set 2414", what, "results at nodes, whole"}});
  }

  std::string file_, line_;
  int line_number_;
  std::istringstream stream_;
  UniversalShape s_;
};

} // namespace

std::optional<UniversalShape> shape_of_results(const UniversalText& set, const std::string& file) {
  return Results2414(set, file).shape();
}

} // namespace plica
