// A YAML file as a plain tree with line numbers: yaml_parser.cpp alone knows yaml-cpp.
//
// Strict: one document of UTF-8 text, at most 4 MB and 64 levels deep, plain keys, no duplicate
// keys, no anchors, aliases or tags. Problems are collected, not thrown.
#pragma once

#include "words/input_error.hpp"

#include <string>
#include <vector>

namespace plica {

struct YamlEntry;

struct YamlNode {
  enum class Kind { null, scalar, list, map };
  Kind kind = Kind::null;
  int line = 0;                   // from 1
  bool quoted = false;            // scalar in quotes: text, never a bool
  std::string text;               // scalar
  std::vector<YamlNode> items;    // list
  std::vector<YamlEntry> entries; // map, in the order of the file

  const YamlNode* find(const std::string& key) const;
  YamlNode* find(const std::string& key);
};

struct YamlEntry {
  std::string key;
  int line = 0; // of the key
  YamlNode value;
};

struct YamlFile {
  std::string text; // as it stood when it was read
  YamlNode root;
};

// Tree of a file. Appends to `problems` what is wrong with it (file not found, syntax, duplicate
// keys); the tree is null when nothing could be read.
YamlFile read_yaml(const std::string& path, std::vector<InputProblem>& problems);

// Tree of a text; `file` names it in problems.
YamlNode parse_yaml(const std::string& text, const std::string& file,
                    std::vector<InputProblem>& problems);

// The tree as one line of YAML (flow style), such that parsing gives the same tree.
std::string to_yaml(const YamlNode& node);

// The same as lines of a file: what is short stands on one line.
std::string to_yaml_file(const YamlNode& root);

// "a map", "a list", "'text'", "no value"
std::string kind_of(const YamlNode& node);

// Sets every line of the tree.
void set_lines(YamlNode& node, int line);

} // namespace plica
