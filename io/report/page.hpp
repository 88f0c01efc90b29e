// The frame of a page: head, style, and the scripts where something turns or answers the cursor.
#pragma once

#include <string>
#include <vector>

namespace plica {

// `title` plain text; `header` and `body` HTML already.
std::string html_page(const std::string& title, const std::string& header, const std::string& body);

// A page whose header has the title, one paragraph of HTML and warnings.
std::string report_page(const std::string& title, const std::string& lead,
                        const std::vector<std::string>& warnings, const std::string& sections);

} // namespace plica
