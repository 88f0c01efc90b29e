// What `plica identify` leaves behind: identification.json, identified.csv, measured_modes.yaml
// (the modes as entries of a measured.yaml), shapes.uff (set 55), frf.uff and synthesised.uff (sets
// 58, the responses that were used and those of the modes; of free decays and outputs alone not),
// identification.html; of noise also spectra.csv.
#pragma once

#include "io/files/output_folder.hpp"
#include "lab/identification/identify.hpp"
#include "lab/identification/linearity.hpp"
#include "lab/signals/frf_of_signals.hpp"

namespace plica {

// `noise`: of noise with its input; `time`: of free decays or outputs alone, without responses.
std::vector<std::string> identification_files(bool noise, bool time = false);

// The test with the modes in place of its responses and signals, as compare, fit and diagnose read
// it: beside the folders of several sets.
constexpr const char* identified_file = "measured.yaml";

// `below`: before every name, "" or as "2/".
void write_identification(const Identification& found, const LinearityOfSet& linearity,
                          const std::string& title, OutputFolder& out,
                          const std::string& below = "");

// The same in words, for the terminal.
std::string identification_text(const Identification& found, const LinearityOfSet& linearity,
                                const std::string& title);

// Pieces of it, for tests and other writers.
std::string identification_json(const Identification& found, const LinearityOfSet& linearity,
                                const std::string& title);
std::string identified_csv(const Identification& found);
std::string measured_modes_yaml(const Identification& found);

// Of noise: auto densities of all channels, with their RMS in the head, and coherences.
std::string spectra_csv(const SignalFrf& frf);

// Verdicts over levels: levels.json beside the identifications, and in words.
constexpr const char* levels_file = "levels.json";
void write_levels(const std::vector<LevelVerdict>& levels,
                  const std::vector<Homogeneity>& homogeneity, OutputFolder& out);
std::string levels_text(const std::vector<LevelVerdict>& levels,
                        const std::vector<Homogeneity>& homogeneity);

} // namespace plica
