#include "io/superelements/hdf5.hpp"

#include "io/superelements/hdf5_text.hpp"

#include <H5Cpp.h>
#include <stdexcept>
#include <system_error>

namespace plica {
namespace {

namespace fs = std::filesystem;
using Eigen::MatrixXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr const char* format = "plica superelement";
constexpr int version = 2;

void put(H5::Group& group, const std::string& name, const MatrixXd& matrix) {
  const std::array<hsize_t, 2> size{hsize_t(matrix.rows()), hsize_t(matrix.cols())};
  const RowMajor rows = matrix;
  H5::DSetCreatPropList checked; // a checksum with every matrix
  if (matrix.size() > 0) {
    checked.setChunk(2, size.data());
    checked.setFletcher32();
  }
  group.createDataSet(name, H5::PredType::IEEE_F64LE, H5::DataSpace(2, size.data()), checked)
      .write(rows.data(), H5::PredType::NATIVE_DOUBLE);
}

// One group an entry, with its name.
template <class List, class F>
void put_list(H5::Group& root, const std::string& name, const List& list, F&& put_entry) {
  H5::Group groups = root.createGroup(name);
  for (std::size_t k = 0; k < list.size(); ++k) {
    H5::Group group = groups.createGroup(std::to_string(k));
    set_text(group, "name", list[k].name);
    put_entry(group, list[k]);
  }
}

void write(const Superelement& s, H5::H5File& file) {
  set_text(file, "format", format);
  set_number(file, "version", version);
  set_text(file, "name", s.name);
  set_text(file, "units", s.units);
  set_text(file, "dof_order", "ux uy uz rx ry rz per boundary node, then modal coordinates");
  H5::Group root = file.openGroup("/");
  MatrixXd places(Eigen::Index(s.nodes.size()), 3);
  H5::Group names = root.createGroup("node_names");
  for (std::size_t k = 0; k < s.nodes.size(); ++k) {
    places.row(Eigen::Index(k)) = s.nodes[k].transpose();
    set_text(names, std::to_string(k), s.node_names[k]);
  }
  put(root, "nodes", places);
  put(root, "K", s.K);
  put(root, "M", s.M);
  if (s.C.size() > 0) put(root, "C", s.C);
  if (s.D.size() > 0) put(root, "D", s.D);
  const auto put_rows = [](H5::Group& group, const auto& entry) {
    put(group, "place", entry.place);
    put(group, "rows", entry.rows);
  };
  put_list(root, "recovery", s.recovery, put_rows);
  put_list(root, "stresses", s.stresses, put_rows);
  put_list(root, "loads", s.loads,
           [](H5::Group& group, const LoadVector& load) { put(group, "force", load.force); });
}

} // namespace

void write_hdf5(const Superelement& s, const fs::path& path) {
  const fs::path temporary = path.parent_path() / ("." + path.filename().string() + ".part");
  std::error_code error;
  H5::Exception::dontPrint();
  try {
    H5::H5File file(temporary.string(), H5F_ACC_TRUNC);
    write(s, file);
    file.close();
    fs::rename(temporary, path);
  } catch (const H5::Exception& e) {
    fs::remove(temporary, error);
    throw std::runtime_error("cannot write " + path.string() + ": " + e.getDetailMsg());
  } catch (...) {
    fs::remove(temporary, error);
    throw;
  }
}

} // namespace plica
