#include "io/superelements/matlab.hpp"

#include "io/matlab/matlab_file.hpp"
#include "io/superelements/labels.hpp"

#include <matio.h>

#include <array>
#include <stdexcept>
#include <system_error>

namespace plica {
namespace {

namespace fs = std::filesystem;
using Eigen::MatrixXd;

// One structure an entry, fields name and `what`.
template <class List, class Rows>
MatlabVariable structures(const char* name, const char* what, const List& list, Rows&& rows) {
  std::array<const char*, 2> fields{"name", what};
  std::array<std::size_t, 2> size{list.size(), 1};
  MatlabVariable all(Mat_VarCreateStruct(name, 2, size.data(), fields.data(), 2));
  for (std::size_t i = 0; i < list.size(); ++i) {
    Mat_VarSetStructFieldByName(all.get(), "name", i, matlab_text(nullptr, list[i].name).release());
    Mat_VarSetStructFieldByName(all.get(), what, i,
                                matlab_matrix(nullptr, rows(list[i])).release());
  }
  return all;
}

MatrixXd places_of(const Superelement& s) {
  MatrixXd places(Eigen::Index(s.nodes.size()), 3);
  for (std::size_t k = 0; k < s.nodes.size(); ++k)
    places.row(Eigen::Index(k)) = s.nodes[k].transpose();
  return places;
}

void write(const Superelement& s, const fs::path& path) {
  MatlabWriter file(path, "MATLAB 5.0 MAT-file, superelement of Plica");
  file.put(matlab_text("name", s.name));
  file.put(matlab_text("units", s.units));
  for (const NamedMatrix& m : matrices_of(s))
    file.put(matlab_matrix(std::string(1, m.letter).c_str(), *m.matrix));
  file.put(matlab_matrix("nodes", places_of(s)));
  file.put(matlab_cell("node_names", s.node_names));
  file.put(matlab_cell("coordinates", coordinate_names(s)));
  if (!s.recovery.empty())
    file.put(
        structures("recovery", "rows", s.recovery, [](const RecoveryRows& r) { return r.rows; }));
  if (!s.loads.empty())
    file.put(structures("loads", "force", s.loads,
                        [](const LoadVector& l) { return MatrixXd(l.force); }));
}

} // namespace

void write_matlab(const Superelement& s, const fs::path& path) {
  const fs::path temporary = path.parent_path() / ("." + path.filename().string() + ".part");
  std::error_code error;
  try {
    write(s, temporary);
    fs::rename(temporary, path);
  } catch (...) {
    fs::remove(temporary, error);
    throw;
  }
}

Superelement read_matlab(const fs::path& path) {
  const MatlabReader reader(path);
  const auto matrix = [&](const char* name) { return MatrixXd(reader.matrix(name).real()); };
  const auto fail = [&](const std::string& what) {
    throw std::runtime_error(path.string() + ": " + what);
  };
  Superelement s;
  s.name = reader.text("name");
  s.units = reader.text("units");
  s.K = matrix("K");
  s.M = matrix("M");
  if (reader.holds("C")) s.C = matrix("C");
  if (reader.holds("D")) s.D = matrix("D");
  const MatrixXd places = matrix("nodes");
  s.node_names = reader.cell("node_names");
  if (places.cols() != 3 || places.rows() != Eigen::Index(s.node_names.size()))
    fail("nodes and node_names do not belong together");
  for (Eigen::Index k = 0; k < places.rows(); ++k) s.nodes.push_back(places.row(k));
  for (const MatrixXd* m : {&s.K, &s.M, &s.C, &s.D})
    if (m->size() > 0 && (m->rows() != s.K.rows() || m->cols() != s.K.rows() ||
                          m->rows() < s.boundary() || !m->allFinite()))
      fail("a matrix has not the size of K or is not finite");
  return s;
}

} // namespace plica
