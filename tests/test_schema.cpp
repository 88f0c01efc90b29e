// The JSON Schema: valid JSON, and the shipped cases conform to it.
#include "io/input/benchmark_file.hpp"
#include "io/input/reference.hpp"
#include "io/input/schema.hpp"
#include "io/input/yaml_tree.hpp"

#include <charconv>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

namespace plica {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// As an editor would see the file: plain scalars become numbers and booleans where they look so.
Json json_of(const YamlNode& node) {
  Json result;
  if (node.kind == YamlNode::Kind::list) {
    result = Json::array();
    for (const YamlNode& item : node.items) result.push_back(json_of(item));
  } else if (node.kind == YamlNode::Kind::map) {
    result = Json::object();
    for (const YamlEntry& entry : node.entries) result[entry.key] = json_of(entry.value);
  } else if (node.kind == YamlNode::Kind::scalar) {
    const char *begin = node.text.data(), *end = begin + node.text.size();
    long whole = 0;
    double number = 0;
    result = node.text;
    if (node.quoted || begin == end) return result;
    if (node.text == "true" || node.text == "false")
      result = node.text == "true";
    else if (std::from_chars(begin, end, whole).ptr == end)
      result = whole;
    else if (std::from_chars(begin, end, number).ptr == end)
      result = number;
  }
  return result;
}

bool has_type(const Json& x, const std::string& type) {
  return (type == "object" && x.is_object()) || (type == "array" && x.is_array()) ||
         (type == "string" && x.is_string()) || (type == "boolean" && x.is_boolean()) ||
         (type == "integer" && x.is_number_integer()) || (type == "number" && x.is_number());
}

// The keywords our schemas use, and no more.
bool conforms(const Json& x, const Json& schema) {
  if (schema.contains("type")) {
    const Json types = schema["type"].is_array() ? schema["type"] : Json::array({schema["type"]});
    if (std::none_of(types.begin(), types.end(), [&](const Json& t) { return has_type(x, t); }))
      return false;
  }
  if (schema.contains("enum") &&
      schema["enum"].end() == std::find(schema["enum"].begin(), schema["enum"].end(), x))
    return false;
  if (schema.contains("pattern") && x.is_string() &&
      !std::regex_search(x.get<std::string>(), std::regex(schema["pattern"].get<std::string>())))
    return false;
  if (x.is_number()) {
    const double v = x;
    if (schema.contains("minimum") && v < schema["minimum"]) return false;
    if (schema.contains("maximum") && v > schema["maximum"]) return false;
    if (schema.contains("exclusiveMinimum") && v <= schema["exclusiveMinimum"]) return false;
    if (schema.contains("exclusiveMaximum") && v >= schema["exclusiveMaximum"]) return false;
  }
  const auto branches = [&](const char* key) {
    return std::count_if(schema[key].begin(), schema[key].end(),
                         [&](const Json& s) { return conforms(x, s); });
  };
  if (schema.contains("anyOf") && branches("anyOf") == 0) return false;
  if (schema.contains("oneOf") && branches("oneOf") != 1) return false;
  if (x.is_array()) {
    if (schema.contains("minItems") && x.size() < schema["minItems"]) return false;
    if (schema.contains("maxItems") && x.size() > schema["maxItems"]) return false;
    for (std::size_t i = 0; i < x.size() && schema.contains("items"); ++i)
      if (!conforms(x[i], schema["items"].is_array() ? schema["items"][i] : schema["items"]))
        return false;
  }
  if (!x.is_object()) return true;
  for (const Json& key : schema.value("required", Json::array()))
    if (!x.contains(key)) return false;
  for (const auto& [key, value] : x.items()) {
    if (schema.contains("properties") && schema["properties"].contains(key)) {
      if (!conforms(value, schema["properties"][key])) return false;
    } else if (schema.contains("additionalProperties")) {
      const Json& other = schema["additionalProperties"];
      if (other.is_boolean() ? !other.get<bool>() : !conforms(value, other)) return false;
    }
  }
  return true;
}

Json json_of_file(const fs::path& path) {
  std::vector<InputProblem> problems;
  return json_of(read_yaml(path, problems).root);
}

TEST(Schema, is_draft_07_and_describes_every_key_at_the_top) {
  const Json schema = Json::parse(case_schema());
  EXPECT_TRUE(schema["$schema"] == "http://json-schema.org/draft-07/schema#");
  EXPECT_TRUE(schema["additionalProperties"] == false);
  for (const char* key : {"case", "materials", "parts", "caps", "mount", "supports", "sensors",
                          "analyses", "variants", "measured"})
    EXPECT_TRUE(schema["properties"][key].contains("description")) << key;
  EXPECT_TRUE(Json::parse(measured_schema())["title"] == "Plica measured data");
}

TEST(Schema, shipped_cases_and_their_data_conform) {
  const Json cases = Json::parse(case_schema()), data = Json::parse(measured_schema()),
             benchmark = Json::parse(benchmark_schema());
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(PLICA_SOURCE_DIR) / "cases")) {
    if (entry.path().extension() != ".yaml") continue;
    const bool measured = entry.path().filename() == "measured.yaml";
    const Json& schema = measured ? data : is_benchmark(entry.path()) ? benchmark : cases;
    EXPECT_TRUE(conforms(json_of_file(entry.path()), schema)) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 17);
}

