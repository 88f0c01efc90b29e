// Decks with loads for the tests, and what a run of them gives.
#pragma once

#include "io/files/files.hpp"
#include "io/input/case_file.hpp"
#include "tests/bellows_case.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace plica::test {
namespace deck_loads {

// A case of one deck in mm and t; N and MPa follow.
inline Results loads_of(const std::string& file, const std::string& deck,
                        const std::string& more = "", const std::string& analyses = "") {
  const TemporaryFolder folder("deck_loads");
  write_whole(folder.path / file, deck);
  write_whole(folder.path / "case.yaml", "case: loads\nparts:\n  it: {type: deck, file: " + file +
                                             ", length_unit: mm, mass_unit: t" + more +
                                             "}\nanalyses: {static: deck, error_bars: false" +
                                             analyses + "}\n");
  return run_silently(read_case((folder.path / "case.yaml").string()).data);
}

inline const DeckLoadResult& load_case(const Results& results, const std::string& name) {
  for (const DeckLoadResult& r : results.deck_loads)
    if (r.name == name) return r;
  throw std::runtime_error("no load case " + name);
}

inline const DeckLoadNode& node_of(const DeckLoadResult& r, int label) {
  for (const DeckLoadNode& n : r.nodes)
    if (n.label == label) return n;
  throw std::runtime_error("no node " + std::to_string(label));
}

inline void expect_balance(const DeckLoadResult& r, double force, double moment) {
  for (std::size_t d = 0; d < 6; ++d)
    EXPECT_NEAR(r.load[d] + r.reaction[d], 0, 1e-9 * (d < 3 ? force : moment))
        << r.name << " " << d;
  EXPECT_LT(r.residual, 1e-9);
}

// --- a bar of ten elements along x: L = 1000, E = 2e5, I1 = 100 (bending in x-y), I2 = 300, A = 50

inline constexpr double L = 1000, E = 2e5, I1 = 100, I2 = 300, A = 50, rho = 8e-9;

inline std::string bar(const std::string& control, const std::string& loads) {
  std::string text = "SOL 101\nCEND\n" + control + "BEGIN BULK\n";
  for (int i = 0; i <= 10; ++i) text += fmt::format("GRID,{},,{}.,0.,0.\n", i + 1, 100 * i);
  for (int i = 1; i <= 10; ++i) text += fmt::format("CBAR,{},1,{},{},0.,1.,0.\n", i, i, i + 1);
  return text +
         "PBAR,1,1,50.,100.,300.,400.\nMAT1,1,2.+5,,0.3,8.-9\nSPC1,1,123456,1\n"
         "SPC1,2,123456,1,11\nSPCADD,7,1,8\nSPC1,8,23,11\n" +
         loads + "ENDDATA\n";
}

} // namespace deck_loads
} // namespace plica::test
