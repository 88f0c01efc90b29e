#include "io/input/case_file.hpp"

#include "io/decks/read_deck.hpp"
#include "io/input/case_models.hpp"
#include "io/input/field_reader.hpp"
#include "io/input/fit_input.hpp"
#include "io/input/phases_alone.hpp"
#include "io/input/time_signal.hpp"
#include "io/input/yaml_path.hpp"
#include "model/description/case_checks.hpp"
#include "model/description/case_fields.hpp"
#include "model/description/check_log.hpp"
#include "model/description/place_keys.hpp"
#include "model/description/steels.hpp"
#include "model/description/toleranced_damping.hpp"
#include "words/did_you_mean.hpp"
#include "words/short_text.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

namespace plica {

namespace {

constexpr double default_accuracy = 0.01;
constexpr std::array toleranced_keys{"materials", "parts", "caps", "mount"};

// Keys that could not be read.
std::vector<std::string> bad_keys(const ReadLog& log) {
  std::vector<std::string> keys = log.misspelt;
  for (const InputProblem& p : log.problems)
    if (!p.key.empty()) keys.push_back(p.key);
  return keys;
}

// Line of the key or of the nearest one above it.
int line_of(std::string key, const std::map<std::string, int>& lines) {
  while (true) {
    if (const auto found = lines.find(key); found != lines.end()) return found->second;
    const std::size_t cut = key.find_last_of(".[");
    if (cut == std::string::npos) return 1;
    key.resize(cut);
  }
}

// What is wrong in a deck is said at its own lines.
void read_content(DeckPart& deck, const std::string& directory, const std::string& key,
                  ReadLog& log) {
  deck.file = (std::filesystem::path(directory) / deck.file).string();
  std::error_code ignored;
  if (deck_format(deck.file) == DeckFormat::none ||
      !std::filesystem::is_regular_file(deck.file, ignored))
    return; // the checks say so
  try {
    deck.content = read_deck(deck.file, deck.unknown_cards);
  } catch (const InputError& error) {
    log.problems.insert(log.problems.end(), error.problems().begin(), error.problems().end());
    log.misspelt.push_back(key);
  }
}

// `nominal`: as the file says. Its fit belongs to it alone, not to what a variant or a limit of a
// tolerance makes of it.
Case read_tree(const YamlNode& root, const std::string& path, const std::string& model,
               bool nominal, ReadLog& log) {
  Case data;
  data.model = model;
  FieldReader::read(root, "", data, log);
  refuse_phases_alone(log);
  for (const Tolerance& t : log.tolerances) // those of other models belong to them
    if (!is_below(t.path, "models")) data.tolerances.push_back(t);
  add_known_steels(data.parts, data.materials);
  if (root.kind != YamlNode::Kind::map) return data;
  const std::string directory = std::filesystem::path(path).parent_path().string();
  for (Part& part : data.parts) {
    if (auto* surface = std::get_if<SurfacePart>(&part.body); surface && !surface->file.empty())
      surface->file = (std::filesystem::path(directory) / surface->file).string();
    if (auto* deck = std::get_if<DeckPart>(&part.body); deck && !deck->file.empty())
      read_content(*deck, directory, part_key(part.name) + ".file", log);
  }
  try {
    read_signals(data, directory);
  } catch (const InputError& error) {
    for (InputProblem problem : error.problems()) {
      if (problem.file.empty()) {
        problem.file = log.file;
        problem.line = line_of(problem.key, log.lines);
      }
      log.problems.push_back(std::move(problem));
    }
  }
  CheckLog fit(data, bad_keys(log));
  if (nominal) resolve_fit(data, fit);
  for (const auto& problems : {check_case(data, bad_keys(log), directory), fit.problems})
    for (const InputProblem& problem : problems)
      log.add(line_of(problem.key, log.lines), problem.key, problem.wrong, problem.allowed);
  for (Part& part : data.parts)
    if (auto* bellows = std::get_if<Bellows>(&part.body))
      if (bellows->mesh.around == 0 && bellows->mesh.accuracy == 0)
        bellows->mesh.accuracy = default_accuracy;
  return data;
}

// What is wrong beyond the problems of the nominal case: what is bad there is said once.
std::vector<InputProblem> new_problems(const ReadLog& changed, const ReadLog& nominal) {
  std::set<std::string> known;
  for (const InputProblem& p : nominal.problems) known.insert(p.key);
  std::vector<InputProblem> result;
  for (const InputProblem& p : changed.problems)
    if (!known.count(p.key)) result.push_back(p);
  return result;
}

std::string below(std::string map, const std::string& key) {
  return map.append(1, '.').append(key);
}

// A number put to a limit of its tolerance must leave a good case.
void check_tolerances(const YamlNode& tree, const Case& data, const std::string& path,
                      const ReadLog& nominal, ReadLog& log) {
  for (const Tolerance& t : data.tolerances) {
    const bool physical =
        t.path == toleranced_damping ||
        std::any_of(toleranced_keys.begin(), toleranced_keys.end(),
                    [&](const char* key) { return t.path.starts_with(std::string(key) + "."); });
    if (!physical) {
      log.add(line_of(t.path, nominal.lines), t.path, "takes no tolerance",
              std::string("numbers under materials, parts, caps and mount do, and ") +
                  toleranced_damping);
      continue;
    }
    if (t.path.ends_with(".thickness_field")) {
      log.add(line_of(t.path, nominal.lines), t.path, "takes no tolerance",
              "it is one itself: a number with %");
      continue;
    }
    for (const double limit : {t.low, t.high}) {
      YamlNode changed_tree = tree;
      if (!put(changed_tree, t.path, all_digits(limit), 0).wrong.empty()) continue;
      ReadLog changed{.file = log.file};
      read_tree(changed_tree, path, data.model, false, changed);
      for (const InputProblem& p : new_problems(changed, nominal))
        log.add(line_of(t.path, nominal.lines), t.path,
                "has a limit that makes a bad case: " + p.key + " " + p.wrong, p.allowed);
    }
  }
}

// Line of the entry of a variant that changed this key.
int line_of_change(const Variant& variant, const std::string& place, const std::string& key,
                   const std::map<std::string, int>& lines) {
  const std::string set = place + ".set";
  for (const auto& [path, value] : variant.set)
    if (is_below(key, path) || is_below(path, key)) return line_of(below(set, path), lines);
  return line_of(set, lines);
}

// The case with what a variant sets. Problems it has beyond those of the nominal case go into the
// log.
Case read_variant(YamlNode tree, const Case& data, const Variant& variant, const std::string& place,
                  const std::string& path, const ReadLog& nominal, ReadLog& log) {
  const std::string set = place + ".set";
  for (const auto& [where, value] : variant.set) {
    const std::string key = below(set, where);
    const int line = line_of(key, nominal.lines);
    const bool itself = is_below(where, "variants");
    const PathProblem problem =
        itself ? PathProblem{"a variant cannot change variants", "give a path of the nominal case"}
               : put(tree, where, value, line);
    if (!problem.wrong.empty()) log.add(line, key, problem.wrong, problem.allowed);
  }
  ReadLog changed{.file = log.file};
  Case result = read_tree(tree, path, data.model, false, changed);
  for (const InputProblem& p : new_problems(changed, nominal))
    log.add(line_of_change(variant, place, p.key, nominal.lines), p.key,
            "in variant '" + shown(variant.name) + "': " + p.wrong, p.allowed);
  return result;
}

std::vector<Case> read_variants(const YamlNode& root, const Case& data, const std::string& path,
                                const ReadLog& log, ReadLog& changed) {
  std::vector<Case> variants;
  for (std::size_t i = 0; i < data.variants.size(); ++i)
    variants.push_back(read_variant(root, data, data.variants[i],
                                    "variants[" + std::to_string(i) + "]", path, log, changed));
  return variants;
}

// Problems of the other models beyond those of the nominal case.
void check_models(const YamlNode& root, const std::string& path, const ReadLog& nominal,
                  ReadLog& log) {
  for (const YamlEntry& model : models_of(root)) {
    const std::string place = "models." + model.key;
    const bool readable =
        std::none_of(nominal.problems.begin(), nominal.problems.end(),
                     [&](const InputProblem& p) { return is_below(p.key, place); });
    if (!readable || model.value.kind != YamlNode::Kind::map) continue;
    ReadLog own{.file = log.file}, deeper{.file = log.file};
    const std::size_t before = log.problems.size();
    const YamlNode tree = as_model(root, model, log);
    if (log.problems.size() > before) continue;
    const Case data = read_tree(tree, path, model.key, true, own);
    read_variants(tree, data, path, own, deeper);
    check_tolerances(tree, data, path, own, deeper);
    std::vector<InputProblem> problems = new_problems(own, nominal);
    problems.insert(problems.end(), deeper.problems.begin(), deeper.problems.end());
    for (const InputProblem& p : problems) {
      const bool moved = model.value.find(p.key.substr(0, p.key.find_first_of(".[")));
      log.add(p.line, moved ? below(place, p.key) : p.key,
              "in model '" + shown(model.key) + "': " + p.wrong, p.allowed);
    }
  }
}

// `whole`: with its variants, its fit, its other models.
CaseFile read(YamlFile yaml, ReadLog log, const std::string& model, const Replacements& overrides,
              bool whole) {
  const std::string path = log.file;
  YamlNode& root = yaml.root;
  if (root.kind == YamlNode::Kind::null) throw InputError(std::move(log.problems));
  const YamlNode as_written = root;
  if (!model.empty()) root = chosen_model(as_written, model, log);
  for (const auto& [where, value] : overrides) {
    const PathProblem problem = put(root, where, value, 0);
    if (!problem.wrong.empty()) log.add(0, where, problem.wrong, problem.allowed);
  }
  CaseFile file;
  file.path = path;
  file.text = std::move(yaml.text);
  file.set = overrides;
  file.data = read_tree(root, path, model, whole, log);
  ReadLog changed{.file = path};
  if (whole) file.variants = read_variants(root, file.data, path, log, changed);
  check_tolerances(root, file.data, path, log, changed);
  if (whole && model.empty()) check_models(root, path, log, changed);
  log.problems.insert(log.problems.end(), changed.problems.begin(), changed.problems.end());
  if (!log.problems.empty()) {
    sort_by_line(log.problems, log.file);
    throw InputError(std::move(log.problems));
  }
  file.lines = std::move(log.lines);
  return file;
}

CaseFile read(const std::string& path, const std::string& model, const Replacements& overrides,
              bool whole) {
  ReadLog log{.file = path};
  YamlFile yaml = read_yaml(path, log.problems);
  return read(std::move(yaml), std::move(log), model, overrides, whole);
}

// The tree of what was read, with its model and what was put into it.
YamlNode tree_of(const CaseFile& file, ReadLog& log) {
  YamlNode root = parse_yaml(file.text, file.path, log.problems);
  if (!file.data.model.empty()) root = chosen_model(root, file.data.model, log);
  for (const auto& [where, value] : file.set) put(root, where, value, 0);
  return root;
}

} // namespace

CaseFile read_case(const std::string& path, const std::string& model,
                   const Replacements& overrides) {
  return read(path, model, overrides, overrides.empty());
}

CaseFile read_case_with(const std::string& path, const std::string& model,
                        const Replacements& set) {
  return read(path, model, set, true);
}

CaseFile read_case(const CaseFile& kept, const Replacements& overrides) {
  ReadLog log{.file = kept.path};
  YamlFile yaml{.text = kept.text, .root = parse_yaml(kept.text, kept.path, log.problems)};
  return read(std::move(yaml), std::move(log), kept.data.model, overrides, overrides.empty());
}

std::string test_named_in(const std::string& path, const std::string& model,
                          const Replacements& set) {
  ReadLog log{.file = path};
  const YamlFile yaml = read_yaml(path, log.problems);
  if (yaml.root.kind != YamlNode::Kind::map) return "";
  YamlNode root = model.empty() ? yaml.root : chosen_model(yaml.root, model, log);
  for (const auto& [where, value] : set) put(root, where, value, 0);
  const YamlNode* test = root.find("measured");
  return test && test->kind == YamlNode::Kind::scalar ? test->text : "";
}

ChangedCases::ChangedCases(const CaseFile& file) : path_(file.path), model_(file.data.model) {
  ReadLog log{.file = file.path};
  root_ = std::make_unique<const YamlNode>(tree_of(file, log));
}
ChangedCases::~ChangedCases() = default;

Case ChangedCases::with(const Replacements& changes) const {
  YamlNode root = *root_;
  ReadLog log{.file = path_};
  for (const auto& [where, value] : changes)
    if (const PathProblem problem = put(root, where, value, 0); !problem.wrong.empty())
      log.add(0, where, problem.wrong, problem.allowed);
  Case data = log.problems.empty() ? read_tree(root, path_, model_, false, log) : Case{};
  if (!log.problems.empty()) throw InputError(std::move(log.problems));
  return data;
}

void ChangedCases::check(const std::string& path) const {
  YamlNode root = *root_;
  if (const PathProblem problem = put(root, path, "0", 0); !problem.wrong.empty())
    throw InputError({{.file = path_,
                       .line = 0,
                       .key = path,
                       .wrong = problem.wrong,
                       .allowed = problem.allowed}});
}

std::string yaml_of(const CaseFile& file, const std::map<std::string, std::string>& changes,
                    const std::filesystem::path& measured, const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  ReadLog log{.file = file.path};
  YamlNode root = tree_of(file, log);
  std::erase_if(root.entries, [](const YamlEntry& e) {
    return e.key == "models" || e.key == "variants" || e.key == "fit";
  });
  if (root.find("diagnose")) put(root, "diagnose.fit_baseline", "~", 0);
  for (const auto& [path, value] : changes) {
    const PathProblem problem = put(root, path, value, 0);
    if (!problem.wrong.empty()) log.add(0, path, problem.wrong, problem.allowed);
  }
  if (!log.problems.empty()) throw InputError(std::move(log.problems));
  const fs::path here = fs::path(file.path).parent_path();
  const auto from_folder = [&](const fs::path& path) {
    return fs::proximate(fs::absolute(path), fs::absolute(folder)).generic_string();
  };
  if (YamlNode* parts = root.find("parts"))
    for (YamlEntry& part : parts->entries)
      if (YamlNode* geometry = part.value.find("file"))
        geometry->text = from_folder(here / geometry->text);
  const auto put_file = [&](const std::string& key, const fs::path& path) {
    YamlNode name;
    name.kind = YamlNode::Kind::scalar;
    name.text = from_folder(path);
    put(root, key, to_yaml(name), 0);
  };
  for (const SignalFile& signal : signal_files(file.data.analyses))
    put_file(signal.key + ".file", here / signal.file);
  const YamlNode* named = root.find("measured");
  if (named || !measured.empty())
    put_file("measured", measured.empty() ? here / named->text : measured);
  return to_yaml_file(root);
}

std::vector<std::filesystem::path> files_of(const CaseFile& file) {
  std::vector<std::filesystem::path> files{file.path};
  for (const Part& part : file.data.parts) {
    if (const auto* surface = std::get_if<SurfacePart>(&part.body)) files.push_back(surface->file);
    const auto* deck = std::get_if<DeckPart>(&part.body);
    if (deck && deck->content)
      files.insert(files.end(), deck->content->files.begin(), deck->content->files.end());
  }
  const std::filesystem::path folder = std::filesystem::path(file.path).parent_path();
  for (const SignalFile& signal : signal_files(file.data.analyses))
    files.push_back(folder / signal.file);
  return files;
}

} // namespace plica
