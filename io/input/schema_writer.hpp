// Writes the JSON Schema of a described struct (words/field_types.hpp).
//
// Words that decide which keys follow (`tag`, `one_of`) are walked through one by one: each
// combination becomes one object under "oneOf".
#pragma once

#include "io/files/json_text.hpp"
#include "words/field_types.hpp"
#include "words/variant_at.hpp"

#include <array>
#include <map>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace plica {

// The parts that do not depend on a type.
Json quantity_schema(const Quantity& q, Dimension unit, const std::string& help);
Json list_schema(Json item, int min, int max, const std::string& help);
Json whole_schema(const Whole& w, const std::string& help);
Json text_schema(const Text& t, const std::string& help);
Json words_schema(const std::vector<std::string>& words, const std::string& help);
Json names_schema(Json value, int min, const std::string& help);
Json object_schema(Json properties, const std::vector<std::string>& required);

class SchemaWriter {
public:
  // `picks`: which alternative of the first, second, ... deciding word is taken.
  explicit SchemaWriter(std::vector<int>& picks) : picks_(picks) {}

  Json properties = Json::object();
  std::vector<std::string> required;
  std::vector<int> sizes;         // alternatives of each deciding word met
  std::vector<std::string> words; // the struct may be one of these words instead

  void quantity(double&, const char* key, const Quantity& q, const char* help) {
    add(key, quantity_schema(q, q.unit, help), q.required);
  }
  void quantity(std::optional<double>&, const char* key, const Quantity& q, const char* help) {
    add(key, quantity_schema(q, q.unit, help), q.required);
  }
  void quantities(std::vector<double>&, const char* key, const Quantity& q, const char* help) {
    add(key, list_schema(quantity_schema(q, q.unit, ""), q.min_items, q.max_items, help),
        q.required);
  }
  template <std::size_t N>
  void quantities(std::array<double, N>&, const char* key, const Quantity& q, const char* help) {
    add(key, row(int(N), q, help), q.required);
  }
  template <std::size_t N>
  void points(std::vector<std::array<double, N>>&, const char* key, const Quantity& q,
              const char* help) {
    add(key, list_schema(row(int(N), q, ""), q.min_items, q.max_items, help), q.required);
  }
  template <std::size_t N, std::size_t M>
  void points(std::array<std::array<double, N>, M>&, const char* key, const Quantity& q,
              const char* help) {
    add(key, list_schema(row(int(N), q, ""), int(M), int(M), help), q.required);
  }
  void whole(int&, const char* key, const Whole& w, const char* help) {
    add(key, whole_schema(w, help), w.required);
  }
  template <std::size_t N>
  void whole(std::array<int, N>&, const char* key, const Whole& w, const char* help) {
    add(key, list_schema(whole_schema(w, ""), int(N), int(N), help), w.required);
  }
  void flag(bool& x, const char* key, const char* help) {
    add(key, {{"type", "boolean"}, {"description", help}, {"default", x}}, false);
  }
  void flag(std::optional<bool>&, const char* key, const char* help) {
    add(key, {{"type", "boolean"}, {"description", help}}, false);
  }
  void flag_or(std::optional<bool>&, bool&, const char* key, const char* word, const char* help) {
    add(key,
        {{"oneOf", {Json{{"type", "boolean"}}, words_schema({word}, "")}}, {"description", help}},
        false);
  }
  void text(std::string&, const char* key, const Text& t, const char* help) {
    add(key, text_schema(t, help), t.required);
  }
  void texts(std::vector<std::string>&, const char* key, const char* help) {
    add(key, list_schema(text_schema({}, ""), 0, 1000, help), false);
  }
  void one_or_more(std::vector<std::string>&, const char* key, const char* help) {
    const Json one = text_schema({}, "");
    add(key, {{"oneOf", {one, list_schema(one, 1, 100, "")}}, {"description", help}}, true);
  }
  template <std::size_t N>
  void quantities(std::optional<std::array<double, N>>&, const char* key, const Quantity& q,
                  const char* help) {
    add(key, row(int(N), q, help), q.required);
  }
  template <class E>
  void choice(E& x, const char* key, const std::type_identity_t<std::vector<Named<E>>>& names,
              const Need& need, const char* help) {
    Json schema = words_schema(words_of(names), help);
    for (const Named<E>& n : names)
      if (!need.required && n.value == x) schema["default"] = n.name;
    add(key, std::move(schema), need.required);
  }
  template <class E>
  void choice(std::optional<E>&, const char* key,
              const std::type_identity_t<std::vector<Named<E>>>& names, const Need& need,
              const char* help) {
    add(key, words_schema(words_of(names), help), need.required);
  }
  template <class E>
  void tag(E& x, const char* key, const std::type_identity_t<std::vector<Named<E>>>& names,
           const Need& need, const char* help) {
    const E usual = x;
    const Named<E>& name = names[pick(static_cast<int>(names.size()))];
    x = name.value;
    add(key, words_schema({name.name}, help), need.required || x != usual);
  }
  void choices(std::vector<int>&, const char* key, const std::vector<Named<int>>& names,
               const Need& need, const char* help) {
    add(key,
        list_schema(words_schema(words_of(names), ""), need.min_items,
                    static_cast<int>(names.size()), help),
        need.required);
  }
  template <class T>
  void choices_or(std::vector<int>&, std::vector<T>&, const char* key,
                  const std::vector<Named<int>>& names, const Need& need, const char* help) {
    const Json map = schema_of<T>();
    add(key,
        {{"oneOf",
          {map, list_schema({{"oneOf", {words_schema(words_of(names), ""), map}}}, need.min_items,
                            1000, "")}},
         {"description", help}},
        need.required);
  }
  template <class T> void object(T&, const char* key, const Need& need, const char* help) {
    add(key, described(schema_of<T>(), help), need.required);
  }
  template <class T>
  void object(std::optional<T>&, const char* key, const Need& need, const char* help) {
    add(key, described(schema_of<T>(), help), need.required);
  }
  template <class T>
  void list(std::vector<T>&, const char* key, const Need& need, const char* help) {
    add(key, list_schema(schema_of<T>(), need.min_items, 10000, help), need.required);
  }
  template <class T>
  void one_or_more(std::vector<T>&, const char* key, const Need& need, const char* help) {
    const Json map = schema_of<T>();
    add(key, {{"oneOf", {map, list_schema(map, 1, 10000, "")}}, {"description", help}},
        need.required);
  }
  template <class T>
  void named(std::vector<T>&, std::string T::*, const char* key, const Need& need,
             const char* help) {
    add(key, names_schema(schema_of<T>(), need.min_items, help), need.required);
  }
  template <class T>
  void named(std::map<std::string, T>&, const char* key, const Need& need, const char* help) {
    add(key, names_schema(schema_of<T>(), need.min_items, help), need.required);
  }
  template <class... T>
  void one_of(std::variant<T...>& x, const char* key, const std::vector<std::string>& names,
              const char* help) {
    const int i = pick(static_cast<int>(sizeof...(T)));
    add(key, words_schema({names[i]}, help), true);
    emplace_at(x, std::size_t(i));
    std::visit([this](auto& body) { fields(*this, body); }, x);
  }
  template <class E>
  void word(E& x, const std::type_identity_t<std::vector<Named<E>>>& names,
            const std::type_identity_t<E>& otherwise, const char*) {
    x = otherwise;
    words = words_of(names);
  }
  void replacements(std::map<std::string, std::string>&, const char* key, const Need& need,
                    const char* help) {
    add(key, {{"type", "object"}, {"description", help}, {"minProperties", 1}}, need.required);
  }

