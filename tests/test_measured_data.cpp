// The lab's files: CSV in its dialects, MATLAB, universal files; channels, references, signals.
#include "tests/support/refusal.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/synthetic_frf.hpp"

#include "io/files/files.hpp"
#include "io/input/measured_file.hpp"
#include "io/lab_files/csv_table.hpp"
#include "io/lab_files/measured_data.hpp"
#include "io/matlab/matlab_file.hpp"
#include "io/universal/signals.hpp"
#include "io/universal/writer.hpp"
#include "lab/identification/identify.hpp"
#include "lab/signals/frf_of_signals.hpp"

#include <fmt/format.h>

namespace plica::test {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

CsvTable table_of(const TemporaryFolder& folder, const std::string& text) {
  write_whole(folder.path / "t.csv", text);
  return read_csv(folder.path / "t.csv");
}

TEST(Csv, reads_its_dialects_alike) {
  const TemporaryFolder folder("csv");
  for (const char* text :
       {"f [Hz],mid y real [g],mid y imaginary [g]\n1,2.5,-3\n2,1e-3,4\n",
        "\xef\xbb\xbf# made by somebody\r\nf [Hz];\"mid y real [g]\";mid y imaginary "
        "[g]\r\n1;2,5;-3\r\n"
        "2;1e-3;4\r\n",
        "f [Hz]\tmid y real [g]\tmid y imaginary [g]\n% units\n1\t2.5\t-3\n\n2\t0.001\t+4"}) {
    const CsvTable t = table_of(folder, text);
    ASSERT_EQ(t.columns.size(), 3U) << text;
    EXPECT_TRUE(t.header);
    EXPECT_EQ(t.columns[0].name, "f");
    EXPECT_EQ(t.columns[0].unit, "Hz");
    EXPECT_EQ(t.columns[1].name, "mid y real");
    EXPECT_EQ(t.columns[1].real, Eigen::Vector2d(2.5, 1e-3));
    EXPECT_EQ(t.columns[2].real, Eigen::Vector2d(-3, 4));
  }
}

TEST(Csv, reads_complex_cells) {
  const TemporaryFolder folder("csv");
  const CsvTable t = table_of(folder, "0.5+0j;-1.5e-3+2i;(1-2j)\n1;3j;4\n");
  ASSERT_EQ(t.columns.size(), 3U);
  EXPECT_FALSE(t.header);
  EXPECT_EQ(t.columns[1].real, Eigen::Vector2d(-1.5e-3, 0));
  EXPECT_EQ(t.columns[1].imaginary, Eigen::Vector2d(2, 3));
  EXPECT_EQ(t.columns[2].imaginary, Eigen::Vector2d(-2, 0));
}

TEST(Csv, names_line_and_column_of_what_is_wrong) {
  const TemporaryFolder folder("csv");
  const auto error = [&](const char* text) { return error_of([&] { table_of(folder, text); }); };
  EXPECT_NE(error("f,a\n1,2\n3,x\n").find("t.csv:3: column 2: 'x' is no number"),
            std::string::npos);
  EXPECT_NE(error("f,a\n1,2\n3,nan\n").find(":3: column 2"), std::string::npos);
  EXPECT_NE(error("f,a\n1,2\n3\n").find(":3"), std::string::npos);
  EXPECT_NE(error("f,a\n").find("no rows"), std::string::npos);
  EXPECT_NE(error("").find("has no rows"), std::string::npos);
}

Measured two_sensors() {
  Measured m;
  m.sensors = {{.name = "p1", .node = 7}, {.name = "p2"}};
  return m;
}

MeasuredFrf driven(const std::string& file, const std::string& channel) {
  MeasuredFrf f;
  f.file = file;
  f.force = channel;
  return f;
}

std::string frf_csv(const FrfSet& set, int reference) {
  std::string text = "frequency [Hz]";
  for (const std::string& r : set.responses) {
    const std::string name = r.substr(0, r.size() - 2) + " " + r.back();
    text += "," + name + " real," + name + " imaginary";
  }
  for (Index f = 0; f < set.hertz.size(); ++f) {
    text += fmt::format("\n{}", set.hertz[f]);
    for (Index o = 0; o < Index(set.responses.size()); ++o)
      text += fmt::format(",{},{}", set.H[reference](f, o).real(), set.H[reference](f, o).imag());
  }
  return text + "\n";
}

// Two files, each one driven point: one set with two references, whatever the form of the files.
TEST(MeasuredData, makes_references_of_files_of_every_kind) {
  const TemporaryFolder folder("frf");
  const FrfSet truth = synthetic(four_dof(), FrfQuantity::accelerance, 5, 70, 66, 2);
  std::string uff;
  for (const UniversalFunction& f : universal_functions(truth)) uff += universal_text(f);
  write_whole(folder.path / "both.uff", uff);
  Measured m;
  for (int i = 0; i < 2; ++i) {
    const std::string name = "by" + std::to_string(i + 1);
    write_whole(folder.path / (name + ".csv"), frf_csv(truth, i));
    MatlabWriter mat(folder.path / (name + ".mat"), "MATLAB 5.0 MAT-file");
    mat.put(matlab_matrix("f", MatrixXd(truth.hertz)));
    mat.put(matlab_matrix("H", MatrixXcd(truth.H[i].transpose()))); // lines along, as some do
  }
  for (const std::string ending : {".csv", ".mat", ".uff"}) {
    m.frf.clear();
    for (int i = 0; i < 2; ++i) {
      MeasuredFrf f = driven(ending == ".uff" ? "both.uff" : "by" + std::to_string(i + 1) + ending,
                             truth.references[i]);
      if (ending == ".mat") {
        f.channels = truth.responses;
        f.variables = {.abscissa = "f", .values = "H"};
      }
      m.frf.push_back(f);
    }
    const std::vector<FrfSet> sets = load_frfs(m, folder.path);
    ASSERT_EQ(sets.size(), 1U) << ending;
    EXPECT_EQ(sets[0].responses, truth.responses) << ending;
    EXPECT_EQ(sets[0].references, truth.references) << ending;
    for (int i = 0; i < 2; ++i)
      EXPECT_LT((sets[0].H[i] - truth.H[i]).norm(), 1e-10 * truth.H[i].norm()) << ending;
  }
}

TEST(MeasuredData, takes_nodes_and_directions_of_universal_files) {
  const TemporaryFolder folder("uff");
  UniversalFunction f;
  f.type = FunctionType::transmissibility;
  f.response = {.entity = "NONE", .node = 7, .direction = -2};
  f.reference = {.entity = "table", .node = 1, .direction = 2};
  f.data_type = UniversalDataType::complex_double;
  f.dx = 1;
  f.real = Eigen::Vector3d(1, 2, 3);
  f.imaginary = Eigen::Vector3d(0, 1, 0);
  write_whole(folder.path / "t.uff", universal_text(f));
  Measured m = two_sensors();
  m.frf.emplace_back();
  m.frf[0].file = "t.uff";
  m.frf[0].base = Axis::y;
  m.frf[0].sigma = FrfSigma{.relative = 0.1, .floor = 0.25};
  const FrfSet set = load_frfs(m, folder.path).at(0);
  EXPECT_EQ(set.responses.at(0), "p1.y");
  EXPECT_EQ(set.references.at(0), "base.y");
  EXPECT_EQ(set.H[0](1, 0), std::complex<double>(-2, -1));
  EXPECT_NEAR(set.sigma[0](0, 0), 0.25, 1e-15);
  EXPECT_NEAR(set.sigma[0](2, 0), 0.3, 1e-15);
}

TEST(MeasuredData, says_what_does_not_fit) {
  const TemporaryFolder folder("frf");
  write_whole(folder.path / "a.csv", "f,p1 x real,p1 x imaginary\n1,2,3\n1,2,3\n");
  write_whole(folder.path / "b.csv", "1,2,3,4\n2,3,4,5\n");
  write_whole(folder.path / "c.mat", "no MATLAB file");
  Measured m = two_sensors();
  const auto error = [&](MeasuredFrf f) {
    m.frf = {std::move(f)};
    return error_of([&] { load_frfs(m, folder.path); });
  };
  EXPECT_NE(error(driven("a.csv", "p1.x")).find("do not increase at row 2"), std::string::npos);
  write_whole(folder.path / "d.csv", "f,p1 x mag\n1,2\n2,2\n");
  EXPECT_NE(error(driven("d.csv", "p1.x")).find("no response has an imaginary part"),
            std::string::npos);
  MeasuredFrf two = driven("b.csv", "p1.x");
  two.channels = {"p1.x", "p2.x"};
  EXPECT_NE(error(two).find("names 2 channels, the file has 3"), std::string::npos);
  EXPECT_NE(error(driven("c.mat", "p1.x")).find("c.mat"), std::string::npos);
  EXPECT_NE(error(driven("none.uff", "p1.x")).find("none.uff"), std::string::npos);
}

// Types of a universal file: mobility, and accelerations in g.
TEST(MeasuredData, believes_the_data_types_of_universal_files) {
  const TemporaryFolder folder("types");
  FrfSet truth = synthetic(four_dof(), FrfQuantity::mobility, 5, 70, 66, 1);
  std::string text;
  for (const UniversalFunction& f : universal_functions(truth)) text += universal_text(f);
  write_whole(folder.path / "m.uff", text);
  EXPECT_EQ(load_frf_files({folder.path / "m.uff"}, std::nullopt).quantity, FrfQuantity::mobility);
  EXPECT_NE(error_of([&] {
              load_frf_files({folder.path / "m.uff"}, FrfQuantity::accelerance);
            }).find("the file says mobility"),
            std::string::npos);
  truth.quantity = FrfQuantity::accelerance;
  text.clear();
  for (UniversalFunction& f : universal_functions(truth)) {
    f.numerator.unit = "g";
    text += universal_text(f);
  }
  write_whole(folder.path / "g.uff", text);
  const FrfSet set = load_frf_files({folder.path / "g.uff"}, std::nullopt);
  EXPECT_LT((set.H[0] - 9.80665 * truth.H[0]).norm(), 1e-10 * set.H[0].norm());
}

// matio would give other numbers of a file that was cut, or sent as a text.
TEST(MatlabFile, damaged_on_its_way_is_refused) {
  const TemporaryFolder folder("matlab");
  {
    MatlabWriter mat(folder.path / "a.mat", "MATLAB 5.0 MAT-file");
    mat.put(matlab_matrix("f", MatrixXd(Eigen::VectorXd::LinSpaced(40, 1, 40))));
    mat.put(matlab_cell("names", {"one", "two"}));
    mat.put(matlab_matrix("H", MatrixXcd(MatrixXcd::Random(40, 2))));
  }
  const std::string good = read_whole(folder.path / "a.mat");
  EXPECT_EQ(MatlabReader(folder.path / "a.mat").matrix("f").rows(), 40);
  const auto refused = [&](const std::string& bytes) {
    write_whole(folder.path / "b.mat", bytes);
    try {
      MatlabReader(folder.path / "b.mat").matrix("H");
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).find("b.mat") != std::string::npos;
    }
    return false;
  };
  for (const std::size_t left : {100UL, 130UL, 300UL, good.size() / 2, good.size() - 8})
    EXPECT_TRUE(refused(good.substr(0, left))) << left;
  std::string as_text = good;
  as_text.insert(good.size() / 2, "\r"); // before a byte that was taken for the end of a line
  EXPECT_TRUE(refused(as_text));
  EXPECT_TRUE(refused(good + "\n"));
  EXPECT_FALSE(refused(good));
}

