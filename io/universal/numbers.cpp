#include "io/universal/numbers.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace plica::universal {
namespace {

constexpr std::uint64_t exact_integer = std::uint64_t(1) << 53;

// These are exact in double, so one multiplication or division rounds once (Clinger 1990).
constexpr std::array<double, 23> powers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                        1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                        1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_gap(char c) {
  return c == ' ' || c == '\t' || c == ',' || c == '\r' || c == '\n';
}
bool is_sign(char c) {
  return c == '+' || c == '-';
}

struct Mantissa {
  std::uint64_t digits = 0;
  int used = 0;     // significant digits
  int decimals = 0; // digits behind the point
  bool any = false, point = false;
};

const char* scan_mantissa(const char* p, const char* end, Mantissa& m) {
  for (; p != end; ++p) {
    if (is_digit(*p)) {
      m.any = true;
      if (m.used > 0 || *p != '0') ++m.used;
      if (m.used < 20) m.digits = 10 * m.digits + std::uint64_t(*p - '0');
      m.decimals += m.point;
    } else if (*p == '.' && !m.point) {
      m.point = true;
    } else {
      break;
    }
  }
  return p;
}

// Without a letter, a sign opens an exponent of up to three digits, or the next number.
const char* scan_exponent(const char* p, const char* end, bool point, int& exponent, int& digits) {
  const char* q = p;
  const bool letter = q != end && (*q == 'e' || *q == 'E' || *q == 'd' || *q == 'D');
  if (letter) ++q;
  if (!letter && (!point || q == end || !is_sign(*q))) return p;
  const bool negative = q != end && *q == '-';
  if (q != end && is_sign(*q)) ++q;
  for (; q != end && is_digit(*q); ++q, ++digits)
    exponent = std::min(10 * exponent + (*q - '0'), 100000);
  if (negative) exponent = -exponent;
  const bool taken = letter ? digits > 0 : digits > 0 && digits <= 3 && (q == end || *q != '.');
  if (taken) return q;
  exponent = digits = 0;
  return p;
}

// The rest of all numbers: many digits or far exponents. `magnitude` is the power of ten of the
// first digit; it tells too large (refused) from too small (zero). The largest double, which some
// write for "not known", is read back also where rounding to their digits carried it beyond
// (0.17977+309 of Code_Aster).
bool convert(const char* begin, const char* end, int exponent, int magnitude, double& value) {
  std::string text(begin, end);
  text += 'e' + std::to_string(exponent);
  const auto [last, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (last != text.data() + text.size()) return false;
  if (error == std::errc::result_out_of_range) {
    value = 0;
    if (magnitude <= 0) return true;
    if (magnitude != std::numeric_limits<double>::max_exponent10 + 1) return false;
    constexpr double rounded_up = 1.8e298, lower = 10;
    double less = 0;
    if (!convert(begin, end, exponent - int(lower), magnitude - int(lower), less)) return false;
    value = std::numeric_limits<double>::max();
    return less <= rounded_up;
  }
  return error == std::errc();
}

} // namespace

Scan scan_number(const char*& at, const char* end, ScannedNumber& number) {
  while (at != end && is_gap(*at)) ++at;
  if (at == end) return Scan::end;
  const char* p = at;
  const bool negative = *p == '-';
  if (is_sign(*p)) ++p;
  Mantissa m;
  const char* const first = p;
  p = scan_mantissa(p, end, m);
  if (!m.any) return Scan::bad;
  const char* const last = p;
  int exponent = 0;
  number = {0, m.decimals, 0, !m.point};
  p = scan_exponent(p, end, m.point, exponent, number.exponent_digits);
  if (number.exponent_digits > 0) number.whole = false;
  if (p != end && !is_gap(*p) && !is_sign(*p)) return Scan::bad;
  const int power = exponent - m.decimals;
  if (m.used < 20 && m.digits <= exact_integer && std::abs(power) <= 22) {
    const double digits = double(m.digits);
    number.value =
        power < 0 ? digits / powers[std::size_t(-power)] : digits * powers[std::size_t(power)];
  } else if (m.used > 0 && !convert(first, last, exponent, m.used + power, number.value)) {
    return Scan::bad;
  }
  if (negative) number.value = -number.value;
  at = p;
  return Scan::number;
}

bool is_numeric(std::string_view line) {
  const char* at = line.data();
  const char* const end = at + line.size();
  ScannedNumber number;
  Scan scan = scan_number(at, end, number);
  if (scan != Scan::number) return false;
  while (scan == Scan::number) scan = scan_number(at, end, number);
  return scan == Scan::end;
}

std::vector<std::string_view> tokens(std::string_view line) {
  std::vector<std::string_view> found;
  for (std::size_t i = 0; i < line.size();) {
    while (i < line.size() && is_gap(line[i])) ++i;
    std::size_t j = i;
    while (j < line.size() && !is_gap(line[j])) ++j;
    if (j > i) found.push_back(line.substr(i, j - i));
    i = j;
  }
  return found;
}

std::optional<int> whole_number(std::string_view field) {
  while (!field.empty() && is_gap(field.front())) field.remove_prefix(1);
  while (!field.empty() && is_gap(field.back())) field.remove_suffix(1);
  if (field.size() > 1 && field[0] == '+' && is_digit(field[1])) field.remove_prefix(1);
  int value = 0;
  const auto [last, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || last != field.data() + field.size()) return std::nullopt;
  return value;
}

std::string_view columns(std::string_view line, std::size_t at, std::size_t width) {
  return at < line.size() ? line.substr(at, width) : std::string_view();
}

std::optional<int> whole_columns(std::string_view line, std::size_t at, std::size_t width) {
  const std::string_view field = columns(line, at, width);
  if (std::all_of(field.begin(), field.end(), [](char c) { return c == ' '; })) return 0;
  if (field.size() < width || is_gap(field.back()) || field.find('\t') != std::string_view::npos)
    return std::nullopt;
  return whole_number(field);
}

std::optional<std::vector<int>> whole_numbers(std::string_view line) {
  constexpr std::size_t width = 10; // what is wider is two numbers that touch
  std::vector<int> values;
  const auto all = [&](const std::vector<std::string_view>& fields) {
    values.clear();
    for (std::string_view field : fields) {
      const std::optional<int> value = whole_number(field);
      if (!value || field.size() > width) return false;
      values.push_back(*value);
    }
    return true;
  };
  if (all(tokens(line))) return values;
  std::vector<std::string_view> fields;
  for (std::size_t at = 0; at < line.size(); at += width)
    fields.push_back(columns(line, at, width));
  if (all(fields)) return values;
  return std::nullopt;
}

namespace {

// One number of the field and nothing else.
bool single(std::string_view field, bool whole, double& value) {
  const char* at = field.data();
  const char* const end = at + field.size();
  ScannedNumber number;
  if (scan_number(at, end, number) != Scan::number || (whole && !number.whole)) return false;
  value = number.value;
  return scan_number(at, end, number) == Scan::end;
}

bool in_columns(std::string_view line, std::initializer_list<int> widths, std::size_t wholes,
                std::vector<double>& values) {
  std::size_t at = 0;
  if (line.find('\t') != std::string_view::npos) return false;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const std::size_t width = std::size_t(widths.begin()[i]);
    const std::string_view field = columns(line, at, width);
    if (i < wholes) {
      const std::optional<int> value = whole_columns(line, at, width);
      if (!value) return false;
      values[i] = *value;
    } else if (field.find_first_not_of(' ') == std::string_view::npos) {
      values[i] = 0;
    } else if (!single(field, false, values[i])) {
      return false;
    }
    at += width;
  }
  return line.find_first_not_of(" \r\n", at) == std::string_view::npos;
}

} // namespace

