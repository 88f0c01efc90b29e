// Small pieces of HTML: escaped text, numbers, tables, sections.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace plica {

// & < > " ' as entities; control characters that XML forbids are dropped. Every text that comes
// from a case file passes here.
std::string html_escape(const std::string& text);

inline constexpr const char* dash = "\u2013"; // where there is no number

// significant() with a true minus sign and powers of ten as superscripts; a dash if not finite.
std::string html_number(double value, int digits);
std::string html_number(const std::optional<double>& value, int digits); // none: a dash
std::string html_fixed(double value, int decimals);                      // 116.20
std::string html_signed(double value, int decimals); // +3.2, with a true minus sign
std::string html_unit(std::string unit);             // m/s2 as m/s², escaped

struct HtmlColumn {
  std::string head, unit; // the unit stands below the head
  bool is_number = true;  // right-aligned
};

struct HtmlRow {
  std::vector<std::string> cells; // HTML already; the first heads the row
  std::string css_class;
};

// `note` (a line above the table, or empty) and heads are HTML already. Scrolls sideways by itself
// when the page is narrow. Without any head there is no head line.
std::string html_table(const std::string& note, const std::vector<HtmlColumn>& columns,
                       const std::vector<HtmlRow>& rows);

// <section> with a heading; empty when the body is.
std::string html_section(const std::string& id, const std::string& heading,
                         const std::string& body);

// <script> with data for the scripts of the page; what would end it is escaped.
std::string json_script(std::string json);

// <ul> of plain texts, escaped here.
std::string html_list(const std::vector<std::string>& texts);

} // namespace plica
