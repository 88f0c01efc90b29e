// Beams of Nastran decks whose section varies: closed forms.
#include "tests/deck_loads.hpp"

#include <cmath>

namespace plica::test {
namespace deck_loads {
namespace {

// One CBEAM clamped at one end, A from 50 to 20, I1 from 100 to 40, I2 from 300 to 60.
std::string tapered(const std::string& property) {
  return "SOL 101\nCEND\nSPC = 1\nLOAD = 10\nBEGIN BULK\nGRID,1,,0.,0.,0.\nGRID,2,,1000.,0.,0.\n"
         "CBEAM,1,1,1,2,0.,1.,0.\n" +
         property +
         "MAT1,1,2.+5,,0.3,8.-9\nSPC1,1,123456,1\nFORCE,10,2,0,9.,0.,1.,0.\n"
         "FORCE,10,2,0,7.,0.,0.,1.\nFORCE,10,2,0,500.,1.,0.,0.\nGRAV,10,0,9810.,0.,1.,0."
         "\nENDDATA\n";
}

// Integral of s^2 / I(s) from the free end, I straight between both: a s^2 over b + c s.
double bent(double clamped, double free) {
  const double c = (clamped - free) / L;
  return L * L / (2 * c) - free * L / (c * c) +
         free * free / (c * c * c) * std::log(clamped / free);
}

TEST(DeckTapered, cantilever_bends_and_stretches_as_the_integrals_say) {
  const std::string end = ",NO,1.,20.,40.,60.,,,\n,0.,0.\n"; // K1 = K2 = 0: rigid in shear
  const Results all = loads_of("beam.bdf", tapered("PBEAM,1,1,50.,100.,300.,,400.\n" + end));
  const auto& tip = node_of(all.deck_loads.at(0), 2).displacement;
  const double weight = all.deck_loads.at(0).load[1] - 9;
  EXPECT_NEAR(weight / (9810 * rho * L * 35), 1, 1e-6); // of the mean area
  const double stretched = 500 * L / (E * (50 - 20)) * std::log(50. / 20);
  print_for_table("tapered CBEAM, along", 1e3 * tip[0], stretched, 2e-3);
  EXPECT_NEAR(1e3 * tip[0] / stretched, 1, 2e-3);
  const double across = 7 / E * bent(300, 60);
  print_for_table("tapered CBEAM, across in plane 2", 1e3 * tip[2], across, 2e-3);
  EXPECT_NEAR(1e3 * tip[2] / across, 1, 2e-3);
  EXPECT_NEAR(1e3 * tip[1] / (9 / E * bent(100, 40)), 1, 0.2); // its weight beside it
}

// A station between that says what the straight line says, and sizes of a profile.
TEST(DeckTapered, stations_and_profiles_say_the_same) {
  const auto tip = [](const std::string& property) {
    return node_of(loads_of("beam.bdf", tapered(property)).deck_loads.at(0), 2).displacement;
  };
  const auto plain = tip("PBEAM,1,1,50.,100.,300.,,400.\n,NO,1.,20.,40.,60.,,,\n,0.,0.\n"),
             three = tip("PBEAM,1,1,50.,100.,300.,,400.\n,NO,0.5,35.,70.,180.,,,\n"
                         ",NO,1.,20.,40.,60.,,,\n,0.,0.\n"),
             blank = tip("PBEAM,1,1,50.,100.,300.,,400.\n,NO,0.5\n,NO,1.,20.,40.,60.,,,\n,0.,0.\n");
  EXPECT_LT((three - plain).norm(), 1e-9 * plain.norm());
  EXPECT_LT((blank - plain).norm(), 1e-9 * plain.norm());
  // A bar of 6 by 10 whose end is as wide and half as deep: I1 between is straight here.
  const auto bar = tip("PBEAML,1,1,,BAR\n,6.,10.,0.,NO,1.,6.,5.,0.\n"),
             first = tip("PBEAML,1,1,,BAR\n,6.,10.\n"), last = tip("PBEAML,1,1,,BAR\n,6.,5.\n");
  EXPECT_GT(bar[1], 1.05 * first[1]);
  EXPECT_LT(bar[1], 0.95 * last[1]);
}

} // namespace
} // namespace deck_loads
} // namespace plica::test
