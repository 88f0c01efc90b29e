// MATLAB files (version 4, 5 and, with HDF5 in the library, 7.3) through matio.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

struct _mat_t; // the name of matio's
struct matvar_t;

namespace plica {

struct CloseMatlab {
  void operator()(_mat_t* file) const;
};
struct FreeMatlab {
  void operator()(matvar_t* variable) const;
};
using MatlabVariable = std::unique_ptr<matvar_t, FreeMatlab>;

// Variables for writing; the data are copied.
MatlabVariable matlab_matrix(const char* name, const Eigen::MatrixXd& A);
MatlabVariable matlab_matrix(const char* name, const Eigen::MatrixXcd& A);
MatlabVariable matlab_text(const char* name, const std::string& text);
MatlabVariable matlab_cell(const char* name, const std::vector<std::string>& texts);

class MatlabWriter {
public:
  // Version 5, not compressed. Throws std::runtime_error, as put() does, with the path.
  MatlabWriter(const std::filesystem::path& path, const std::string& header);
  void put(const MatlabVariable& variable);

private:
  std::filesystem::path path_;
  std::unique_ptr<_mat_t, CloseMatlab> file_;
};

class MatlabReader {
public:
  explicit MatlabReader(const std::filesystem::path& path); // std::runtime_error with the path

  std::vector<std::string> names() const; // of all variables
  // Numbers of any numeric class; `name` may go into structures by points, "run.H". Arrays of more
  // than two dimensions have their further ones side by side. Throws std::runtime_error naming path
  // and variable.
  Eigen::MatrixXcd matrix(const std::string& name) const;
  bool holds(const std::string& name) const;
  bool has_numbers(const std::string& name) const; // which may go into structures
  std::string text(const std::string& name) const;
  // Nothing where there is none; `name` may go into structures.
  std::optional<std::string> text_if(const std::string& name) const;
  std::vector<std::string> cell(const std::string& name) const;

private:
  MatlabVariable variable(const std::string& name) const;
  [[noreturn]] void fail(const std::string& what) const;

  std::filesystem::path path_;
  std::unique_ptr<_mat_t, CloseMatlab> file_;
};

} // namespace plica
