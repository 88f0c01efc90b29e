// A rod as a superelement goes out in four formats; two are read back, in mm and tonnes.
#include "expect.hpp"
#include "plica/io/decks/op4_file.hpp"
#include "plica/io/files/files.hpp"
#include "plica/io/superelements/hdf5.hpp"
#include "plica/io/superelements/matlab.hpp"
#include "plica/io/superelements/nastran_dmig.hpp"
#include "plica/io/superelements/op4.hpp"

#include <numbers>

int main() {
  using namespace plica;
  constexpr double E = 200e9, rho = 8000, length = 0.5, radius = 0.01;
  const BeamProperties section = round_section({.E = E, .nu = 0.25, .rho = rho}, radius);
  const BeamGeometry line{.node1 = {0, 0, 0}, .node2 = {0, length, 0}};
  Superelement rod{.name = "rod", .node_names = {"left", "right"}};
  rod.nodes = {line.node1, line.node2};
  rod.K = beam_stiffness(line, section);
  rod.M = beam_mass(line, section);
  const Superelement in_mm = in_millimetres(rod);

  // Along the rod E A / L in N/mm, a third and a sixth of its mass in t.
  constexpr double area = std::numbers::pi * radius * radius;
  write_whole("consumer.op4", op4_file(in_mm));
  const auto op4 = read_op4_file("consumer.op4", {"KPLICA", "MPLICA"});
  expect(op4.size() == 2 && op4.at("KPLICA") == in_mm.K, "every bit of K by OUTPUT4");
  expect_near(op4.at("KPLICA")(1, 1), E * area / length / 1e3, "stiffness along the rod");
  expect_near(op4.at("MPLICA")(1, 7), rho * area * length / 6 / 1e3, "mass between its ends");

  write_matlab(in_mm, "consumer_rod.mat");
  const Superelement back = read_matlab("consumer_rod.mat");
  expect(back.M == in_mm.M && back.node_names == rod.node_names, "M and the names by MATLAB");
  expect_near(back.nodes[1].y(), 500, "place of the right end");

  write_hdf5(in_mm, "consumer_rod.h5");
  expect(read_whole("consumer_rod.h5").starts_with("\x89HDF\r\n\x1a\n"), "the signature of HDF5");
  expect(nastran_deck(rod).find("K2GG = KPLICA, KPLICAL") != std::string::npos, "K2GG in the deck");
  return differs;
}
