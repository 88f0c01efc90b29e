// Ten lines as their users write them: what each stumbled over is gone.
#include "io/files/files.hpp"
#include "io/files/output_folder.hpp"
#include "io/input/case_file.hpp"
#include "io/input/starter_case.hpp"
#include "io/report/report.hpp"
#include "io/tables/summary.hpp"
#include "io/write/write_results.hpp"
#include "run/analyses/run.hpp"
#include "tests/support/temporary_folder.hpp"
#include "words/directions.hpp"
#include "words/input_error.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace plica::test {
namespace {

using Complex = std::complex<double>;

// A pipe on its engine with a hanger at its end; what follows is the rest of the case.
const std::string hung_pipe = R"(case: hung
materials: {steel: {E: 200 GPa, nu: 0.3, rho: 7850 kg/m3}}
parts:
  pipe:
    type: beam
    points: [[0, 0, 0], [0, 1.2 m, 0]]
    elements: 12
    section: {shape: pipe, material: steel, radius: 30 mm, thickness: 1.5 mm}
    PLACES
  muffler: {type: mass, at: "pipe.MUFFLER", mass: 6 kg, inertia: [0.1, 0.05, 0.1, 0, 0, 0]}
caps: {engine: {of: pipe.start}, hanger: {of: pipe.end}}
mount:
  engine: rigid
  hanger: {stiffness: [20 N/mm, 20 N/mm, 40 N/mm, 0, 0, 0]}
sensors: [{name: muffler, at: [0, 0.6 m, 0]}, {name: tail, at: [0, 1.2 m, 0]}]
analyses:
  error_bars: false
  static: false
  modes: {count: 10}
  damping: {modal: 1 %}
)";

