// Reads a YAML tree into a described struct (words/field_types.hpp), strictly: every key known,
// every required key present, every value of the right kind and within its bounds. What is wrong
// goes into the log, and reading continues, so that one run shows all mistakes.
#pragma once

#include "io/input/yaml_tree.hpp"
#include "model/description/case.hpp"
#include "words/field_types.hpp"
#include "words/variant_at.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace plica {

struct ReadLog {
  std::string file;
  std::vector<InputProblem> problems = {};
  std::map<std::string, int> lines = {}; // key path -> line
  std::vector<std::string> misspelt =
      {}; // keys that are bad without a problem of their own: missing because of a misspelt one
  std::vector<Tolerance> tolerances = {}; // numbers written with one

  void add(int line, std::string key, std::string wrong, std::string allowed);
  void add(std::string key, std::string wrong, std::string allowed); // at the line of the key
};

// Sorts those of a file by line and keeps their order within a line; those of others come behind
// them in the order in which they were found: decks say first what is missing most often.
void sort_by_line(std::vector<InputProblem>& problems, const std::string& file);

// One map of the file. Call `finish` when its struct has been visited.
class FieldReader {
public:
  FieldReader(const YamlNode& node, std::string path, ReadLog& log);

  void quantity(double& x, const char* key, const Quantity& q, const char* help);
  void quantity(std::optional<double>& x, const char* key, const Quantity& q, const char* help);
  void quantities(std::vector<double>& x, const char* key, const Quantity& q, const char* help);
  template <std::size_t N>
  void quantities(std::array<double, N>& x, const char* key, const Quantity& q, const char* help) {
    if (const YamlNode* node = take(key, q.required, help)) numbers(*node, at(key), x.data(), N, q);
  }
  template <std::size_t N>
  void quantities(std::optional<std::array<double, N>>& x, const char* key, const Quantity& q,
                  const char* help) {
    if (const YamlNode* node = take(key, q.required, help))
      numbers(*node, at(key), x.emplace().data(), N, q);
  }
  template <std::size_t N>
  void points(std::vector<std::array<double, N>>& x, const char* key, const Quantity& q,
              const char* help) {
    const YamlNode* node = take(key, q.required, help);
    if (!node || !items(*node, at(key), q.min_items, q.max_items, help)) return;
    x.assign(node->items.size(), {});
    for (std::size_t i = 0; i < x.size(); ++i)
      numbers(node->items[i], at(key, i), x[i].data(), N, q);
  }
  template <std::size_t N, std::size_t M>
  void points(std::array<std::array<double, N>, M>& x, const char* key, const Quantity& q,
              const char* help) {
    const YamlNode* node = take(key, q.required, help);
    if (!node || !items(*node, at(key), int(M), int(M), help)) return;
    for (std::size_t i = 0; i < M; ++i) numbers(node->items[i], at(key, i), x[i].data(), N, q);
  }
  void whole(int& x, const char* key, const Whole& w, const char* help);
  template <std::size_t N>
  void whole(std::array<int, N>& x, const char* key, const Whole& w, const char* help) {
    const YamlNode* node = take(key, w.required, help);
    if (!node || !items(*node, at(key), int(N), int(N), help)) return;
    for (std::size_t i = 0; i < N; ++i) integer(node->items[i], at(key, i), x[i], w);
  }
  void flag(bool& x, const char* key, const char* help);
  void flag(std::optional<bool>& x, const char* key, const char* help);
  // true, false, or a word, which sets `said` and leaves x open.
  void flag_or(std::optional<bool>& x, bool& said, const char* key, const char* word,
               const char* help);
  void text(std::string& x, const char* key, const Text& t, const char* help);
  void texts(std::vector<std::string>& x, const char* key, const char* help);
  void one_or_more(std::vector<std::string>& x, const char* key, const char* help);

