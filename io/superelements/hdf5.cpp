#include "io/superelements/hdf5.hpp"

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

template <class Place>
void set_text(Place& place, const std::string& key, const std::string& text) {
  const H5::StrType type(H5::PredType::C_S1, std::max<std::size_t>(1, text.size()));
  place.createAttribute(key, type, H5::DataSpace(H5S_SCALAR)).write(type, text);
}

template <class Place> std::string text_of(const Place& place, const std::string& key) {
  const H5::Attribute attribute = place.openAttribute(key);
  std::string text;
  attribute.read(attribute.getStrType(), text);
  return text.c_str(); // up to the first zero
}

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

MatrixXd get(const H5::Group& group, const std::string& name) {
  const H5::DataSet set = group.openDataSet(name);
  std::array<hsize_t, 2> size{};
  if (set.getSpace().getSimpleExtentNdims() != 2)
    throw std::runtime_error(name + " is not a matrix");
  set.getSpace().getSimpleExtentDims(size.data());
  RowMajor rows = RowMajor::Zero(Eigen::Index(size[0]), Eigen::Index(size[1]));
  set.read(rows.data(), H5::PredType::NATIVE_DOUBLE);
  return rows;
}

void require(bool good, const std::string& what) {
  if (!good) throw std::runtime_error(what);
}

template <class F> void for_each_group(const H5::Group& root, const std::string& name, F&& f) {
  const H5::Group groups = root.openGroup(name);
  for (hsize_t k = 0; k < groups.getNumObjs(); ++k) f(groups.openGroup(std::to_string(k)));
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

Superelement read(const H5::H5File& file) {
  require(text_of(file, "format") == format, "it is no superelement of Plica");
  int number = 0;
  file.openAttribute("version").read(H5::PredType::NATIVE_INT, &number);
  require(number == version,
          "version " + std::to_string(number) + ", this program reads " + std::to_string(version));
  Superelement s;
  s.name = text_of(file, "name");
  s.units = text_of(file, "units");
  const H5::Group root = file.openGroup("/");
  const MatrixXd places = get(root, "nodes");
  require(places.cols() == 3, "nodes are not given by three coordinates");
  for (Eigen::Index k = 0; k < places.rows(); ++k) {
    s.nodes.push_back(places.row(k));
    s.node_names.push_back(text_of(root.openGroup("node_names"), std::to_string(k)));
  }
  s.K = get(root, "K");
  s.M = get(root, "M");
  if (root.nameExists("C")) s.C = get(root, "C");
  if (root.nameExists("D")) s.D = get(root, "D");
  const Eigen::Index n = s.K.rows();
  require(n >= s.boundary(), "K is smaller than the boundary");
  for (const MatrixXd* m : {&s.K, &s.M, &s.C, &s.D})
    require(m->size() == 0 || (m->rows() == n && m->cols() == n && m->allFinite()),
            "a matrix has not the size of K or is not finite");
  for_each_group(root, "recovery", [&](const H5::Group& group) {
    s.recovery.push_back({text_of(group, "name"), get(group, "place").col(0), get(group, "rows")});
    require(s.recovery.back().rows.cols() == n, "recovery rows have not the size of K");
  });
  for_each_group(root, "stresses", [&](const H5::Group& group) {
    s.stresses.push_back({text_of(group, "name"), get(group, "place").col(0), get(group, "rows")});
    require(s.stresses.back().rows.cols() == n, "stress rows have not the size of K");
  });
  for_each_group(root, "loads", [&](const H5::Group& group) {
    s.loads.push_back({text_of(group, "name"), get(group, "force").col(0)});
    require(s.loads.back().force.size() == n, "a load has not the size of K");
  });
  return s;
}

void write(const Superelement& s, H5::H5File& file) {
  set_text(file, "format", format);
  file.createAttribute("version", H5::PredType::STD_I32LE, H5::DataSpace(H5S_SCALAR))
      .write(H5::PredType::NATIVE_INT, &version);
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

Superelement read_hdf5(const fs::path& path) {
  H5::Exception::dontPrint();
  try {
    return read(H5::H5File(path.string(), H5F_ACC_RDONLY));
  } catch (const H5::Exception& e) {
    throw std::runtime_error(path.string() + ": damaged, or no HDF5 file: " + e.getDetailMsg());
  } catch (const std::runtime_error& e) {
    throw std::runtime_error(path.string() + ": " + e.what());
  }
}

} // namespace plica
