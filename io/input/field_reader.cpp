#include "io/input/field_reader.hpp"

#include "words/did_you_mean.hpp"
#include "words/tolerance.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace plica {

namespace {

bool is_name(const std::string& text) {
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto inner = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
  };
  return !text.empty() && text.size() <= 64 && letter(text.front()) &&
         std::all_of(text.begin(), text.end(), inner);
}

constexpr const char* name_rule = "a name is a letter, then letters, digits, _ or -, at most 64";

} // namespace

void ReadLog::add(std::string key, std::string wrong, std::string allowed) {
  const auto found = lines.find(key);
  add(found == lines.end() ? 1 : found->second, std::move(key), std::move(wrong),
      std::move(allowed));
}

void ReadLog::add(int line, std::string key, std::string wrong, std::string allowed) {
  problems.push_back({file, line, std::move(key), std::move(wrong), std::move(allowed)});
}

void sort_by_line(std::vector<InputProblem>& problems, const std::string& file) {
  const auto others = std::stable_partition(problems.begin(), problems.end(),
                                            [&](const InputProblem& p) { return p.file == file; });
  std::stable_sort(problems.begin(), others,
                   [](const InputProblem& a, const InputProblem& b) { return a.line < b.line; });
}

FieldReader::FieldReader(const YamlNode& node, std::string path, ReadLog& log)
    : node_(node), path_(std::move(path)), log_(log) {
  if (node_.kind == YamlNode::Kind::map)
    for (const YamlEntry& entry : node_.entries) log_.lines[at(entry.key)] = entry.line;
}

const YamlNode* FieldReader::take(const char* key, bool required, const char* help) {
  if (stopped_) return nullptr;
  if (node_.kind != YamlNode::Kind::map) {
    log_.add(node_.line, path_, "is " + kind_of(node_), "allowed: a map with keys and values");
    stopped_ = true;
    return nullptr;
  }
  known_.emplace_back(key);
  const YamlNode* node = node_.find(key);
  if (!node) {
    if (required) missing_.emplace_back(key, help);
    return nullptr;
  }
  if (node->kind != YamlNode::Kind::null) return node;
  log_.add(log_.lines[at(key)], at(key), "has no value", std::string("needed: ") + help);
  return nullptr;
}

bool FieldReader::items(const YamlNode& node, const std::string& path, int min, int max,
                        const char* help) {
  if (node.kind != YamlNode::Kind::list) {
    log_.add(node.line, path, "is " + kind_of(node),
             std::string("allowed: a list [...] of ") + help);
    return false;
  }
  const int n = static_cast<int>(node.items.size());
  for (int i = 0; i < n; ++i) log_.lines[path + "[" + std::to_string(i) + "]"] = node.items[i].line;
  if (n >= min && n <= max) return true;
  const std::string count = min == max ? "" : n < min ? "at least " : "at most ";
  log_.add(node.line, path, "has " + std::to_string(n) + (n == 1 ? " item" : " items"),
           "allowed: " + count + std::to_string(n < min ? min : max));
  return false;
}

bool FieldReader::number(const YamlNode& node, const std::string& path, double& x,
                         const Quantity& q, Dimension unit) {
  if (node.kind != YamlNode::Kind::scalar) {
    log_.add(node.line, path,
             node.kind == YamlNode::Kind::null ? "has no value" : "is " + kind_of(node),
             "allowed: " + describe(q, unit));
    return false;
  }
  const bool one =
      q.is_unit && !node.text.empty() && std::isalpha(static_cast<unsigned char>(node.text[0]));
  const TolerancedQuantity toleranced = parse_toleranced((one ? "1 " : "") + node.text, unit);
  const ParsedQuantity& parsed = toleranced.value;
  if (!parsed.wrong.empty()) {
    log_.add(node.line, path, parsed.wrong, parsed.allowed);
    return false;
  }
  const auto outside = [&](double v) {
    return v < q.min || v > q.max || (q.exclusive_min && v == q.min) ||
           (q.exclusive_max && v == q.max);
  };
  if (outside(parsed.value)) {
    const bool cut = path.ends_with(']') && node.text == "0"; // of "0,2 mm"
    log_.add(node.line, path, kind_of(node) + " is out of range",
             "allowed: " + describe(q, unit) + (cut ? "; decimals with a point, not a comma" : ""));
    return false;
  }
  if (const auto& limits = toleranced.limits) {
    if (outside(limits->low) || outside(limits->high)) {
      const bool in_points = std::count(node.text.begin(), node.text.end(), '%') > 1;
      log_.add(
          node.line, path, kind_of(node) + " has a tolerance that leads out of range",
          "allowed: " + describe(q, unit) +
              (in_points ? "; beside a number in % the tolerance is in points: 1 % +- 0.2 %" : ""));
      return false;
    }
    log_.tolerances.push_back({path, parsed.value, limits->low, limits->high, limits->interval});
  }
  x = parsed.value;
  return true;
}

