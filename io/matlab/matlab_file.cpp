#include "io/matlab/matlab_file.hpp"

#include "io/files/files.hpp"
#include "io/matlab/matlab5_elements.hpp"

#include <matio.h>

#include <array>
#include <stdexcept>

namespace plica {

namespace fs = std::filesystem;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

void CloseMatlab::operator()(_mat_t* file) const {
  Mat_Close(file);
}

void FreeMatlab::operator()(matvar_t* variable) const {
  Mat_VarFree(variable);
}

// matio takes the data by a pointer to non-const, and copies them.
MatlabVariable matlab_matrix(const char* name, const MatrixXd& A) {
  std::array<std::size_t, 2> size{std::size_t(A.rows()), std::size_t(A.cols())};
  return MatlabVariable(Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, size.data(),
                                      const_cast<double*>(A.data()), 0));
}

MatlabVariable matlab_matrix(const char* name, const MatrixXcd& A) {
  std::array<std::size_t, 2> size{std::size_t(A.rows()), std::size_t(A.cols())};
  MatrixXd real = A.real(), imaginary = A.imag();
  mat_complex_split_t parts{real.data(), imaginary.data()};
  return MatlabVariable(
      Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, size.data(), &parts, MAT_F_COMPLEX));
}

MatlabVariable matlab_text(const char* name, const std::string& text) {
  std::array<std::size_t, 2> size{1, text.size()};
  return MatlabVariable(Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UTF8, 2, size.data(),
                                      const_cast<char*>(text.data()), 0));
}

MatlabVariable matlab_cell(const char* name, const std::vector<std::string>& texts) {
  std::array<std::size_t, 2> size{texts.size(), 1};
  MatlabVariable cell(Mat_VarCreate(name, MAT_C_CELL, MAT_T_CELL, 2, size.data(), nullptr, 0));
  for (std::size_t i = 0; i < texts.size(); ++i)
    Mat_VarSetCell(cell.get(), static_cast<int>(i), matlab_text(nullptr, texts[i]).release());
  return cell;
}

MatlabWriter::MatlabWriter(const fs::path& path, const std::string& header)
    : path_(path), file_(Mat_CreateVer(path.c_str(), header.c_str(), MAT_FT_MAT5)) {
  if (!file_) throw std::runtime_error("cannot write " + path.string());
}

void MatlabWriter::put(const MatlabVariable& variable) {
  if (!variable || Mat_VarWrite(file_.get(), variable.get(), MAT_COMPRESSION_NONE) != 0)
    throw std::runtime_error("cannot write " + path_.string());
}

namespace {

template <class T> MatrixXd copied(const void* data, Index rows, Index columns) {
  using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
  return Eigen::Map<const Matrix>(static_cast<const T*>(data), rows, columns)
      .template cast<double>();
}

MatrixXd numbers(matio_types type, const void* data, Index rows, Index columns) {
  switch (type) {
  case MAT_T_DOUBLE:
    return copied<double>(data, rows, columns);
  case MAT_T_SINGLE:
    return copied<float>(data, rows, columns);
  case MAT_T_INT8:
    return copied<mat_int8_t>(data, rows, columns);
  case MAT_T_UINT8:
    return copied<mat_uint8_t>(data, rows, columns);
  case MAT_T_INT16:
    return copied<mat_int16_t>(data, rows, columns);
  case MAT_T_UINT16:
    return copied<mat_uint16_t>(data, rows, columns);
  case MAT_T_INT32:
    return copied<mat_int32_t>(data, rows, columns);
  case MAT_T_UINT32:
    return copied<mat_uint32_t>(data, rows, columns);
  case MAT_T_INT64:
    return copied<mat_int64_t>(data, rows, columns);
  case MAT_T_UINT64:
    return copied<mat_uint64_t>(data, rows, columns);
  default:
    throw std::invalid_argument("holds no numbers");
  }
}

std::string text_of(const matvar_t& v) {
  return {static_cast<const char*>(v.data), v.nbytes};
}

MatrixXcd matrix_of(const matvar_t& v) {
  if (v.rank < 2 || !v.data || v.class_type == MAT_C_CHAR)
    throw std::invalid_argument("holds no numbers");
  const auto rows = Index(v.dims[0]);
  Index columns = 1;
  for (int d = 1; d < v.rank; ++d) columns *= Index(v.dims[d]);
  if (v.class_type >= MAT_C_DOUBLE && v.class_type <= MAT_C_UINT64) {
    if (!v.isComplex)
      return numbers(v.data_type, v.data, rows, columns).cast<std::complex<double>>();
    const auto& parts = *static_cast<const mat_complex_split_t*>(v.data);
    MatrixXcd A(rows, columns);
    A.real() = numbers(v.data_type, parts.Re, rows, columns);
    A.imag() = numbers(v.data_type, parts.Im, rows, columns);
    return A;
  }
  throw std::invalid_argument("holds no numbers");
}

} // namespace

