#include "io/universal/numbers.hpp"
#include "io/universal/records.hpp"
#include "words/short_text.hpp"

#include <algorithm>

namespace plica::universal {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Tokens = std::vector<std::string_view>;

std::string text_of(std::string_view field) {
  return std::string(trimmed(field));
}

std::string joined(const Tokens& fields, std::size_t begin, std::size_t end) {
  std::string text;
  for (std::size_t i = begin; i < end; ++i) (text += i > begin ? " " : "") += fields[i];
  return text;
}

// Record 6 in columns: 2(I5,I10),2(1X,10A1,I10,I4). False when it has been shifted.
bool dof_columns(std::string_view line, UniversalFunction& f) {
  if (line.find('\t') != std::string_view::npos || is_blank(line)) return false;
  std::array<int, 8> whole{};
  constexpr std::array<std::array<std::size_t, 2>, 8> places{
      {{0, 5}, {5, 10}, {15, 5}, {20, 10}, {41, 10}, {51, 4}, {66, 10}, {76, 4}}};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto value = whole_columns(line, places[i][0], places[i][1]);
    if (!value) return false;
    whole[i] = *value;
  }
  for (std::size_t at : {30, 55, 80})
    if (!is_blank(columns(line, at, at == 80 ? line.size() : 1))) return false;
  f.type = FunctionType(whole[0]);
  f.id = whole[1];
  f.version = whole[2];
  f.load_case = whole[3];
  f.response = {text_of(columns(line, 31, 10)), whole[4], whole[5]};
  f.reference = {text_of(columns(line, 56, 10)), whole[6], whole[7]};
  return true;
}

// Record 6 by its tokens. Entity names may hold blanks and digits, so the response ends with the
// last pair of integers that a word follows; without a word there are four integers at the end.
bool dof_tokens(std::string_view line, UniversalFunction& f) {
  const Tokens t = tokens(line);
  const auto whole = [&](std::size_t i) { return whole_number(t[i]).has_value(); };
  const auto value = [&](std::size_t i) { return *whole_number(t[i]); };
  const std::size_t n = t.size();
  if (n < 6 || !whole(0) || !whole(1) || !whole(2) || !whole(3) || !whole(n - 1) || !whole(n - 2))
    return false;
  std::size_t split = 0; // the first token of the reference
  for (std::size_t at = n - 3; at >= 6 && split == 0; --at)
    if (whole(at - 1) && whole(at - 2) && !whole(at)) split = at;
  if (split == 0 && n >= 8 && whole(n - 3) && whole(n - 4)) split = n - 2;
  f.type = FunctionType(value(0));
  f.id = value(1);
  f.version = value(2);
  f.load_case = value(3);
  const std::size_t end = split == 0 ? n : split;
  f.response = {joined(t, 4, end - 2), value(end - 2), value(end - 1)};
  f.reference = {};
  if (split != 0) f.reference = {joined(t, split, n - 2), value(n - 2), value(n - 1)};
  return true;
}

// Label and unit where the columns do not hold: two blanks part them, or the last one.
void label_and_unit(std::string_view rest, UniversalAxis& axis) {
  rest = trimmed(rest);
  std::size_t gap = std::min(rest.find("  "), rest.find('\t'));
  if (gap == std::string_view::npos) gap = rest.rfind(' ');
  axis.label = text_of(rest.substr(0, gap));
  axis.unit = gap == std::string_view::npos ? "" : text_of(rest.substr(gap));
}

// Records 8 to 11: I10,3I5,2(1X,20A1).
UniversalAxis read_axis(Lines& lines, int number) {
  const std::string record = "record " + std::to_string(number);
  const std::string_view line = next_record(lines, record);
  UniversalAxis axis;
  const auto type = whole_columns(line, 0, 10), length = whole_columns(line, 10, 5),
             force = whole_columns(line, 15, 5), temperature = whole_columns(line, 20, 5);
  if (type && length && force && temperature && is_blank(columns(line, 25, 1))) {
    axis = {*type, *length, *force, *temperature, "", "", lines.number()};
    if (is_blank(columns(line, 46, 1)) && line.find('\t') == std::string_view::npos) {
      axis.label = text_of(columns(line, 26, 20));
      axis.unit = text_of(columns(line, 47, 20));
    } else {
      label_and_unit(columns(line, 25, line.size()), axis);
    }
    return axis;
  }
  const Tokens t = tokens(line);
  std::array<int, 4> whole{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto value = i < t.size() ? whole_number(t[i]) : std::nullopt;
    if (!value)
      lines.fail(record, in_quotes(line) + " does not describe an axis",
                 "data type and three exponents of units, label and unit");
    whole[i] = *value;
  }
  axis = {whole[0], whole[1], whole[2], whole[3], "", "", lines.number()};
  label_and_unit(line.substr(std::size_t(t[3].data() + t[3].size() - line.data())), axis);
  return axis;
}

