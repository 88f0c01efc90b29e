// Mass of the elements of a deck at their nodes alone, as Nastran has it without PARAM COUPMASS:
// chains of masses and springs in closed form, and the same structure with bodies (CONM2) in place
// of a density.
#include "io/decks/read_deck.hpp"
#include "io/decks/write_nastran.hpp"
#include "io/files/files.hpp"
#include "model/shape/build.hpp"
#include "model/shape/symbols.hpp"
#include "solve/effective_mass.hpp"
#include "tests/deck_loads.hpp"
#include "tests/deck_text.hpp"

#include <cmath>
#include <numbers>

namespace plica::test {
namespace deck_lumped {

using std::numbers::pi;

DeckModel lumped_deck(const std::string& file, const std::string& text) {
  const TemporaryFolder folder("deck_lumped");
  write_whole(folder.path / file, text);
  return *read_deck(folder.path / file, UnknownCards::error);
}

Eigen::VectorXd lumped_hertz(const DeckModel& deck, int count) {
  return find_modes(place(deck, {}), count).hertz;
}

void expect_alike(const std::string& a, const std::string& b, int count = 6) {
  const Eigen::VectorXd of_a = lumped_hertz(lumped_deck("a.bdf", a), count),
                        of_b = lumped_hertz(lumped_deck("b.bdf", b), count);
  for (Eigen::Index i = 0; i < count; ++i) EXPECT_NEAR(of_a[i] / of_b[i], 1, deck_agreement) << i;
}

// --- a rod of eight elements, held at one end, that only stretches

constexpr int pieces = 8;
constexpr double E = 2e11, rho = 8000, h = 0.1;

std::string chain(const std::string& element, const std::string& property) {
  std::string text = "MAT1,1,2.+11,,.3,8000.\n" + property + "GRDSET,,,,,,,23456\n";
  for (int i = 0; i <= pieces; ++i)
    text += fmt::format("GRID,{},,{:.1f},0.,0.,,{}\n", i + 1, i * h, i == 0 ? "123456" : "23456");
  for (int i = 1; i <= pieces; ++i)
    text += fmt::format("{},{},1,{},{}{}\n", element, i, i, i + 1,
                        element == "CROD" ? "" : ",0.,1.,0.");
  return text;
}

double phase(int mode) {
  return (2 * mode - 1) * pi / (2 * pieces);
}

// w = 2 c / h sin(phi / 2), phi = (2 k - 1) pi / (2 n), c^2 = E / rho.
double of_masses(int mode) {
  return std::sqrt(E / rho) / h / (2 * pi) * 2 * std::sin(phase(mode) / 2);
}

// w^2 = 6 c^2 / h^2 (1 - cos phi) / (2 + cos phi): linear shapes.
double of_shapes(int mode) {
  const double cosine = std::cos(phase(mode));
  return std::sqrt(6 * E / rho * (1 - cosine) / (2 + cosine)) / h / (2 * pi);
}

TEST(DeckLumped, bars_that_stretch_are_masses_and_springs) {
  const std::string bar = chain("CBAR", "PBAR,1,1,1.-4,1.-9,1.-9,2.-9\n"),
                    beam = chain("CBEAM", "PBEAM,1,1,1.-4,1.-9,1.-9,,2.-9\n"),
                    rod = chain("CROD", "PROD,1,1,1.-4\n");
  for (const std::string& text : {bar, beam, rod}) {
    const Eigen::VectorXd alone = lumped_hertz(lumped_deck("a.bdf", text), 5);
    for (const char* coupled : {"PARAM,COUPMASS,1\n", "PARAM,COUPMASS,YES\n",
                                "SOL 103\nCEND\n PARAM, COUPMASS, 1\nBEGIN BULK\n"}) {
      const Eigen::VectorXd spread = lumped_hertz(lumped_deck("b.bdf", coupled + text), 5);
      for (int i = 0; i < 5; ++i) EXPECT_NEAR(spread[i] / of_shapes(i + 1), 1, deck_agreement);
    }
    const Eigen::VectorXd refused =
        lumped_hertz(lumped_deck("c.bdf", "PARAM,COUPMASS,-1\n" + text), 5);
    for (int i = 0; i < 5; ++i) {
      EXPECT_NEAR(alone[i] / of_masses(i + 1), 1, deck_agreement) << text;
      EXPECT_EQ(alone[i], refused[i]);
    }
  }
}

// --- bodies in place of a density

const std::string two_bars = "GRID,1,,0.,0.,0.,,123456\nGRID,2,,.3,0.,0.\nGRID,3,,.5,.2,.1,,123\n";

// Half the mass of a bar is where its axis ends: beside the node by the offset there.
TEST(DeckLumped, a_bar_beside_its_nodes_weighs_at_the_ends_of_its_axis) {
  for (const char* pins : {"", "56"}) {
    const std::string bars =
        two_bars + fmt::format("CBAR,1,1,1,2,0.,1.,0.\n,{},,0.,.02,0.,0.,.02,.03\n"
                               "CBAR,2,1,2,3,0.,1.,0.\n,,,0.,.02,.03\n"
                               "PBAR,1,1,1.-4,1.-9,3.-9,2.-9,.2\n",
                               pins);
    const double per_length = 8000 * 1e-4 + 0.2, first = std::hypot(0.3, 0.03) * per_length / 2,
                 second = Eigen::Vector3d(0.2, 0.18, 0.07).norm() * per_length / 2;
    expect_alike(
        bars + "MAT1,1,2.+11,,.3,8000.\n",
        two_bars + bars.substr(two_bars.size(), bars.find("PBAR") - two_bars.size()) +
            "PBAR,1,1,1.-4,1.-9,3.-9,2.-9\nMAT1,1,2.+11,,.3\n" +
            fmt::format("CONM2,11,2,,{0:.10f},0.,.02,.03\nCONM2,12,2,,{1:.10f},0.,.02,.03\n"
                        "CONM2,13,3,,{1:.10f}\n",
                        first, second),
        3);
  }
}

// Half the inertia about its axis of a CBEAM is at either end, as in listings of MSC Nastran: w^2 =
// G J / L / (rho (I1 + I2) L / 2), by two elements that of a chain. Of a CBAR none, so that it does
// not twist.
TEST(DeckLumped, a_cbeam_twists_and_a_cbar_does_not) {
  const std::string held = "GRID,1,,0.,0.,0.,,123456\nGRID,2,,0.,.6,0.,,12346\n"
                           "GRID,3,,0.,1.2,0.,,12346\nMAT1,1,2.+11,,.3,8000.\n";
  const double G = 2e11 / 2.6, L = 0.6, wave = std::sqrt(G * 2e-9 / (8000 * 4e-9)) / L / (2 * pi);
  const std::string plain = "CBEAM,1,1,1,2,1.,0.,0.\n", pinned = "CBEAM,1,1,1,2,1.,0.,0.,,+\n+,5\n";
  for (const std::string& first : {plain, pinned}) { // what is released bends alone
    const Eigen::VectorXd found =
        lumped_hertz(lumped_deck("a.bdf", held + first +
                                              "CBEAM,2,1,2,3,1.,0.,0.\n"
                                              "PBEAM,1,1,1.-4,1.-9,3.-9,,2.-9\n"),
                     2);
    for (int k = 0; k < 2; ++k)
      EXPECT_NEAR(found[k] / (wave * 2 * std::sin((2 * k + 1) * pi / 8)), 1, deck_agreement);
  }
  const Model bars = place(
      lumped_deck("a.bdf", held + "CBAR,1,1,1,2,1.,0.,0.\nPBAR,1,1,1.-4,1.-9,3.-9,2.-9\n"), {});
  for (const MassElement& m : bars.masses) EXPECT_TRUE(m.body.inertia.isZero(0));
}

// The heavier end of a tapered bar has more of it, together they have all.
TEST(DeckLumped, tapered_bars_keep_their_mass) {
  const std::string bar = two_bars + "CBEAM,1,1,1,2,0.,1.,0.\nCBEAM,2,1,2,3,0.,1.,0.\n"
                                     "PBEAM,1,1,1.-4,1.-9,3.-9,,2.-9\n,,,,,,,,\n"
                                     ",YES,1.,4.-4,4.-9,12.-9,,8.-9\n,0.,0.\n"
                                     "MAT1,1,2.+11,,.3,8000.\n";
  const Model placed = place(lumped_deck("a.bdf", bar), {});
  EXPECT_NEAR(total_mass(placed) / (8000 * 2.5e-4 * 0.6), 1, 1e-9);
  ASSERT_EQ(placed.masses.size(), 3U);
  const double light = placed.masses[0].body.mass, heavy = placed.masses[2].body.mass;
  EXPECT_NEAR(light / (8000 * 0.3e-4 * (1 / 2. + 3 / 6.)), 1, 1e-9); // integral of rho A (1 - x)
  EXPECT_NEAR(placed.masses[1].body.mass, light + heavy, 1e-12);
}

std::string strip(const std::string& element, const std::string& property,
                  const std::string& density) {
  const Mesh mesh = deck_plate();
  std::string text = property + "MAT1,1,2.+11,,.3," + density + "\n";
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    text += fmt::format("GRID,{},,{:.6f},{:.6f},0.\n", i + 1, mesh.nodes[i].x(), mesh.nodes[i].y());
  for (std::size_t e = 0; e < mesh.quads.size(); ++e) {
    const auto& n = mesh.quads[e].nodes;
    if (element == "CQUAD4")
      text +=
          fmt::format("CQUAD4,{},1,{},{},{},{}\n", e + 1, n[0] + 1, n[1] + 1, n[2] + 1, n[3] + 1);
    else
      text += fmt::format("CTRIA3,{},1,{},{},{}\nCTRIA3,{},1,{},{},{}\n", 2 * e + 1, n[0] + 1,
                          n[1] + 1, n[2] + 1, 2 * e + 2, n[0] + 1, n[2] + 1, n[3] + 1);
  }
  for (int node : mesh.sets.at("edge4")) text += fmt::format("SPC1,1,123456,{}\n", node + 1);
  return text;
}

// Bodies of the mass of every shell in equal parts at its corners.
std::string bodies(bool triangles, double mass_per_area) {
  const Mesh mesh = deck_plate();
  const double area = 0.3 * 0.2 / 24;
  std::vector<double> mass(mesh.nodes.size(), 0);
  for (const ShellQuad& q : mesh.quads)
    for (std::size_t a = 0; a < 4; ++a) {
      const double share = triangles ? (a % 2 == 0 ? 1. / 3 : 1. / 6) : 1. / 4;
      mass[std::size_t(q.nodes[a])] += share * area * mass_per_area;
    }
  std::string text;
  for (std::size_t i = 0; i < mass.size(); ++i)
    text += fmt::format("CONM2,{},{},,{:.10f}\n", 900 + i, i + 1, mass[i]);
  return text;
}

TEST(DeckLumped, shells_weigh_at_their_corners) {
  for (const char* element : {"CQUAD4", "CTRIA3"}) {
    const bool triangles = element[1] == 'T';
    for (const char* wall :
         {"PSHELL,1,1,.002,1,,1", "PSHELL,1,1,.002", "PCOMP,1,,{}\n,1,1.-3,0.,,1,1.-3,0.",
          "PCOMP,1,,{}\n,1,1.-3,0.,,2,1.-3,0."}) {
      const std::string text = wall;
      const bool plies = text.starts_with("PCOMP"), membrane = text == "PSHELL,1,1,.002";
      const auto property = [&](const std::string& extra) {
        const std::string orthotropic =
            "MAT8,2,2.+11,1.+11,.3,7.+10,,," + std::string(extra.empty() ? "" : "8000.") + "\n";
        if (plies) return orthotropic + fmt::format(fmt::runtime(text), extra) + "\n";
        return text + (membrane ? ",,,,," : ",,") + extra + "\n" +
               (membrane ? "SPC1,1,3456,1,THRU,35\n" : "");
      };
      expect_alike(strip(element, property("5."), "8000."),
                   strip(element, property(""), "") + bodies(triangles, 8000 * 0.002 + 5));
    }
  }
}

// --- what else there is

// What Plica writes of such a model comes back: its elements weigh nothing there, its bodies do.
TEST(DeckLumped, is_written_again) {
  const TemporaryFolder folder("deck_lumped");
  const std::string text = strip("CQUAD4", "PSHELL,1,1,.002,1,,1\n", "8000.");
  const auto read = [&](const std::string& deck) {
    write_whole(folder.path / "strip.bdf", deck);
    write_whole(folder.path / "case.yaml",
                "case: strip\nparts:\n  all: {type: deck, file: strip.bdf, length_unit: 1 m, "
                "mass_unit: 1 kg}\nanalyses: {static: false, error_bars: false, "
                "modes: {count: 4}}\n");
    return read_case((folder.path / "case.yaml").string()).data;
  };
  const Results consistent = run_silently(read(of_consistent_mass(text)));
  const Case data = read(text);
  const Results lumped = run_silently(data);
  EXPECT_LT(lumped.modes[3].frequency, 0.995 * consistent.modes[3].frequency);
  EXPECT_NEAR(lumped.model.mass, 8000 * 0.3 * 0.2 * 0.002, 1e-9);
  EXPECT_EQ(lumped.warnings.size(), consistent.warnings.size());
  EXPECT_TRUE(symbols_of(data, build(data)).empty()); // masses of elements are not drawn
  const Results again = run_silently(read(nastran_model(data, build(data))));
  for (std::size_t m = 0; m < 4; ++m)
    EXPECT_NEAR(again.modes[m].frequency / lumped.modes[m].frequency, 1, deck_agreement) << m;
}

} // namespace deck_lumped
} // namespace plica::test
