// Universal files (UFF, UNV): a picture of their data sets as they stand in the file, in the units
// of the file. A data set lies between two lines "    -1" and opens with its number.
//
//   number      type                here
//   58, 58b     UniversalFunction   functions at a degree of freedom, ASCII or IEEE binary
//   55          UniversalShape      data at nodes: mode shapes, deflection shapes
//   15, 2411    UniversalNodes      single and double precision; 781 as 2411
//   2412        UniversalElements
//   82          UniversalTraceline
//   164         UniversalUnits
//   any other   UniversalText       byte for byte
//
// Source: SDRC I-DEAS universal data sets as published by the Structural Dynamics Research
// Laboratory, University of Cincinnati. Field names follow these pages.
#pragma once

#include <Eigen/Core>

#include <array>
#include <complex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace plica {

// A count that the file states and does not keep, or another fault that leaves all data readable.
struct UniversalWarning {
  int line = 0;
  std::string what;
  Eigen::Index stated = 0, found = 0; // both 0 when nothing was counted
};

enum class FunctionType : int { // may hold any other number of the file
  unknown = 0,
  time_response = 1,
  auto_spectrum = 2,
  cross_spectrum = 3,
  frequency_response = 4,
  transmissibility = 5,
  coherence = 6,
  auto_correlation = 7,
  cross_correlation = 8,
  power_spectral_density = 9,
  energy_spectral_density = 10,
  probability_density = 11,
  spectrum = 12,
  cumulative_frequency = 13,
  peaks_valley = 14,
  stress_cycles = 15,
  strain_cycles = 16,
  orbit = 17,
  mode_indicator = 18,
  force_pattern = 19,
  partial_power = 20,
  partial_coherence = 21,
  eigenvalue = 22,
  eigenvector = 23,
  shock_response = 24,
  impulse_response_filter = 25,
  multiple_coherence = 26,
  order_function = 27,
  phase_compensation = 28
};

enum class UniversalDataType : int {
  real_single = 2,
  real_double = 4,
  complex_single = 5,
  complex_double = 6
};

constexpr bool is_complex(UniversalDataType t) {
  return t == UniversalDataType::complex_single || t == UniversalDataType::complex_double;
}
constexpr bool is_double(UniversalDataType t) {
  return t == UniversalDataType::real_double || t == UniversalDataType::complex_double;
}

// By the standard an id line is never blank.
inline const std::array<std::string, 5> no_ids{"NONE", "NONE", "NONE", "NONE", "NONE"};

// Degree of freedom: directions 1 2 3 are +x +y +z, 4 5 6 the rotations, negative against the axis,
// 0 a scalar.
struct UniversalDof {
  std::string entity = "NONE";
  int node = 0, direction = 0;
};

struct UniversalAxis {
  int data_type = 0; // specific data type: 8 displacement, 12 acceleration, 13 force, 17 time,
                     // 18 frequency, ...
  int length = 0, force = 0, temperature = 0; // exponents of units
  std::string label = "NONE", unit = "NONE";
  int line = 0; // in the file it was read from
};

enum class UniversalByteOrder : int { little_endian = 1, big_endian = 2 };
enum class UniversalFloatFormat : int {
  dec_vms = 1,
  ieee = 2,
  ibm = 3
}; // only ieee is read and written

struct UniversalBinaryForm {
  UniversalByteOrder order = UniversalByteOrder::little_endian;
  UniversalFloatFormat format = UniversalFloatFormat::ieee;
  int abscissa_bytes = 4; // of an uneven abscissa; 4 by the standard, some writers take 8
};

struct UniversalFunction {
  int line = 0; // of the -1 that opens the data set
  std::vector<UniversalWarning> warnings;
  std::array<std::string, 5> ids = no_ids; // without trailing blanks
  FunctionType type = FunctionType::unknown;
  int id = 0, version = 0, load_case = 0;
  UniversalDof response, reference;
  UniversalDataType data_type = UniversalDataType::real_double;
  bool even = true;
  double x0 = 0, dx = 0, z = 0; // x0 and dx only when even
  UniversalAxis abscissa_axis, numerator, denominator, z_axis;
  Eigen::VectorXd abscissa;                  // empty when even
  Eigen::VectorXd real, imaginary;           // imaginary is empty when the data are real
  std::optional<UniversalBinaryForm> binary; // 58b
};

