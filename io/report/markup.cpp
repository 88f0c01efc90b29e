#include "io/report/markup.hpp"

#include "io/tables/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

std::string with_true_minus(const std::string& text) {
  return text.starts_with('-') ? "\u2212" + text.substr(1) : text;
}

const char* css(const HtmlColumn& column) {
  return column.is_number ? " class=\"n\"" : "";
}

std::string table_head(const std::vector<HtmlColumn>& columns) {
  std::string html = "<thead><tr>";
  for (const HtmlColumn& column : columns) {
    html += fmt::format("<th scope=\"col\"{}>{}", css(column), column.head);
    if (!column.unit.empty()) html += " <span class=\"unit\">" + column.unit + "</span>";
    html += "</th>";
  }
  return html + "</tr></thead>\n";
}

} // namespace

std::string html_escape(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    switch (letter) {
    case '&':
      escaped += "&amp;";
      break;
    case '<':
      escaped += "&lt;";
      break;
    case '>':
      escaped += "&gt;";
      break;
    case '"':
      escaped += "&quot;";
      break;
    case '\'':
      escaped += "&#39;";
      break;
    default:
      const auto code = static_cast<unsigned char>(letter);
      if (code >= 0x20 || letter == '\n' || letter == '\t') escaped += letter;
    }
  }
  return escaped;
}

std::string html_number(double value, int digits) {
  if (!std::isfinite(value)) return dash;
  const std::string text = significant(value, digits);
  const std::size_t exponent = text.find('e');
  if (exponent == std::string::npos) return with_true_minus(text);
  const int power = std::stoi(text.substr(exponent + 1));
  return fmt::format("{}\u00a0\u00d7\u00a010<sup>{}</sup>",
                     with_true_minus(text.substr(0, exponent)),
                     with_true_minus(std::to_string(power)));
}

std::string html_number(const std::optional<double>& value, int digits) {
  return value ? html_number(*value, digits) : dash;
}

std::string html_fixed(double value, int decimals) {
  if (!std::isfinite(value)) return dash;
  return with_true_minus(fmt::format("{:.{}f}", value, decimals));
}

std::string html_signed(double value, int decimals) {
  if (!std::isfinite(value)) return dash;
  return with_true_minus(with_sign(value, decimals));
}

std::string html_table(const std::string& note, const std::vector<HtmlColumn>& columns,
                       const std::vector<HtmlRow>& rows) {
  std::string html;
  if (!note.empty()) html += "<p class=\"note\">" + note + "</p>\n";
  html += "<div class=\"scroll\"><table>\n";
  const bool has_heads = std::any_of(columns.begin(), columns.end(),
                                     [](const HtmlColumn& column) { return !column.head.empty(); });
  if (has_heads) html += table_head(columns);
  html += "<tbody>\n";
  for (const HtmlRow& row : rows) {
    html += row.css_class.empty() ? "<tr>" : "<tr class=\"" + row.css_class + "\">";
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      html += i == 0 ? fmt::format("<th scope=\"row\"{}>{}</th>", css(columns[i]), row.cells[i])
                     : fmt::format("<td{}>{}</td>", css(columns[i]), row.cells[i]);
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string html_unit(std::string unit) {
  for (std::size_t at = 0; (at = unit.find("m/s2", at)) != std::string::npos;)
    unit.replace(at, 4, "m/s²");
  return html_escape(unit);
}

std::string html_section(const std::string& id, const std::string& heading,
                         const std::string& body) {
  if (body.empty()) return "";
  return fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", id, heading, body);
}

std::string json_script(std::string json) {
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos;)
    json.replace(at, 1, "\\u003c");
  return "<script type=\"application/json\">" + json + "</script>";
}

std::string html_list(const std::vector<std::string>& texts) {
  if (texts.empty()) return "";
  std::string html = "<ul>\n";
  for (const std::string& text : texts) html += "<li>" + html_escape(text) + "</li>\n";
  return html + "</ul>\n";
}

} // namespace plica
