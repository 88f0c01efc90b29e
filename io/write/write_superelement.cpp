#include "io/write/write_superelement.hpp"

#include "io/files/json_text.hpp"
#include "io/report/superelements.hpp"
#include "io/superelements/abaqus.hpp"
#include "io/superelements/hdf5.hpp"
#include "io/superelements/labels.hpp"
#include "io/superelements/matlab.hpp"
#include "io/superelements/matrix_market.hpp"
#include "io/superelements/nastran_dmig.hpp"
#include "io/superelements/op4.hpp"
#include "io/tables/certificate_words.hpp"
#include "io/tables/text.hpp"
#include "words/input_error.hpp"

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

// Entries that are rounding of their row and column are zero, not -1.5e-15.
Eigen::MatrixXd without_rounding(const Eigen::MatrixXd& A, const Eigen::MatrixXd& scale) {
  constexpr double rounding = 1e-14;
  const Eigen::VectorXd size = scale.diagonal().cwiseAbs().cwiseSqrt();
  Eigen::MatrixXd clear = A;
  for (Eigen::Index j = 0; j < A.cols(); ++j)
    for (Eigen::Index i = 0; i < A.rows(); ++i)
      if (std::abs(A(i, j)) <= rounding * size[i] * size[j]) clear(i, j) = 0;
  return clear;
}

Superelement without_rounding(Superelement s) {
  double size = 0;
  for (const Eigen::Vector3d& x : s.nodes) size = std::max(size, x.cwiseAbs().maxCoeff());
  for (Eigen::Vector3d& x : s.nodes) x = (x.array().abs() < 1e-12 * size).select(0, x);
  for (RecoveryRows& r : s.recovery) {
    r.place = (r.place.array().abs() < 1e-12 * size).select(0, r.place);
    r.rows = (r.rows.array().abs() < 1e-14 * r.rows.cwiseAbs().maxCoeff()).select(0, r.rows);
  }
  const Eigen::MatrixXd K = s.K;
  s.K = without_rounding(s.K, K);
  s.M = without_rounding(s.M, s.M);
  if (s.C.size() > 0) s.C = without_rounding(s.C, s.C);
  if (s.D.size() > 0) s.D = without_rounding(s.D, K);
  return s;
}

std::string recovered_names(const Superelement& s) {
  std::string text = "six rows each of";
  for (const RecoveryRows& r : s.recovery) text += " " + r.name;
  return text + ", units: " + s.units;
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
  std::vector<std::string> names{
      "superelement_recovery.bdf", "superelement_recovery.inp", "superelement_otm.mtx",
      "superelement_otm.bdf",      "superelement.h5",           "superelement.mat",
      "superelement.bdf",          "superelement.op4",          "superelement.inp",
      "superelement_user.inp",     "superelement.json",         "certificate.html",
      "certificate.json"};
  for (const char letter : std::string(damped ? "KMCD" : "KM")) {
    const std::string name = abaqus_matrix_file(letter);
    names.push_back(name);
    names.push_back(fs::path(name).replace_extension(".mtx").string());
  }
  return names;
}

void write_superelement(const ReducedCase& r, const SuperelementFormat& format, OutputFolder& out) {
  ElementLabels labels = format.labels;
  // In axes of its own the element stays as it is, and the deck says where these lie.
  Superelement s = labels.system > 0 ? r.element : placed(r.element, labels.axes, labels.origin);
  if (format.units == Units::millimetres) {
    s = in_millimetres(s);
    labels.origin *= 1000;
  }
  s = without_rounding(std::move(s));
  try {
    check_labels(labels, s);
  } catch (const std::invalid_argument& error) {
    input_error("labels", error.what(), "other numbers or another name");
  }
  if (!s.K.allFinite() || !s.M.allFinite())
    throw std::runtime_error(
        "the superelement has numbers that are not finite; nothing is written");
  out.add_by("superelement.h5", [&](const fs::path& file) { write_hdf5(s, file); });
  out.add_by("superelement.mat", [&](const fs::path& file) {
    write_matlab(s, file);
    read_matlab(file); // matio says nothing of a full disk
  });
  out.add("superelement.bdf", nastran_deck(s, labels));
  out.add("superelement.op4", op4_file(s, labels));
  out.add("superelement.inp", abaqus_deck(s, labels));
  out.add("superelement_user.inp", abaqus_user_element(s, labels));
  if (!s.recovery.empty()) {
    out.add("superelement_recovery.bdf", nastran_recovery(s, labels));
    out.add("superelement_recovery.inp", abaqus_recovery(s, labels));
    out.add("superelement_otm.bdf", nastran_recovery_matrix(s, labels));
    out.add("superelement_otm.mtx", general_matrix_market(recovery_matrix(s), recovered_names(s)));
  }
  for (const NamedMatrix& m : matrices_of(s)) {
    const std::string name = abaqus_matrix_file(m.letter);
    out.add(name, abaqus_matrix(s, *m.matrix, labels));
    out.add(fs::path(name).replace_extension(".mtx").string(),
            matrix_market(*m.matrix, s.name + ", units: " + s.units));
  }
  out.add("superelement.json", json_text(sidecar(s, r)));
  out.add("certificate.html", certificate_report(r, s.units));
  out.add("certificate.json", certificate_json(r));
}

} // namespace plica
