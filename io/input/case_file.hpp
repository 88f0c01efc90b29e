// Reads a case file (YAML). Strict: throws InputError with all problems of the file at once.
//
//   CaseFile file = read_case("cases/bellow_a2/bellow_a2.yaml");
//   const Case& thin = file.variants[0]; // as file.data.variants[0].set says
//   CaseFile pipe = read_case(file.path, "pipe");
//
// All variants and alternative models are checked together with the nominal case.
#pragma once

#include "model/description/case.hpp"
#include "words/input_error.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace plica {

struct YamlNode;

using Replacements = std::map<std::string, std::string>; // path: new value, as YAML

struct CaseFile {
  Case data;
  std::string path;                 // as given
  std::string text;                 // as it stood when it was read
  std::map<std::string, int> lines; // key path -> line, e.g. "parts.bellows.wall.plies[1]"
  std::vector<Case> variants;       // data with what each of its variants sets
  Replacements set;                 // what was put into it before it was read
};

// `model`: alternative model of the case, whose sections replace those of the case; empty = none.
// `overrides`: put into the file before it is read; variants and fit then are left out.
CaseFile read_case(const std::string& path, const std::string& model = {},
                   const Replacements& overrides = {});

// The text that was kept, whatever the file says by now, with others in place of what was put into
// it.
CaseFile read_case(const CaseFile& kept, const Replacements& overrides);

// The same with variants and fit, as if the file said so itself.
CaseFile read_case_with(const std::string& path, const std::string& model, const Replacements& set);

// The test that a file names, as it stands there, also where much else is wrong in it; empty where
// it names none or cannot be read.
std::string test_named_in(const std::string& path, const std::string& model,
                          const Replacements& set);

// A case that was read, with other values at some paths, many times over.
class ChangedCases {
public:
  explicit ChangedCases(const CaseFile& file);
  ~ChangedCases();

  // Throws InputError with the path of what is wrong as its key. Several threads may ask.
  Case with(const Replacements& changes) const;
  // Throws InputError when a path of the file can be no such.
  void check(const std::string& path) const;

private:
  std::string path_, model_;
  std::unique_ptr<const YamlNode> root_;
};

// The case that was read as a file in a folder: with its model in place of others, without fit and
// variants, with other values at some paths (YAML). `measured`: the test it is held against; empty
// = as the case says.
std::string yaml_of(const CaseFile& file, const std::map<std::string, std::string>& changes,
                    const std::filesystem::path& measured, const std::filesystem::path& folder);

// It, the files of its parts (geometry, decks with what they include) and of its signals.
std::vector<std::filesystem::path> files_of(const CaseFile& file);

} // namespace plica
