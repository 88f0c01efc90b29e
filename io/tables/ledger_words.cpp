#include "io/tables/ledger_words.hpp"

#include "diagnose/weigh/blocks.hpp"
#include "io/tables/effect_words.hpp"
#include "io/tables/located_gaps.hpp"
#include "io/tables/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace plica {
namespace {

constexpr double rounds_to_nothing = 0.005; // of a share in whole percents

const char* words_of(Remainder left) {
  switch (left) {
  case Remainder::measurement:
    return "what measuring leaves open";
  case Remainder::mounting:
    return "scatter of mounting anew";
  case Remainder::model:
    return "tolerances and error of the model";
  case Remainder::unexplained:
    break;
  }
  return "not explained";
}

// Without the other places, which stand in its row.
NamedEffect alone(NamedEffect e) {
  e.other_places.clear();
  return e;
}

// A row with its effects as `words` says them.
std::string row_by(const LedgerRow& row, std::string (*words)(const NamedEffect& e)) {
  if (row.left) return words_of(*row.left);
  if (row.effects.size() == 1) return words(row.effects.front());
  if (is_long(row))
    return words(alone(row.effects.front())) +
           fmt::format("; or one of {} others that the test does not tell from it",
                       row.effects.size() - 1);
  std::string text;
  for (const NamedEffect& e : row.effects)
    text += (text.empty() ? "one of: " : "; or ") + words(alone(e));
  return text;
}

std::string plain_with_values(const NamedEffect& e) {
  constexpr std::size_t in_a_line = 2; // the table of effects has all
  const std::string values = values_words(e, significant, in_a_line);
  return plain_at_place(e) + (values.empty() ? "" : ": " + values);
}

// Of the effect, and that it sits there: "39 %, 31 % there".
std::string odds_words(const NamedEffect& e) {
  const std::string anywhere = fmt::format("{:.0f} %", 100 * e.anywhere);
  const std::string there = fmt::format("{:.0f} %", 100 * e.probability);
  return e.probability >= e.anywhere || there == anywhere ? anywhere
                                                          : anywhere + ", " + there + " there";
}

std::string interval_words(const std::array<double, 2>& share) {
  return fmt::format("[{:.0f}, {:.0f}]", 100 * share[0], 100 * share[1]);
}

// What is left where nothing is known of it is told; small parts of it are not.
bool is_told(const LedgerRow& row) {
  return !row.effects.empty() || row.left == Remainder::unexplained ||
         std::abs(row.share) >= rounds_to_nothing;
}

// "; 8 % is not explained"
std::string rest_words(const Ledger& ledger) {
  for (const LedgerRow& row : ledger.rows)
    if (row.left == Remainder::unexplained)
      return row.share < rounds_to_nothing
                 ? "; less than 1 % is not explained"
                 : fmt::format("; {:.0f} % is not explained", 100 * row.share);
  return "";
}

std::string of_the_gap(double share, const std::array<double, 2>& interval) {
  return fmt::format("{:.0f} % of the gap {}", 100 * share, interval_words(interval));
}

// What the ledger names, with its share: one cause, or the first of several.
std::string causes_words(const Ledger& ledger, const std::vector<const LedgerRow*>& causes) {
  if (causes.size() == 1) {
    const LedgerRow& own = *causes.front();
    return row_words(own) + ": " + of_the_gap(own.share, own.interval) +
           (own.effects.size() > 1 ? ", whichever it is" : "");
  }
  constexpr std::size_t most = 3;
  std::string text =
      "several causes together, " + of_the_gap(ledger.explained, ledger.explained_interval) + ": ";
  for (std::size_t i = 0; i < std::min(most, causes.size()); ++i)
    text += fmt::format("{}{} ({:.0f} %)", i == 0 ? "" : "; ", row_words(*causes[i]),
                        100 * causes[i]->share);
  if (causes.size() > most) text += fmt::format("; and {} more", causes.size() - most);
  return text;
}

// "; what is no effect here would do better: 15 g on a spring of its own, which ..."
std::string resonator_words(const Diagnosis& d) {
  return d.resonator ? resonator_clause(d.resonator->is_ahead, d.resonator->words) : "";
}

std::string where_line(const Diagnosis& d) {
  constexpr std::size_t shown = 2;
  std::string text;
  const auto add = [&](const std::vector<LocatedGap>& list, bool counts_all) {
    std::size_t told = 0;
    for (const LocatedGap& b : list)
      if ((counts_all || b.significant) && told++ < shown)
        text += (text.empty() ? "" : "; ") + name_of(b) + " " + with_sign(b.z, 1);
  };
  add(located_blocks(d), false);
  if (text.empty()) text = "no block beyond admissible specimens";
  add(located_components(d), true);
  return "Where (z): " + text + "\n";
}

std::string gap_line(const Diagnosis& d) {
  const auto both = [&](const GapShrink& g) {
    return significant(g.before, 3) +
           (d.best ? " before, " + significant(g.after, 3) + " after" : "");
  };
  return "How far (root of G): " + both(d.gap) +
         (d.held_out ? "; held out " + both(*d.held_out) : "") + "\n";
}

std::string next_line(const Diagnosis& d) {
  if (!d.next.empty())
    return fmt::format("Measure next: {} (about {}; changes the ledger by {:.0f} %)\n",
                       d.next.front().what, d.next.front().about, 100 * d.next.front().change);
  return d.advice.empty() ? "" : "Measure next: " + d.advice.front() + "\n";
}

} // namespace