// A base-driven oscillator under noise, as time signals in a file: its transmissibility identified.
TEST(MeasuredData, goes_from_time_signals_to_modes) {
  const TemporaryFolder folder("signals");
  const double rate = 512, fn = 40, zeta = 0.03, dt = 1 / rate, w = 2 * std::numbers::pi * fn;
  const int fine = 16;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0, 1);
  // u'' + 2 zeta w u' + w^2 u = -a, exact for a held input over each fine step.
  const double wd = w * std::sqrt(1 - zeta * zeta), h = dt / fine, e = std::exp(-zeta * w * h);
  const double c = std::cos(wd * h), s = std::sin(wd * h);
  double u = 0, v = 0;
  std::string text = "time [s],base y,mid y\n";
  for (int n = 0; n < 60000; ++n) {
    const double a = normal(random);
    text += fmt::format("{},{},{}\n", n * dt, a, -2 * zeta * w * v - w * w * u); // absolute
    for (int k = 0; k < fine; ++k) {
      const double x0 = u + a / (w * w);
      const double x1 = e * (x0 * c + (v + zeta * w * x0) / wd * s);
      v = e * (v * c - (zeta * w * v + w * w * x0) / wd * s);
      u = x1 - a / (w * w);
    }
  }
  write_whole(folder.path / "noise.csv", text);
  MeasuredSignals entry;
  entry.file = "noise.csv";
  entry.reference = "base.y";
  const SignalSet set = load_signals(entry, {}, folder.path, "signals[0]");
  EXPECT_NEAR(set.rate, rate, 1e-6);
  const SignalFrf frf =
      frf_of_noise(set.samples, set.rate, set.channels, "base.y", FrfQuantity::transmissibility,
                   {.block = 4096}, FrfEstimator::H1);
  entry.rate = 1024; // the file says 512
  EXPECT_NE(error_of([&] {
              load_signals(entry, {}, folder.path, "signals[0]");
            }).find("is 1024 Hz, the times of the file are 512 Hz"),
            std::string::npos);
  const Identification found = identify(frf.set, {.low = 20, .high = 80});
  ASSERT_GE(found.modes.size(), 1U);
  const auto best = std::max_element(
      found.modes.begin(), found.modes.end(),
      [](const IdentifiedMode& a, const IdentifiedMode& b) { return a.share < b.share; });
  EXPECT_NEAR(best->frequency / fn, 1, 2e-3);
  EXPECT_NEAR(best->damping / zeta, 1, 0.05);
  EXPECT_GT(frf.coherence(320, 0), 0.9); // at 40 Hz
}

TEST(ReadMeasured, takes_the_scatter_of_repeats_for_sigma) {
  const TemporaryFolder folder("repeats");
  write_whole(
      folder.path / "measured.yaml",
      "specimen: a\nstatic:\n  - {direction: axial, value: 10 N/m, repeats: [9, 10, 11]}\n");
  const Measured m = read_measured((folder.path / "measured.yaml").string());
  EXPECT_NEAR(*m.statics[0].sigma, 1, 1e-14);
}

} // namespace
} // namespace plica::test
