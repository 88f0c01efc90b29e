// Record 12 of data set 58b. Its line of the number: 58, b, byte order, floating point format,
// number of ASCII lines, number of bytes (I6,A1,2I6,2I12). The numbers are interleaved as in the
// ASCII form. By the standard an uneven abscissa is single; some writers make it double, and some
// state a number of bytes that is not theirs. The closing -1 behind the data tells who is right.
#include "io/universal/numbers.hpp"
#include "io/universal/records.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace plica::universal {
namespace {

using Eigen::Index;

constexpr const char* record = "record 12";

struct Form {
  UniversalByteOrder order = UniversalByteOrder::little_endian;
  std::uint64_t bytes = 0;
};

Form read_form(const Lines& lines, const SetHeader& header) {
  const auto fail = [&](const std::string& wrong, const std::string& allowed) {
    lines.fail_at(header.line + 1, "record 0", wrong, allowed);
  };
  const std::string_view rest =
      std::string_view(header.text).substr(header.text.find_first_of("bB") + 1);
  const auto r = numeric_record(rest, {6, 6, 12, 12, 6, 6, 12, 12}, 8, 4);
  if (!r)
    fail(in_quotes(header.text) + " does not describe binary data",
         "58b, byte order, floating point format, ASCII lines, bytes");
  const std::vector<double>& v = *r;
  constexpr double most = 1e15;
  if (std::any_of(v.begin(), v.end(), [](double x) { return std::abs(x) > most; }))
    fail(in_quotes(header.text) + " has a number beyond all files", "at most 1e15");
  if (v[0] != 1 && v[0] != 2)
    fail("unknown byte order " + std::to_string(std::int64_t(v[0])),
         "1 little endian, 2 big endian");
  if (v[1] != 2) {
    const std::string name = v[1] == 1   ? "the DEC VMS floating point format"
                             : v[1] == 3 ? "the IBM 5/370 floating point format"
                                         : "an unknown floating point format";
    fail(name + " is not supported", "2, IEEE 754: export the file again in it, or as ASCII");
  }
  if (v[2] != 11 && v[2] != 0)
    fail("the number of ASCII lines is " + std::to_string(std::int64_t(v[2])), "11");
  if (v[3] < 0) fail("the number of bytes is negative", "0 or more");
  return {UniversalByteOrder(int(v[0])), std::uint64_t(v[3])};
}

struct Layout {
  int abscissa = 0, ordinate = 0, ordinates = 1; // bytes, bytes of each, how many
  std::uint64_t stride() const {
    return std::uint64_t(abscissa) + std::uint64_t(ordinate) * std::uint64_t(ordinates);
  }
};

std::vector<Layout> layouts(const UniversalFunction& f) {
  const int ordinate = is_double(f.data_type) ? 8 : 4, parts = is_complex(f.data_type) ? 2 : 1;
  if (f.even) return {{0, ordinate, parts}};
  return {{4, ordinate, parts}, {8, ordinate, parts}};
}

struct Block {
  Layout layout;
  std::uint64_t bytes = 0;
};

// How the data lie between header and -1: by the stated points with either abscissa, else by the
// stated bytes when only one abscissa divides them.
Block find_block(Lines& lines, std::uint64_t stated_bytes, std::uint64_t stated_points,
                 const UniversalFunction& f) {
  const std::vector<Layout> all = layouts(f);
  const int line = lines.number() + 1; // where the data begin
  for (const Layout& layout : all) {
    const std::uint64_t bytes = stated_points * layout.stride();
    if (lines.closes_behind(bytes)) return {layout, bytes};
  }
  const std::string allowed = "as many bytes as the header says, then -1";
  if (lines.closes_behind(stated_bytes)) {
    const auto fits = [&](const Layout& l) { return stated_bytes % l.stride() == 0; };
    const auto first = std::find_if(all.begin(), all.end(), fits);
    if (first != all.end() && std::count_if(all.begin(), all.end(), fits) == 1)
      return {*first, stated_bytes};
    lines.fail_at(line, record,
                  std::to_string(stated_bytes) + " bytes are not " + std::to_string(stated_points) +
                      " points, nor whole points of one kind",
                  "a number of points that fits to the number of bytes");
  }
  const std::uint64_t least = stated_points * all[0].stride();
  if (lines.remaining() < std::max(least, stated_bytes))
    lines.fail_at(line, record,
                  "the file ends inside of the data set; " +
                      std::to_string(lines.remaining() / all[0].stride()) + " of " +
                      std::to_string(stated_points) + " points are there",
                  "a whole file");
  lines.fail_at(line, record,
                "no -1 follows behind " + std::to_string(stated_bytes) + " bytes or " +
                    std::to_string(stated_points) + " points",
                allowed);
}

template <class Float> double decode(const char* at, bool swap) {
  std::array<char, sizeof(Float)> bytes;
  std::memcpy(bytes.data(), at, sizeof(Float));
  if (swap) std::reverse(bytes.begin(), bytes.end());
  return double(std::bit_cast<Float>(bytes));
}

} // namespace

void read_binary_values(Lines& lines, const SetHeader& header, Index stated, UniversalFunction& f) {
  const Form form = read_form(lines, header);
  const Block block = find_block(lines, form.bytes, std::uint64_t(stated), f);
  const int line = lines.number() + 1;
  const std::string data = lines.bytes(block.bytes);
  const bool swap = (form.order == UniversalByteOrder::little_endian) !=
                    (std::endian::native == std::endian::little);
  const auto number = [&](std::size_t at, int width) {
    return width == 4 ? decode<float>(data.data() + at, swap)
                      : decode<double>(data.data() + at, swap);
  };
  std::vector<double> values;
  const Index points = Index(block.bytes / block.layout.stride());
  values.reserve(std::size_t(points * numbers_per_point(f)));
  for (std::size_t at = 0; at < data.size();) {
    if (block.layout.abscissa > 0) {
      values.push_back(number(at, block.layout.abscissa));
      at += std::size_t(block.layout.abscissa);
    }
    for (int k = 0; k < block.layout.ordinates; ++k, at += std::size_t(block.layout.ordinate))
      values.push_back(number(at, block.layout.ordinate));
  }
  const auto bad =
      std::find_if_not(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  if (bad != values.end())
    lines.fail_at(line, record,
                  "number " + std::to_string(bad - values.begin() + 1) + " is NaN or infinite",
                  "finite numbers; is the byte order right?");
  if (points != stated)
    f.warnings.push_back({line, "the number of points is not the one stated", stated, points});
  if (block.bytes != form.bytes)
    f.warnings.push_back(
        {line, "the number of bytes is not the one stated", Index(form.bytes), Index(block.bytes)});
  f.binary = UniversalBinaryForm{form.order, UniversalFloatFormat::ieee,
                                 f.even ? 4 : block.layout.abscissa};
  take_points(f, values);
  while (lines.next() && !lines.ends_set(Lines::Wanted::nothing)) {
  }
}

} // namespace plica::universal
