// From the files of a test to a measured.yaml that compare, fit and diagnose read as it is; and
// what is said, with file, line and key, of signals from which no mode follows.
#include "tests/chain_of_masses.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/temporary_folder.hpp"

#include "compare/correlate.hpp"
#include "io/files/files.hpp"
#include "io/input/measured_file.hpp"
#include "io/lab_files/time_runs.hpp"
#include "io/write/simulated_yaml.hpp"
#include "lab/identification/identified_measured.hpp"
#include "words/input_error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace plica::test {
namespace {

using Eigen::Index;

std::string csv_of(const TimeRecord& record, const std::string& unit = "") {
  std::string text = "time [s]";
  for (const std::string& c : record.channels)
    text += "," + c.substr(0, c.size() - 2) + " " + c.back() + unit;
  for (Index n = 0; n < record.samples.rows(); ++n) {
    text += fmt::format("\n{}", double(n) / record.rate);
    for (Index c = 0; c < record.samples.cols(); ++c)
      text += fmt::format(",{:.9g}", record.samples(n, c));
  }
  return text + "\n";
}

constexpr const char* head = "specimen: chain\n"                 // 1
                             "source: 'a chain''s test'\n"       // 2
                             "sensors:\n"                        // 3
                             "  - {name: m1, at: [0, 0.1, 0]}\n" // 4
                             "  - {name: m2, at: [0, 0.2, 0]}\n" // 5
                             "  - {name: m3, at: [0, 0.3, 0]}\n" // 6
                             "  - {name: m4, at: [0, 0.4, 0], mass: 5 g}\n"
                             "states: [{name: cold, baseline: true}, {name: warm}]\n"
                             "signals:\n"; // 9

MeasuredFile read(const TemporaryFolder& folder, const std::string& signals,
                  const std::string& begin = head) {
  write_whole(folder.path / "measured.yaml", begin + signals);
  return read_measured_file((folder.path / "measured.yaml").string());
}

TestOnFile on_file(const MeasuredFile& file) {
  return {.data = file.data, .path = file.path, .lines = file.lines};
}

// Decays in a baseline and outputs in another state, identified, written, read and held against
// what is true: nothing is pasted.
TEST(IdentifiedFile, is_read_as_it_is_written) {
  const TemporaryFolder folder("identified");
  const Chain cold;
  Chain warm = cold;
  warm.f0 *= 0.97;
  for (int hit = 0; hit < 2; ++hit) {
    TimeRecord record = let_go(cold, 2 * hit, 256, 5, 0.4);
    add_white_noise(record.samples, 0.005, 1 + unsigned(hit));
    write_whole(folder.path / fmt::format("hit{}.csv", hit + 1), csv_of(record));
  }
  TimeRecord noise = shaken(warm, 128, 20000, 5);
  write_whole(folder.path / "road.csv", csv_of(noise));
  const MeasuredFile file =
      read(folder, "  - {file: hit1.csv, excitation: free_decay, state: cold}\n"
                   "  - {file: hit2.csv, excitation: free_decay, state: cold}\n"
                   "  - {file: road.csv, excitation: output_only, state: warm}\n");
  std::vector<IdentifiedRun> runs;
  const std::vector<TimeRun> all = time_runs(on_file(file));
  ASSERT_EQ(all.size(), 2U); // the decays belong together
  EXPECT_EQ(all[0].records.size(), 2U);
  for (const TimeRun& run : all)
    runs.push_back({.title = run.records[0].name,
                    .found = identified(run, on_file(file), {.highest_order = 12}),
                    .state = run.state});
  write_whole(folder.path / "identified.yaml",
              simulated_yaml(identified_measured(file.data, runs)));
  const Measured back = read_measured((folder.path / "identified.yaml").string());
  EXPECT_EQ(back.specimen, "chain");
  EXPECT_EQ(back.source, "a chain's test");
  EXPECT_EQ(back.sensors.size(), 4U);
  EXPECT_DOUBLE_EQ(back.sensors[3].mass, 0.005);
  ASSERT_EQ(back.states.size(), 2U);
  EXPECT_TRUE(back.states[0].baseline);
  EXPECT_TRUE(back.signals.empty());
  ASSERT_EQ(back.modes.size(), 8U);
  for (int i = 0; i < 8; ++i) {
    const MeasuredMode& mode = back.modes[std::size_t(i)];
    const Chain& chain = i < 4 ? cold : warm;
    EXPECT_EQ(mode.state, i < 4 ? "cold" : "warm");
    ASSERT_TRUE(mode.sigma && mode.damping && mode.sigma_damping && mode.vector);
    EXPECT_LT(std::abs(mode.frequency - chain.frequency(i % 4)), 4 * *mode.sigma) << i;
    EXPECT_EQ(mode.shape, MeasuredShape::transverse);
    EXPECT_EQ(mode.direction, Axis::x);
    EXPECT_EQ(mode.order, i % 4 + 1);
    const IdentifiedMode& own = runs[std::size_t(i / 4)].found.modes[std::size_t(i % 4)];
    EXPECT_EQ(mode.frequency, own.frequency); // without loss
    EXPECT_EQ(mode.vector->imaginary[2], own.shape[2].imag());
  }
  // Held against the chain in the other state: by shape, 3 % apart.
  TestData one{.data = back, .responses = {}}, other = one;
  std::erase_if(one.data.modes, [](const MeasuredMode& m) { return m.state != "cold"; });
  std::erase_if(other.data.modes, [](const MeasuredMode& m) { return m.state != "warm"; });
  const Correlation c = correlate(one, other);
  ASSERT_EQ(c.pairs.size(), 4U);
  for (const PairedMode& p : c.pairs) {
    EXPECT_EQ(p.by, "shape");
    EXPECT_GT(*p.mac, 0.98);
    EXPECT_NEAR(p.frequency_error, 1 / 0.97 - 1, 6e-3);
  }
}

TEST(IdentifiedFile, names_file_line_and_key_of_bad_signals) {
  const TemporaryFolder folder("bad_signals");
  const Chain chain;
  TimeRecord steady = shaken(chain, 128, 4000, 1), good = let_go(chain, 0, 256, 5, 0.4);
  write_whole(folder.path / "steady.csv", csv_of(steady));
  write_whole(folder.path / "good.csv", csv_of(good));
  TimeRecord clipped = good;
  clipped.samples = clipped.samples.cwiseMin(0.08).eval();
  write_whole(folder.path / "clipped.csv", csv_of(clipped));
  const auto error = [&](const std::string& signals) {
    const MeasuredFile file = read(folder, signals);
    return error_of([&] { time_runs(on_file(file)); });
  };
  EXPECT_NE(error("  - {file: good.csv, excitation: free_decay}\n"
                  "  - {file: steady.csv, excitation: free_decay}\n")
                .find("measured.yaml:11: signals[1].file: does not decay"),
            std::string::npos);
  const std::string channels = "  - file: clipped.csv\n"
                               "    excitation: free_decay\n"
                               "    channels: [m1.x, m2.x, m3.x, m4.x]\n";
  EXPECT_NE(error(channels).find("measured.yaml:12: signals[0].channels: m1.x is clipped"),
            std::string::npos)
      << error(channels);
  // A row is missing.
  std::string torn = csv_of(good);
  const std::size_t row = torn.find("\n1,");
  torn.erase(row, torn.find('\n', row + 1) - row);
  write_whole(folder.path / "torn.csv", torn);
  EXPECT_NE(error("  - {file: torn.csv, excitation: free_decay}\n").find("not evenly spaced"),
            std::string::npos);
  // Two kinds of channels.
  std::string mixed = csv_of(good, " [m/s]");
  mixed.replace(mixed.find("[m/s]"), 5, "[m/s2]");
  write_whole(folder.path / "mixed.csv", mixed);
  EXPECT_NE(error("  - {file: mixed.csv, excitation: free_decay}\n")
                .find("measured.yaml:10: signals[0].channels: m2.x is"),
            std::string::npos);
  const MeasuredFile file = read(folder, "  - {file: steady.csv, excitation: output_only}\n");
  const std::vector<TimeRun> runs = time_runs(on_file(file));
  EXPECT_NE(error_of([&] {
              identified(runs[0], on_file(file), {.high = 80});
            }).find("measured.yaml:10: signals[0].rate: of 128 Hz is too low"),
            std::string::npos);
}

TEST(IdentifiedFile, says_what_does_not_go_with_an_excitation) {
  const TemporaryFolder folder("excitation");
  write_whole(folder.path / "a.csv", csv_of(let_go(Chain(), 0, 256, 5, 0.4)));
  const auto error = [&](const std::string& rest) {
    return error_of([&] { read(folder, "  - {file: a.csv" + rest + "}\n"); });
  };
  EXPECT_EQ(error(", excitation: free_decay"), "no error");
  EXPECT_EQ(error(", excitation: output_only, state: warm"), "no error");
  EXPECT_NE(error("").find(":10: signals[0]: names no reference"), std::string::npos);
  EXPECT_NE(error(", excitation: output_only, reference: m1.x")
                .find("signals[0].reference: does not go with output_only"),
            std::string::npos);
  EXPECT_NE(error(", excitation: free_decay, base: y")
                .find("signals[0].base: does not go with free_decay"),
            std::string::npos);
  EXPECT_NE(error(", excitation: output_only, quantity: mobility")
                .find("signals[0].quantity: does not go"),
            std::string::npos);
  EXPECT_NE(error(", excitation: free_decy").find("did you mean 'free_decay'?"), std::string::npos);
  EXPECT_NE(error(", excitation: free_decay, state: hot").find("there is no state 'hot'"),
            std::string::npos);
}

} // namespace
} // namespace plica::test