std::string replaced_by(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

std::string hung(const std::string& analyses, const std::string& places = "",
                 const std::string& muffler = "all") {
  return replaced_by(replaced_by(hung_pipe, "PLACES",
                                 places.empty() ? "places: {middle: {at: [0, "
                                                  "0.6 m, 0]}}"
                                                : places),
                     "MUFFLER", muffler == "all" ? "middle" : muffler) +
         analyses;
}

Case case_of(const std::string& text) {
  const TemporaryFolder folder("line_case");
  write_whole(folder.path / "line.yaml", text);
  return read_case((folder.path / "line.yaml").string()).data;
}

Results line_results(const std::string& text) {
  return run(case_of(text), [](const std::string&) {});
}

std::string complaints(const std::string& text) {
  try {
    line_results(text);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

// 1. The engine moves, the body behind the hanger rests: no heavy mass is needed, the proof holds,
// and slowly the engine end is followed by the share that statics says.
TEST(LineCases, the_engine_moves_and_the_body_rests) {
  const Results r =
      line_results(hung("  response: {base: [{move: [engine], direction: z}, "
                        "{move: [hanger], direction: z}], band: [0.5 Hz, 100 Hz]}\n"));
  EXPECT_TRUE(r.verification.passed) << r.verification.reason;
  ASSERT_EQ(r.responses.size(), 2u);
  // Tail by both together is 1 in statics: channel 5 is tail z.
  const Complex sum = r.responses[0].acceleration(0, 5) + r.responses[1].acceleration(0, 5);
  EXPECT_NEAR(std::abs(sum), 1, 0.02);
  EXPECT_GT(std::abs(r.responses[1].acceleration(0, 5)), 0.05);
}

// 2. Amplitudes in kN; forces are in responses.uff; peaks have a phase.
TEST(LineCases, forces_in_kilonewtons_are_written_and_their_peaks_have_phases) {
  const Case data = case_of(hung("  response: {forces: [{name: tap, at: pipe.middle, direction: z, "
                                 "amplitude: 0.2 kN}], band: [2 Hz, 300 Hz]}\n"));
  const Results r = run(data, [](const std::string&) {});
  EXPECT_EQ(r.responses.at(0).level, 200);
  ASSERT_FALSE(r.responses[0].peaks.empty());
  EXPECT_NEAR(std::abs(r.responses[0].peaks[0].phase), std::numbers::pi / 2, 0.2);
  const TemporaryFolder folder("line_forces");
  OutputFolder out(folder.path / "out",
                   {.command = "run", .inputs = {}, .names = result_files(data)});
  write_results(r, out);
  out.commit();
  EXPECT_NE(read_whole(folder.path / "out" / "responses.uff").find("tap"), std::string::npos);
}

// 3. A run-up whose speed is given over time: Campbell, the crossing and what is reached in time.
TEST(LineCases, a_run_up_over_time_is_drawn_and_reaches_less_than_steadily) {
  const Results r = line_results(
      hung("  response: {base: [{move: [engine], direction: z}], band: [2 Hz, 300 Hz]}\n"
           "  run_ups: [{name: pull, table: [[0 s, 600 rpm], [3 s, 3000 rpm]], orders: [{order: 2, "
           "of: engine_z, acceleration: 1 m/s2}]}]\n"));
  const RunUpResult& u = r.run_ups.at(0);
  ASSERT_TRUE(u.sweeps);
  ASSERT_FALSE(u.crossings.empty());
  const OrderCrossing& largest =
      *std::max_element(u.crossings.begin(), u.crossings.end(),
                        [](const OrderCrossing& one, const OrderCrossing& other) {
                          return one.amplitude < other.amplitude;
                        });
  EXPECT_GT(*largest.haste, 2);
  EXPECT_LT(*largest.reached, 0.9 * largest.amplitude);
  const std::string page = report_html(r);
  EXPECT_NE(page.find("Campbell"), std::string::npos);
  EXPECT_NE(page.find("in time"), std::string::npos);
  EXPECT_NE(summary_text(r, {}).find("in time"), std::string::npos);
}

// 4. A dashpot at the hanger: the terminal and the modes have its damping, complex modes are there.
TEST(LineCases, a_dashpot_at_a_hanger_damps_the_modes_that_move_it) {
  const std::string text = replaced_by(
      hung("  response: {base: [z], band: [2 Hz, 300 Hz], referee: 4}\n"), "40 N/mm, 0, 0, 0]}",
      "40 N/mm, 0, 0, 0], damping: {dashpot: [0, 0, 200 N s/m, 0, 0, 0]}}");
  const Results r = line_results(text), undamped = line_results(hung(""));
  ASSERT_TRUE(r.complex_modes.complete) << r.complex_modes.reason;
  double most = 0;
  for (const ModeResult& m : r.modes) most = std::max(most, m.damping);
  EXPECT_GT(most, 0.05);
  for (const ModeResult& m : undamped.modes) EXPECT_NEAR(m.damping, 0.01, 1e-12);
  for (const DirectCheck& check : r.responses.at(0).direct) EXPECT_LT(check.difference, 0.01);
  EXPECT_NE(summary_text(r, {}).find("direct solution"), std::string::npos);
}

// 5. A mode that moves in z is no axial one: the first axial mode moves along the pipe.
TEST(LineCases, modes_are_called_by_what_they_move) {
  const Results r = line_results(hung(""));
  int axial = 0, along_z = 0;
  for (const ModeResult& m : r.modes) {
    if (m.shape == "axial") {
      ++axial;
      EXPECT_GT(m.effective_mass[1], m.effective_mass[2]) << m.frequency;
    }
    if (m.effective_mass[2] > 0.5 * r.free_mass[2]) {
      ++along_z;
      EXPECT_EQ(m.shape, "transverse") << m.frequency;
      EXPECT_EQ(m.direction, "z");
    }
  }
  EXPECT_EQ(axial, 1);
  EXPECT_EQ(along_z, 1);
}

// Local maxima of what is shown, farther than 4 % from any mode.
int maxima_away_from_modes(const Results& r) {
  int count = 0;
  for (const ResponseResult& response : r.responses)
    for (int c : response.shown) {
      const Eigen::VectorXd a = response.acceleration.col(c).cwiseAbs();
      for (Eigen::Index i = 1; i + 1 < a.size(); ++i)
        if (a[i] > a[i - 1] && a[i] > a[i + 1] &&
            std::none_of(r.modes.begin(), r.modes.end(), [&](const ModeResult& m) {
              return std::abs(m.frequency / response.hertz[i] - 1) < 0.04;
            }))
          ++count;
    }
  return count;
}

// 6. Every peak is at a mode: no plateau between antiresonances is one.
TEST(LineCases, plateaus_are_no_peaks) {
  const Results r = line_results(hung("  response: {base: [x, y, z], band: [2 Hz, 900 Hz]}\n"));
  int peaks = 0;
  for (const ResponseResult& response : r.responses)
    for (const ResponsePeak& p : response.peaks) {
      ++peaks;
      EXPECT_TRUE(std::any_of(r.modes.begin(), r.modes.end(), [&](const ModeResult& m) {
        return std::abs(m.frequency / p.frequency - 1) < 0.04;
      })) << p.frequency;
    }
  EXPECT_GT(peaks, 5);
  EXPECT_GT(maxima_away_from_modes(r), 0) << "a line without a plateau shows nothing here";
}

// 7. Masses and sensors anywhere along a beam, a sensor on its skin: the mesh makes the nodes.
TEST(LineCases, a_muffler_sits_where_it_is_said) {
  const std::string text = replaced_by(hung("", "places: {odd: {at: [0, 0.437 m, 0]}}", "odd"),
                                       "at: [0, 0.6 m, 0]}", "at: [0, 0.913 m, 30 mm]}");
  const Results r = line_results(text);
  EXPECT_LT(r.sensors.at(0).distance, 1e-9);
  const auto muffler = std::find_if(r.symbols.begin(), r.symbols.end(),
                                    [](const Symbol& s) { return s.name == "muffler"; });
  ASSERT_NE(muffler, r.symbols.end());
  EXPECT_NEAR(r.mesh.nodes[std::size_t(muffler->node)].y(), 0.437, 1e-12);
}

// Distances are judged as they are printed: none is refused as "5.00 mm, at most 5 mm".
TEST(LineCases, a_distance_is_judged_as_it_is_printed) {
  const auto at = [](const std::string& z) {
    return "case: bent\nmaterials: {steel: {E: 200 GPa, nu: 0.3, rho: 7850}}\nparts:\n  pipe: "
           "{type: "
           "beam, points: [[0.1, 0, 0], [0.1, 1, 0]], elements: 8, section: {shape: pipe, "
           "material: "
           "steel, radius: 30 mm, thickness: 1.5 mm}}\ncaps: {end: {of: pipe.start}}\nmount: {end: "
           "rigid}\nsensors: [{name: skin, at: [0.1, 0.5, " +
           z + "]}]\nanalyses: {modes: {count: 3}, error_bars: false}\n";
  };
  EXPECT_EQ(complaints(at("35.754 mm")), ""); // 5.004 mm off the skin
  const std::string said = complaints(at("35.81 mm"));
  EXPECT_NE(said.find("5.06 mm away"), std::string::npos) << said;
}

// 8. What nothing holds is named by its free motion.
TEST(LineCases, a_line_that_nothing_holds_says_how_it_is_free) {
  const std::string text = replaced_by(
      replaced_by(hung("  response: {base: [z], band: [2 Hz, 300 Hz]}\n"), "  engine: rigid\n", ""),
      "[20 N/mm, 20 N/mm, 40 N/mm, 0, 0, 0]", "[0, 20 N/mm, 40 N/mm, 1e3, 1e3, 1e3]");
  const std::string said = complaints(text);
  EXPECT_NE(said.find("nothing holds the part"), std::string::npos) << said;
  EXPECT_NE(said.find("x"), std::string::npos) << said;
}

// 9. Friction and rubber at one hanger, over the level.
TEST(LineCases, a_hanger_with_friction_and_rubber_has_levels) {
  const std::string text = replaced_by(
      hung("  levels: {base: [z], levels: [0.01, 5], band: [5 Hz, 60 Hz], points: 40, backbones: "
           "0}\n"),
      "40 N/mm, 0, 0, 0]}",
      "40 N/mm, 0, 0, 0], damping: {maxwell: [{share: 0.3, time: 5 ms}]}, friction: {z: {sliders: "
      "[{stiffness: 30 N/mm, slip_force: 5 N}]}}}");
  const Results r = line_results(text);
  const LevelResponses& responses = r.level_responses.at(0);
  ASSERT_EQ(responses.curves.size(), 2U);
  for (const LevelCurve& c : responses.curves) EXPECT_TRUE(c.complete) << c.reason;
  EXPECT_EQ(responses.referee.size(), 2U);
  for (const RefereeCheck& check : responses.referee) {
    EXPECT_TRUE(check.settled);
    EXPECT_LT(check.difference, 0.02);
  }
}

// 10. The line of `plica init`, seen: beams with their section, muffler and hangers with their
// names.
TEST(LineCases, the_starter_is_drawn_with_its_muffler_and_hangers) {
  const std::vector<StarterFile> files = starter_files(Starter::line, "own");
  std::string text = files[0].text;
  text = replaced_by(text, "mesh: {accuracy: 2 %}", "mesh: {around: 32, arc: 2, wall: 2}");
  Case data = case_of(text);
  data.analyses.error_bars = false;
  const Results r = run(data, [](const std::string&) {});
  for (std::size_t i = 0; i < r.lines.size(); ++i) EXPECT_GT(r.line_radii.at(i), 0.03);
  for (const ModeResult& m : r.modes) // the bellows moves along, the line is what they are about
    for (std::size_t d = 0; d < 3; ++d)
      if (m.effective_mass[d] > 0.5 * r.free_mass[d]) {
        EXPECT_EQ(m.direction, axis_word(int(d))) << m.frequency;
        EXPECT_EQ(m.shape, d == 1 ? "axial" : "transverse") << m.frequency;
      }
  const std::string page = report_html(r);
  for (const char* name : {"muffler", "hanger_front", "hanger_rear", "engine"})
    EXPECT_NE(page.find(">" + std::string(name) + "</text>"), std::string::npos) << name;
  EXPECT_NE(page.find("class=\"body\""), std::string::npos);
}

// The report begins with the verdict, the part and its numbers, then come the sections; units are
// written in one way, and 3 sigma stands beside the RMS.
TEST(LineCases, the_report_begins_with_picture_and_verdict) {
  const Results r = line_results(
      hung("  response: {base: [y, z], level: 5 m/s2, band: [2 Hz, 300 Hz], random: {level: 0.05 "
           "(m/s2)2/Hz}}\n"));
  const std::string page = report_html(r);
  const auto place = [&](const char* what) { return page.find(what); };
  EXPECT_LT(place("class=\"verdict"), place("<figure class=\"viewer"));
  EXPECT_LT(place("<figure class=\"viewer"), place("first axial mode"));
  EXPECT_LT(place("first axial mode"), place("<section"));
  EXPECT_NE(place("3 σ"), std::string::npos);
  EXPECT_NE(place("m/s² per m/s²"), std::string::npos);
  EXPECT_EQ(place("m/s² per m/s2"), std::string::npos);
}

} // namespace
} // namespace plica::test