TEST(Schema, takes_one_weighing_or_a_list) {
  const Json schema = Json::parse(measured_schema());
  const auto holds = [&](const char* mass) {
    return conforms(Json{{"specimen", "a"}, {"mass", Json::parse(mass)}}, schema);
  };
  EXPECT_TRUE(holds(R"({"value": 1})"));
  EXPECT_TRUE(holds(R"([{"value": 1, "state": "before"}, {"value": 2, "state": "after"}])"));
  EXPECT_FALSE(holds("[]"));
  EXPECT_FALSE(holds("1"));
  EXPECT_FALSE(holds(R"([{"sigma": 1}])"));
}

TEST(Schema, refuses_misspelt_keys_wrong_units_and_keys_of_another_shape) {
  const Json schema = Json::parse(case_schema());
  const fs::path broken = fs::path(PLICA_SOURCE_DIR) / "tests/broken_cases";
  for (const char* name :
       {"unknown_key", "unit_unknown", "unit_wrong_dimension", "key_of_other_shape", "part_type",
        "shape_missing", "missing_keys", "negative_thickness", "mount_list", "too_few_numbers",
        "zero_plies", "thinning_exponent"})
    EXPECT_FALSE(conforms(json_of_file(broken / (std::string(name) + ".yaml")), schema)) << name;
}

} // namespace
// docs/case_reference.md and docs/measured_reference.md are `plica schema --reference`, of now.
TEST(Reference, of_the_docs_is_that_of_the_schema) {
  for (const auto& [file, schema] : {std::pair{"case_reference.md", case_schema()},
                                     {"measured_reference.md", measured_schema()}}) {
    std::ifstream in(std::string(PLICA_SOURCE_DIR) + "/docs/" + file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    EXPECT_TRUE(text == reference_of(schema) + "\n")
        << file << ": write it anew by plica schema --reference";
  }
}

// Every key of the schema has a line of its own in the reference.
TEST(Reference, names_every_key) {
  const std::string text = reference_of(case_schema());
  std::set<std::string> keys;
  const std::function<void(const nlohmann::json&)> walk = [&](const nlohmann::json& schema) {
    if (schema.is_object() && schema.contains("properties"))
      for (const auto& [key, value] : schema["properties"].items()) keys.insert(key);
    if (schema.is_structured())
      for (const auto& inner : schema) walk(inner);
  };
  walk(nlohmann::json::parse(case_schema()));
  EXPECT_GT(keys.size(), 100u);
  for (const std::string& key : keys)
    EXPECT_NE(text.find("\n| `" + key + "` |"), std::string::npos) << key;
}

} // namespace plica
