#include "io/report/page.hpp"

#include "io/report/css.hpp"
#include "io/report/markup.hpp"

#include <fmt/format.h>

namespace plica {

std::string report_page(const std::string& title, const std::string& lead,
                        const std::vector<std::string>& warnings, const std::string& sections) {
  std::string html =
      fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                  "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                  "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<main>\n"
                  "<header>\n<h1>{0}</h1>\n<p class=\"case\">{2}</p>\n",
                  html_escape(title), report_css, lead);
  if (!warnings.empty())
    html += "<div class=\"warnings\"><b>Warnings</b>\n" + html_list(warnings) + "</div>\n";
  return html + "</header>\n" + sections + "</main>\n</body>\n</html>\n";
}

} // namespace plica