void FieldReader::numbers(const YamlNode& node, const std::string& path, double* x, std::size_t n,
                          const Quantity& q) {
  if (!items(node, path, int(n), int(n), "numbers")) return;
  for (std::size_t i = 0; i < n; ++i)
    number(node.items[i], path + "[" + std::to_string(i) + "]", x[i], q,
           q.tail && int(i) >= q.tail_from ? *q.tail : q.unit);
}

void FieldReader::quantity(double& x, const char* key, const Quantity& q, const char* help) {
  if (const YamlNode* node = take(key, q.required, help)) number(*node, at(key), x, q, q.unit);
}

void FieldReader::quantity(std::optional<double>& x, const char* key, const Quantity& q,
                           const char* help) {
  const YamlNode* node = take(key, q.required, help);
  double value = 0;
  if (node && number(*node, at(key), value, q, q.unit)) x = value;
}

void FieldReader::quantities(std::vector<double>& x, const char* key, const Quantity& q,
                             const char* help) {
  const YamlNode* node = take(key, q.required, help);
  if (!node || !items(*node, at(key), q.min_items, q.max_items, "numbers")) return;
  x.assign(node->items.size(), 0.0);
  for (std::size_t i = 0; i < x.size(); ++i) number(node->items[i], at(key, i), x[i], q, q.unit);
}

void FieldReader::integer(const YamlNode& node, const std::string& path, int& x, const Whole& w) {
  const std::string allowed = std::string("allowed: ") + (w.even ? "an even" : "a") +
                              " whole number from " + std::to_string(w.min) + " to " +
                              std::to_string(w.max);
  if (node.kind != YamlNode::Kind::scalar)
    return log_.add(node.line, path, "is " + kind_of(node), allowed);
  long long value = 0;
  const char* end = node.text.data() + node.text.size();
  const auto [stop, status] = std::from_chars(node.text.data(), end, value);
  if (status == std::errc::invalid_argument || stop != end)
    return log_.add(node.line, path, kind_of(node) + " is not a whole number", allowed);
  if (status != std::errc() || value < w.min || value > w.max || (w.even && value % 2 != 0))
    return log_.add(node.line, path, kind_of(node) + " is out of range", allowed);
  x = static_cast<int>(value);
}

void FieldReader::whole(int& x, const char* key, const Whole& w, const char* help) {
  if (const YamlNode* node = take(key, w.required, help)) integer(*node, at(key), x, w);
}

void FieldReader::flag(bool& x, const char* key, const char* help) {
  const YamlNode* node = take(key, false, help);
  if (!node) return;
  const bool yes = node->text == "true", no = node->text == "false";
  if (node->kind != YamlNode::Kind::scalar || node->quoted || !(yes || no))
    log_.add(node->line, at(key), "is " + kind_of(*node), "allowed: true or false");
  else
    x = yes;
}

void FieldReader::flag(std::optional<bool>& x, const char* key, const char* help) {
  if (bool value = false; find(key)) {
    flag(value, key, help);
    x = value;
  } else {
    take(key, false, help);
  }
}

void FieldReader::flag_or(std::optional<bool>& x, bool& said, const char* key, const char* word,
                          const char* help) {
  const YamlNode* node = take(key, false, help);
  if (!node) return;
  const bool yes = node->text == "true", no = node->text == "false";
  if (node->kind == YamlNode::Kind::scalar && node->text == word)
    said = true;
  else if (node->kind == YamlNode::Kind::scalar && !node->quoted && (yes || no))
    x = yes;
  else
    log_.add(node->line, at(key), "is " + kind_of(*node),
             std::string("allowed: true, false or ") + word);
}

void FieldReader::text(std::string& x, const char* key, const Text& t, const char* help) {
  const YamlNode* node = take(key, t.required, help);
  if (!node) return;
  if (node->kind != YamlNode::Kind::scalar || node->text.empty())
    return log_.add(node->line, at(key),
                    "is " + (node->kind == YamlNode::Kind::scalar ? std::string("an empty text")
                                                                  : kind_of(*node)),
                    "allowed: a text");
  x = node->text;
  if (t.name && !is_name(x))
    log_.add(node->line, at(key), kind_of(*node) + " is not a name", name_rule);
}

void FieldReader::texts(std::vector<std::string>& x, const char* key, const char* help) {
  const YamlNode* node = take(key, false, help);
  if (!node || !items(*node, at(key), 0, 1000, "texts")) return;
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    const YamlNode& item = node->items[i];
    if (item.kind == YamlNode::Kind::scalar)
      x.push_back(item.text);
    else
      log_.add(item.line, at(key, i), "is " + kind_of(item),
               "allowed: a text; put it in quotes if it contains a colon");
  }
}