// Record 7; the stated number of points.
Index read_form(Lines& lines, UniversalFunction& f) {
  next_record(lines, "record 7");
  const std::vector<double> r = numbers_of(lines, "record 7", {10, 10, 10, 13, 13, 13}, 3, 3);
  if (r[0] != 2 && r[0] != 4 && r[0] != 5 && r[0] != 6)
    lines.fail("record 7", "unknown type of ordinate data " + std::to_string(int(r[0])),
               "2 and 4 (real, single and double), 5 and 6 (complex)");
  if (r[1] < 0)
    lines.fail("record 7", "the number of values is " + std::to_string(int(r[1])), "0 or more");
  if (r[2] != 0 && r[2] != 1)
    lines.fail("record 7", "unknown spacing " + std::to_string(int(r[2])), "0 uneven, 1 even");
  f.data_type = UniversalDataType(int(r[0]));
  f.even = r[2] == 1;
  f.x0 = r[3];
  f.dx = r[4];
  f.z = r[5];
  return Index(r[1]);
}

// Zeros that only fill the last line are no values; some writers leave them.
bool is_padding(const std::vector<double>& values, std::size_t stated) {
  return values.size() - stated < 6 && std::all_of(values.begin() + std::ptrdiff_t(stated),
                                                   values.end(), [](double v) { return v == 0; });
}

// A file cut inside of its last number: no line end, and a number of another shape than the one
// before it.
bool is_cut(std::string_view last_line) {
  if (last_line.ends_with('\n')) return false;
  const char* at = last_line.data();
  const char* const end = at + last_line.size();
  ScannedNumber number, before;
  int count = 0;
  for (ScannedNumber n; scan_number(at, end, n) == Scan::number; ++count) {
    before = number;
    number = n;
  }
  return count > 1 &&
         (number.decimals != before.decimals || number.exponent_digits != before.exponent_digits);
}

void read_ascii_values(Lines& lines, Index stated, UniversalFunction& f) {
  const std::string record = "record 12";
  const int per_point = numbers_per_point(f);
  const std::size_t wanted = std::size_t(stated) * std::size_t(per_point);
  std::vector<double> values;
  // A number takes two bytes at least, so that a wrong count cannot ask for more than the file has.
  values.reserve(std::min(wanted, std::size_t(lines.remaining() / 2 + 1)));
  int last_stated = 0;
  bool closed = false;
  while (!closed && lines.next()) {
    closed =
        lines.ends_set(values.size() < wanted ? Lines::Wanted::numbers : Lines::Wanted::nothing);
    if (closed) break;
    if (values.size() < wanted) last_stated = lines.number();
    append_numbers(lines, record, values);
    if (values.size() > wanted && lines.number() != last_stated) last_stated = -1;
  }
  const std::string count =
      std::to_string(values.size()) + " of " + std::to_string(wanted) + " numbers are there";
  if (!closed && values.size() < wanted)
    lines.fail(record, "the file ends inside of the data set; " + count, "a whole file");
  if (!closed && is_cut(lines.raw()))
    lines.fail(record, "the file ends inside of a number", "a whole file");
  const Index found = Index(values.size()) / per_point;
  if (values.size() > wanted && last_stated > 0 && is_padding(values, wanted)) {
    f.warnings.push_back({lines.number(), "zeros fill the last line, they are left out", stated,
                          Index(values.size()) / per_point});
    values.resize(wanted);
  } else if (values.size() % std::size_t(per_point) != 0) {
    lines.fail(record, "the last point is not whole; " + count,
               std::to_string(per_point) + " numbers for each point");
  } else if (found != stated) {
    f.warnings.push_back(
        {lines.number(), "the number of points is not the one stated", stated, found});
  }
  take_points(f, values);
}

} // namespace

int numbers_per_point(const UniversalFunction& f) {
  return (is_complex(f.data_type) ? 2 : 1) + (f.even ? 0 : 1);
}

void take_points(UniversalFunction& f, const std::vector<double>& values) {
  using Strided = Eigen::Map<const VectorXd, 0, Eigen::InnerStride<>>;
  const int stride = numbers_per_point(f);
  const Index n = Index(values.size()) / stride;
  const auto part = [&](int at) {
    return VectorXd(Strided(values.data() + at, n, Eigen::InnerStride<>(stride)));
  };
  if (n == 0) return;
  const int first = f.even ? 0 : 1;
  if (!f.even) f.abscissa = part(0);
  f.real = part(first);
  if (is_complex(f.data_type)) f.imaginary = part(first + 1);
}

UniversalFunction read_function(Lines& lines, const SetHeader& header) {
  UniversalFunction f;
  f.line = header.line;
  f.ids = read_ids(lines);
  const std::string_view line = next_record(lines, "record 6");
  if (!dof_columns(line, f) && !dof_tokens(line, f))
    lines.fail("record 6", in_quotes(line) + " does not describe a degree of freedom",
               "type, id, version and load case of the function, then entity, node and direction "
               "of response and reference");
  const Index stated = read_form(lines, f);
  f.abscissa_axis = read_axis(lines, 8);
  f.numerator = read_axis(lines, 9);
  f.denominator = read_axis(lines, 10);
  f.z_axis = read_axis(lines, 11);
  if (tokens(header.text)[0].find_first_of("bB") == std::string_view::npos)
    read_ascii_values(lines, stated, f);
  else
    read_binary_values(lines, header, stated, f);
  return f;
}

} // namespace plica::universal

namespace plica {

Eigen::VectorXd abscissa(const UniversalFunction& f) {
  if (!f.even) return f.abscissa;
  const Eigen::Index n = f.real.size();
  return Eigen::VectorXd::NullaryExpr(n, [&](Eigen::Index k) { return f.x0 + double(k) * f.dx; });
}

} // namespace plica
