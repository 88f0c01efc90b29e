#include "io/write_superelement.hpp"

#include "io/results_text.hpp"
#include "io/superelement_abaqus.hpp"
#include "io/superelement_hdf5.hpp"
#include "io/superelement_labels.hpp"
#include "io/superelement_nastran.hpp"
#include "io/write_results.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace plica {
namespace {

using Json = nlohmann::ordered_json;

struct CheckLine {
  const char* key;
  const char* text;
  double value;
};

std::vector<CheckLine> checks(const Certificate& c) {
  return {{"asymmetry", "asymmetry of K and M", c.asymmetry},
          {"smallest_mass", "smallest eigenvalue of M / largest", c.smallest_mass},
          {"negative_stiffness", "most negative eigenvalue of K / largest", c.negative_stiffness},
          {"grounding", "force of a rigid motion / stiffness", c.grounding},
          {"rigid_modes", "lowest six modes off the rigid motions", c.rigid_modes},
          {"coordinates", "coordinates found from K off the drawn ones, m", c.coordinates},
          {"mass", "mass off that of the part", c.mass},
          {"centre", "centre of mass off that of the part, m", c.centre},
          {"inertia", "inertia off that of the part", c.inertia},
          {"statics", "static stiffness off that of the part", c.statics}};
}

Json json_of(const std::vector<FrequencyCheck>& checks) {
  Json list = Json::array();
  for (const FrequencyCheck& f : checks)
    list.push_back({{"part", f.full}, {"superelement", f.reduced}, {"error", f.error()}});
  return list;
}

Json sidecar(const Superelement& s) {
  Json labels = Json::array();
  for (int i = 0; i < s.K.rows(); ++i) {
    if (i < s.boundary())
      labels.push_back(s.node_names[i / 6] + "." + dof_name(i % 6));
    else
      labels.push_back("mode " + std::to_string(i - s.boundary() + 1));
  }
  Json nodes = Json::array();
  for (const Eigen::Vector3d& x : s.nodes) nodes.push_back({x[0], x[1], x[2]});
  return {{"name", s.name}, {"units", "m kg s N rad"}, {"nodes", nodes}, {"coordinates", labels}};
}

} // namespace

std::string certificate_text(const ReducedCase& r) {
  const Certificate& c = r.certificate;
  const Superelement& s = r.element;
  std::string text =
      fmt::format("Superelement {}: {} boundary nodes, {} modes up to {} Hz, {}\n", s.name,
                  s.nodes.size(), s.modal(), significant(r.cutoff, 4), r.route);
  text += r.proved ? "Proved, no fixed-interface mode below the cut-off is missing.\n"
                   : "Not proved: " + r.reason + "\n";
  for (const CheckLine& line : checks(c))
    text += fmt::format("  {:<48} {:>9}\n", line.text, significant(line.value, 2));
  text += fmt::format("  {:<48} {:>9}\n", "zero eigenvalues of K", c.zero_stiffness);
  text += "  free-interface frequencies, Hz: part, superelement, error %\n";
  for (const FrequencyCheck& f : c.free)
    text += fmt::format("    {:>10.3f} {:>10.3f} {:>8}\n", f.full, f.reduced,
                        with_sign(100 * f.error(), 4));
  text += fmt::format("Good up to {} Hz with an error of {} %.\n", significant(c.good_up_to, 4),
                      significant(100 * c.error, 2));
  text += c.passed ? "The certificate is passed.\n" : "The certificate FAILED:\n";
  for (const std::string& failure : c.failures) text += "  " + failure + "\n";
  return text;
}

std::string certificate_json(const ReducedCase& r) {
  const Certificate& c = r.certificate;
  Json json{{"name", r.element.name},     {"route", r.route},   {"cutoff", r.cutoff},
            {"modes", r.element.modal()}, {"proved", r.proved}, {"reason", r.reason}};
  for (const CheckLine& line : checks(c)) json["checks"][line.key] = line.value;
  json["checks"]["zero_stiffness"] = c.zero_stiffness;
  json["free_interface"] = json_of(c.free);
  json["fixed_interface"] = json_of(c.fixed);
  json["good_up_to"] = c.good_up_to;
  json["error"] = c.error;
  json["passed"] = c.passed;
  json["failures"] = c.failures;
  json["timing"] = r.timing;
  json["peak_memory"] = r.peak_memory;
  return json.dump(2) + "\n";
}

void write_superelement(const ReducedCase& r, const std::filesystem::path& folder) {
  make_folder(folder);
  const Superelement& s = r.element;
  write_hdf5(s, folder / "superelement.h5");
  write_whole(folder / "superelement.bdf", nastran_deck(s));
  write_whole(folder / "superelement_k.inp", abaqus_matrix(s, s.K));
  write_whole(folder / "superelement_m.inp", abaqus_matrix(s, s.M));
  write_whole(folder / "superelement.inp",
              abaqus_deck(s, "superelement_k.inp", "superelement_m.inp"));
  write_whole(folder / "superelement_k.mtx", matrix_market(s.K, "stiffness, SI"));
  write_whole(folder / "superelement_m.mtx", matrix_market(s.M, "mass, SI"));
  write_whole(folder / "superelement.json", sidecar(s).dump(2) + "\n");
  write_whole(folder / "certificate.json", certificate_json(r));
}

} // namespace plica
