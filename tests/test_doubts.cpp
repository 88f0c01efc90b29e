// Cases that are allowed and most likely not meant: each is doubted in words, good ones are not.
#include "io/files/files.hpp"
#include "model/shape/doubts.hpp"
#include "tests/bellows_case.hpp"
#include "tests/support/temporary_folder.hpp"

#include <chrono>

namespace plica::test {
namespace {

const std::string plate_case = R"(case: plate
materials: {steel: {E: 200 GPa, nu: 0.3, rho: 7850 kg/m3}}
parts:
  web: {type: plate, corners: [[0, 0, 0], [300 mm, 0, 0], [300 mm, 200 mm, 0], [0, 200 mm, 0]],
        thickness: 2 mm, elements: [3, 2], material: steel}
supports: [{set: web.edge1, fix: [ux, uy, uz, rx, ry, rz]}]
analyses: {modes: {count: 4}}
)";

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::vector<std::string> doubts_of(const std::string& text) {
  const TemporaryFolder folder("doubts");
  write_whole(folder.path / "case.yaml", text);
  write_whole(folder.path / "deck.inp",
              "*NODE\n1, 0, 0, 0\n2, 100, 0, 0\n3, 100, 100, 0\n4, 0, 100, 0\n"
              "*ELEMENT, TYPE=S4, ELSET=WALL\n1, 1, 2, 3, 4\n*MATERIAL, NAME=M\n"
              "*ELASTIC\n2.e5, 0.3\n*DENSITY\n7850.\n*SHELL SECTION, ELSET=WALL, MATERIAL=M\n1.\n");
  const Case data = read_case((folder.path / "case.yaml").string()).data;
  return doubts(data, build(data));
}

void expect_doubt(const std::string& text, const std::string& words) {
  const std::vector<std::string> found = doubts_of(text);
  ASSERT_EQ(found.size(), 1U) << words;
  EXPECT_NE(found[0].find(words), std::string::npos) << found[0];
}

TEST(Doubts, are_none_of_shipped_cases) {
  for (const auto& [name, model] : {std::pair{"bellow_a2", ""},
                                    {"bellow_a2", "connector"},
                                    {"bellow_a1", "connector"},
                                    {"hose_b", ""},
                                    {"dual_assembly", ""},
                                    {"dual_assembly", "connector"},
                                    {"pipe_with_bracket", ""},
                                    {"bolted_lap", ""},
                                    {"cantilever_masses", ""},
                                    {"tutorial", ""}}) {
    const std::string file =
        std::string(PLICA_SOURCE_DIR) + "/cases/" + name + "/" + name + ".yaml";
    const Case data = read_case(file, model).data;
    for (const std::string& doubt : doubts(data, build(data)))
      ADD_FAILURE() << name << " " << model << ": " << doubt;
  }
}

TEST(Doubts, name_what_a_forgotten_unit_gives) {
  EXPECT_TRUE(doubts_of(plate_case).empty());
  expect_doubt(with(plate_case, "7850 kg/m3", "7.85e-9"), "a density of 7.85e-09 kg/m3");
  expect_doubt(with(plate_case, "200 GPa", "200"), "E = 200 Pa");
  expect_doubt(with(plate_case, "2 mm, el", "2, el"), "a wall of 2000 mm");
  expect_doubt(with(plate_case, "7850 kg/m3", "0"), "has no density");
}

// Four millimetres beside an edge, which half a wall of 2 mm reaches, is no place on the plate.
TEST(Doubts, name_a_sensor_that_sits_elsewhere) {
  const std::string on = plate_case + "sensors: [{name: a, at: [300 mm, 201 mm, 0]}]\n";
  EXPECT_TRUE(doubts_of(on).empty());
  expect_doubt(with(on, "201 mm", "204 mm"), "sensor a is 3 mm off the part");
}

// A bellows that begins 20 mm along, its end circle at a radius of 50 mm.
std::string bellows_with_sensor(const std::string& at) {
  return R"(case: bellows
materials: {steel: {E: 193 GPa, nu: 0.3, rho: 8000 kg/m3}}
parts:
  bellows:
    type: bellows
    material: steel
    root_radius: 50 mm
    start: 20 mm
    profile: [{shape: cuff, length: 10 mm}, {shape: U, count: 2, height: 8 mm, pitch: 6 mm}]
    wall: {plies: [0.3 mm]}
    mesh: {around: 12, arc: 2, wall: 2}
caps: {left: {of: bellows.left}, right: {of: bellows.right}}
mount: {left: rigid, right: rigid}
sensors: [{name: a, at: )" +
         at + "}]\nanalyses: {modes: {count: 4}}\n";
}

TEST(Doubts, name_a_sensor_beside_an_end_circle) {
  EXPECT_TRUE(doubts_of(bellows_with_sensor("[0, 20 mm, 50 mm]")).empty());
  expect_doubt(bellows_with_sensor("[0, 20 mm, 54 mm]"), "sensor a is 3.8 mm off the part");
}

// Between two of twelve nodes around, on the wall: it sits there.
TEST(Doubts, are_none_of_a_sensor_at_45_degrees) {
  const TemporaryFolder folder("doubts");
  write_whole(folder.path / "case.yaml", bellows_with_sensor("[35.355 mm, 25 mm, 35.355 mm]"));
  const Case data = read_case((folder.path / "case.yaml").string()).data;
  const BuiltCase built = build(data);
  EXPECT_TRUE(doubts(data, built).empty());
  const Eigen::Vector3d& x = built.model.mesh.nodes[std::size_t(built.sensors.at(0).node)];
  EXPECT_NEAR((x - Eigen::Vector3d(0.035355, 0.025, 0.035355)).norm(), 0, 1e-9);
}

// What a message would show as 5.00 mm is not refused as more than 5 mm.
TEST(Doubts, hold_a_sensor_against_the_digits_that_are_shown) {
  const auto wrong = [](const std::string& at) {
    try {
      doubts_of(bellows_with_sensor(at));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(wrong("[0, 15 mm, 50 mm]"), "");
  EXPECT_EQ(wrong("[0, 14.996 mm, 50 mm]"), "");
  EXPECT_NE(wrong("[0, 14.98 mm, 50 mm]").find("5.02 mm away"), std::string::npos)
      << wrong("[0, 14.98 mm, 50 mm]");
}

TEST(Doubts, name_materials_that_no_part_uses) {
  expect_doubt(
      with(plate_case, "materials: {", "materials: {copper: {E: 120 GPa, nu: 0.3, rho: 8900}, "),
      "materials.copper: no part uses it");
}

TEST(Doubts, of_very_many_materials_take_no_longer_than_their_number) {
  Case data;
  for (int i = 0; i < 200000; ++i) data.materials["m" + std::to_string(i)] = {};
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(doubts(data, {}).size(), data.materials.size());
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

TEST(Doubts, name_a_deck_of_other_units_and_a_turn_of_many_turns) {
  const std::vector<std::string> found = doubts_of(
      "case: deck\nparts:\n  net: {type: deck, file: deck.inp, length_unit: mm, mass_unit: "
      "t, rotate: [0, 90, 0]}\nanalyses: {modes: {count: 2}}\n");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NE(found[0].find("the deck net has a density of 7.85e+15"), std::string::npos) << found[0];
  EXPECT_NE(found[1].find("write 90 deg"), std::string::npos) << found[1];
}

TEST(Doubts, name_what_is_joined_across_a_distance_and_what_is_not_joined) {
  const std::string second = "  far: {type: plate, corners: [[5, 0, 0], [6, 0, 0], [6, 1, 0], [5, "
                             "1, 0]], thickness: 2 mm, "
                             "elements: [2, 2], material: steel}\n";
  expect_doubt(with(plate_case, "supports", second + "supports"),
               "falls into 2 pieces that nothing joins (a cap or a clamp does): web | far (held by "
               "nothing)");
  expect_doubt(with(plate_case, "supports",
                    second + "caps: {joint: {of: [web.edge2, far.edge4]}}\nsupports"),
               "cap joint joins web.edge2 and far.edge4, ");
  EXPECT_TRUE(doubts_of(with(plate_case, "supports",
                             second + "caps: {table: {of: [web.edge2, far.edge4]}}\nmount: "
                                      "{table: rigid}\nsupports"))
                  .empty())
      << "feet on one table";
}

} // namespace
} // namespace plica::test
