#include "io/input/schema.hpp"

#include "compare/benchmark_fields.hpp"
#include "io/input/schema_writer.hpp"
#include "lab/measured/measured_fields.hpp"
#include "model/description/case_fields.hpp"
#include "words/units.hpp"

#include <cmath>

namespace plica {

namespace {

Json with_help(Json schema, const std::string& help) {
  if (!help.empty()) schema["description"] = help;
  return schema;
}

template <class T> std::string schema_text(const char* title) {
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", title}};
  schema.update(SchemaWriter::schema_of<T>());
  return json_text(schema);
}

} // namespace

Json quantity_schema(const Quantity& q, Dimension unit, const std::string& help) {
  Json number{{"type", "number"}};
  if (std::isfinite(q.min)) number[q.exclusive_min ? "exclusiveMinimum" : "minimum"] = q.min;
  if (std::isfinite(q.max)) number[q.exclusive_max ? "exclusiveMaximum" : "maximum"] = q.max;
  Json string{{"type", "string"}, {"pattern", quantity_pattern(unit, q.min < 0, q.is_unit)}};
  const std::string allowed = describe(q, unit);
  return with_help({{"anyOf", {number, string}}}, help.empty() ? allowed : help + "; " + allowed);
}

Json list_schema(Json item, int min, int max, const std::string& help) {
  return with_help(
      {{"type", "array"}, {"items", std::move(item)}, {"minItems", min}, {"maxItems", max}}, help);
}

Json whole_schema(const Whole& w, const std::string& help) {
  Json schema{{"type", "integer"}, {"minimum", w.min}, {"maximum", w.max}};
  if (w.even) schema["multipleOf"] = 2;
  return with_help(std::move(schema), help);
}

Json text_schema(const Text& t, const std::string& help) {
  Json schema;
  if (t.name)
    schema = {{"type", "string"}, {"pattern", "^[A-Za-z][A-Za-z0-9_-]*$"}};
  else
    schema = {{"type", {"string", "number", "boolean"}}}; // YAML reads `title: 5` as a number
  return with_help(std::move(schema), help);
}

Json words_schema(const std::vector<std::string>& words, const std::string& help) {
  return with_help({{"enum", words}}, help);
}

Json names_schema(Json value, int min, const std::string& help) {
  return with_help({{"type", "object"},
                    {"propertyNames", {{"pattern", "^[A-Za-z][A-Za-z0-9_-]*$"}}},
                    {"additionalProperties", std::move(value)},
                    {"minProperties", min}},
                   help);
}

Json object_schema(Json properties, const std::vector<std::string>& required) {
  Json schema{
      {"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
  if (!required.empty()) schema["required"] = required;
  return schema;
}

std::string case_schema() {
  return schema_text<Case>("Plica case file");
}

std::string measured_schema() {
  return schema_text<Measured>("Plica measured data");
}

std::string benchmark_schema() {
  return schema_text<Benchmark>("Plica benchmark");
}

} // namespace plica