void FieldReader::one_or_more(std::vector<std::string>& x, const char* key, const char* help) {
  const YamlNode* node = take(key, true, help);
  if (!node) return;
  const auto add = [&](const YamlNode& item, const std::string& path) {
    if (item.kind == YamlNode::Kind::scalar && !item.text.empty())
      x.push_back(item.text);
    else
      log_.add(item.line, path, "is " + kind_of(item), "allowed: a text, or a list of texts");
  };
  if (node->kind != YamlNode::Kind::list) return add(*node, at(key));
  if (!items(*node, at(key), 1, 100, help)) return;
  for (std::size_t i = 0; i < node->items.size(); ++i) add(node->items[i], at(key, i));
}

std::string FieldReader::one_word_of(const char* help, const std::vector<std::string>& names) {
  std::string text = help;
  for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? ": " : ", ") + names[i];
  return text;
}

int FieldReader::word_index(const YamlNode& node, const std::string& path,
                            const std::vector<std::string>& names, const char* also) {
  const auto found = std::find(names.begin(), names.end(), node.text);
  if (node.kind == YamlNode::Kind::scalar && found != names.end())
    return static_cast<int>(found - names.begin());
  log_.add(node.line, path, "is " + kind_of(node), suggestion(node.text, names) + also);
  return -1;
}

void FieldReader::choices(std::vector<int>& x, const char* key,
                          const std::vector<Named<int>>& names, const Need& need,
                          const char* help) {
  const YamlNode* node = take(key, need.required, help);
  if (node) words_of_list(*node, x, at(key), names, need);
}

void FieldReader::words_of_list(const YamlNode& node, std::vector<int>& x, const std::string& path,
                                const std::vector<Named<int>>& names, const Need& need) {
  if (!items(node, path, need.min_items, static_cast<int>(names.size()), "words")) return;
  x.clear();
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const std::string own = path + "[" + std::to_string(i) + "]";
    const int index = word_index(node.items[i], own, words(names));
    if (index < 0) continue;
    const int value = names[index].value;
    if (std::find(x.begin(), x.end(), value) != x.end())
      log_.add(node.items[i].line, own, kind_of(node.items[i]) + " is given twice",
               "keep one of them");
    x.push_back(value);
  }
}

std::vector<const YamlEntry*> FieldReader::by_name(const char* key, const Need& need,
                                                   const char* help) {
  const YamlNode* node = take(key, need.required, help);
  std::vector<const YamlEntry*> result;
  if (!node) return result;
  if (node->kind != YamlNode::Kind::map) {
    log_.add(node->line, at(key), "is " + kind_of(*node), std::string("allowed: a map of ") + help);
    return result;
  }
  if (static_cast<int>(node->entries.size()) < need.min_items)
    log_.add(node->line, at(key), "is empty",
             "allowed: at least " + std::to_string(need.min_items));
  for (const YamlEntry& entry : node->entries) {
    log_.lines[at(key) + "." + entry.key] = entry.line;
    if (!is_name(entry.key))
      log_.add(entry.line, at(key) + "." + shown(entry.key), "is not a name", name_rule);
    else
      result.push_back(&entry);
  }
  return result;
}

void FieldReader::replacements(std::map<std::string, std::string>& x, const char* key,
                               const Need& need, const char* help) {
  const YamlNode* node = take(key, need.required, help);
  if (!node) return;
  if (node->kind != YamlNode::Kind::map || node->entries.empty())
    return log_.add(node->line, at(key),
                    "is " +
                        (node->kind == YamlNode::Kind::map ? std::string("empty") : kind_of(*node)),
                    "allowed: a map of paths of this file to new values");
  constexpr std::size_t most = 1000;
  if (node->entries.size() > most)
    return log_.add(node->line, at(key), "has " + std::to_string(node->entries.size()) + " items",
                    "allowed: at most " + std::to_string(most));
  for (const YamlEntry& entry : node->entries) {
    x[entry.key] = to_yaml(entry.value);
    log_.lines[at(key) + "." + entry.key] = entry.line;
  }
}

void FieldReader::finish() {
  if (node_.kind != YamlNode::Kind::map && !stopped_)
    return log_.add(node_.line, path_, "is " + kind_of(node_),
                    "allowed: a map with keys and values");
  constexpr std::size_t most_named = 50;
  std::size_t unknown = 0;
  for (const YamlEntry& entry : node_.entries) {
    if (stopped_ || std::find(known_.begin(), known_.end(), entry.key) != known_.end()) continue;
    if (++unknown > most_named) continue;
    log_.add(entry.line, at(shown(entry.key)), "unknown key", suggestion(entry.key, known_));
    const std::string meant = nearest_word(entry.key, known_);
    if (std::erase_if(missing_, [&](const auto& m) { return m.first == meant; }) > 0)
      log_.misspelt.push_back(at(meant));
  }
  if (unknown > most_named)
    log_.add(node_.line, path_,
             "has " + std::to_string(unknown - most_named) + " more unknown keys",
             "those of docs/case_reference.md");
  const int line =
      log_.lines.count(path_) && log_.lines[path_] > 0 ? log_.lines[path_] : node_.line;
  for (const auto& [key, help] : missing_) log_.add(line, at(key), "is missing", "needed: " + help);
}

} // namespace plica
