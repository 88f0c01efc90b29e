#include "verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <set>

namespace sealed {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// 95 % power at ln BF = 3, which the diagnosis asks for, where the evidence of an effect is the
// mean over its hypotheses: (d - 1.645)^2 / 2 - ln(1 + d^2) / 2 - ln(hypotheses) = 3.
double non_centrality_of_95(int hypotheses) {
  double d = 1.645;
  while ((d - 1.645) * (d - 1.645) / 2 - std::log1p(d * d) / 2 - std::log(hypotheses) < 3)
    d += 0.01;
  return d * d;
}

// Damage is declared for ways "22.5 degrees", half a turn being the same: how far off the truth.
double degrees_off(const json& entry, const json& truth) {
  const std::string way = entry.value("way", "");
  if (!truth["value"].contains("angle") || way.find(" degrees") == std::string::npos) return 0;
  constexpr double to_degrees = 57.29577951308232;
  return std::abs(
      std::remainder(std::stod(way) - to_degrees * double(truth["value"]["angle"]), 180));
}

// A diagnosis that says where along a beam names the truth, a point of it, if its interval holds
// it.
bool is_along(const json& said, const std::string& truth) {
  const std::string part = said.value("place", "");
  constexpr std::size_t digit = 7; // of ".point[5]"
  if (!said.value("interval", json::object()).contains("at") ||
      !truth.starts_with(part + ".point["))
    return false;
  const double step = part == "beam" ? 0.150 : 0.125; // m, cantilever_masses and bolted_lap
  const double at = step * (truth[part.size() + digit] - '1');
  return at >= double(said["interval"]["at"][0]) - 1e-9 &&
         at <= double(said["interval"]["at"][1]) + 1e-9;
}

json parsed(const fs::path& file) {
  std::ifstream in(file);
  return in ? json::parse(in, nullptr, false) : json();
}

// How far a value lies from no effect; compliances count by their inverse, the ratio of a mass that
// was not weighed by itself.
double size_of(const std::string& effect, const std::string& key, double value) {
  if (effect == "unweighed_mass") return std::abs(value);
  if (key == "ratio" || key == "gain") return std::abs(std::log(std::max(value, 1e-3)));
  if (key == "bond") return std::abs(value - 0.5);
  if (key.starts_with("k_") || key == "frequency") return 1 / value;
  return std::abs(value);
}

// The diagnosis states non-centrality for a size of its own: scaled to the true one.
double scale_to_truth(const json& entry, const json& truth) {
  json values = entry.value("value", json());
  if (values.is_number() && entry.contains("parameter")) // one value, its parameter beside it
    values = {{std::string(entry["parameter"]), values}};
  if (!values.is_object()) return 1;
  double scale = 0;
  for (const auto& [key, value] : values.items())
    if (value.is_number() && truth["value"].contains(key))
      if (const double declared = size_of(truth["name"], key, value); declared > 0)
        scale = std::max(scale,
                         std::pow(size_of(truth["name"], key, truth["value"][key]) / declared, 2));
  return scale > 0 ? scale : 1;
}

bool detectable(const Scored& s) {
  if (s.truth["effects"].empty()) return false;
  const json& effect = s.truth["effects"][0];
  double best = -1, nearest = 1e300;
  int hypotheses = 0;
  const json declared =
      s.diagnosis.value(json::json_pointer("/identifiability/detectable"), json::array());
  for (const json& entry : declared) {
    if (entry.value("name", "") != effect["name"]) continue;
    ++hypotheses;
    if (entry.contains("place") && entry["place"] != effect["place"]) continue;
    const double own = entry.value("noncentrality", 0.) * scale_to_truth(entry, effect),
                 off = degrees_off(entry, effect);
    best = off < nearest ? own : off > nearest ? best : std::max(best, own);
    nearest = std::min(nearest, off);
  }
  return best < 0 ? s.truth["strength"] != "weak" : best >= non_centrality_of_95(hypotheses);
}

} // namespace

std::vector<Scored> read_verdicts(const fs::path& truth, const fs::path& out) {
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(truth))
    if (entry.path().extension() == ".json") files.insert(entry.path());
  const json runs = parsed(out / "runs.json");
  std::vector<Scored> all;
  for (const fs::path& file : files) {
    Scored s;
    s.truth = parsed(file);
    s.id = s.truth["id"];
    s.kind = s.truth["kind"];
    s.cls = s.truth["class"];
    s.diagnosis = parsed(out / s.id / "diagnosis.json");
    if (!s.diagnosis.is_object()) s.diagnosis = json::object();
    s.verdict = s.diagnosis.value("verdict", "missing");
    for (const json& e : s.diagnosis.value("effects", json::array())) s.named.push_back(e["name"]);
    s.seconds = runs.is_object() && runs.contains(s.id) ? double(runs[s.id]["seconds"]) : 0;
    s.is_detectable = detectable(s);
    all.push_back(s);
  }
  return all;
}

bool names(const Scored& s, const std::string& effect) {
  return std::find(s.named.begin(), s.named.end(), effect) != s.named.end();
}

std::string true_effect(const Scored& s, std::size_t k) {
  return k < s.truth["effects"].size() ? std::string(s.truth["effects"][k]["name"]) : "";
}

std::string true_place(const Scored& s) {
  return s.truth["effects"].empty() ? "" : std::string(s.truth["effects"][0]["place"]);
}

double declared_cosine(const Scored& s, const std::string& a, const std::string& b) {
  double best = 0;
  const auto stands_for = [](const std::string& shown, const std::string& name) {
    return shown == name || shown.starts_with(name + "@") || shown.starts_with(name + " ");
  };
  const json mimics =
      s.diagnosis.value(json::json_pointer("/identifiability/mimics"), json::array());
  for (const json& m : mimics) {
    const std::string p = m.value("a", ""), q = m.value("b", "");
    if ((stands_for(p, a) && stands_for(q, b)) || (stands_for(p, b) && stands_for(q, a)))
      best = std::max(best, m.value("cosine", 0.));
  }
  return best;
}

bool place_is_right(const Scored& s) {
  return says_place(s, s.diagnosis["effects"][0], true_place(s));
}

bool says_place(const Scored& s, const json& said, const std::string& truth) {
  const std::string place = said.value("place", ""), name = said["name"];
  if (place == truth || is_along(said, truth)) return true;
  for (const auto& other : said.value("other_places", json::array()))
    if (other == truth) return true;
  for (const char* between : {"@", " @ ", " "})
    if (declared_cosine(s, name + between + place, name + between + truth) >= 0.95) return true;
  return false;
}

double number_at(const json& object, const std::string& pointer) {
  const json::json_pointer at(pointer);
  if (!object.contains(at) || !object.at(at).is_number())
    return std::numeric_limits<double>::quiet_NaN();
  return object.at(at);
}

} // namespace sealed
