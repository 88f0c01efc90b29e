#include "mesher/step_text.hpp"

#include "mesher/step_parser.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <unordered_map>
#include <unordered_set>

namespace plica {
namespace {

using Kind = StepValue::Kind;

std::string tag(int number) {
  return "#" + std::to_string(number);
}

// CONTEXT_DEPENDENT_SHAPE_REPRESENTATION places one, and is none.
bool is_shape_representation(std::string_view name) {
  return name.ends_with("SHAPE_REPRESENTATION") && !name.starts_with("CONTEXT_DEPENDENT");
}

// What would be missing, silently, were it left out of the list that held it.
bool must_be_used(std::string_view name) {
  static const std::unordered_set<std::string_view> kinds{
      "ADVANCED_FACE",
      "FACE_SURFACE",
      "ORIENTED_FACE",
      "FACE_BOUND",
      "FACE_OUTER_BOUND",
      "EDGE_LOOP",
      "VERTEX_LOOP",
      "POLY_LOOP",
      "ORIENTED_EDGE",
      "EDGE_CURVE",
      "VERTEX_POINT",
      "OPEN_SHELL",
      "CLOSED_SHELL",
      "ORIENTED_OPEN_SHELL",
      "ORIENTED_CLOSED_SHELL",
      "CONNECTED_FACE_SET",
      "SHELL_BASED_SURFACE_MODEL",
      "FACE_BASED_SURFACE_MODEL",
      "MANIFOLD_SOLID_BREP",
      "GEOMETRIC_SET",
      "PRODUCT_DEFINITION_SHAPE",
      "NEXT_ASSEMBLY_USAGE_OCCURRENCE",
      "ITEM_DEFINED_TRANSFORMATION",
      "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION"};
  return kinds.contains(name) || is_shape_representation(name);
}

long whole(const StepValue& value, int line) {
  long number = 0;
  const auto [end, error] =
      std::from_chars(value.text.data(), value.text.data() + value.text.size(), number);
  if (value.kind != Kind::number || error != std::errc{} ||
      end != value.text.data() + value.text.size())
    step_error(line, "a spline has no whole number where its degree or a multiplicity belongs");
  return number;
}

const StepValue& item(const StepValue& record, std::size_t i, int line) {
  if (i >= record.items.size())
    step_error(line, std::string(record.text) + " has " + std::to_string(record.items.size()) +
                         " parameters: some are missing");
  return record.items[i];
}

// Knots, multiplicities and control points along one parameter.
void check_spline(const StepValue& degree, std::size_t points, const StepValue& multiplicities,
                  const StepValue& knots, int line) {
  long sum = 0;
  for (const StepValue& m : multiplicities.items) sum += whole(m, line);
  const long degree_is = whole(degree, line);
  if (multiplicities.items.size() != knots.items.size() || sum != long(points) + degree_is + 1)
    step_error(
        line, "a spline of degree " + std::to_string(degree_is) + " has " + std::to_string(points) +
                  " control points, " + std::to_string(knots.items.size()) + " knots, " +
                  std::to_string(multiplicities.items.size()) + " multiplicities that sum to " +
                  std::to_string(sum) + ": numbers are missing");
}

void check_splines(const StepEntity& e) {
  const int line = e.line;
  const bool simple = e.records.size() == 1;
  if (const StepValue* knots = e.record("B_SPLINE_CURVE_WITH_KNOTS")) {
    const StepValue* curve = simple ? knots : e.record("B_SPLINE_CURVE");
    if (!curve) step_error(line, "a spline without its control points");
    const std::size_t first = simple ? 1 : 0, at = simple ? 6 : 0;
    const std::size_t points = item(*curve, first + 1, line).items.size();
    check_spline(item(*curve, first, line), points, item(*knots, at, line),
                 item(*knots, at + 1, line), line);
    if (const StepValue* weights = e.record("RATIONAL_B_SPLINE_CURVE");
        weights && item(*weights, 0, line).items.size() != points)
      step_error(line, "a spline has not as many weights as control points");
  }
  if (const StepValue* knots = e.record("B_SPLINE_SURFACE_WITH_KNOTS")) {
    const StepValue* surface = simple ? knots : e.record("B_SPLINE_SURFACE");
    if (!surface) step_error(line, "a spline without its control points");
    const std::size_t first = simple ? 1 : 0, at = simple ? 8 : 0;
    const std::vector<StepValue>& rows = item(*surface, first + 2, line).items;
    if (rows.empty()) step_error(line, "a spline without control points");
    for (const StepValue& row : rows)
      if (row.items.size() != rows[0].items.size())
        step_error(line, "rows of control points of a spline differ in length");
    check_spline(item(*surface, first, line), rows.size(), item(*knots, at, line),
                 item(*knots, at + 2, line), line);
    check_spline(item(*surface, first + 1, line), rows[0].items.size(), item(*knots, at + 1, line),
                 item(*knots, at + 3, line), line);
  }
}

class Checks {
public:
  void add(const StepEntity& e) {
    const auto [before, is_new] = line_.try_emplace(e.number, e.line);
    if (!is_new)
      step_error(e.line, tag(e.number) + " is defined a second time, after line " +
                             std::to_string(before->second));
    for (const StepValue& record : e.records) {
      use(record, e.line);
      if (must_be_used(record.text)) needed_.push_back({e.number, std::string(record.text)});
      if (is_shape_representation(record.text)) add_representation(e, record);
    }
    if (const StepValue* units = e.record("GLOBAL_UNIT_ASSIGNED_CONTEXT"))
      for (const StepValue& list : units->items)
        for (const StepValue& unit : list.items) units_[e.number].push_back(unit.reference);
    if (e.record("LENGTH_UNIT") && e.record("NAMED_UNIT") &&
        std::any_of(e.records.begin(), e.records.end(), [](const StepValue& r) {
          return r.text == "SI_UNIT" || r.text.starts_with("CONVERSION_BASED_UNIT");
        }))
      lengths_.insert(e.number);
    check_splines(e);
  }

