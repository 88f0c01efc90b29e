#include "io/input/yaml_tree.hpp"

#include "io/files/files.hpp"
#include "words/did_you_mean.hpp"
#include "words/utf8.hpp"

#include <algorithm>
#include <deque>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <unordered_map>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

namespace plica {

namespace {

constexpr int deepest = 64;
constexpr std::size_t largest = 4u << 20;

YamlNode node_at(const YAML::Mark& mark, YamlNode::Kind kind) {
  YamlNode node;
  node.kind = kind;
  node.line = mark.line + 1;
  return node;
}

struct Stop {}; // a problem after which the rest of the file means nothing

// Builds the tree from parser events.
class TreeBuilder : public YAML::EventHandler {
public:
  TreeBuilder(const std::string& file, std::vector<InputProblem>& problems)
      : file_(file), problems_(problems) {}

  YamlNode root;

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override {
    add(node_at(mark, YamlNode::Kind::null));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    fail(mark, "aliases (*name) are not supported", "write the value out");
  }
  void OnAnchor(const YAML::Mark& mark, const std::string&) override {
    fail(mark, "anchors (&name) are not supported", "write the value out where it is needed");
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                const std::string& value) override {
    if (tag != "?" && tag != "!" && !tag.empty()) fail_tag(mark, tag);
    YamlNode node = node_at(mark, YamlNode::Kind::scalar);
    node.quoted = tag == "!";
    node.text = value;
    add(std::move(node));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    open(mark, tag, YamlNode::Kind::list);
  }
  void OnSequenceEnd() override { stack_.pop_back(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    open(mark, tag, YamlNode::Kind::map);
  }
  void OnMapEnd() override { stack_.pop_back(); }

private:
  struct Level {
    YamlNode* node;
    std::string path;
    bool has_key = false; // map: the next event is the value of the last entry
    bool duplicate = false;
    std::unordered_map<std::string, int> lines = {}; // of the keys of a map
  };

  [[noreturn]] void fail(const YAML::Mark& mark, std::string wrong, std::string allowed) {
    problems_.push_back({file_, mark.line + 1, stack_.empty() ? "" : stack_.back().path,
                         std::move(wrong), std::move(allowed)});
    throw Stop{};
  }
  [[noreturn]] void fail_tag(const YAML::Mark& mark, const std::string& tag) {
    fail(mark, "the tag '" + shown(tag) + "' is not supported", "write the plain value");
  }

  void open(const YAML::Mark& mark, const std::string& tag, YamlNode::Kind kind) {
    if (tag != "?" && !tag.empty()) fail_tag(mark, tag);
    if (static_cast<int>(stack_.size()) >= deepest)
      fail(mark, "nested too deeply", "at most " + std::to_string(deepest) + " levels");
    const auto [node, path] = add(node_at(mark, kind));
    stack_.push_back({node, path});
  }

  // Puts a node where the file has it; its place and path.
  std::pair<YamlNode*, std::string> add(YamlNode node) {
    if (stack_.empty()) {
      root = std::move(node);
      return {&root, ""};
    }
    Level& level = stack_.back();
    if (level.node->kind == YamlNode::Kind::list) {
      const std::string path = level.path + "[" + std::to_string(level.node->items.size()) + "]";
      level.node->items.push_back(std::move(node));
      return {&level.node->items.back(), path};
    }
    if (!level.has_key) {
      add_key(level, node);
      return {nullptr, ""};
    }
    level.has_key = false;
    YamlEntry& entry = level.node->entries.back();
    const std::string path = level.path.empty() ? entry.key : level.path + "." + entry.key;
    if (level.duplicate) { // reported; keep reading it into a place that is thrown away
      level.duplicate = false;
      level.node->entries.pop_back();
      return {&dropped_.emplace_back(std::move(node)), path};
    }
    entry.value = std::move(node);
    return {&entry.value, path};
  }

  void add_key(Level& level, const YamlNode& node) {
    const YAML::Mark mark = [&] {
      YAML::Mark m;
      m.line = node.line - 1;
      return m;
    }();
    if (node.kind != YamlNode::Kind::scalar)
      fail(mark, "here a key is " + kind_of(node), "allowed: a word");
    const auto [first, is_new] = level.lines.try_emplace(node.text, node.line);
    if (!is_new) {
      const std::string path = level.path.empty() ? node.text : level.path + "." + node.text;
      problems_.push_back({file_, node.line, path,
                           "key given twice, first in line " + std::to_string(first->second),
                           "keep one of them"});
      level.duplicate = true;
    }
    level.node->entries.push_back({node.text, node.line, {}});
    level.has_key = true;
  }

  std::string file_;
  std::vector<InputProblem>& problems_;
  std::vector<Level> stack_;
  std::deque<YamlNode> dropped_;
};

// Length of the UTF-8 character at i, 0 if it is none or a control character.
std::size_t text_character(const std::string& s, std::size_t i) {
  const auto c = static_cast<unsigned char>(s[i]);
  if (c >= 0x80) return utf8_length(s, i);
  return (c >= 0x20 && c != 0x7F) || c == '\t' || c == '\n' || c == '\r' ? 1 : 0;
}

// Line of the first byte that is not text; 0 = all is text.
int line_of_binary(const std::string& s) {
  int line = 1;
  for (std::size_t i = 0; i < s.size();) {
    const std::size_t length = text_character(s, i);
    if (length == 0) return line;
    if (s[i] == '\n') ++line;
    i += length;
  }
  return 0;
}

// Levels of brackets open at once, counted without regard to quotes: the parser recurses on them.
bool too_many_brackets(const std::string& s) {
  long open = 0;
  for (const char c : s) {
    if (c == '[' || c == '{') ++open;
    if ((c == ']' || c == '}') && open > 0) --open;
    if (open > 400) return true;
  }
  return false;
}

} // namespace

YamlNode parse_yaml(const std::string& text, const std::string& file,
                    std::vector<InputProblem>& problems) {
  if (const int line = line_of_binary(text); line > 0) {
    problems.push_back({file, line, "", "holds bytes that are not text", "allowed: YAML in UTF-8"});
    return {};
  }
  TreeBuilder builder(file, problems);
  try {
    if (too_many_brackets(text)) {
      problems.push_back(
          {file, 0, "", "nested too deeply", "at most " + std::to_string(deepest) + " levels"});
      return {};
    }
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder)) return {};
    YamlNode root = std::move(builder.root);
    TreeBuilder rest(file, problems);
    if (parser.HandleNextDocument(rest))
      problems.push_back({file, rest.root.line, "", "a second YAML document starts here",
                          "one document per file"});
    return root;
  } catch (const Stop&) {
  } catch (const YAML::Exception& e) {
    const int line = e.mark.is_null() ? 0 : e.mark.line + 1;
    if (e.msg.find("anchor") != std::string::npos)
      problems.push_back(
          {file, line, "", "aliases (*name) are not supported", "write the value out"});
    else if (e.msg.find("deep") != std::string::npos)
      problems.push_back(
          {file, line, "", "nested too deeply", "at most " + std::to_string(deepest) + " levels"});
    else
      problems.push_back({file, line, "", "YAML syntax: " + e.msg,
                          "check brackets, quotes, colons and indentation here and above; within { "
                          "} a name with [ ] "
                          "needs quotes"});
  }
  return {};
}

YamlFile read_yaml(const std::string& path, std::vector<InputProblem>& problems) {
  YamlFile file;
  const auto fail = [&](const std::string& wrong, const char* allowed) {
    problems.push_back({path, 0, "", wrong, allowed});
    return file;
  };
  if (const std::string why = why_unreadable(path); !why.empty())
    return fail(why, "give the path of a YAML file");
  std::error_code ignored;
  if (std::filesystem::file_size(path, ignored) > largest)
    return fail("is larger than 4 MB", "this cannot be a hand-written case");
  try {
    file.text = read_whole(path);
  } catch (const std::runtime_error& error) { // gone meanwhile
    return fail(error.what(), "give the path of a YAML file");
  }
  const std::size_t before = problems.size();
  file.root = parse_yaml(file.text, path, problems);
  if (file.root.kind == YamlNode::Kind::null && problems.size() == before)
    return fail("the file is empty", "a YAML map with keys and values");
  return file;
}

} // namespace plica
