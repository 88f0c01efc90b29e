// The models of a case file, as trees.
#pragma once

#include "io/input/field_reader.hpp"
#include "io/input/yaml_tree.hpp"

namespace plica {

// Those of the section `models`; empty when there are none.
std::vector<YamlEntry> models_of(const YamlNode& root);

// The tree with the sections of one of its models in place of those of the case, and what it sets.
YamlNode as_model(const YamlNode& root, const YamlEntry& model, ReadLog& log);

// The same of the model of that name; a problem in the log when there is none.
YamlNode chosen_model(const YamlNode& root, const std::string& name, ReadLog& log);

} // namespace plica
