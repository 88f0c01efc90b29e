// Decks of the whole model: CalculiX solves what is written for Abaqus, and the cards for Nastran
// are read field by field.
#include "tests/calculix_frequencies.hpp"
#include "tests/pipe_case.hpp"

#include "io/decks/nastran_cards.hpp"
#include "io/decks/write_nastran.hpp"
#include "io/superelements/labels.hpp"

#include <cmath>
#include <sstream>

namespace plica::test {
namespace {

// A stiff pipe, one cap held, the other with a lopsided body on springs.
Case pipe_with_body() {
  Case data = pipe_of({1e-3, 1e-3});
  data.caps[1].mass = 1.5;
  data.caps[1].inertia = {2e-3, 1e-3, 3e-3, 2e-4, 0, 0};
  data.caps[1].offset = {0.01, 0.02, 0};
  data.mount = {
      {.cap = "left", .kind = MountKind::rigid, .stiffness = {}},
      {.cap = "right", .kind = MountKind::springs, .stiffness = {1e6, 2e6, 5e5, 0, 3e3, 0}}};
  data.sensors = {{.name = "end", .at = {0.03, 0.3, 0}}};
  data.analyses.modes = Modes{.count = 5, .band = {}};
  return data;
}

// Bending, torsion and stretching of the pipe under a body with products of inertia, beside its
// node, on springs. The elements differ by less than 1 % on this mesh.
TEST(AbaqusDeck, solved_by_calculix_has_our_frequencies) {
  const Case data = pipe_with_body();
  const Results ours = run_silently(data);
  const std::vector<double> theirs = calculix_frequencies(data);
  ASSERT_EQ(theirs.size(), ours.modes.size());
  for (std::size_t i = 0; i < theirs.size(); ++i) {
    std::printf("| pipe with a body, mode %zu | Plica %.2f Hz | CalculiX %.2f Hz |\n", i + 1,
                ours.modes[i].frequency, theirs[i]);
    EXPECT_NEAR(ours.modes[i].frequency / theirs[i], 1, 0.01) << i;
  }
}

double ratio_to_calculix(Case data, std::size_t modes) {
  data.analyses.response.reset();
  data.analyses.stress.reset();
  data.analyses.error_bars = false;
  data.analyses.modes->count = static_cast<int>(modes);
  const Results ours = run_silently(data);
  const std::vector<double> theirs = calculix_frequencies(data);
  if (theirs.size() < modes) return 0;
  double first = 0;
  for (std::size_t i = 0; i < modes; ++i) {
    const double ratio = theirs[i] / ours.modes[i].frequency;
    std::printf("| %s, mode %zu | Plica %.2f Hz | CalculiX %.2f Hz | ratio %.4f |\n",
                data.name.c_str(), i + 1, ours.modes[i].frequency, theirs[i], ratio);
    if (i == 0) first = ratio;
  }
  return first;
}

// The shells of CalculiX are far too stiff on a mesh of this density: by how much, the bare wall
// shows. The whole pipe, with the rings of its interlock on average ties and its caps, must differ
// by the same.
TEST(AbaqusDeckSlow, of_pipe_a2_differs_in_calculix_by_the_elements_alone) {
  const MeshDensity mesh{.around = 24, .arc = 4, .wall = 4};
  const double bare = ratio_to_calculix(verification_case("a2_slipping_plies", mesh), 3);
  Case a2 = read_case(std::string(PLICA_SOURCE_DIR) + "/cases/bellow_a2/bellow_a2.yaml").data;
  bellows_of(a2).mesh = mesh;
  const double whole = ratio_to_calculix(a2, 3);
  ASSERT_GT(bare, 1);
  EXPECT_NEAR(whole / bare, 1, 0.005);
}

struct Card {
  std::string name;
  std::vector<std::string> fields;
};

std::vector<Card> bulk_data(const std::string& deck) {
  std::istringstream stream(deck.substr(deck.find("BEGIN BULK\n") + 11));
  std::vector<Card> cards;
  for (std::string line; std::getline(stream, line) && line != "ENDDATA";) {
    if (line.starts_with("$")) continue;
    EXPECT_LE(line.size(), 72u) << line;
    const std::string head = line.substr(0, 8);
    const bool more = head[0] == '*' || head[0] == '+', large = head.find('*') != std::string::npos;
    if (!more) cards.push_back({head.substr(0, head.find_first_of("* ")), {}});
    const std::size_t width = large ? 16 : 8;
    std::vector<std::string>& fields = cards.back().fields;
    if (more) fields.resize((fields.size() + 64 / width - 1) / (64 / width) * (64 / width));
    for (std::size_t at = 8; at < line.size(); at += width) {
      std::string field = line.substr(at, width);
      field.erase(0, field.find_first_not_of(' '));
      fields.push_back(field);
    }
  }
  return cards;
}

TEST(NastranDeck, says_field_by_field_what_the_model_is) {
  Case data = pipe_with_body();
  add_liner(data, Attachment::caps);
  bellows_of(data).wall.bond = 0;
  data.analyses.damping.modal = 0.02;
  data.analyses.response = Response{.bases = {1, 0}, .forces = {}, .band = {5, 400}};
  const BuiltCase built = build(data);
  std::map<std::string, std::vector<Card>> cards;
  const std::string deck = nastran_model(data, built);
  for (const Card& card : bulk_data(deck)) cards[card.name].push_back(card);
  ASSERT_EQ(cards["GRID"].size(), built.model.mesh.nodes.size());
  for (std::size_t i = 0; i < cards["GRID"].size(); ++i)
    for (int d = 0; d < 3; ++d)
      EXPECT_NEAR(nastran_number(cards["GRID"][i].fields[2 + d]), built.model.mesh.nodes[i][d],
                  1e-12);
  ASSERT_EQ(cards["CQUAD4"].size(), built.model.mesh.quads.size());
  EXPECT_EQ(cards["CQUAD4"][7].fields[3], std::to_string(built.model.mesh.quads[7].nodes[1] + 1));
  EXPECT_NEAR(nastran_number(cards["CQUAD4"][7].fields[10]), 2e-3, 1e-12) << "T1";
  EXPECT_NEAR(nastran_number(cards["PSHELL"][0].fields[4]), 0.25, 1e-12) << "two slipping plies";
  ASSERT_EQ(cards["RBE2"].size(), 2u);
  EXPECT_EQ(cards["RBE2"][0].fields.size(), 3u + 32u);
  EXPECT_EQ(cards["CBAR"].size(), 16u);
  EXPECT_NEAR(nastran_number(cards["PBAR"][0].fields[2]), 2e3, 1e-9);
  ASSERT_EQ(cards["CONM2"].size(), 1u + 2 * 16u);
  double polar = 0, wanted = 0; // about y, of the liner: bodies at the ends of its beams
  for (std::size_t i = 0; i < 32; ++i) polar += nastran_number(cards["CONM2"][i].fields[10]);
  for (const Part& part : data.parts)
    if (const auto* liner = std::get_if<Interlock>(&part.body))
      wanted = liner->mass * liner->radius * liner->radius;
  ASSERT_GT(wanted, 0);
  EXPECT_NEAR(polar, wanted, 1e-12);
  const std::vector<std::string>& body = cards["CONM2"][32].fields;
  EXPECT_NEAR(nastran_number(body[3]), 1.5, 1e-12);
  EXPECT_NEAR(nastran_number(body[5]), 0.02, 1e-12) << "offset y";
  // A matrix entry J_xy = 2e-4 is minus the integral that the card wants.
  EXPECT_NEAR(nastran_number(body[9]), -2e-4, 1e-15);
  EXPECT_NEAR(nastran_number(cards["PBUSH"][0].fields[3]), 2e6, 1e-6);
  EXPECT_EQ(cards["SPC1"].size(), 1u);
  ASSERT_EQ(cards["SPCD"].size(), 2u) << "one held cap, two directions of the base";
  EXPECT_EQ(cards["SPCD"][0].fields[2], "2") << "along y first";
  EXPECT_EQ(cards["EIGRL"][0].fields[3], "5");
  EXPECT_NEAR(nastran_number(cards["TABDMP1"][0].fields[9]), 0.02, 1e-12);
  EXPECT_NE(deck.find("SOL 111"), std::string::npos);
}

} // namespace
} // namespace plica::test
