#include "words/tolerance.hpp"

#include "words/did_you_mean.hpp"
#include "words/short_text.hpp"

#include <charconv>

namespace plica {
namespace {

constexpr const char* how = "write 8 mm +- 1 mm, 193 GPa +- 5 %, or 3 kN [0.3, 30]";

// What follows the number at the start.
std::string unit_of(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double ignored = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), ignored);
  if (status != std::errc()) return "";
  return std::string(trimmed(text.substr(static_cast<std::size_t>(end - text.data()))));
}

class Parser {
public:
  Parser(std::string_view text, Dimension dimension) : text_(text), dimension_(dimension) {}

  TolerancedQuantity parse() {
    for (const std::string_view sign : {std::string_view("+-"), std::string_view("±")})
      if (const std::size_t at = text_.find(sign); at != std::string_view::npos)
        return around(text_.substr(0, at), trimmed(text_.substr(at + sign.size())));
    if (const std::size_t at = text_.find('['); at != std::string_view::npos && at > 0)
      return between(text_.substr(0, at), trimmed(text_.substr(at)));
    return {.value = parse_quantity(text_, dimension_), .limits = {}};
  }

private:
  TolerancedQuantity wrong(const std::string& what) const {
    return {.value = {0, "'" + shown(text_) + "' " + what, how}, .limits = {}};
  }

  // A number of the tolerance.
  ParsedQuantity limit(std::string_view text, const std::string& unit) const {
    if (trimmed(text).empty())
      return {0, "'" + shown(text_) + "' has no number in its tolerance", how};
    const std::string own = unit_of(text);
    return parse_quantity(std::string(text) + (own.empty() ? " " + unit : ""), dimension_);
  }

  TolerancedQuantity around(std::string_view left, std::string_view right) const {
    const ParsedQuantity value = parse_quantity(left, dimension_);
    if (!value.wrong.empty()) return {.value = value, .limits = {}};
    const std::string unit = unit_of(left), own = unit_of(right);
    ParsedQuantity half;
    if (own == "%" && dimension_ != Dimension::ratio) {
      half = parse_quantity(right, Dimension::ratio);
      half.value *= std::abs(value.value);
    } else if (unit.empty() && !own.empty()) {
      return wrong("has a unit behind its tolerance and none behind its value");
    } else {
      half = limit(right, unit);
    }
    if (!half.wrong.empty()) return {.value = half, .limits = {}};
    if (half.value <= 0) return wrong("has a tolerance that is not above zero");
    return {.value = value,
            .limits = {{value.value - half.value, value.value + half.value, false}}};
  }

  TolerancedQuantity between(std::string_view left, std::string_view right) const {
    const ParsedQuantity value = parse_quantity(left, dimension_);
    if (!value.wrong.empty()) return {.value = value, .limits = {}};
    const std::size_t comma = right.find(',');
    if (right.back() != ']' || comma == std::string_view::npos)
      return wrong("has an interval that is not [low, high]");
    const std::string unit = unit_of(left);
    const ParsedQuantity low = limit(trimmed(right.substr(1, comma - 1)), unit);
    const ParsedQuantity high =
        limit(trimmed(right.substr(comma + 1, right.size() - comma - 2)), unit);
    if (!low.wrong.empty()) return {.value = low, .limits = {}};
    if (!high.wrong.empty()) return {.value = high, .limits = {}};
    if (!(low.value < high.value) || value.value < low.value || value.value > high.value)
      return wrong("has a value outside of its interval");
    return {.value = value, .limits = {{low.value, high.value, true}}};
  }

  std::string_view text_;
  Dimension dimension_;
};

} // namespace

TolerancedQuantity parse_toleranced(std::string_view text, Dimension dimension) {
  return Parser(text, dimension).parse();
}

} // namespace plica
