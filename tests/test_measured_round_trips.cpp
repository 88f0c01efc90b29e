// What runs and identifications write is read again: the way simulate, write, add noise, read,
// identify.
#include "tests/bellows_case.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/written.hpp"
#include "tests/synthetic_frf.hpp"

#include "compare/correlate.hpp"
#include "compare/simulated.hpp"
#include "io/files/files.hpp"
#include "io/input/measured_file.hpp"
#include "io/lab_files/measured_data.hpp"
#include "io/universal/signals.hpp"
#include "io/universal/writer.hpp"
#include "io/write/simulated_yaml.hpp"
#include "io/write/write_identification.hpp"
#include "lab/identification/identify.hpp"
#include "lab/measured/entries.hpp"

#include <fmt/format.h>

namespace plica::test {
namespace {

Results base_driven_bellows() {
  Case data = verification_case("bellows_a", {16, 2, 3}, 12);
  const double y = data.analyses.modes ? 0.02 : 0;
  data.sensors = {{.name = "a", .at = {0.026, y, 0}, .axes = {1, 2, 3}, .reach = 1},
                  {.name = "b", .at = {0, y / 2, 0.026}, .axes = {1, -3, 2}, .reach = 1}};
  data.analyses.damping.modal = 0.01;
  data.analyses.response =
      Response{.bases = {1, 0}, .forces = {}, .band = {50, 2500}, .points = 4000};
  return run_silently(data);
}

// Simulate, write as UFF with noise, read, identify: frequencies to 0.05 %, damping to 5 %.
TEST(MeasuredRoundTrip, simulated_responses_are_identified) {
  const TemporaryFolder folder("round_trip");
  const Results results = base_driven_bellows();
  Measured m = as_measured(results);
  std::string text;
  std::vector<FrfSet> sets = responses_to_base(results);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    add_noise(sets[i], 0.002, 7 + unsigned(i));
    text.clear();
    for (const UniversalFunction& f : universal_functions(sets[i])) text += universal_text(f);
    m.frf[i].file = "base" + std::to_string(i) + ".uff";
    write_whole(folder.path / m.frf[i].file, text);
  }
  int compared = 0;
  const std::vector<FrfSet> read = load_frfs(m, folder.path);
  ASSERT_EQ(read.size(), 1U) << "two directions of the base are two references";
  const Identification found = identify(read[0], {});
  for (const ModeResult& mode : results.modes) {
    if (mode.frequency > 2400 ||
        mode.effective_mass[0] + mode.effective_mass[1] < 0.02 * results.model.mass)
      continue;
    ++compared;
    const bool met =
        std::any_of(found.modes.begin(), found.modes.end(), [&](const IdentifiedMode& f) {
          return std::abs(f.frequency / mode.frequency - 1) < 5e-4 &&
                 std::abs(f.damping / 0.01 - 1) < 0.05;
        });
    EXPECT_TRUE(met) << mode.shape << " at " << mode.frequency;
  }
  if (HasFailure()) std::printf("%s", identification_text(found, {}, "found").c_str());
  EXPECT_GE(compared, 3);
}

// simulated.yaml is a measured.yaml: read again it is the run, and beside itself all is one.
TEST(MeasuredRoundTrip, a_run_is_read_as_a_test) {
  const TemporaryFolder folder("simulated");
  const Results results = base_driven_bellows();
  Measured written = as_measured(results);
  written.frf.clear();
  write_whole(folder.path / "simulated.yaml", simulated_yaml(written));
  const Measured read = read_measured((folder.path / "simulated.yaml").string());
  ASSERT_EQ(read.modes.size(), written.modes.size());
  for (std::size_t i = 0; i < read.modes.size(); ++i) {
    EXPECT_EQ(read.modes[i].frequency, written.modes[i].frequency);
    EXPECT_EQ(read.modes[i].vector->real, written.modes[i].vector->real);
  }
  EXPECT_EQ(read.sensors.at(1).axes, (std::vector<int>{1, -3, 2}));
  EXPECT_EQ(read.weighings.at(0).value, written.weighings.at(0).value);
  const std::vector<FrfSet> frfs = responses_to_base(results);
  const Correlation c = correlate({read, {frfs}}, {written, {frfs}});
  ASSERT_EQ(c.pairs.size(), written.modes.size());
  for (const PairedMode& p : c.pairs) EXPECT_EQ(p.frequency_error, 0);
  for (const ComparedResponse& r : c.responses) EXPECT_NEAR(r.frac, 1, 1e-12);
}

TEST(MeasuredRoundTrip, weighings_of_several_states_stay_a_list) {
  const TemporaryFolder folder("weighings");
  Measured written;
  written.specimen = "a";
  written.source = "a scale";
  written.states = {{.name = "before", .baseline = true, .set = {}, .numbers = {}},
                    {.name = "after", .baseline = false, .set = {}, .numbers = {}}};
  written.weighings = {{.value = 1.2, .sigma = 0.001, .repeats = {}, .state = "before"},
                       {.value = 1.25, .sigma = {}, .repeats = {}, .state = "after"}};
  written.hold_out = {"mass[1]"};
  write_whole(folder.path / "measured.yaml", simulated_yaml(written));
  const Measured read = read_measured((folder.path / "measured.yaml").string());
  ASSERT_EQ(read.weighings.size(), 2U);
  EXPECT_EQ(read.weighings[0].sigma, 0.001);
  EXPECT_EQ(read.weighings[1].value, 1.25);
  EXPECT_EQ(read.weighings[1].state, "after");
  EXPECT_TRUE(is_held_out(read, "mass[1]"));
}

// What identify writes for a measured.yaml is read there.
TEST(MeasuredRoundTrip, identified_modes_are_entries_of_measured_yaml) {
  const TemporaryFolder folder("entries");
  const Identification found =
      identify(synthetic(four_dof(), FrfQuantity::accelerance, 5, 70, 1301, 2), {});
  written(folder.path, [&](OutputFolder& out) { write_identification(found, {}, "four", out); });
  std::string sensors = "specimen: four\nsensors:\n";
  for (int k = 1; k < 5; ++k) sensors += fmt::format("  - {{name: p{}, at: [0, 0, 0]}}\n", k);
  write_whole(folder.path / "measured.yaml",
              sensors + read_whole(folder.path / "measured_modes.yaml"));
  const Measured m = read_measured((folder.path / "measured.yaml").string());
  ASSERT_EQ(m.modes.size(), 4U);
  EXPECT_NEAR(m.modes[0].frequency, 12, 1e-4);
  EXPECT_NEAR(m.modes[0].vector->real[3], 1, 1e-5); // mass-normalised
  EXPECT_TRUE(std::filesystem::exists(folder.path / "shapes.uff"));
}

} // namespace
} // namespace plica::test
