#include "io/universal/numbers.hpp"
#include "io/universal/records.hpp"

#include <algorithm>

namespace plica::universal {
namespace {

using Eigen::Index;
using Wanted = Lines::Wanted;

// Record 6; the number of values at each node.
int read_definition(Lines& lines, UniversalShape& s) {
  const std::string record = "record 6";
  next_record(lines, record);
  const std::vector<double> r = numbers_of(lines, record, {10, 10, 10, 10, 10, 10}, 6, 6);
  if (r[4] != 2 && r[4] != 4 && r[4] != 5 && r[4] != 6)
    lines.fail(record, "unknown type of data " + std::to_string(int(r[4])),
               "2 (real) and 5 (complex); 4 and 6 in double precision");
  constexpr int most = 1000; // tensors have 9
  if (r[5] < 1 || r[5] > most)
    lines.fail(record, std::to_string(int(r[5])) + " values per node", "1 to 1000");
  s.model_type = int(r[0]);
  s.analysis = UniversalAnalysisType(int(r[1]));
  s.data_characteristic = int(r[2]);
  s.specific_data_type = int(r[3]);
  s.data_type = UniversalDataType(int(r[4]));
  return int(r[5]);
}

void check_count(const Lines& lines, const std::string& what, std::size_t stated, std::size_t found,
                 UniversalShape& s) {
  if (stated != found)
    s.warnings.push_back({lines.number(), "the number of " + what + " is not the one stated",
                          Index(stated), Index(found)});
}

// Record 7, 8I10; the number of reals in record 8.
std::size_t read_integers(Lines& lines, UniversalShape& s) {
  const std::string record = "record 7";
  constexpr int most = 1000;
  constexpr std::size_t per_line = 8;
  std::vector<int> all;
  std::size_t on_line = per_line, wanted = 2;
  while (all.size() < wanted && on_line == per_line) {
    const auto more = whole_numbers(next_record(lines, record, Wanted::numbers));
    if (!more || more->empty() || (all.empty() && more->size() < 2))
      lines.fail(record, in_quotes(lines.text()) + " is not this record",
                 "number of integers, number of reals, then the integers");
    on_line = more->size();
    all.insert(all.end(), more->begin(), more->end());
    if (all[0] < 0 || all[1] < 0 || all[0] > most || all[1] > most)
      lines.fail(record,
                 std::to_string(all[0]) + " integers and " + std::to_string(all[1]) + " reals",
                 "1 to 10 integers, 1 to 12 reals");
    wanted = 2 + std::size_t(all[0]);
  }
  s.integers.assign(all.begin() + 2, all.end());
  check_count(lines, "integers of record 7", wanted - 2, s.integers.size(), s);
  return std::size_t(all[1]);
}

// Record 8, 6E13.5. It may be missing when it is all zeros.
void read_reals(Lines& lines, std::size_t wanted, UniversalShape& s) {
  const std::string record = "record 8";
  const auto follows = [&] {
    const std::string line = lines.peek();
    return !line.empty() && !is_label(line) && !is_delimiter(line);
  };
  if (wanted == 0 && follows()) lines.next();
  if (!follows()) {
    s.reals.assign(wanted, 0.);
    return;
  }
  while (s.reals.size() < wanted && follows()) {
    next_record(lines, record);
    s.decimals = std::max(s.decimals, append_numbers(lines, record, s.reals));
  }
  check_count(lines, "reals of record 8", wanted, s.reals.size(), s);
}

// Record 10; all zeros when the next label follows at once.
void read_values(Lines& lines, std::size_t wanted, std::vector<double>& values, UniversalShape& s) {
  const std::string record = "record 10";
  const std::size_t before = values.size();
  const auto found = [&] { return values.size() - before; };
  while (found() < wanted) {
    if (!lines.next())
      lines.fail(record,
                 "the file ends inside of the data set; " + std::to_string(found()) + " of " +
                     std::to_string(wanted) + " numbers of node " + std::to_string(s.nodes.back()) +
                     " are there",
                 "a whole file");
    const bool closes = lines.ends_set(Wanted::numbers);
    if (found() == 0 && wanted > 1 && (closes || is_label(lines.text()))) {
      values.resize(before + wanted, 0.);
      lines.back();
      return;
    }
    if (closes) break;
    s.decimals = std::max(s.decimals, append_numbers(lines, record, values));
  }
  if (found() != wanted)
    lines.fail(record,
               "node " + std::to_string(s.nodes.back()) + " has " + std::to_string(found()) +
                   " numbers",
               std::to_string(wanted) + " as record 6 says");
}

} // namespace

UniversalShape read_shape(Lines& lines, const SetHeader& header) {
  UniversalShape s;
  s.line = header.line;
  s.ids = read_ids(lines);
  const Index per_node = read_definition(lines, s);
  read_reals(lines, read_integers(lines, s), s);
  const Index parts = is_complex(s.data_type) ? 2 : 1;
  std::vector<double> values;
  while (next_entry(lines, "record 9", s.warnings)) {
    const auto label = whole_numbers(without_comment(lines.text()));
    if (!label || label->size() != 1)
      lines.fail("record 9", in_quotes(lines.text()) + " is not the label of a node",
                 "one integer");
    s.nodes.push_back(label->front());
    read_values(lines, std::size_t(per_node * parts), values, s);
  }
  constexpr int most_decimals = 16;
  s.decimals = std::min(s.decimals, most_decimals);
  const Index rows = Index(s.nodes.size());
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  using Strided = Eigen::Map<const RowMajor, 0, Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>>;
  const Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic> stride(per_node * parts, parts);
  s.real = Eigen::MatrixXd::Zero(rows, per_node);
  if (parts == 2) s.imaginary = s.real;
  if (rows == 0) return s;
  s.real = Strided(values.data(), rows, per_node, stride);
  if (parts == 2) s.imaginary = Strided(values.data() + 1, rows, per_node, stride);
  return s;
}

} // namespace plica::universal

