#include "io/superelement_matlab.hpp"

#include "io/superelement_labels.hpp"

#include <matio.h>

#include <memory>
#include <stdexcept>
#include <system_error>

namespace plica {
namespace {

namespace fs = std::filesystem;
using Eigen::MatrixXd;

struct CloseFile {
  void operator()(mat_t* file) const { Mat_Close(file); }
};
struct FreeVariable {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using File = std::unique_ptr<mat_t, CloseFile>;
using Variable = std::unique_ptr<matvar_t, FreeVariable>;

// matio takes the data by a pointer to non-const, and copies them.
Variable matrix_variable(const char* name, const MatrixXd& A) {
  std::array<std::size_t, 2> size{std::size_t(A.rows()), std::size_t(A.cols())};
  return Variable(Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, size.data(),
                                const_cast<double*>(A.data()), 0));
}

Variable text_variable(const char* name, const std::string& text) {
  std::array<std::size_t, 2> size{1, text.size()};
  return Variable(Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UTF8, 2, size.data(),
                                const_cast<char*>(text.data()), 0));
}

Variable cell_variable(const char* name, const std::vector<std::string>& texts) {
  std::array<std::size_t, 2> size{texts.size(), 1};
  Variable cell(Mat_VarCreate(name, MAT_C_CELL, MAT_T_CELL, 2, size.data(), nullptr, 0));
  for (std::size_t i = 0; i < texts.size(); ++i)
    Mat_VarSetCell(cell.get(), static_cast<int>(i), text_variable(nullptr, texts[i]).release());
  return cell;
}

// One structure an entry, fields name and `what`.
template <class List, class Rows>
Variable structures(const char* name, const char* what, const List& list, Rows&& rows) {
  std::array<const char*, 2> fields{"name", what};
  std::array<std::size_t, 2> size{list.size(), 1};
  Variable all(Mat_VarCreateStruct(name, 2, size.data(), fields.data(), 2));
  for (std::size_t i = 0; i < list.size(); ++i) {
    Mat_VarSetStructFieldByName(all.get(), "name", i,
                                text_variable(nullptr, list[i].name).release());
    Mat_VarSetStructFieldByName(all.get(), what, i,
                                matrix_variable(nullptr, rows(list[i])).release());
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
  const File file(
      Mat_CreateVer(path.c_str(), "MATLAB 5.0 MAT-file, superelement of Plica", MAT_FT_MAT5));
  if (!file) throw std::runtime_error("cannot write " + path.string());
  const auto put = [&](const Variable& variable) {
    if (!variable || Mat_VarWrite(file.get(), variable.get(), MAT_COMPRESSION_NONE) != 0)
      throw std::runtime_error("cannot write " + path.string());
  };
  put(text_variable("name", s.name));
  put(text_variable("units", s.units));
  for (const NamedMatrix& m : matrices_of(s))
    put(matrix_variable(std::string(1, m.letter).c_str(), *m.matrix));
  put(matrix_variable("nodes", places_of(s)));
  put(cell_variable("node_names", s.node_names));
  put(cell_variable("coordinates", coordinate_names(s)));
  if (!s.recovery.empty())
    put(structures("recovery", "rows", s.recovery, [](const RecoveryRows& r) { return r.rows; }));
  if (!s.loads.empty())
    put(structures("loads", "force", s.loads,
                   [](const LoadVector& l) { return MatrixXd(l.force); }));
}

class Reader {
public:
  explicit Reader(const fs::path& path)
      : path_(path), file_(Mat_Open(path.c_str(), MAT_ACC_RDONLY)) {
    if (!file_) fail("damaged, or no MATLAB file");
  }

  MatrixXd matrix(const char* name, bool required = true) {
    const Variable v(Mat_VarRead(file_.get(), name));
    if (!v && !required) return {};
    if (!v || v->rank != 2 || v->class_type != MAT_C_DOUBLE || !v->data)
      fail(std::string("there is no matrix ") + name);
    return MatrixXd::Map(static_cast<const double*>(v->data), Eigen::Index(v->dims[0]),
                         Eigen::Index(v->dims[1]));
  }
  std::string text(const char* name) {
    const Variable v(Mat_VarRead(file_.get(), name));
    if (!v || v->class_type != MAT_C_CHAR) fail(std::string("there is no text ") + name);
    return text_of(*v);
  }
  std::vector<std::string> cell(const char* name) {
    const Variable v(Mat_VarRead(file_.get(), name));
    if (!v || v->class_type != MAT_C_CELL) fail(std::string("there is no cell array ") + name);
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < v->dims[0]; ++i)
      texts.push_back(text_of(*Mat_VarGetCell(v.get(), static_cast<int>(i))));
    return texts;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(path_.string() + ": " + what);
  }

private:
  static std::string text_of(const matvar_t& v) {
    return {static_cast<const char*>(v.data), v.nbytes};
  }

  const fs::path& path_;
  File file_;
};

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
  Reader reader(path);
  Superelement s;
  s.name = reader.text("name");
  s.units = reader.text("units");
  s.K = reader.matrix("K");
  s.M = reader.matrix("M");
  s.C = reader.matrix("C", false);
  s.D = reader.matrix("D", false);
  const MatrixXd places = reader.matrix("nodes");
  s.node_names = reader.cell("node_names");
  if (places.cols() != 3 || places.rows() != Eigen::Index(s.node_names.size()))
    reader.fail("nodes and node_names do not belong together");
  for (Eigen::Index k = 0; k < places.rows(); ++k) s.nodes.push_back(places.row(k));
  for (const MatrixXd* m : {&s.K, &s.M, &s.C, &s.D})
    if (m->size() > 0 && (m->rows() != s.K.rows() || m->cols() != s.K.rows() ||
                          m->rows() < s.boundary() || !m->allFinite()))
      reader.fail("a matrix has not the size of K or is not finite");
  return s;
}

} // namespace plica