  template <class E>
  void choice(E& x, const char* key, const std::type_identity_t<std::vector<Named<E>>>& names,
              const Need& need, const char* help) {
    const std::string hint = one_word_of(help, words(names));
    if (const YamlNode* node = take(key, need.required, hint.c_str()))
      if (const int i = word_index(*node, at(key), words(names)); i >= 0) x = names[i].value;
  }
  template <class E>
  void choice(std::optional<E>& x, const char* key,
              const std::type_identity_t<std::vector<Named<E>>>& names, const Need& need,
              const char* help) {
    if (E value{}; find(key)) {
      choice(value, key, names, need, help);
      x = value;
    } else {
      take(key, need.required, help);
    }
  }
  template <class E>
  void tag(E& x, const char* key, const std::type_identity_t<std::vector<Named<E>>>& names,
           const Need& need, const char* help) {
    const std::size_t before = log_.problems.size();
    const bool given = find(key) != nullptr;
    choice(x, key, names, need, help);
    if (log_.problems.size() > before || (need.required && !given)) stopped_ = true;
  }
  void choices(std::vector<int>& x, const char* key, const std::vector<Named<int>>& names,
               const Need& need, const char* help);
  template <class T>
  void choices_or(std::vector<int>& words, std::vector<T>& maps, const char* key,
                  const std::vector<Named<int>>& names, const Need& need, const char* help) {
    const YamlNode* node = find(key);
    const auto is_map = [](const YamlNode& n) { return n.kind == YamlNode::Kind::map; };
    if (node && is_map(*node)) {
      take(key, need.required, help);
      read(*node, at(key, 0), maps.emplace_back());
    } else if (node && std::any_of(node->items.begin(), node->items.end(), is_map)) {
      take(key, need.required, help);
      const auto first = std::find_if(node->items.begin(), node->items.end(), is_map);
      YamlNode leading = *node;
      leading.items.assign(node->items.begin(), first);
      if (!leading.items.empty()) words_of_list(leading, words, at(key), names, need);
      if (!items(*node, at(key), need.min_items, 10000, help)) return;
      for (std::size_t i = leading.items.size(); i < node->items.size(); ++i)
        if (is_map(node->items[i]))
          read(node->items[i], at(key, i), maps.emplace_back());
        else
          log_.add(node->items[i].line, at(key, i), kind_of(node->items[i]) + " behind a map",
                   "words first, then maps");
    } else {
      choices(words, key, names, need, help);
    }
  }
  template <class T> void object(T& x, const char* key, const Need& need, const char* help) {
    if (const YamlNode* node = take(key, need.required, help)) read(*node, at(key), x);
  }
  template <class T>
  void object(std::optional<T>& x, const char* key, const Need& need, const char* help) {
    if (const YamlNode* node = take(key, need.required, help)) read(*node, at(key), x.emplace());
  }
  template <class T>
  void list(std::vector<T>& x, const char* key, const Need& need, const char* help) {
    const YamlNode* node = take(key, need.required, help);
    if (!node || !items(*node, at(key), need.min_items, 10000, help)) return;
    x.resize(node->items.size());
    for (std::size_t i = 0; i < x.size(); ++i) read(node->items[i], at(key, i), x[i]);
  }
  template <class T>
  void one_or_more(std::vector<T>& x, const char* key, const Need& need, const char* help) {
    if (const YamlNode* node = find(key); node && node->kind == YamlNode::Kind::list)
      return list(x, key, {.required = need.required, .min_items = 1}, help);
    const YamlNode* node = take(key, need.required, help);
    if (node && node->kind == YamlNode::Kind::map)
      read(*node, at(key), x.emplace_back());
    else if (node)
      log_.add(node->line, at(key), "is " + kind_of(*node),
               "allowed: a map with keys and values, or a list of maps");
  }
  template <class T>
  void named(std::vector<T>& x, std::string T::*name, const char* key, const Need& need,
             const char* help) {
    for (const YamlEntry* entry : by_name(key, need, help)) {
      x.emplace_back();
      x.back().*name = entry->key;
      read(entry->value, at(key) + "." + entry->key, x.back());
    }
  }
  template <class T>
  void named(std::map<std::string, T>& x, const char* key, const Need& need, const char* help) {
    for (const YamlEntry* entry : by_name(key, need, help))
      read(entry->value, at(key) + "." + entry->key, x[entry->key]);
  }
  template <class... T>
  void one_of(std::variant<T...>& x, const char* key, const std::vector<std::string>& names,
              const char* help) {
    const YamlNode* node = take(key, true, one_word_of(help, names).c_str());
    const int i = node ? word_index(*node, at(key), names) : -1;
    if (i < 0) {
      stopped_ = true;
      return;
    }
    emplace_at(x, std::size_t(i));
    std::visit([this](auto& body) { fields(*this, body); }, x);
  }
  template <class E>
  void word(E& x, const std::type_identity_t<std::vector<Named<E>>>& names,
            const std::type_identity_t<E>& otherwise, const char*) {
    x = otherwise;
    if (node_.kind == YamlNode::Kind::map) return;
    stopped_ = true;
    if (const int i = word_index(node_, path_, words(names), ", or a map"); i >= 0)
      x = names[i].value;
  }
  void replacements(std::map<std::string, std::string>& x, const char* key, const Need& need,
                    const char* help);

  void finish(); // unknown and missing keys

  template <class T>
  static void read(const YamlNode& node, const std::string& path, T& x, ReadLog& log) {
    log.lines[path] = node.line;
    FieldReader reader(node, path, log);
    fields(reader, x);
    reader.finish();
  }

private:
  template <class T> void read(const YamlNode& node, const std::string& path, T& x) {
    const int line = log_.lines.count(path) ? log_.lines[path] : node.line;
    read(node, path, x, log_);
    log_.lines[path] = line; // of the key, not of the first entry
  }
  template <class E> static std::vector<std::string> words(const std::vector<Named<E>>& names) {
    std::vector<std::string> result;
    result.reserve(names.size());
    for (const Named<E>& n : names) result.emplace_back(n.name);
    return result;
  }

  static std::string one_word_of(const char* help, const std::vector<std::string>& names);
  std::string at(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }
  std::string at(const std::string& key, std::size_t i) const {
    return at(key) + "[" + std::to_string(i) + "]";
  }
  const YamlNode* find(const char* key) const { return stopped_ ? nullptr : node_.find(key); }
  // Notes the key as known; its node, or null when absent, empty or reading has stopped.
  const YamlNode* take(const char* key, bool required, const char* help);
  bool items(const YamlNode& node, const std::string& path, int min, int max, const char* help);
  void words_of_list(const YamlNode& node, std::vector<int>& x, const std::string& path,
                     const std::vector<Named<int>>& names, const Need& need);
  bool number(const YamlNode& node, const std::string& path, double& x, const Quantity& q,
              Dimension unit);
  void numbers(const YamlNode& node, const std::string& path, double* x, std::size_t n,
               const Quantity& q);
  void integer(const YamlNode& node, const std::string& path, int& x, const Whole& w);
  int word_index(const YamlNode& node, const std::string& path,
                 const std::vector<std::string>& names, const char* also = "");
  std::vector<const YamlEntry*> by_name(const char* key, const Need& need, const char* help);

  const YamlNode& node_;
  std::string path_;
  ReadLog& log_;
  bool stopped_ = false; // the rest of this map cannot be judged
  std::vector<std::string> known_;
  std::vector<std::pair<std::string, std::string>> missing_; // key, help
};

} // namespace plica