bool is_long(const LedgerRow& row) {
  constexpr std::size_t at_a_glance = 3;
  return row.effects.size() > at_a_glance;
}

std::string row_words(const LedgerRow& row) {
  return row_by(row, plain_at_place);
}

std::vector<std::pair<std::string, double>> most_left_in(const Ledger& ledger) {
  constexpr double worth_a_word = 0.01, nothing = 0.01;
  constexpr std::size_t most = 4;
  std::vector<std::pair<std::string, double>> readings;
  for (const LedgerRow& row : ledger.rows)
    if (row.left == Remainder::unexplained && row.share < nothing) return readings;
  for (const auto& own : ledger.left_in)
    if (own.second >= worth_a_word && readings.size() < most) readings.push_back(own);
  return readings;
}

std::string plain_verdict(const Diagnosis& d) {
  std::vector<const LedgerRow*> causes;
  for (const LedgerRow& row : d.ledger.rows)
    if (!row.effects.empty()) causes.push_back(&row);
  if (d.verdict == Verdict::none)
    return "The model as it is explains the test, within what measuring and tolerances leave";
  if (causes.empty())
    return "Cause not found: nothing that is known here comes nearer to the test than the model "
           "as it is" +
           rest_words(d.ledger) + resonator_words(d);
  std::string text = causes_words(d.ledger, causes);
  const bool is_list = causes.size() == 1 && causes.front()->effects.size() > 1;
  if (d.verdict == Verdict::mostly) text = "mostly " + text;
  if (d.verdict == Verdict::unknown) text = "cause not found; nearest comes " + text;
  if (d.verdict == Verdict::ambiguous && !is_list) text = "perhaps " + text;
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text + rest_words(d.ledger) + resonator_words(d);
}

std::string ledger_text(const Ledger& ledger) {
  TextRows rows;
  for (const LedgerRow& row : ledger.rows) {
    if (!is_told(row)) continue;
    std::string words = row_by(row, plain_with_values);
    if (row.effects.size() == 1)
      words += "; probability " + odds_words(row.effects.front());
    else if (!row.told_apart_by.empty())
      words += "; to tell them apart: " + row.told_apart_by;
    rows.push_back({fmt::format("{:.0f} %", 100 * row.share), interval_words(row.interval), words});
  }
  std::string text = fmt::format(
      "Ledger: the gap, G = {} over {} readings (1 = what measuring and scatter leave)\n",
      significant(ledger.gap, 3), ledger.readings);
  text += text_table(rows, ">><");
  std::string readings;
  for (const auto& [reading, share] : most_left_in(ledger))
    readings += fmt::format("{}{} {:.0f} %", readings.empty() ? "" : ", ", reading, 100 * share);
  return readings.empty() ? text : text + "  what is left sits in " + readings + "\n";
}

std::string first_screen_text(const Diagnosis& d) {
  return d.case_name + ": " + plain_verdict(d) + "\n" + ledger_text(d.ledger) + where_line(d) +
         gap_line(d) + next_line(d);
}

} // namespace plica
