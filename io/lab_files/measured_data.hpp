// The files that measured.yaml names, read into the forms that test-signal processing takes.
//
// Files end in .csv or .txt (io/lab_files/csv_table.hpp: the abscissa first, then a complex column,
// or a real and an imaginary one, per channel), .mat, or anything else (universal files, sets 58).
// Channels are "sensor.axis". Without a list of channels CSV columns are taken by their names ("mid
// y real" is mid.y), functions of a universal file by their response: the sensor with that node
// number, else the entity's name; direction 1 2 3 is x y z, negative reverses the sign.
//
// Units that a file states are brought to SI or refused (io/lab_files/lab_units.hpp,
// io/lab_files/universal_units.hpp).
#pragma once

#include "io/lab_files/lab_units.hpp"
#include "lab/measured/measured.hpp"

#include <filesystem>

namespace plica {

struct SignalSet {
  double rate = 0; // Hz
  std::vector<std::string> channels;
  std::vector<std::optional<UnitPowers>> powers; // of each channel, where its unit is stated
  Eigen::MatrixXd samples;                       // time x channels, in SI
  std::vector<std::string> warnings;
};

// All throw InputError: with the file and its line, or with the key of `entry` ("frf[2].channels").

// Frequency responses of all entries, or of those of one state. Entries of one quantity, level, set
// of lines and channels that differ in what was driven become references of one set, in their
// order.
std::vector<FrfSet> load_frfs(const Measured& measured, const std::filesystem::path& folder,
                              const std::optional<std::string>& state = std::nullopt);

// Those of each entry on its own.
std::vector<std::vector<FrfSet>> load_each_frf(const Measured& measured,
                                               const std::filesystem::path& folder);

SignalSet load_signals(const MeasuredSignals& entry, const Measured& measured,
                       const std::filesystem::path& folder, const std::string& key);

// Files as they stand, without a measured.yaml: one reference a file, named by it, or the
// references of a universal file.
FrfSet load_frf_files(const std::vector<std::filesystem::path>& files,
                      std::optional<FrfQuantity> quantity);

} // namespace plica
