// What makes a report turn, play and answer the cursor: the sources in web/ and the libraries they
// use, bundled by the build.
#pragma once

#include <string_view>

namespace plica {

extern const std::string_view report_script;       // one script, ASCII, without "</script"
extern const std::string_view report_script_style; // of the plots

} // namespace plica
