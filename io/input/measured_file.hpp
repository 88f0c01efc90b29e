// Reads measured.yaml. Strict: throws InputError with all problems of the file at once. A universal
// file (.uff, .unv) is taken by its modes (io/lab_files/universal_modes.hpp).
#pragma once

#include "io/input/case_file.hpp"
#include "lab/measured/measured.hpp"
#include "words/input_error.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plica {

struct MeasuredFile {
  Measured data;
  std::filesystem::path path;       // as given
  std::string text;                 // as it stood when it was read
  std::map<std::string, int> lines; // of its keys, such as signals[0].file
};

MeasuredFile read_measured_file(const std::string& path);
Measured read_measured(const std::string& path);

// The test of a case: `given`, a file or a folder with a measured.yaml, or else what the case
// names; none where neither is.
std::optional<MeasuredFile> test_of(const CaseFile& file, const std::string& given = {});

// Of a case that has `problems` adds those of its test, where it can be told which that is.
void add_problems_of_test(const std::string& case_path, const std::string& model,
                          const Replacements& set, const std::string& given,
                          std::vector<InputProblem>& problems);

// It and the files it names.
std::vector<std::filesystem::path> files_of(const MeasuredFile& file);

// Turns what the states set into numbers of the case. Throws InputError.
void resolve_states(MeasuredFile& file, const CaseFile& asked);

} // namespace plica
