#include "io/decks/nastran_cards.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

namespace plica {
namespace {

std::string card(const std::string& name, std::vector<std::string> fields, std::size_t width,
                 const char* continuation) {
  const std::size_t per_line = 64 / width;
  while (!fields.empty() && fields.back().empty()) fields.pop_back();
  std::string text = fmt::format("{:<8}", name);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0 && i % per_line == 0) text += fmt::format("\n{:<8}", continuation);
    text += fmt::format("{:>{}}", fields[i], width);
  }
  return text + "\n";
}

} // namespace

std::string nastran_real(double x) {
  if (x == 0) return "0.";
  for (int digits = 14; digits > 0; --digits) {
    std::string text = fmt::format("{:.{}e}", x, digits);
    const std::size_t e = text.find('e');
    const int exponent = std::stoi(text.substr(e + 1));
    text = text.substr(0, e) + fmt::format("{:+d}", exponent);
    if (text.size() <= 16) return text;
  }
  return "0.0";
}

double nastran_number(std::string text) {
  std::erase(text, ' ');
  if (text.starts_with('+') && !text.starts_with("+-")) text.erase(0, 1);
  for (char& c : text)
    if (c == 'D' || c == 'd' || c == 'E') c = 'e';
  const std::size_t sign = text.find_first_of("+-", 1);
  if (sign != std::string::npos && text.find('e') == std::string::npos) text.insert(sign, "e");
  if (const std::size_t plus = text.find("e+"); plus != std::string::npos) text.erase(plus + 1, 1);
  double x = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (error != std::errc() || end != text.data() + text.size()) throw std::invalid_argument(text);
  return x;
}

std::optional<int> whole_number_of(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string large_card(const std::string& name, const std::vector<std::string>& fields) {
  return card(name + "*", fields, 16, "*");
}

std::string small_card(const std::string& name, const std::vector<std::string>& fields) {
  return card(name, fields, 8, "+");
}

} // namespace plica
