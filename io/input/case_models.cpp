#include "io/input/case_models.hpp"

#include "io/input/yaml_path.hpp"
#include "words/did_you_mean.hpp"

#include <algorithm>
#include <array>

namespace plica {

std::vector<YamlEntry> models_of(const YamlNode& root) {
  const YamlNode* models = root.find("models");
  return models ? models->entries : std::vector<YamlEntry>{};
}

YamlNode as_model(const YamlNode& root, const YamlEntry& model, ReadLog& log) {
  static constexpr std::array replaced{"assumptions", "parts",    "caps", "mount",
                                       "sensors",     "variants", "fit"};
  const std::string place = "models." + model.key;
  YamlNode tree = root;
  std::erase_if(tree.entries, [&](const YamlEntry& e) {
    return e.key == "models" || e.key == "variants" || e.key == "fit" ||
           (model.value.find(e.key) &&
            std::find(replaced.begin(), replaced.end(), e.key) != replaced.end());
  });
  for (const YamlEntry& section : model.value.entries)
    if (std::find(replaced.begin(), replaced.end(), section.key) != replaced.end())
      tree.entries.push_back(section);
  const YamlNode* set = model.value.find("set");
  if (!set && !model.value.find("parts"))
    log.add(model.line, place, "is no other model", "give parts, or set: {path: new value}");
  if (!set) return tree;
  for (const YamlEntry& change : set->entries) {
    const PathProblem problem = put(tree, change.key, to_yaml(change.value), change.line);
    if (!problem.wrong.empty())
      log.add(change.line, place + ".set." + change.key, problem.wrong, problem.allowed);
  }
  return tree;
}

YamlNode chosen_model(const YamlNode& root, const std::string& name, ReadLog& log) {
  std::vector<std::string> names;
  for (const YamlEntry& entry : models_of(root)) {
    if (entry.key == name) return as_model(root, entry, log);
    names.push_back(entry.key);
  }
  const YamlNode* models = root.find("models");
  log.add(models ? models->line : 1, "models", "there is no model '" + shown(name) + "'",
          names.empty() ? "the case has no other models" : suggestion(name, names));
  return root;
}

} // namespace plica