namespace plica {

std::optional<UniversalNormalMode> normal_mode(const UniversalShape& s) {
  if (s.analysis != UniversalAnalysisType::normal_mode || s.integers.size() < 2 ||
      s.reals.size() < 4)
    return std::nullopt;
  return UniversalNormalMode{s.integers[0], s.integers[1], s.reals[0],
                             s.reals[1],    s.reals[2],    s.reals[3]};
}

std::optional<UniversalComplexMode> complex_mode(const UniversalShape& s) {
  const bool complex = s.analysis == UniversalAnalysisType::complex_eigenvalue_first_order ||
                       s.analysis == UniversalAnalysisType::complex_eigenvalue_second_order;
  if (!complex || s.integers.size() < 2 || s.reals.size() < 6) return std::nullopt;
  return UniversalComplexMode{s.integers[0],
                              s.integers[1],
                              {s.reals[0], s.reals[1]},
                              {s.reals[2], s.reals[3]},
                              {s.reals[4], s.reals[5]}};
}

std::optional<UniversalFrequencyStep> frequency_step(const UniversalShape& s) {
  if (s.analysis != UniversalAnalysisType::frequency_response || s.integers.size() < 2 ||
      s.reals.empty())
    return std::nullopt;
  return UniversalFrequencyStep{s.integers[0], s.integers[1], s.reals[0]};
}

void describe(UniversalShape& s, const UniversalNormalMode& m) {
  s.analysis = UniversalAnalysisType::normal_mode;
  s.integers = {m.load_case, m.mode};
  s.reals = {m.frequency, m.modal_mass, m.viscous_damping, m.hysteretic_damping};
}

void describe(UniversalShape& s, const UniversalComplexMode& m) {
  if (s.analysis != UniversalAnalysisType::complex_eigenvalue_second_order)
    s.analysis = UniversalAnalysisType::complex_eigenvalue_first_order;
  s.integers = {m.load_case, m.mode};
  s.reals = {m.eigenvalue.real(), m.eigenvalue.imag(), m.modal_a.real(),
             m.modal_a.imag(),    m.modal_b.real(),    m.modal_b.imag()};
}

void describe(UniversalShape& s, const UniversalFrequencyStep& step) {
  s.analysis = UniversalAnalysisType::frequency_response;
  s.integers = {step.load_case, step.step};
  s.reals = {step.frequency};
}

} // namespace plica
