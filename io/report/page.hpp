// The frame of a page of its own: head, style, title, warnings.
#pragma once

#include <string>
#include <vector>

namespace plica {

// `title` plain text, `lead` HTML of one paragraph, `sections` HTML already.
std::string report_page(const std::string& title, const std::string& lead,
                        const std::vector<std::string>& warnings, const std::string& sections);

} // namespace plica
