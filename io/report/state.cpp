#include "io/report/state.hpp"

#include "io/report/markup.hpp"
#include "io/report/page.hpp"
#include "io/tables/state_words.hpp"

#include <fmt/format.h>

namespace plica {

namespace {

// The named states of the case: what acts in each; their numbers stand among the variants.
std::string states_html(const Results& results) {
  std::string html;
  for (const VariantResult& variant : results.variants) {
    if (!variant.state) continue;
    std::vector<std::string> sentences = state_sentences(*variant.state);
    for (std::string& b : buckling_sentences(*variant.state)) sentences.push_back(std::move(b));
    html += "<h3>" + html_escape(variant.name) + "</h3>\n" + html_list(sentences);
  }
  return html;
}

} // namespace

std::string state_html(const Results& results) {
  if (!results.state) return states_html(results);
  const StateResult& s = *results.state;
  std::vector<std::string> sentences = state_sentences(s);
  for (std::string& b : buckling_sentences(s)) sentences.push_back(std::move(b));
  std::vector<HtmlRow> rows;
  for (const StateIterationResult& i : s.iterations)
    rows.push_back({{html_fixed(100 * i.share, 2), fmt::format("{:.1e}", i.residual),
                     fmt::format("{:.3g}", 1e3 * i.step)},
                    ""});
  return "<p>Everything on this page is around this state, motions and stresses of responses on "
         "top "
         "of it.</p>\n" +
         html_list(sentences) +
         html_table("Newton's iteration",
                    {{"loads", "%"}, {"unbalanced force", ""}, {"largest step", "mm"}}, rows) +
         states_html(results);
}

} // namespace plica