// x0 + k dx, or the abscissa of the file when uneven.
Eigen::VectorXd abscissa(const UniversalFunction& f);

enum class UniversalAnalysisType : int { // may hold any other number of the file
  unknown = 0,
  static_load = 1,
  normal_mode = 2,
  complex_eigenvalue_first_order = 3,
  transient = 4,
  frequency_response = 5,
  buckling = 6,
  complex_eigenvalue_second_order = 7
};

struct UniversalShape {
  int line = 0;
  std::vector<UniversalWarning> warnings;
  std::array<std::string, 5> ids = no_ids;
  int model_type = 1; // 1 structural
  UniversalAnalysisType analysis = UniversalAnalysisType::unknown;
  int data_characteristic = 2; // 1 scalar, 2 three translations, 3 with rotations, 4 and 5 tensors
  int specific_data_type = 8;  // 8 displacement, 11 velocity, 12 acceleration, ...
  UniversalDataType data_type = UniversalDataType::real_single;
  std::vector<int> integers; // record 7 behind its two counts
  std::vector<double> reals; // record 8
  std::vector<int> nodes;
  Eigen::MatrixXd real, imaginary; // nodes x values per node; imaginary is empty when real
  int decimals = 5;                // of the numbers in the file, E13.5
};

struct UniversalNormalMode { // frequency in Hz, dampings as fractions
  int load_case = 0, mode = 0;
  double frequency = 0, modal_mass = 0, viscous_damping = 0, hysteretic_damping = 0;
};

struct UniversalComplexMode { // eigenvalue in rad/s
  int load_case = 0, mode = 0;
  std::complex<double> eigenvalue, modal_a, modal_b;
};

struct UniversalFrequencyStep {
  int load_case = 0, step = 0;
  double frequency = 0;
};

// Records 7 and 8 by their meaning; nothing when the analysis is another one or a field is missing.
std::optional<UniversalNormalMode> normal_mode(const UniversalShape& s);
std::optional<UniversalComplexMode> complex_mode(const UniversalShape& s);
std::optional<UniversalFrequencyStep> frequency_step(const UniversalShape& s);

// The same the other way, with the type of analysis; a complex mode is of the first order unless
// the shape says second order.
void describe(UniversalShape& s, const UniversalNormalMode& mode);
void describe(UniversalShape& s, const UniversalComplexMode& mode);
void describe(UniversalShape& s, const UniversalFrequencyStep& step);

struct UniversalNode {
  int label = 0;
  int definition_system = 0, displacement_system = 0, colour = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

struct UniversalNodes {
  int line = 0;
  std::vector<UniversalWarning> warnings;
  bool double_precision = true; // 2411, else 15
  std::vector<UniversalNode> nodes;
};

struct UniversalBeam {
  int orientation_node = 0, fore_section = 0, aft_section = 0;
};

struct UniversalElement {
  int label = 0;
  int descriptor = 0; // fe descriptor id: 21 beam, 44 linear plane stress quadrilateral, ...
  int property = 0, material = 0, colour = 0;
  std::optional<UniversalBeam> beam; // descriptors 11, 21 to 24
  std::vector<int> nodes;
};

struct UniversalElements {
  int line = 0;
  std::vector<UniversalWarning> warnings;
  std::vector<UniversalElement> elements;
};

struct UniversalTraceline {
  int line = 0;
  std::vector<UniversalWarning> warnings;
  int number = 0, colour = 0;
  std::string id;
  std::vector<int> nodes; // 0 lifts the pen
};

struct UniversalUnits {
  int line = 0;
  std::vector<UniversalWarning> warnings;
  int code = 1; // 1 SI, 5 mm with milli newton, 7 inch, ...
  std::string description;
  int temperature_mode = 2;                      // 1 absolute, 2 relative
  double length = 1, force = 1, temperature = 1; // SI = value of the file / factor
  double temperature_offset = 273.15;
};

struct UniversalText {
  int line = 0;
  std::vector<UniversalWarning> warnings;
  int number = 0;
  std::string text; // from the line of the number to the closing -1, both line ends included
};

using UniversalDataset =
    std::variant<UniversalFunction, UniversalShape, UniversalNodes, UniversalElements,
                 UniversalTraceline, UniversalUnits, UniversalText>;

} // namespace plica
