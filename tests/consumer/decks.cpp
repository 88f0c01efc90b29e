// Two masses on springs out of a Nastran deck in mm and tonnes, as a model in SI.
#include "expect.hpp"
#include "plica/io/decks/read_deck.hpp"
#include "plica/model/shape/build.hpp"
#include "plica/solve/assembly.hpp"

#include <fstream>

int main() {
  using namespace plica;
  std::ofstream("consumer.bdf") << "SOL 103\nCEND\nBEGIN BULK\n"
                                   "GRID,1,,0.,0.,0.,,23456\n"
                                   "GRID,2,,100.,0.,0.,,23456\n"
                                   "CELAS2,1,80.,1,1\n"
                                   "CELAS2,2,80.,1,1,2,1\n"
                                   "CONM2,3,1,,.002\n"
                                   "CONM2,4,2,,.002\n"
                                   "ENDDATA\n";
  DeckPart deck{.file = "consumer.bdf", .length_unit = 1e-3, .mass_unit = 1e3};
  deck.content = read_deck(deck.file, deck.unknown_cards);
  Case data;
  data.name = "two masses";
  data.parts.push_back({"deck", deck});
  const Model model = build(data).model;
  expect(model.mesh.nodes.size() == 2, "two nodes");
  expect_near(model.mesh.nodes.back().x(), 0.1, "place of the second one");

  // Two alike, one behind the other: w^2 = k / m (3 -+ sqrt 5) / 2, k = 80 kN/m, m = 2 kg.
  const System system = assemble(model);
  const Eigen::MatrixXd K = system.K, M = system.M;
  expect(K.rows() == 2, "two unknowns");
  expect(M(1, 0) == 0, "masses of their own"); // the lower triangles are the matrices
  const double trace = K(0, 0) / M(0, 0) + K(1, 1) / M(1, 1);
  const double product = (K(0, 0) * K(1, 1) - K(1, 0) * K(1, 0)) / (M(0, 0) * M(1, 1));
  const double root = std::sqrt(trace * trace - 4 * product);
  expect_near((trace - root) / 2, 4e4 * (3 - std::sqrt(5.)) / 2, "first eigenvalue");
  expect_near((trace + root) / 2, 4e4 * (3 + std::sqrt(5.)) / 2, "second eigenvalue");
  return differs;
}