std::optional<std::vector<double>> numeric_record(std::string_view line,
                                                  std::initializer_list<int> widths,
                                                  std::size_t wholes, std::size_t least) {
  std::vector<double> values(widths.size());
  const std::vector<std::string_view> fields = tokens(line);
  if (fields.size() < least && fields.size() < 2) return std::nullopt;
  bool good = fields.size() == widths.size();
  for (std::size_t i = 0; good && i < fields.size(); ++i)
    good = single(fields[i], i < wholes, values[i]);
  if (good || in_columns(line, widths, wholes, values)) return values;
  std::fill(values.begin(), values.end(), 0.);
  const char* at = line.data();
  const char* const end = at + line.size();
  ScannedNumber number;
  std::size_t count = 0;
  Scan scan = scan_number(at, end, number);
  for (; scan == Scan::number; scan = scan_number(at, end, number)) {
    if (count == values.size() || (count < wholes && !number.whole)) return std::nullopt;
    values[count++] = number.value;
  }
  if (scan != Scan::end || count < least) return std::nullopt;
  return values;
}

std::optional<int> data_set_number(std::string_view line) {
  const std::vector<std::string_view> fields = tokens(line);
  if (fields.empty()) return std::nullopt;
  std::string_view field = fields[0];
  if (field.size() > 1 && (field.back() == 'b' || field.back() == 'B')) field.remove_suffix(1);
  const std::optional<int> number = whole_number(field);
  if (!number || *number < 1) return std::nullopt;
  return number;
}

} // namespace plica::universal
