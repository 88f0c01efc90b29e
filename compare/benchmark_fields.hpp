// Every key of a benchmark file; see words/field_types.hpp for the visitor.
#pragma once

#include "compare/benchmark.hpp"
#include "words/field_types.hpp"

namespace plica {

template <class V> void fields(V& v, BenchmarkColumn& c) {
  v.text(c.name, "name", {.required = true}, "head of the column");
  v.text(c.model, "model", {}, "one of the models of the case");
  v.replacements(c.set, "set", optional_key, "path of the case: new value");
}

template <class V> void fields(V& v, BenchmarkRow& r) {
  v.text(r.label, "label", {.required = true}, "head of the row");
  v.text(r.quantity, "quantity", {.required = true},
         "headline number (f_axial, k_axial, mass, ...), quantity of the comparison with the test, "
         "or path of a number of the case");
  v.text(r.unit, "unit", {}, "unit shown");
  v.quantity(r.scale, "scale", {.min = 0, .exclusive_min = true}, "shown = SI * scale");
  v.quantity(r.published, "published", {}, "the study's value, in the unit shown");
  v.quantities(r.test, "test", {.min_items = 1, .max_items = 2}, "[value], or [lowest, highest]");
  v.text(r.only, "only", {}, "the one column it belongs to");
}

template <class V> void fields(V& v, BenchmarkTable& t) {
  v.text(t.number, "table", {.required = true}, "number in the study");
  v.text(t.title, "title", {.required = true}, "title");
  v.text(t.case_file, "case", {.required = true}, "case file, relative to this one");
  v.list(t.columns, "columns", required_key, "ways to run it");
  v.list(t.rows, "rows", required_key, "quantities");
  v.texts(t.remarks, "remarks", "where ours differs, why");
}

template <class V> void fields(V& v, Benchmark& b) {
  v.text(b.name, "benchmark", {.required = true, .name = true}, "name of the benchmark");
  v.text(b.title, "title", {}, "title of the report");
  v.text(b.published, "published", {}, "head of the column of the study's values");
  v.texts(b.remarks, "remarks", "on the whole");
  v.list(b.tables, "tables", required_key, "one by one");
}

} // namespace plica
