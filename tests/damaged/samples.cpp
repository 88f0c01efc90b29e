#include "tests/damaged/samples.hpp"

#include "io/files/files.hpp"
#include "io/matlab/matlab_file.hpp"
#include "io/universal/signals.hpp"
#include "io/universal/writer.hpp"
#include "lab/measured/frf_set.hpp"
#include "tests/damaged/geometry_samples.hpp"

#include <fmt/format.h>

#include <complex>
#include <cstring>
#include <filesystem>
#include <numbers>
#include <unistd.h>

namespace plica::test {
namespace {

using Eigen::Index;
using Files = std::map<std::string, std::string>;

// --- models

std::string case_of_part(const std::string& part) {
  return "case: t\nmaterials:\n  steel: {E: 200 GPa, nu: 0.3, rho: 8000 kg/m3}\nparts:\n  p: {" +
         part +
         "}\nanalyses: {static: false, modes: {count: 2}, damping: {modal: 1 %}, error_bars: "
         "false}\n";
}

Sample model(const std::string& name, const std::string& file, const std::string& bytes,
             const FormatRule& rule, const std::string& part) {
  return {name,
          file,
          bytes,
          rule,
          {{"case.yaml", case_of_part(part + ", file: " + file)}},
          {"run", "case.yaml", "--out", "out", "--threads", "1"},
          "out/results.json"};
}

Sample yaml_case() {
  return {"case_yaml",
          "case.yaml",
          "# A plate with a mass on a beam.\n"
          "case: t\n"
          "title: Plate and beam\n"
          "materials:\n"
          "  steel: {E: 200 GPa +- 2 %, nu: 0.3, rho: 8000 kg/m3}\n"
          "parts:\n"
          "  plate:\n"
          "    type: plate\n"
          "    material: steel\n"
          "    corners: [[0, 0, 0], [0.2, 0, 0], [0.2, 0.1, 0], [0, 0.1, 0]]\n"
          "    thickness: 2 mm\n"
          "    elements: [3, 2]\n"
          "  beam:\n"
          "    type: beam\n"
          "    points: [[0, 0, 100 mm], [0, 150 mm, 100 mm]]\n"
          "    elements: 2\n"
          "    section: {shape: rectangle, material: steel, width: 25 mm, depth: 15 mm}\n"
          "  weight: {type: mass, at: \"beam.point[2]\", mass: 150 g}\n"
          "supports:\n"
          "  - {set: plate.edge4, fix: [ux, uy, uz, rx, ry, rz]}\n"
          "caps:\n"
          "  root: {of: beam.start}\n"
          "mount: {root: rigid}\n"
          "sensors:\n"
          "  - {name: tip, at: [0, 150 mm, 100 mm], mass: 5 g}\n"
          "analyses:\n"
          "  static: false\n"
          "  modes: {count: 4}\n"
          "  damping: {modal: 1 %}\n"
          "  error_bars: false\n",
          {.comment = '#'},
          {},
          {"run", "case.yaml", "--out", "out", "--threads", "1"},
          "out/results.json"};
}

Sample benchmark_yaml() {
  return {"benchmark_yaml",
          "benchmark.yaml",
          "benchmark: one\n"
          "title: A beam\n"
          "published: theory\n"
          "tables:\n"
          "  - table: \"1\"\n"
          "    title: Cantilever\n"
          "    case: case.yaml\n"
          "    columns:\n"
          "      - {name: steel}\n"
          "      - {name: light, set: {\"materials.steel.rho\": 4000 kg/m3}}\n"
          "    rows:\n"
          "      - {label: weight, quantity: mass, unit: kg, published: 1.2, test: [1.19, 1.21]}\n"
          "      - {label: modulus, quantity: \"materials.steel.E\", unit: GPa, scale: 1.0e-9}\n"
          "    remarks: [Nothing is fitted.]\n",
          {.comment = '#'},
          {{"case.yaml",
            "case: t\nmaterials:\n  steel: {E: 200 GPa, nu: 0.3, rho: 8000 kg/m3}\nparts:\n"
            "  beam: {type: beam, points: [[0, 0, 0], [0, 150 mm, 0]], elements: 2, section: "
            "{shape: rectangle, material: steel, width: 25 mm, depth: 15 mm}}\n"
            "caps: {root: {of: beam.start}}\nmount: {root: rigid}\n"
            "analyses: {static: false, modes: {count: 2}, error_bars: false}\n"}},
          {"run", "benchmark.yaml", "--out", "out", "--threads", "1"},
          ""};
}

Sample nastran_deck() {
  return model("nastran_deck", "d.bdf",
               "$ a plate with a body on a beam\n"
               "SOL 103\nCEND\nSPC = 1\nBEGIN BULK\n"
               "PARAM,POST,-1\n"
               "CORD2R,5,,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n"
               "GRID,1,,0.,0.,0.\n"
               "GRID,2,,.1,0.,0.\n"
               "GRID,3,,.2,0.,0.\n"
               "GRID,4,,0.,.1,0.\n"
               "GRID,5,,.1,.1,0.\n"
               "GRID*                  6               5              .2              .1\n"
               "*                     0.\n"
               "GRID,7,5,.2,.1,.15\n"
               "CQUAD4,1,1,1,2,5,4\n"
               "CQUAD4,2,1,2,3,6,5\n"
               "CBAR,3,2,6,7,1.,0.,0.\n"
               "CONM2,4,7,,.25,0.,0.,.01,,+A\n"
               "+A,1.-4,0.,1.-4,0.,0.,1.-4\n"
               "PSHELL  1       1       .002    1               1\n"
               "PBARL,2,1,,ROD\n"
               ",.005\n"
               "MAT1    1       2.+11           .3      8000.\n"
               "SPC1,1,123456,1,4\n"
               "ENDDATA\n",
               {.comment = '$'}, "type: deck, length_unit: m, mass_unit: kg");
}

Sample abaqus_deck() {
  return model("abaqus_deck", "d.inp",
               "*HEADING\nplate with a body on a beam\n"
               "*NODE\n1, 0., 0., 0.\n2, 0.1, 0., 0.\n3, 0.2, 0., 0.\n4, 0., 0.1, 0.\n"
               "5, 0.1, 0.1, 0.\n6, 0.2, 0.1, 0.\n7, 0.2, 0.1, 0.15\n"
               "*ELEMENT, TYPE=S4, ELSET=WALL\n1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n"
               "*ELEMENT, TYPE=B31, ELSET=ROD\n3, 6, 7\n"
               "*ELEMENT, TYPE=MASS, ELSET=BODY\n4, 7\n"
               "*NSET, NSET=EDGE\n1, 4\n"
               "*MATERIAL, NAME=STEEL\n*ELASTIC\n2.e11, 0.3\n*DENSITY\n8000.\n"
               "*SHELL SECTION, ELSET=WALL, MATERIAL=STEEL\n0.002, 5\n"
               "*BEAM SECTION, ELSET=ROD, MATERIAL=STEEL, SECTION=CIRC\n0.005\n1., 0., 0.\n"
               "*MASS, ELSET=BODY\n0.25\n"
               "*BOUNDARY\nEDGE, 1, 6\n"
               "*STEP\n*FREQUENCY\n10\n*END STEP\n",
               {}, "type: deck, length_unit: m, mass_unit: kg");
}

// --- the lab's files

FrfSet two_channels() {
  FrfSet set;
  set.quantity = FrfQuantity::accelerance;
  set.hertz = Eigen::VectorXd::LinSpaced(81, 10, 50);
  set.responses = {"a.z", "b.z"};
  set.references = {"a.z"};
  set.H = {Eigen::MatrixXcd(set.hertz.size(), 2)};
  for (Index i = 0; i < set.hertz.size(); ++i) {
    const double s = 2 * std::numbers::pi * set.hertz[i];
    const auto mode = [&](double hertz, double phi) {
      const double w = 2 * std::numbers::pi * hertz;
      return -s * s * 0.7 * phi / (w * w - s * s + std::complex<double>(0, 0.04 * w * s));
    };
    set.H[0](i, 0) = mode(21.5, 0.7) + mode(38, 0.5);
    set.H[0](i, 1) = mode(21.5, 0.4) + mode(38, -0.6);
  }
  return set;
}

std::string universal(bool binary) {
  UniversalUnits si;
  si.description = "SI";
  std::string text = universal_text(si);
  for (UniversalFunction& f : universal_functions(two_channels())) {
    f.numerator.length = f.denominator.force = 1;
    if (binary) f.binary = UniversalBinaryForm{};
    text += universal_text(f);
  }
  return text;
}

std::string csv_of_responses() {
  const FrfSet set = two_channels();
  std::string text = "f [Hz],a z real [m/s2/N],a z imag [m/s2/N],b z real [m/s2/N],"
                     "b z imag [m/s2/N]\n";
  for (Index i = 0; i < set.hertz.size(); ++i)
    text += fmt::format("{:.6g},{:.9e},{:.9e},{:.9e},{:.9e}\n", set.hertz[i], set.H[0](i, 0).real(),
                        set.H[0](i, 0).imag(), set.H[0](i, 1).real(), set.H[0](i, 1).imag());
  return text;
}

const std::string measured = "specimen: t\n"
                             "source: a bench   # of the lab\n"
                             "sensors:\n"
                             "  - {name: a, at: [0, 0, 0], axes: [x, y, z], mass: 5 g, node: 1}\n"
                             "  - {name: b, at: [0, 100 mm, 0], axes: [x, y, z]}\n"
                             "mass: [{value: 1.2 kg, sigma: 2 g}, {value: 1201 g}]\n"
                             "modes:\n"
                             "  - {frequency: 21.5 Hz, sigma: 0.1 Hz, damping: 2 %, shape: other}\n"
                             "frf:\n";

std::string csv_entry() {
  return "  - {file: f.csv, force: a.z, quantity: accelerance, sigma: {relative: 1 %}}\n";
}

std::vector<std::string> identify(const std::string& file) {
  return {"identify", file, "--out", "out"};
}

std::string matlab_file() {
  const auto path = std::filesystem::temp_directory_path() /
                    ("plica_damaged_" + std::to_string(getpid()) + ".mat");
  {
    const FrfSet set = two_channels();
    MatlabWriter file(path, "MATLAB 5.0 MAT-file");
    file.put(matlab_matrix("f", Eigen::MatrixXd(set.hertz)));
    file.put(matlab_matrix("H", set.H[0]));
    file.put(matlab_text("H_unit", "m/s^2/N"));
  }
  const std::string bytes = read_whole(path);
  std::filesystem::remove(path);
  return bytes;
}

// Where `count` numbers lie that begin with the bytes of `first`.
std::pair<std::size_t, std::size_t> numbers_at(const std::string& bytes, double first,
                                               Index count) {
  std::string pattern(sizeof first, '\0');
  std::memcpy(pattern.data(), &first, sizeof first);
  const std::size_t at = bytes.find(pattern);
  return {at, at + std::size_t(count) * sizeof first};
}

FormatRule binary_rule(const std::string& bytes, bool abscissa) {
  const FrfSet set = two_channels();
  const Index n = set.hertz.size();
  FormatRule rule;
  if (abscissa) {
    constexpr std::size_t description = 116; // a text, to no purpose
    rule.payload = {{0, description}, numbers_at(bytes, set.hertz[0], n)};
    for (int c = 0; c < 2; ++c) {
      rule.payload.push_back(numbers_at(bytes, set.H[0](0, c).real(), n));
      rule.payload.push_back(numbers_at(bytes, set.H[0](0, c).imag(), n));
    }
  } else {
    for (int c = 0; c < 2; ++c)
      rule.payload.push_back(numbers_at(bytes, set.H[0](0, c).real(), 2 * n));
  }
  return rule;
}

std::vector<Sample> lab_files() {
  std::vector<Sample> all;
  all.push_back({"csv",
                 "f.csv",
                 csv_of_responses(),
                 {.comment = '#'},
                 {},
                 identify("f.csv"),
                 "out/identification.json"});
  all.push_back({"measured_yaml",
                 "measured.yaml",
                 measured + csv_entry(),
                 {.comment = '#'},
                 {{"f.csv", csv_of_responses()}},
                 identify("measured.yaml"),
                 "out/identification.json"});
  all.push_back({"universal_ascii",
                 "f.uff",
                 universal(false),
                 {.chained = true},
                 {},
                 identify("f.uff"),
                 "out/identification.json"});
  const std::string binary = universal(true), mat = matlab_file();
  all.push_back({"universal_binary",
                 "f.uff",
                 binary,
                 binary_rule(binary, false),
                 {},
                 identify("f.uff"),
                 "out/identification.json"});
  all.push_back({"matlab",
                 "f.mat",
                 mat,
                 binary_rule(mat, true),
                 {{"measured.yaml", measured + "  - {file: f.mat, force: a.z, channels: [a.z, "
                                               "b.z], variables: {abscissa: f, values: H}}\n"}},
                 identify("measured.yaml"),
                 "out/identification.json"});
  return all;
}

// --- a fit begun again

Sample fit_restart() {
  const std::string text =
      "case: t\nmaterials:\n  steel: {E: 200 GPa, nu: 0.3, rho: 8000 kg/m3}\nparts:\n"
      "  beam: {type: beam, points: [[0, 0, 0], [0, 150 mm, 0]], elements: 2, section: {shape: "
      "rectangle, material: steel, width: 25 mm, depth: 15 mm}}\n"
      "caps: {root: {of: beam.start}}\nmount: {root: rigid}\n"
      "analyses: {static: false, modes: {count: 2}}\nmeasured: measured.yaml\n"
      "fit:\n  parameters:\n    - {path: materials.steel.rho, bounds: [7000 kg/m3, 9000 kg/m3]}\n"
      "  targets: [{quantity: mass, sigma: 1 %}]\n";
  return {
      "fit_json",
      "fit.json",
      "{\n  \"fit\": \"t\",\n  \"parameters\": [\n    {\n      \"path\": "
      "\"materials.steel.rho\",\n      \"before\": 8000.0,\n      \"after\": 7900.0\n    }\n  "
      "],\n  \"designs\": [\n    [\n      7900.0\n    ],\n    [\n      7800.0\n    ]\n  ]\n}\n",
      {},
      {{"case.yaml", text}, {"measured.yaml", "specimen: t\nmass: {value: 0.45 kg, sigma: 1 g}\n"}},
      {"fit", "case.yaml", "--restart", "fit.json", "--out", "out", "--threads", "1"},
      "out/fit.json"};
}

// --- effects that somebody supposes

Sample supposition() {
  const std::string text =
      "case: t\nmaterials:\n  steel: {E: 200 GPa, nu: 0.3, rho: 8000 kg/m3}\nparts:\n"
      "  beam: {type: beam, points: [[0, 0, 0], [0, 150 mm, 0]], elements: 6, section: {shape: "
      "rectangle, material: steel, width: 25 mm, depth: 15 mm}}\n"
      "caps: {root: {of: beam.start}}\nmount: {root: rigid}\n"
      "analyses: {static: false, modes: {count: 4}, damping: {modal: 1 %}}\n"
      "measured: measured.yaml\n";
  const std::string test =
      "specimen: t\nmodes:\n"
      "  - {shape: transverse, direction: z, order: 1, frequency: 500 Hz, damping: 1.1 %}\n"
      "  - {shape: transverse, direction: x, order: 1, frequency: 800 Hz}\n"
      "  - {shape: transverse, direction: z, order: 2, frequency: 3200 Hz}\n";
  return {"supposition_yaml",
          "effects.yaml",
          "# What might be behind it.\n"
          "effects:\n"
          "  - effect: added_mass\n"
          "    place: beam\n"
          "    value: {mass: 20 g, at: 120 mm}\n"
          "  - {effect: damping, place: all, value: {ratio: 1.2}}\n"
          "  - effect: boundary_compliance\n"
          "    place: mount.root\n"
          "    way: rotation\n"
          "    value: {k_rotation: 30 kNm/rad}\n",
          {.comment = '#'},
          {{"case.yaml", text}, {"measured.yaml", test}},
          {"diagnose", "case.yaml", "--suppose", "effects.yaml", "--out", "out", "--threads", "1"},
          "out/supposed.json"};
}

std::vector<Sample> all_samples() {
  std::vector<Sample> all{yaml_case(),   benchmark_yaml(), nastran_deck(),
                          abaqus_deck(), fit_restart(),    supposition()};
  for (Sample& sample : lab_files()) all.push_back(std::move(sample));
  for (Sample& sample : geometry_samples()) all.push_back(std::move(sample));
  return all;
}

} // namespace

const std::vector<Sample>& samples() {
  static const std::vector<Sample> all = all_samples();
  return all;
}

} // namespace plica::test
