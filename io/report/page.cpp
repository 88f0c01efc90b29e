#include "io/report/page.hpp"

#include "io/report/css.hpp"
#include "io/report/markup.hpp"
#include "io/report/scripts.hpp"

#include <fmt/format.h>

namespace plica {

std::string html_page(const std::string& title, const std::string& header,
                      const std::string& body) {
  const bool lives = body.find("<figure class=\"plot") != std::string::npos ||
                     body.find("<figure class=\"viewer") != std::string::npos;
  std::string html =
      fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                  "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                  "<title>{}</title>\n<style>{}{}</style>\n</head>\n<body>\n<main>\n"
                  "<header>\n{}</header>\n{}</main>\n",
                  html_escape(title), lives ? report_script_style : "", report_css, header, body);
  if (lives) html += fmt::format("<script>{}</script>\n", report_script);
  return html + "</body>\n</html>\n";
}

std::string report_page(const std::string& title, const std::string& lead,
                        const std::vector<std::string>& warnings, const std::string& sections) {
  std::string header =
      fmt::format("<h1>{}</h1>\n<p class=\"case\">{}</p>\n", html_escape(title), lead);
  if (!warnings.empty())
    header += "<div class=\"warnings\"><b>Warnings</b>\n" + html_list(warnings) + "</div>\n";
  return html_page(title, header, sections);
}

} // namespace plica
