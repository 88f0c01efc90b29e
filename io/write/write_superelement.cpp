#include "io/write/write_superelement.hpp"

#include "io/files/json_text.hpp"
#include "io/report/superelements.hpp"
#include "io/superelements/abaqus.hpp"
#include "io/superelements/hdf5.hpp"
#include "io/superelements/labels.hpp"
#include "io/superelements/matlab.hpp"
#include "io/superelements/matrix_market.hpp"
#include "io/superelements/nastran.hpp"
#include "io/superelements/op4.hpp"
#include "io/tables/certificate_words.hpp"
#include "io/tables/text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plica {
namespace {

namespace fs = std::filesystem;

Json json_of(const std::vector<FrequencyCheck>& checks) {
  Json list = Json::array();
  for (const FrequencyCheck& f : checks)
    list.push_back({{"part", f.full}, {"superelement", f.reduced}, {"error", f.error()}});
  return list;
}

Json rows_of(const Eigen::MatrixXd& A) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < A.cols(); ++j) row.push_back(A(i, j));
    rows.push_back(row);
  }
  return rows;
}

// What the columns mean and whose matrices they are.
Json sidecar(const Superelement& s, const ReducedCase& r) {
  Json nodes = Json::array();
  for (const Eigen::Vector3d& x : s.nodes) nodes.push_back({x[0], x[1], x[2]});
  Json recovery = Json::object(), loads = Json::object();
  for (const RecoveryRows& x : s.recovery) recovery[x.name] = rows_of(x.rows);
  for (const LoadVector& x : s.loads) loads[x.name] = rows_of(x.force.transpose())[0];
  return {{"name", s.name},       {"units", s.units},
          {"nodes", nodes},       {"coordinates", coordinate_names(s)},
          {"route", r.route},     {"cutoff", r.cutoff},
          {"recovery", recovery}, {"loads", loads}};
}

} // namespace

std::string certificate_json(const ReducedCase& r) {
  const Certificate& c = r.certificate;
  Json json{{"name", r.element.name},     {"route", r.route},   {"cutoff", r.cutoff},
            {"modes", r.element.modal()}, {"proved", r.proved}, {"reason", r.reason}};
  for (const CertificateLine& line : certificate_lines(c)) json["checks"][line.key] = line.value;
  json["checks"]["zero_stiffness"] = c.zero_stiffness;
  json["left_out"] = {{"modes", r.left_out.count},
                      {"lowest", r.left_out.lowest},
                      {"largest_interface_mass", r.left_out.largest},
                      {"interface_mass", r.left_out.sum}};
  json["free_interface"] = json_of(c.free);
  json["fixed_interface"] = json_of(c.fixed);
  json["good_up_to"] = c.good_up_to;
  json["error"] = c.error;
  json["passed"] = c.passed;
  json["failures"] = c.failures;
  json["timing"] = r.timing;
  json["peak_memory"] = r.peak_memory;
  return json_text(json);
}

std::vector<std::string> superelement_files(bool damped) {
  std::vector<std::string> names{"superelement.h5",   "superelement.mat", "superelement.bdf",
                                 "superelement.op4",  "superelement.inp", "superelement_user.inp",
                                 "superelement.json", "certificate.html", "certificate.json"};
  for (const char letter : std::string(damped ? "KMCD" : "KM")) {
    const std::string name = abaqus_matrix_file(letter);
    names.push_back(name);
    names.push_back(fs::path(name).replace_extension(".mtx").string());
  }
  return names;
}

void write_superelement(const ReducedCase& r, Units units, OutputFolder& out) {
  const Superelement s = units == Units::millimetres ? in_millimetres(r.element) : r.element;
  if (!s.K.allFinite() || !s.M.allFinite())
    throw std::runtime_error(
        "the superelement has numbers that are not finite; nothing is written");
  out.add_by("superelement.h5", [&](const fs::path& file) { write_hdf5(s, file); });
  out.add_by("superelement.mat", [&](const fs::path& file) {
    write_matlab(s, file);
    read_matlab(file); // matio says nothing of a full disk
  });
  out.add("superelement.bdf", nastran_deck(s));
  out.add("superelement.op4", op4_file(s));
  out.add("superelement.inp", abaqus_deck(s));
  out.add("superelement_user.inp", abaqus_user_element(s));
  for (const NamedMatrix& m : matrices_of(s)) {
    const std::string name = abaqus_matrix_file(m.letter);
    out.add(name, abaqus_matrix(s, *m.matrix));
    out.add(fs::path(name).replace_extension(".mtx").string(),
            matrix_market(*m.matrix, s.name + ", units: " + s.units));
  }
  out.add("superelement.json", json_text(sidecar(s, r)));
  out.add("certificate.html", certificate_report(r));
  out.add("certificate.json", certificate_json(r));
}

} // namespace plica
