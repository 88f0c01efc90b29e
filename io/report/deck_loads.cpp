#include "io/report/deck_loads.hpp"

#include "io/report/markup.hpp"

namespace plica {

std::string deck_loads_html(const Results& results) {
  if (results.deck_loads.empty()) return "";
  std::vector<HtmlRow> rows;
  for (const DeckLoadResult& r : results.deck_loads) {
    HtmlRow row{{html_escape(r.name)}, ""};
    for (std::size_t i = 0; i < 3; ++i) row.cells.push_back(html_number(r.load[i], 4));
    for (std::size_t i = 0; i < 3; ++i) row.cells.push_back(html_number(r.reaction[i], 4));
    row.cells.push_back(html_number(1e3 * r.largest, 4));
    for (const double x : r.at) row.cells.push_back(html_number(1e3 * x, 4));
    row.cells.push_back(html_number(r.energy, 4));
    rows.push_back(row);
  }
  return html_table("What acts in the subcases or steps of the deck, solved linearly; every node "
                    "in deck_loads.csv. Reactions: of what is held rigidly.",
                    {{"load case", "", false},
                     {"load x", "N"},
                     {"y", "N"},
                     {"z", "N"},
                     {"reaction x", "N"},
                     {"y", "N"},
                     {"z", "N"},
                     {"largest displacement", "mm"},
                     {"at x", "mm"},
                     {"y", "mm"},
                     {"z", "mm"},
                     {"strain energy", "J"}},
                    rows);
}

} // namespace plica