MatlabReader::MatlabReader(const fs::path& path) : path_(path) {
  if (const std::string why = why_unreadable(path); !why.empty()) fail(why);
  file_.reset(Mat_Open(path.c_str(), MAT_ACC_RDONLY));
  if (!file_) fail("damaged, or no MATLAB file");
  if (Mat_GetVersion(file_.get()) != MAT_FT_MAT5) return;
  if (const std::string wrong = fault_of_matlab5(read_whole(path)); !wrong.empty())
    fail("damaged, or changed on its way: " + wrong);
}

void MatlabReader::fail(const std::string& what) const {
  throw std::runtime_error(path_.string() + ": " + what);
}

std::vector<std::string> MatlabReader::names() const {
  std::vector<std::string> list;
  Mat_Rewind(file_.get());
  while (const MatlabVariable v{Mat_VarReadNextInfo(file_.get())})
    if (v->name) list.emplace_back(v->name);
  return list;
}

MatlabVariable MatlabReader::variable(const std::string& name) const {
  return MatlabVariable(Mat_VarRead(file_.get(), name.c_str()));
}

bool MatlabReader::holds(const std::string& name) const {
  Mat_Rewind(file_.get());
  return MatlabVariable(Mat_VarReadInfo(file_.get(), name.c_str())) != nullptr;
}

namespace {

// The field of a variable that the rest of a name, ".run.H", leads to; null when there is none.
matvar_t* field_of(matvar_t* at, const std::string& path) {
  for (std::size_t from = path.empty() ? std::string::npos : 0; at && from != std::string::npos;) {
    const auto next = path.find('.', from + 1);
    const std::string field =
        path.substr(from + 1, next == std::string::npos ? next : next - from - 1);
    at = at->class_type == MAT_C_STRUCT ? Mat_VarGetStructFieldByName(at, field.c_str(), 0)
                                        : nullptr;
    from = next;
  }
  return at;
}

std::string behind_point(const std::string& name) {
  const auto point = name.find('.');
  return point == std::string::npos ? "" : name.substr(point);
}

} // namespace

MatrixXcd MatlabReader::matrix(const std::string& name) const {
  const MatlabVariable v = variable(name.substr(0, name.find('.')));
  const matvar_t* at = field_of(v.get(), behind_point(name));
  if (!at) fail("there is no matrix " + name);
  try {
    return matrix_of(*at);
  } catch (const std::invalid_argument& e) {
    fail(name + " " + e.what());
  }
}

bool MatlabReader::has_numbers(const std::string& name) const {
  const std::string root = name.substr(0, name.find('.'));
  if (!holds(root)) return false;
  const MatlabVariable v = variable(root);
  const matvar_t* at = field_of(v.get(), behind_point(name));
  return at && at->data && at->class_type >= MAT_C_DOUBLE && at->class_type <= MAT_C_UINT64;
}

std::optional<std::string> MatlabReader::text_if(const std::string& name) const {
  const std::string root = name.substr(0, name.find('.'));
  if (!holds(root)) return std::nullopt;
  const MatlabVariable v = variable(root);
  const matvar_t* at = field_of(v.get(), behind_point(name));
  if (!at || at->class_type != MAT_C_CHAR || !at->data) return std::nullopt;
  return text_of(*at);
}

std::string MatlabReader::text(const std::string& name) const {
  const MatlabVariable v = variable(name);
  if (!v || v->class_type != MAT_C_CHAR) fail("there is no text " + name);
  return text_of(*v);
}

std::vector<std::string> MatlabReader::cell(const std::string& name) const {
  const MatlabVariable v = variable(name);
  if (!v || v->class_type != MAT_C_CELL) fail("there is no cell array " + name);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < v->dims[0]; ++i) {
    const matvar_t* text = Mat_VarGetCell(v.get(), static_cast<int>(i));
    if (!text || text->class_type != MAT_C_CHAR) fail(name + " holds no texts");
    texts.push_back(text_of(*text));
  }
  return texts;
}

} // namespace plica
