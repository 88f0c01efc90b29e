// What a fit of a case is given by the commands that make one.
#pragma once

#include "compare/fit/fit.hpp"
#include "io/input/case_file.hpp"
#include "model/description/case_checks.hpp"

#include <filesystem>

namespace plica {

// As the section `fit` of the case says; designs that its reader would not take are not tried.
inline FitSettings fit_settings(const CaseFile& file) {
  FitSettings settings;
  if (file.data.fit) {
    settings.search = file.data.fit->search;
    settings.evaluations = file.data.fit->evaluations;
  }
  const std::string beside = std::filesystem::path(file.path).parent_path().string();
  settings.refused = [beside](const Case& design) {
    return !check_case(design, {}, beside).empty();
  };
  return settings;
}

} // namespace plica
