// Reads measured.yaml. Strict: throws InputError with all problems of the file at once.
#pragma once

#include "lab/measured/measured.hpp"
#include "model/description/case.hpp"
#include "words/input_error.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace plica {

struct MeasuredFile {
  Measured data;
  std::filesystem::path path; // as given
  std::string text;           // as it stood when it was read
};

MeasuredFile read_measured_file(const std::string& path);
Measured read_measured(const std::string& path);

// It and the files it names.
std::vector<std::filesystem::path> files_of(const MeasuredFile& file);

// Turns what the states set into numbers of the case. Throws InputError.
void resolve_states(Measured& measured, const Case& data, const std::string& path);

} // namespace plica
