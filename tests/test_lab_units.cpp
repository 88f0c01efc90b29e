// Units that the lab's files state: brought to SI, or refused with the line; never taken as SI
// without a word.
#include "io/files/files.hpp"
#include "io/lab_files/lab_units.hpp"
#include "io/lab_files/measured_data.hpp"
#include "io/matlab/matlab_file.hpp"
#include "io/universal/writer.hpp"
#include "tests/matlab_response.hpp"
#include "tests/support/temporary_folder.hpp"
#include "words/input_error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <complex>
#include <numbers>

namespace plica::test {
namespace {

using Eigen::VectorXd;

TEST(LabUnits, are_known_in_their_spellings) {
  constexpr double g = 9.80665, inch = 0.0254, pound = 4.4482216152605;
  struct Spelling {
    const char* text;
    double factor;
    UnitPowers powers;
  };
  const UnitPowers per_force = powers::acceleration - powers::force;
  for (const auto& [text, factor, of] :
       std::vector<Spelling>{{"m/s^2", 1, powers::acceleration},
                             {"m/s2", 1, powers::acceleration},
                             {"m/s**2", 1, powers::acceleration},
                             {"m/s/s", 1, powers::acceleration},
                             {"m/s\xc2\xb2", 1, powers::acceleration},
                             {"m/s\xb2", 1, powers::acceleration},
                             {"m s^-2", 1, powers::acceleration},
                             {"M/S^2", 1, powers::acceleration},
                             {"m/sec^2", 1, powers::acceleration},
                             {"mm/s^2", 1e-3, powers::acceleration},
                             {"in/s^2", inch, powers::acceleration},
                             {"ips2", inch, powers::acceleration},
                             {"g", g, powers::acceleration},
                             {"G", g, powers::acceleration},
                             {"g's", g, powers::acceleration},
                             {"ips", inch, powers::velocity},
                             {"N", 1, powers::force},
                             {"kN", 1e3, powers::force},
                             {"MN", 1e6, powers::force},
                             {"mN", 1e-3, powers::force},
                             {"LBF", pound, powers::force},
                             {"lb", pound, powers::force},
                             {"um", 1e-6, powers::displacement},
                             {"\xc2\xb5m", 1e-6, powers::displacement},
                             {"\xb5m", 1e-6, powers::displacement},
                             {"mil", 2.54e-5, powers::displacement},
                             {"RPM", 1. / 60, powers::frequency},
                             {"krpm", 1000. / 60, powers::frequency},
                             {"kHz", 1e3, powers::frequency},
                             {"rad/s", 1, powers::turning_speed},
                             {"ms", 1e-3, powers::time},
                             {"g/lbf", g / pound, per_force},
                             {"(in/s^2)/lbf", inch / pound, per_force},
                             {"m/s2 per N", 1, per_force},
                             {"m/s2 per m/s2", 1, powers::none},
                             {"N*m", 1, powers::moment}}) {
    const auto unit = lab_unit(text);
    ASSERT_TRUE(unit) << text;
    EXPECT_NEAR(unit->factor / factor, 1, 1e-12) << text;
    EXPECT_TRUE(unit->powers == of) << text << " is " << name_of(unit->powers);
  }
  for (const char* text : {"mn", "volts", "g pk", "m/", "(m", "m)", "m^99", "12", "", "dB", "m//s",
                           "((((((((((m))))))))))"})
    EXPECT_FALSE(lab_unit(text)) << text;
  EXPECT_NEAR(*hertz_of(*lab_unit("rad/s")), 1 / (2 * std::numbers::pi), 1e-15);
}

// One function over three lines; `numerator` and `denominator` name units.
UniversalFunction function(const std::string& numerator, const std::string& denominator,
                           const std::string& abscissa = "Hz") {
  UniversalFunction f;
  f.type = FunctionType::frequency_response;
  f.response = f.reference = {.entity = "a", .node = 1, .direction = 3};
  f.data_type = UniversalDataType::complex_double;
  f.x0 = 10;
  f.dx = 1;
  f.real = Eigen::Vector3d(1, 2, 3);
  f.imaginary = Eigen::Vector3d(0, 1, 0);
  f.abscissa_axis = {.data_type = 18, .unit = abscissa};
  f.numerator = {.data_type = 12, .length = 1, .unit = numerator};
  f.denominator = {.data_type = 13, .force = 1, .unit = denominator};
  return f;
}

class LabFiles : public testing::Test {
protected:
  FrfSet read(const std::string& text, const std::string& name = "f.uff",
              std::optional<FrfQuantity> asked = {}) {
    write_whole(folder_.path / name, text);
    return load_frf_files({folder_.path / name}, asked);
  }
  std::string refusal(const std::string& text, const std::string& name = "f.uff",
                      std::optional<FrfQuantity> asked = {}) {
    try {
      read(text, name, asked);
    } catch (const InputError& error) {
      return error.what();
    }
    return "not refused";
  }
  TemporaryFolder folder_{"units"};
};

// Numbers and lines of `f` in SI.
void expect_si(const FrfSet& set, double factor, double hertz = 1) {
  EXPECT_NEAR(set.H[0](1, 0).real(), 2 * factor, 1e-12 * factor);
  EXPECT_NEAR(set.H[0](1, 0).imag(), factor, 1e-12 * factor);
  EXPECT_NEAR(set.hertz[1], 11 * hertz, 1e-12);
}

TEST_F(LabFiles, universal_functions_come_in_SI_by_the_units_of_their_axes) {
  expect_si(read(universal_text(function("mm/s^2", "N"))), 1e-3);
  expect_si(read(universal_text(function("in/s^2", "lbf"))), 0.0254 / 4.4482216152605);
  expect_si(read(universal_text(function("m/s^2", "kN"))), 1e-3);
  expect_si(read(universal_text(function("g", "N", "RPM"))), 9.80665, 1. / 60);
  expect_si(read(universal_text(function("g/N", "NONE"))), 9.80665);
  UniversalFunction labelled = function("NONE", "N");
  labelled.numerator.label = "acc (mm/s2)";
  expect_si(read(universal_text(labelled)), 1e-3);
}

TEST_F(LabFiles, units_that_are_not_known_or_do_not_fit_are_refused_with_their_line) {
  EXPECT_NE(refusal(universal_text(function("furlong", "N")))
                .find("f.uff:11: data set 58, record 9: the unit 'furlong' is not known"),
            std::string::npos);
  EXPECT_NE(refusal(universal_text(function("m/s^2", "V"))).find("f.uff:12: "), std::string::npos);
  EXPECT_NE(refusal(universal_text(function("m/s^2", "N", "s"))).find("f.uff:10: "),
            std::string::npos);
  EXPECT_NE(refusal(universal_text(function("m", "N"))).find("the data type 12 says an acc"),
            std::string::npos);
  UniversalFunction one_sided = function("g", "NONE");
  one_sided.type = FunctionType::transmissibility;
  one_sided.denominator.data_type = 12;
  EXPECT_NE(refusal(universal_text(one_sided)).find("the numerator is in 'g'"), std::string::npos);
}

TEST_F(LabFiles, what_no_file_states_is_said_to_be_taken_as_SI) {
  const FrfSet set = read(universal_text(function("NONE", "")) + universal_text([] {
                            UniversalFunction f = function("NONE", "");
                            f.response.direction = 2;
                            return f;
                          }()));
  ASSERT_EQ(set.warnings.size(), 2U);
  EXPECT_NE(set.warnings[0].find("f.uff:11: record 9: no unit is stated, m/s2 is taken"),
            std::string::npos)
      << set.warnings[0];
  EXPECT_NE(set.warnings[0].find("(and 1 more)"), std::string::npos);
  EXPECT_TRUE(read(universal_text(function("m/s2", "N"))).warnings.empty());
}

TEST_F(LabFiles, data_set_164_holds_for_axes_without_units) {
  UniversalUnits mm;
  mm.code = 5;
  mm.length = mm.force = 1e3;
  const FrfSet by_system = read(universal_text(mm) + universal_text(function("NONE", "NONE")));
  expect_si(by_system, 1);
  EXPECT_TRUE(by_system.warnings.empty());
  UniversalUnits mm_N = mm;
  mm_N.code = 10;
  mm_N.force = 1;
  expect_si(read(universal_text(mm_N) + universal_text(function("NONE", "NONE"))), 1e-3);
  const FrfSet both = read(universal_text(mm_N) + universal_text(function("m/s^2", "N")));
  expect_si(both, 1);
  ASSERT_EQ(both.warnings.size(), 1U);
  EXPECT_NE(both.warnings[0].find("contradicts data set 164 in line 1"), std::string::npos);
  EXPECT_NE(both.warnings[0].find("the unit of the axis is taken"), std::string::npos);
  EXPECT_TRUE(
      read(universal_text(mm_N) + universal_text(function("mm/s^2", "N"))).warnings.empty());
  UniversalUnits odd = mm_N;
  odd.code = 1;
  EXPECT_NE(read(universal_text(odd) + universal_text(function("mm/s^2", "N")))
                .warnings.at(0)
                .find("those of its code 1 are 1 and 1"),
            std::string::npos);
  odd.length = 0;
  EXPECT_NE(refusal(universal_text(odd) + universal_text(function("", "")))
                .find("f.uff:1: data set 164, record 2: the factors"),
            std::string::npos);
  EXPECT_NE(
      refusal(universal_text(function("", "")) + universal_text(mm)).find("units behind functions"),
      std::string::npos);
}

TEST_F(LabFiles, units_say_the_quantity_where_data_types_do_not) {
  UniversalFunction f = function("mm", "N");
  f.numerator.data_type = f.denominator.data_type = 0;
  const FrfSet set = read(universal_text(f));
  EXPECT_EQ(set.quantity, FrfQuantity::receptance);
  expect_si(set, 1e-3);
  const FrfSet ratio = read(universal_text([] {
    UniversalFunction r = function("g", "g");
    r.denominator.data_type = 12;
    return r;
  }()));
  EXPECT_EQ(ratio.quantity, FrfQuantity::transmissibility);
  expect_si(ratio, 1);
}

TEST_F(LabFiles, headers_of_tables_state_units) {
  const std::string rows = "\n600,1,0\n660,2,1\n720,3,0\n";
  const FrfSet set = read("n [rpm],a z real [g/N],a z imag [g/N]" + rows, "f.csv");
  expect_si(set, 9.80665, 1);
  EXPECT_TRUE(set.warnings.empty());
  EXPECT_EQ(read("n (rpm),a z real (mm/N),a z imag (mm/N)" + rows, "f.csv").quantity,
            FrfQuantity::receptance);
  const FrfSet motion = read("f [rpm],a z real [g],a z imag [g]" + rows, "f.csv");
  expect_si(motion, 9.80665, 1);
  EXPECT_NE(motion.warnings.at(0).find("f.csv:1: column 2: the unit 'g' names no force, N"),
            std::string::npos);
  EXPECT_NE(refusal("# lab\nf [Hz],a z real [V],a z imag [V]" + rows, "f.csv")
                .find("f.csv:2: column 2: the unit 'V' is not known"),
            std::string::npos);
  EXPECT_NE(
      refusal("f [Hz],a z real [g],a z imag [m/s2]" + rows, "f.csv").find("f.csv:1: column 3"),
      std::string::npos);
  EXPECT_NE(refusal("f [mm],a z real,a z imag" + rows, "f.csv").find("none of frequency"),
            std::string::npos);
  EXPECT_NE(
      refusal("f [Hz],a z real [g],a z imag [g]" + rows, "f.csv", FrfQuantity::transmissibility)
          .find("a ratio of like quantities"),
      std::string::npos);
  expect_si(
      read("f [rpm],a z real [g/g],a z imag [g/g]" + rows, "f.csv", FrfQuantity::transmissibility),
      1);
}

// 20 dB and a quarter of a turn are 10 i.
TEST_F(LabFiles, magnitudes_stand_beside_phases) {
  const std::string rows = "\n10,20,90\n20,0,180\n30,6.0206,0\n";
  const FrfSet set = read("f [Hz],a z magnitude [dB],a z phase [deg]" + rows, "f.csv");
  ASSERT_EQ(set.responses, std::vector<std::string>{"a.z"});
  EXPECT_NEAR(std::abs(set.H[0](0, 0) - std::complex<double>(0, 10)), 0, 1e-12);
  EXPECT_NEAR(std::abs(set.H[0](1, 0) + 1.), 0, 1e-12);
  EXPECT_NEAR(set.H[0](2, 0).real(), 2, 1e-5);
  EXPECT_NE(set.warnings.at(0).find("decibels are taken as relative to 1 in SI units"),
            std::string::npos);
  const std::string turned = "\n10,20,0.5\n20,0,-0.5\n";
  const FrfSet plain = read("f [Hz],a z mag [mm/N],a z phase [rad]" + turned, "f.csv");
  EXPECT_NEAR(std::arg(plain.H[0](0, 0)), 0.5, 1e-12);
  EXPECT_NEAR(std::abs(plain.H[0](0, 0)), 0.02, 1e-12);
  EXPECT_NE(refusal("f [Hz],a z magnitude [dB],a z phase" + rows, "f.csv")
                .find("f.csv:1: column 3: a phase without a unit; [deg] or [rad]"),
            std::string::npos);
}

// 2 kHz: from the tenth second on the times hop by a digit, of 0.1 ms.
TEST_F(LabFiles, times_of_six_digits_are_evenly_spaced) {
  MeasuredSignals entry;
  entry.file = "s.csv";
  entry.reference = "hammer";
  entry.channels = {"hammer", "mid.y"};
  const auto load = [&](int missing) {
    std::string text = "t [s],hammer [N],mid [m/s2]\n";
    for (int i = 0; i < 30000; ++i)
      if (i != missing) text += fmt::format("{:.6g},{},{}\n", i / 2000., i % 7, i % 3);
    write_whole(folder_.path / "s.csv", text);
    return load_signals(entry, {}, folder_.path, "signals[0]");
  };
  EXPECT_NEAR(load(-1).rate, 2000, 0.05);
  EXPECT_THROW(load(20000), InputError) << "a sample is missing";
  entry.rate = 2000;
  EXPECT_EQ(load(-1).rate, 2000);
}

TEST_F(LabFiles, time_signals_are_brought_to_SI) {
  MeasuredSignals entry;
  entry.file = "s.csv";
  entry.reference = "hammer";
  entry.channels = {"hammer", "mid.y"};
  const auto load = [&](const std::string& header) {
    write_whole(folder_.path / "s.csv", header + "\n0,1,2\n1,3,4\n2,5,6\n");
    return load_signals(entry, {}, folder_.path, "signals[0]");
  };
  const auto refused = [&](const std::string& header) {
    try {
      load(header);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("not refused");
  };
  const SignalSet set = load("t [ms],hammer [lbf],mid [g]");
  EXPECT_NEAR(set.rate, 1000, 1e-9);
  EXPECT_NEAR(set.samples(1, 0), 3 * 4.4482216152605, 1e-12);
  EXPECT_NEAR(set.samples(1, 1), 4 * 9.80665, 1e-12);
  EXPECT_NE(refused("t [s],hammer [N],mid [V]").find("s.csv:1: column 3: the unit 'V'"),
            std::string::npos);
  EXPECT_NE(refused("t [s],hammer [N],mid [mm]").find("signals[0].quantity: is accelerance"),
            std::string::npos);
  EXPECT_NE(refused("t [s],hammer,mid [g]").find("no unit is stated of hammer"), std::string::npos);
  entry.channels = {"hammer", "-"}; // what is left out may be in anything
  EXPECT_EQ(load("t [s],hammer [N],mid [V]").channels.size(), 1U);
  UniversalFunction f = function("g", "");
  f.type = FunctionType::time_response;
  f.abscissa_axis = {.data_type = 17, .unit = "s"};
  f.data_type = UniversalDataType::real_double;
  f.imaginary.resize(0);
  write_whole(folder_.path / "s.uff", universal_text(f));
  entry.file = "s.uff";
  entry.channels = {};
  EXPECT_NEAR(load_signals(entry, {}, folder_.path, "signals[0]").samples(1, 0), 2 * 9.80665,
              1e-12);
}

TEST_F(LabFiles, matlab_variables_have_their_units_beside_them) {
  const auto load = [&](const std::string& unit) {
    MatlabWriter mat(folder_.path / "h.mat", "MATLAB 5.0 MAT-file");
    mat.put(matlab_matrix("f", Eigen::MatrixXd(Eigen::Vector3d(10, 11, 12))));
    mat.put(matlab_matrix("H", Eigen::MatrixXcd(Eigen::Vector3cd({1, 0}, {2, 1}, {3, 0}))));
    mat.put(matlab_text("H_unit", unit));
    return mat;
  };
  const Measured m = test_by_force({.abscissa = "f", .values = "H"});
  { load("g/N"); }
  expect_si(load_frfs(m, folder_.path).at(0), 9.80665);
  { load("V"); }
  EXPECT_THROW(load_frfs(m, folder_.path), InputError);
}

} // namespace
} // namespace plica::test
