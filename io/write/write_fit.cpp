#include "io/write/write_fit.hpp"

#include "io/files/files.hpp"
#include "io/files/json_text.hpp"
#include "io/report/fit.hpp"
#include "io/tables/csv.hpp"
#include "io/tables/text.hpp"
#include "words/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
constexpr std::size_t kept_designs = 50; // in fit.json, for a restart

std::vector<std::size_t> by_cost(const FitResult& fit) {
  std::vector<std::size_t> order(fit.samples.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return fit.samples[a].cost < fit.samples[b].cost;
  });
  return order;
}

std::vector<std::string> paths_of(const FittedParameter& p) {
  std::vector<std::string> paths{p.path};
  paths.insert(paths.end(), p.also.begin(), p.also.end());
  return paths;
}

std::string parameters_csv(const FitResult& fit) {
  std::string text = "path,unit,before,after,sigma,known,at bound\n";
  for (const FittedParameter& p : fit.parameters)
    text +=
        fmt::format("{},{},{},{},{},{},{}\n", csv_cell(p.path), csv_cell(p.unit), p.start, p.value,
                    p.sigma ? fmt::format("{}", *p.sigma) : "", p.known, p.at_bound ? 1 : 0);
  return text;
}

std::string designs_csv(const FitResult& fit) {
  const auto head = [](const std::string& name, const std::string& unit) {
    return csv_cell(unit.empty() ? name : fmt::format("{} [{}]", name, unit)) + ",";
  };
  std::string text;
  for (const FittedParameter& p : fit.parameters) text += head(p.path, p.unit);
  for (const FittedTarget& t : fit.targets) text += head(t.quantity, t.unit);
  text += "cost\n";
  for (const FitSample& s : fit.samples) {
    for (const double v : s.design) text += fmt::format("{},", v);
    for (const double v : s.targets) text += fmt::format("{},", v);
    text += fmt::format("{}\n", s.cost);
  }
  return text;
}

InputError bad_file(const std::string& path, const std::string& wrong) {
  return InputError({{.file = path,
                      .line = 0,
                      .key = "",
                      .wrong = wrong,
                      .allowed = "the fit.json of an earlier fit of the same parameters"}});
}

} // namespace

std::string fitted_yaml(const FitResult& fit) {
  std::string text = "# Values of a fit, SI units: as `set` of a variant of the case.\nset:\n";
  for (const FittedParameter& p : fit.parameters)
    for (const std::string& path : paths_of(p))
      text += fmt::format("  \"{}\": {}\n", path, p.value);
  for (const auto& [path, value, unit] : fit.ties)
    text += fmt::format("  \"{}\": {}\n", path, value);
  return text;
}

namespace {

// What was fitted to, before and after.
void add_targets(Json& json, const FitResult& fit) {
  json["targets"] = Json::array();
  for (const FittedTarget& t : fit.targets)
    json["targets"].push_back({{"quantity", t.quantity},
                               {"unit", t.unit},
                               {"measured", t.measured},
                               {"sigma", t.sigma},
                               {"before", t.start},
                               {"after", t.value},
                               {"held_out", t.held_out},
                               {"goal", t.goal}});
  json["aims"] = Json::array();
  for (const FittedAim& a : fit.aims)
    json["aims"].push_back({{"quantity", a.quantity},
                            {"aim", a.least ? "least" : "most"},
                            {"unit", a.unit},
                            {"before", a.start},
                            {"after", a.value}});
  json["responses"] = Json::array();
  for (const FittedResponse& r : fit.responses)
    json["responses"].push_back(
        {{"name", r.name}, {"lines", r.lines}, {"before_db", r.start}, {"after_db", r.value}});
  json["stiffness"] = Json::array();
  for (const FittedStiffness& s : fit.stiffness)
    json["stiffness"].push_back({{"name", s.name},
                                 {"numbers", s.numbers},
                                 {"sigma", s.sigma},
                                 {"before", s.start},
                                 {"after", s.value},
                                 {"held_out", s.held_out}});
  json["constraints"] = Json::array();
  for (const FittedConstraint& c : fit.constraints)
    json["constraints"].push_back({{"name", c.name},
                                   {"unit", c.unit},
                                   {"value", c.value},
                                   {"min", json_number(c.min)},
                                   {"max", json_number(c.max)}});
}

// What the search knows beside its best point.
void add_search(Json& json, const FitResult& fit) {
  json["correlation"] = Json::array();
  for (Index i = 0; i < fit.correlation.rows(); ++i) {
    const VectorXd row = fit.correlation.row(i).transpose();
    json["correlation"].push_back(std::vector<double>(row.begin(), row.end()));
  }
  json["open"] = Json::array();
  for (const OpenDirection& o : fit.open) {
    Json parts = Json::object();
    for (const auto& [path, weight] : o.parts) parts[path] = weight;
    json["open"].push_back({{"effect", o.effect}, {"parts", parts}});
  }
  json["islands"] = Json::array();
  for (const Island& i : fit.islands)
    json["islands"].push_back(
        {{"strategy", i.strategy}, {"cost", i.cost}, {"improvements", i.improvements}});
  json["designs"] = Json::array(); // the best ones, for a restart
  const std::vector<std::size_t> order = by_cost(fit);
  for (std::size_t k = 0; k < std::min(order.size(), kept_designs); ++k) {
    const VectorXd& d = fit.samples[order[k]].design;
    json["designs"].push_back(std::vector<double>(d.begin(), d.end()));
  }
}

} // namespace