  template <class T> static Json schema_of() {
    std::vector<int> picks, sizes;
    std::vector<std::string> words;
    Json alternatives = Json::array();
    do {
      T object{};
      SchemaWriter writer(picks);
      fields(writer, object);
      sizes = writer.sizes;
      words = writer.words;
      alternatives.push_back(object_schema(writer.properties, writer.required));
    } while (next(picks, sizes));
    if (!words.empty()) alternatives.push_back(words_schema(words, ""));
    return alternatives.size() == 1 ? alternatives[0] : Json{{"oneOf", alternatives}};
  }

private:
  // Counts the picks up like an odometer; false after the last combination.
  static bool next(std::vector<int>& picks, const std::vector<int>& sizes) {
    while (!picks.empty()) {
      if (++picks.back() < sizes[picks.size() - 1]) return true;
      picks.pop_back();
    }
    return false;
  }
  int pick(int size) {
    const std::size_t i = sizes.size();
    sizes.push_back(size);
    if (i == picks_.size()) picks_.push_back(0);
    return picks_[i];
  }
  template <class E> static std::vector<std::string> words_of(const std::vector<Named<E>>& names) {
    std::vector<std::string> result;
    result.reserve(names.size());
    for (const Named<E>& n : names) result.emplace_back(n.name);
    return result;
  }
  static Json row(int n, const Quantity& q, const std::string& help) {
    if (!q.tail) return list_schema(quantity_schema(q, q.unit, ""), n, n, help);
    Json items = Json::array();
    for (int i = 0; i < n; ++i)
      items.push_back(quantity_schema(q, i < q.tail_from ? q.unit : *q.tail, ""));
    return list_schema(items, n, n, help);
  }
  static Json described(Json schema, const char* help) {
    schema["description"] = help;
    return schema;
  }
  void add(const char* key, Json schema, bool needed) {
    properties[key] = std::move(schema);
    if (needed) required.emplace_back(key);
  }

  std::vector<int>& picks_;
};

} // namespace plica
