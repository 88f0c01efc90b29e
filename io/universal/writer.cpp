#include "io/universal/writer.hpp"

#include "io/universal/fields.hpp"
#include "io/universal/lines.hpp"

#include <algorithm>

namespace plica {

using universal::Fields;

namespace {

using Eigen::Index;

constexpr int label_width = 10;

// 8I10
void write_labels(Fields& fields, const std::vector<int>& labels) {
  constexpr std::size_t per_line = 8;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    fields.whole(labels[i], label_width);
    if ((i + 1) % per_line == 0 || i + 1 == labels.size()) fields.end_line();
  }
}

// A label -1 on a line of its own would close the data set.
void check_labels(const Fields& fields, const std::vector<int>& labels) {
  if (std::any_of(labels.begin(), labels.end(), [](int label) { return label < 0; }))
    fields.fail("the label of a node is negative", "0 or more");
}

// 6E13.5, or as many on a line of 80 as wider numbers allow.
void write_reals(Fields& fields, const std::vector<double>& values, int decimals) {
  constexpr int narrow = 13, most_narrow = 6, line = 80;
  const int width = decimals <= most_narrow ? narrow : decimals + 8;
  const std::size_t per_line = std::size_t(line / width);
  for (std::size_t i = 0; i < values.size(); ++i) {
    fields.real(values[i], width, decimals);
    if ((i + 1) % per_line == 0 || i + 1 == values.size()) fields.end_line();
  }
}

void check(const UniversalShape& s, const Fields& fields) {
  const bool complex = is_complex(s.data_type);
  if (s.real.rows() != Index(s.nodes.size()) || s.real.cols() < 1 ||
      s.imaginary.rows() != (complex ? s.real.rows() : 0) ||
      s.imaginary.cols() != (complex ? s.real.cols() : 0))
    fields.fail("nodes, real and imaginary values do not agree",
                "one row for each node, imaginary values only when complex");
}

} // namespace

std::string universal_text(const UniversalShape& s) {
  Fields fields("55", "    55");
  check(s, fields);
  check_labels(fields.record(9), s.nodes);
  for (std::size_t i = 0; i < s.ids.size(); ++i) fields.record(int(i) + 1).id(s.ids[i]);
  fields.record(6);
  for (long value : {long(s.model_type), long(s.analysis), long(s.data_characteristic),
                     long(s.specific_data_type), long(s.data_type), long(s.real.cols())})
    fields.whole(value, label_width);
  std::vector<int> integers{int(s.integers.size()), int(s.reals.size())};
  integers.insert(integers.end(), s.integers.begin(), s.integers.end());
  write_labels(fields.end_line().record(7), integers);
  const int decimals = std::clamp(s.decimals, 5, 16);
  write_reals(fields.record(8), s.reals, decimals);
  std::vector<double> values;
  for (Index i = 0; i < s.real.rows(); ++i) {
    fields.record(9).whole(s.nodes[std::size_t(i)], label_width).end_line();
    values.clear();
    for (Index j = 0; j < s.real.cols(); ++j) {
      values.push_back(s.real(i, j));
      if (s.imaginary.size() > 0) values.push_back(s.imaginary(i, j));
    }
    write_reals(fields.record(10), values, decimals);
  }
  return fields.closed();
}

std::string universal_text(const UniversalNodes& set) {
  Fields fields(set.double_precision ? "2411" : "15", set.double_precision ? "  2411" : "    15");
  for (const UniversalNode& n : set.nodes) {
    fields.record(1).whole(n.label, label_width).whole(n.definition_system, label_width);
    fields.whole(n.displacement_system, label_width).whole(n.colour, label_width);
    if (set.double_precision) fields.end_line().record(2);
    for (double x : n.position) {
      if (set.double_precision)
        fields.real(x, 25, 16, 'D');
      else
        fields.real(x, 13, 5);
    }
    fields.end_line();
  }
  return fields.closed();
}

std::string universal_text(const UniversalElements& set) {
  Fields fields("2412", "  2412");
  for (const UniversalElement& e : set.elements) {
    check_labels(fields, e.nodes);
    if (e.nodes.empty()) fields.fail("an element has no nodes", "1 or more");
    fields.record(1);
    for (long value : {long(e.label), long(e.descriptor), long(e.property), long(e.material),
                       long(e.colour), long(e.nodes.size())})
      fields.whole(value, label_width);
    fields.end_line();
    if (e.beam)
      write_labels(fields.record(2),
                   {e.beam->orientation_node, e.beam->fore_section, e.beam->aft_section});
    write_labels(fields.record(e.beam ? 3 : 2), e.nodes);
  }
  return fields.closed();
}

std::string universal_text(const UniversalTraceline& t) {
  Fields fields("82", "    82");
  fields.record(1).whole(t.number, label_width).whole(long(t.nodes.size()), label_width);
  fields.whole(t.colour, label_width).end_line();
  if (universal::is_delimiter(t.id)) fields.record(2).fail("the id is -1", "a name");
  fields.record(2).id(t.id);
  check_labels(fields.record(3), t.nodes);
  write_labels(fields.record(3), t.nodes);
  return fields.closed();
}

std::string universal_text(const UniversalUnits& u) {
  Fields fields("164", "   164");
  if (u.code < 1) fields.fail("the code of units is " + std::to_string(u.code), "1 to 9");
  fields.record(1).whole(u.code, label_width).name(u.description, 20);
  fields.whole(u.temperature_mode, label_width).end_line().record(2);
  for (double factor : {u.length, u.force, u.temperature}) fields.real(factor, 25, 17, 'D');
  return fields.end_line().real(u.temperature_offset, 25, 17, 'D').end_line().closed();
}

std::string universal_text(const UniversalText& t) {
  return "    -1\n" + t.text + (t.text.ends_with('\n') ? "" : "\n") + "    -1\n";
}

std::string universal_text(const UniversalDataset& set) {
  return std::visit([](const auto& s) { return universal_text(s); }, set);
}

void write_universal(std::ostream& out, const UniversalDataset& set) {
  const std::string text = universal_text(set);
  out.write(text.data(), std::streamsize(text.size()));
}

} // namespace plica