std::string fit_json(const FitResult& fit, const std::string& title) {
  Json json{{"title", title},
            {"evaluations", fit.evaluations},
            {"converged", fit.converged},
            {"reason", fit.reason},
            {"cost", {{"before", fit.start_cost}, {"after", fit.cost}}}};
  json["parameters"] = Json::array();
  for (const FittedParameter& p : fit.parameters)
    json["parameters"].push_back({{"path", p.path},
                                  {"also", p.also},
                                  {"unit", p.unit},
                                  {"before", p.start},
                                  {"after", p.value},
                                  {"sigma", json_number(p.sigma)},
                                  {"known", p.known},
                                  {"at_bound", p.at_bound}});
  json["ties"] = Json::object();
  json["tie_units"] = Json::object();
  for (const auto& [path, value, unit] : fit.ties) {
    json["ties"][path] = value;
    json["tie_units"][path] = unit;
  }
  add_targets(json, fit);
  add_search(json, fit);
  json["warnings"] = fit.warnings;
  return json_text(json);
}

std::vector<VectorXd> read_designs(const std::string& path, const FitRequest& request) {
  Json json;
  try {
    json = Json::parse(read_whole(path));
  } catch (const std::exception& error) {
    throw bad_file(path, std::string("cannot be read: ") + error.what());
  }
  try {
    const Json& parameters = json.at("parameters");
    VectorXd best(Index(request.parameters.size()));
    if (parameters.size() != request.parameters.size())
      throw bad_file(path, "has " + std::to_string(parameters.size()) + " parameters, not " +
                               std::to_string(request.parameters.size()));
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const std::string own = parameters[i].at("path"),
                        &asked = request.parameters[i].paths.front();
      if (own != asked)
        throw bad_file(path, fmt::format("has '{}' where the case has '{}'", own, asked));
      best[Index(i)] = parameters[i].at("after");
    }
    std::vector<VectorXd> designs{best};
    for (const Json& d : json.at("designs")) {
      const auto values = d.get<std::vector<double>>();
      if (values.size() != parameters.size())
        throw bad_file(path, "has a design of another length");
      designs.emplace_back(Eigen::Map<const VectorXd>(values.data(), Index(values.size())));
    }
    return designs;
  } catch (const Json::exception& error) {
    throw bad_file(path, std::string("is no result of a fit: ") + error.what());
  }
}

std::vector<std::string> fit_files() {
  return {"fit.csv", "designs.csv", "fitted.yaml", "fit.html", "fit.json"};
}

void write_fit(const FitResult& fit, const std::string& title, OutputFolder& out) {
  out.add("fit.csv", parameters_csv(fit));
  out.add("designs.csv", designs_csv(fit));
  out.add("fitted.yaml", fitted_yaml(fit));
  out.add("fit.html", fit_html(fit, title));
  out.add("fit.json", fit_json(fit, title));
}

} // namespace plica