  void finish() const {
    std::pair<int, int> first{0, 0}; // line, number
    for (const auto& [number, line] : used_)
      if (!line_.contains(number) && (first.first == 0 || std::pair(line, number) < first))
        first = {line, number};
    if (first.first > 0)
      step_error(first.first, tag(first.second) + " is named here and defined nowhere");
    for (const auto& [number, name] : needed_)
      if (!used_.contains(number))
        step_error(line_.at(number),
                   name + " " + tag(number) + " belongs to nothing: what held it is missing");
    for (const auto& [number, context] : representations_) {
      const auto units = units_.find(context);
      if (units == units_.end() || std::none_of(units->second.begin(), units->second.end(),
                                                [&](int unit) { return lengths_.contains(unit); }))
        step_error(line_.at(number), "the shape " + tag(number) +
                                         " has no unit of length in its context " + tag(context));
    }
  }

private:
  void use(const StepValue& value, int line) {
    if (value.kind == Kind::reference) used_.try_emplace(value.reference, line);
    for (const StepValue& inner : value.items) use(inner, line);
  }
  void add_representation(const StepEntity& e, const StepValue& record) {
    const std::vector<StepValue>& items = record.items;
    if (items.size() == 3 && items[2].kind == Kind::reference)
      representations_.push_back({e.number, items[2].reference});
    else if (e.records.size() == 1)
      step_error(e.line, std::string(record.text) + " does not name its context");
  }

  struct Named {
    int number;
    std::string name;
  };
  struct Representation {
    int number, context;
  };
  std::unordered_map<int, int> line_, used_; // by number: where it is defined, first named
  std::vector<Named> needed_;
  std::vector<Representation> representations_;
  std::unordered_map<int, std::vector<int>> units_; // of a context
  std::unordered_set<int> lengths_;
};

} // namespace

void check_step_text(const std::string& text) {
  Checks checks;
  parse_step(text, [&](const StepEntity& e) { checks.add(e); });
  checks.finish();
}

} // namespace plica
