// report.html: one page that explains a run to a colleague.
//
// Self-contained (no script, no external resource), for screen in light and dark and for paper;
// every figure that colour tells is also told by lightness or words. Each section stands in its
// own <section id="...">: comparison, statics, part, modes, variants, assumptions, model, timing.
#pragma once

#include "run/results/results.hpp"

#include <string>

namespace plica {

std::string report_html(const Results& results);

} // namespace plica
