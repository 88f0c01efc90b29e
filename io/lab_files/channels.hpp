// Channels of one file over one abscissa, as measured_data.cpp makes sets of them: numbers in SI,
// each with what is known of its quantity.
#pragma once

#include "io/lab_files/lab_units.hpp"
#include "lab/measured/measured.hpp"
#include "words/input_error.hpp"

#include <filesystem>
#include <map>

namespace plica {

// What of a file is wanted, and how errors name it.
struct ChannelRequest {
  std::filesystem::path path;
  std::string key; // "frf[2]", or empty
  std::vector<std::string> channels;
  MatlabVariables variables;
  bool time = false;
  double rate = 0;   // of a file without times, Hz
  bool base = false; // responses to a base: ratios of accelerations
  std::optional<FrfQuantity> asked;
};

[[noreturn]] void bad_channels(const ChannelRequest& r, const std::string& sub,
                               const std::string& wrong, const std::string& allowed);

struct ChannelColumn {
  std::string name;
  Eigen::VectorXcd values;          // in SI
  double factor = 1;                // by which they were brought there
  std::optional<UnitPowers> powers; // where units are stated
  std::optional<FrfQuantity> quantity;
  std::optional<InputProblem> problem; // why it cannot be taken, unless it is left out
};

// Channels over one abscissa: Hz or s.
struct ChannelTable {
  Eigen::VectorXd abscissa;
  std::vector<std::string> channels;
  std::vector<std::optional<UnitPowers>> powers; // per channel
  std::vector<double> factors;                   // by which they were brought to SI
  Eigen::MatrixXcd values;                       // abscissa x channels
  std::vector<std::string> warnings;
  std::optional<FrfQuantity> quantity; // where the file says it
};

// The columns that the request wants under its names. Throws InputError.
ChannelTable assembled(const Eigen::VectorXd& abscissa, std::vector<ChannelColumn> columns,
                       const ChannelRequest& r);

Eigen::VectorXd times_at(double rate, Eigen::Index count); // of samples without any

ChannelTable csv_channels(const ChannelRequest& r);
ChannelTable matlab_channels(const ChannelRequest& r);

// Functions of a universal file by their reference.
struct UniversalReferences {
  std::vector<std::string> order;
  std::map<std::string, std::vector<ChannelColumn>> columns;
  Eigen::VectorXd abscissa;
  std::vector<std::string> warnings;
};
UniversalReferences universal_references(const ChannelRequest& r, const Measured* measured);

// A column by the unit that stands beside its numbers in a file without data types: of a signal the
// numbers are brought to SI, of a response too, its force being in N where only the motion is named
// (`note` says so). `where` names file, line and key of what is wrong.
struct ColumnUnit {
  double factor = 1;
  std::optional<UnitPowers> powers;
  std::optional<FrfQuantity> quantity;
  std::string note;
  std::optional<InputProblem> problem;
};
ColumnUnit column_unit(const std::string& text, const ChannelRequest& r, InputProblem where);
// Of its abscissa; throws.
double abscissa_unit(const std::string& text, const ChannelRequest& r, InputProblem where);

} // namespace plica
