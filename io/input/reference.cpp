#include "io/input/reference.hpp"

#include "io/files/json_text.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace plica {
namespace {

std::string code(const std::string& text) {
  return "`" + text + "`";
}

// The words of a key that may hold only these.
std::vector<std::string> words(const Json& schema) {
  std::vector<std::string> list;
  if (const auto found = schema.find("enum"); found != schema.end())
    for (const Json& word : *found) list.push_back(word.get<std::string>());
  return list;
}

std::string joined(const std::vector<std::string>& list, const char* last) {
  std::string text;
  for (std::size_t i = 0; i < list.size(); ++i)
    text += (i == 0 ? "" : i + 1 == list.size() ? last : ", ") + code(list[i]);
  return text;
}

// A key of a struct, over all the alternatives of the struct that have it.
struct Key {
  Json schema;
  std::vector<std::string> words;                       // what it may say, of all
  std::size_t present = 0, required = 0;                // alternatives
  std::map<std::string, std::vector<std::string>> with; // deciding key -> its words there
};

// The alternatives of a struct: one, or those under oneOf that are maps; and the words in its
// place.
struct Struct {
  std::vector<Json> maps;
  std::vector<std::string> words;
};
Struct struct_of(const Json& schema) {
  Struct s;
  if (!schema.contains("oneOf")) {
    if (schema.contains("properties")) s.maps.push_back(schema);
    return s;
  }
  for (const Json& alternative : schema["oneOf"]) {
    if (alternative.contains("properties")) s.maps.push_back(alternative);
    for (const std::string& word : words(alternative)) s.words.push_back(word);
  }
  return s;
}

bool decides(const std::string& key, const std::vector<Json>& maps) {
  std::vector<std::string> seen;
  for (const Json& map : maps) {
    const auto found = map["properties"].find(key);
    if (found == map["properties"].end()) continue;
    const std::vector<std::string> own = words(*found);
    if (own.size() != 1) return false;
    if (std::find(seen.begin(), seen.end(), own[0]) == seen.end()) seen.push_back(own[0]);
  }
  return seen.size() > 1;
}

std::vector<std::pair<std::string, Key>> keys_of(const std::vector<Json>& maps) {
  std::vector<std::pair<std::string, Key>> keys;
  for (const Json& map : maps)
    for (const auto& property : map["properties"].items()) {
      const std::string& name = property.key();
      const Json& schema = property.value();
      auto own =
          std::find_if(keys.begin(), keys.end(), [&](const auto& k) { return k.first == name; });
      if (own == keys.end())
        own = keys.insert(keys.end(), {name, Key{.schema = schema, .words = {}, .with = {}}});
      Key& key = own->second;
      ++key.present;
      for (const std::string& word : words(schema))
        if (std::find(key.words.begin(), key.words.end(), word) == key.words.end())
          key.words.push_back(word);
      const Json needed = map.value("required", Json::array());
      key.required += std::find(needed.begin(), needed.end(), name) != needed.end();
      for (const auto& [other, decider] : map["properties"].items())
        if (other != name && decides(other, maps)) {
          const std::string word = words(decider)[0];
          auto& list = key.with[other];
          if (std::find(list.begin(), list.end(), word) == list.end()) list.push_back(word);
        }
    }
  return keys;
}

class Reference {
public:
  explicit Reference(const Json& root) {
    text_ = "# " + root["title"].get<std::string>() +
            ": every key\n\nMade from the JSON Schema by "
            "`plica schema --reference`. Needed keys are marked; the others may be left out.\n";
    describe("", root);
    while (!open_.empty()) {
      const auto [path, schema] = open_.front();
      open_.erase(open_.begin());
      section(path, schema);
    }
  }
  std::string text() const { return text_; }

private:
  void section(const std::string& path, const Json& schema) {
    const Struct own = struct_of(schema);
    if (own.maps.size() > 1 && decides("type", own.maps)) {
      for (const Json& map : own.maps) {
        std::vector<Json> alike;
        const std::string type = words(map["properties"]["type"])[0];
        if (!types_.insert(path + type).second) continue;
        for (const Json& other : own.maps)
          if (words(other["properties"]["type"])[0] == type) alike.push_back(other);
        text_ += "\n## " + code(path) + " of type " + code(type) + "\n";
        table(path, alike);
      }
      return;
    }
    text_ += "\n## " + code(path) + "\n";
    if (!own.words.empty())
      text_ += "\nA map, or one of the words " + joined(own.words, " and ") + ".\n";
    table(path, own.maps);
  }

  void describe(const std::string& path, const Json& schema) {
    table(path, struct_of(schema).maps);
  }

  void table(const std::string& path, const std::vector<Json>& maps) {
    text_ += "\n| key | | what |\n|---|---|---|\n";
    for (auto& [name, key] : keys_of(maps)) {
      std::string what = key.schema.value("description", "");
      if (!key.words.empty()) what += (what.empty() ? "" : "; ") + joined(key.words, " or ");
      if (const auto usual = key.schema.find("default"); usual != key.schema.end())
        what +=
            "; left out: " + code(usual->is_string() ? usual->get<std::string>() : usual->dump());
      if (key.present < maps.size())
        for (const auto& [other, list] : key.with)
          if (all_words(other, maps).size() > list.size())
            what += "; only with " + code(other) + " " + joined(list, " or ");
      const std::string below = (path.empty() ? "" : path + ".") + name;
      if (const std::string where = nested(below, key.schema); !where.empty())
        what += (what.empty() ? "" : ": ") + where;
      text_ += "| " + code(name) + " | " + (key.required == key.present ? "needed" : "") + " | " +
               what + " |\n";
    }
  }

  static std::vector<std::string> all_words(const std::string& key, const std::vector<Json>& maps) {
    std::vector<std::string> list;
    for (const Json& map : maps)
      if (const auto found = map["properties"].find(key); found != map["properties"].end())
        if (const std::string word = words(*found)[0];
            std::find(list.begin(), list.end(), word) == list.end())
          list.push_back(word);
    return list;
  }

  // A struct inside: its section, which is written later; empty when there is none.
  std::string nested(const std::string& path, const Json& schema) {
    const Json* inner = &schema;
    std::string own = path;
    if (schema.contains("additionalProperties") && schema["additionalProperties"].is_object()) {
      inner = &schema["additionalProperties"];
      own += ".NAME";
    } else if (schema.contains("items") && schema["items"].is_object()) {
      inner = &schema["items"];
      own += "[]";
    }
    if (struct_of(*inner).maps.empty()) return "";
    Json bare = *inner;
    bare.erase("description");
    const auto [known, made] = places_.try_emplace(bare.dump(), own);
    if (made) open_.emplace_back(own, bare);
    return "see " + code(known->second);
  }

  std::string text_;
  std::vector<std::pair<std::string, Json>> open_;
  std::map<std::string, std::string> places_; // struct -> where it is described
  std::set<std::string> types_;               // that are described
};

} // namespace

std::string reference_of(const std::string& schema) {
  return Reference(Json::parse(schema)).text();
}

} // namespace plica
