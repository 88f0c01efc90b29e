// What the gap is made of, in words: for the terminal, the report and the tables alike.
#pragma once

#include "diagnose/results/diagnosis.hpp"

namespace plica {

// A row of the ledger: "20 g that nobody weighed, at sensor.mid"; "one of: ...; or ..." of what
// the test does not tell apart; what is left: "not explained", "what measuring leaves open".
std::string row_words(const LedgerRow& row);
// More effects in one row than are read at a glance: its words name the first alone.
bool is_long(const LedgerRow& row);

// Readings in which what no effect explains sits, where it is worth a word.
std::vector<std::pair<std::string, double>> most_left_in(const Ledger& ledger);

// The verdict for whoever knows neither effects nor odds: causes in plain words, their shares of
// the gap, and what is not explained. One line, without a full stop.
std::string plain_verdict(const Diagnosis& d);

// For the terminal.
std::string ledger_text(const Ledger& ledger);

// For the terminal, at most fifteen lines: verdict, ledger, where, how far, what to measure next.
std::string first_screen_text(const Diagnosis& d);

} // namespace plica
