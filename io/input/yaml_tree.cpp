#include "io/input/yaml_tree.hpp"

#include "words/did_you_mean.hpp"

namespace plica {

namespace {

std::string quoted_scalar(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '\n')
      result += "\\n";
    else if (c == '\t')
      result += "\\t";
    else if (c == '\r')
      result += "\\r";
    else
      result += (c == '"' || c == '\\') ? std::string{'\\', c} : std::string{c};
  }
  return result + "\"";
}

std::string scalar_text(const std::string& text, bool quoted) {
  static const std::string special = ",[]{}:#&*!|>'\"%@`\n\t\r\\";
  const bool plain = !text.empty() && text.find_first_of(special) == std::string::npos &&
                     text.front() != ' ' && text.back() != ' ' && text.front() != '-' &&
                     text.front() != '?' && text != "~" && text != "null";
  if (!quoted && !text.empty() &&
      (plain || text.find_first_not_of("+-.0123456789eE mkNPaMGz%/") == std::string::npos))
    return text; // numbers with their units stay readable
  return quoted_scalar(text);
}

} // namespace

const YamlNode* YamlNode::find(const std::string& key) const {
  for (const YamlEntry& entry : entries)
    if (entry.key == key) return &entry.value;
  return nullptr;
}

YamlNode* YamlNode::find(const std::string& key) {
  return const_cast<YamlNode*>(static_cast<const YamlNode*>(this)->find(key));
}

std::string to_yaml(const YamlNode& node) {
  std::string text;
  switch (node.kind) {
  case YamlNode::Kind::null:
    return "~";
  case YamlNode::Kind::scalar:
    return scalar_text(node.text, node.quoted);
  case YamlNode::Kind::list:
    for (const YamlNode& item : node.items) text += (text.empty() ? "" : ", ") + to_yaml(item);
    return "[" + text + "]";
  case YamlNode::Kind::map:
    for (const YamlEntry& e : node.entries)
      text += (text.empty() ? "" : ", ") + scalar_text(e.key, false) + ": " + to_yaml(e.value);
    return "{" + text + "}";
  }
  return text;
}

namespace {

constexpr std::size_t widest = 100;

// An entry of a map or list whose first line begins with `head`, which stands `indent` in.
std::string entry_text(const std::string& head, const YamlNode& value, std::size_t indent);

std::string block_text(const YamlNode& node, std::size_t indent) {
  const std::string margin(indent, ' ');
  std::string text;
  for (const YamlEntry& e : node.entries)
    text += entry_text(margin + scalar_text(e.key, false) + ":", e.value, indent);
  for (const YamlNode& item : node.items) text += entry_text(margin + "-", item, indent);
  return text;
}

std::string entry_text(const std::string& head, const YamlNode& value, std::size_t indent) {
  const std::string line = to_yaml(value);
  if (head.size() + 1 + line.size() <= widest || (value.items.empty() && value.entries.empty()))
    return head + " " + line + "\n";
  return head + "\n" + block_text(value, indent + 2);
}

} // namespace

std::string to_yaml_file(const YamlNode& root) {
  return block_text(root, 0);
}

std::string kind_of(const YamlNode& node) {
  switch (node.kind) {
  case YamlNode::Kind::null:
    return "empty";
  case YamlNode::Kind::scalar:
    return "'" + shown(node.text) + "'";
  case YamlNode::Kind::list:
    return "a list";
  case YamlNode::Kind::map:
    return "a map";
  }
  return "";
}

void set_lines(YamlNode& node, int line) {
  node.line = line;
  for (YamlNode& item : node.items) set_lines(item, line);
  for (YamlEntry& entry : node.entries) {
    entry.line = line;
    set_lines(entry.value, line);
  }
}

} // namespace plica
