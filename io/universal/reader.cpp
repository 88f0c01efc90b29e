#include "io/universal/reader.hpp"

#include "io/universal/numbers.hpp"
#include "io/universal/records.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

namespace plica {

using namespace universal;

namespace {

struct Opening {
  SetHeader header;
  bool exact_columns = true;
  bool delimiter = true; // false: the -1 before the number is missing
};

bool is_known(int number) {
  constexpr std::array known{15, 55, 58, 82, 151, 164, 781, 2411, 2412};
  return std::find(known.begin(), known.end(), number) != known.end();
}

// A number and nothing else, as data sets open.
bool is_bare_number(std::string_view line) {
  const auto number = data_set_number(line);
  const std::size_t fields = tokens(line).size();
  return number && is_known(*number) && (fields == 1 || (*number == 58 && fields >= 5));
}

Opening opened(const Lines& lines, int line, bool exact, bool delimiter) {
  return {{line, *data_set_number(lines.text()), std::string(lines.text())}, exact, delimiter};
}

// The -1 and the number of the next data set, text before it passed over. Where a data set was not
// closed, the -1 of the next one closed it, and a number stands here without.
std::optional<Opening> next_opening(Lines& lines) {
  bool first = true, inside = false, exact = true;
  int line = 0;
  while (lines.next()) {
    if (is_blank(lines.text())) continue;
    if (is_delimiter(lines.text())) {
      inside = true;
      exact = is_exact_delimiter(lines.text());
      line = lines.number();
    } else if (inside) {
      if (!data_set_number(lines.text()))
        lines.fail("", in_quotes(lines.text()) + " follows the -1 that opens a data set",
                   "the number of a data set");
      return opened(lines, line, exact, true);
    } else if (first && is_bare_number(lines.text())) {
      return opened(lines, lines.number(), true, false);
    } else {
      first = false;
    }
  }
  return std::nullopt;
}

UniversalDataset read_set(Lines& lines, const SetHeader& header) {
  switch (header.number) {
  case 58:
    return read_function(lines, header);
  case 55:
    return read_shape(lines, header);
  case 15:
  case 781:
  case 2411:
    return read_nodes(lines, header);
  case 2412:
    return read_elements(lines, header);
  case 82:
    return read_traceline(lines, header);
  case 164:
    return read_units(lines, header);
  default:
    return read_text(lines, header);
  }
}

} // namespace

UniversalReader::UniversalReader(const std::filesystem::path& path)
    : lines_(std::make_unique<Lines>(path)) {}

UniversalReader::UniversalReader(std::unique_ptr<Lines> lines) : lines_(std::move(lines)) {}

UniversalReader::~UniversalReader() = default;
UniversalReader::UniversalReader(UniversalReader&&) noexcept = default;
UniversalReader& UniversalReader::operator=(UniversalReader&&) noexcept = default;

UniversalReader UniversalReader::of_text(std::string text, std::string name) {
  const std::uint64_t size = text.size();
  return UniversalReader(std::make_unique<Lines>(
      std::make_unique<std::istringstream>(std::move(text)), size, std::move(name)));
}

std::optional<UniversalDataset> UniversalReader::next() {
  if (!lines_) return std::nullopt;
  auto lines = std::move(lines_); // given back unless an error is thrown
  lines->begin_set("", true);
  const std::optional<Opening> opening = next_opening(*lines);
  if (!opening) {
    if (!found_) lines->fail_at(0, "", "there is no data set", "data sets between lines of -1");
    return std::nullopt;
  }
  const SetHeader& header = opening->header;
  const std::string name =
      header.number == 58 ? std::string(tokens(header.text)[0]) : std::to_string(header.number);
  lines->begin_set(name, opening->exact_columns);
  UniversalDataset set = read_set(*lines, header);
  if (!opening->delimiter) {
    UniversalWarning missing{header.line, "the -1 before the data set is missing", 0, 0};
    std::visit([&](auto& s) { s.warnings.push_back(missing); }, set);
  }
  found_ = true;
  lines_ = std::move(lines);
  return set;
}

std::vector<UniversalDataset> read_universal(const std::filesystem::path& path) {
  std::vector<UniversalDataset> sets;
  UniversalReader reader(path);
  while (std::optional<UniversalDataset> set = reader.next()) sets.push_back(std::move(*set));
  return sets;
}

} // namespace plica
