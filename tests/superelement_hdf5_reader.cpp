#include "tests/superelement_readers.hpp"

#include <H5Cpp.h>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::MatrixXd;

constexpr const char* superelement_format = "plica superelement";
constexpr int superelement_version = 2;

template <class Place> std::string text_of(const Place& place, const std::string& key) {
  const H5::Attribute attribute = place.openAttribute(key);
  std::string text;
  attribute.read(attribute.getStrType(), text);
  return text.c_str(); // up to the first zero
}

MatrixXd get(const H5::Group& group, const std::string& name) {
  const H5::DataSet set = group.openDataSet(name);
  std::array<hsize_t, 2> size{};
  if (set.getSpace().getSimpleExtentNdims() != 2)
    throw std::runtime_error(name + " is not a matrix");
  set.getSpace().getSimpleExtentDims(size.data());
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows =
      decltype(rows)::Zero(Eigen::Index(size[0]), Eigen::Index(size[1]));
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

Superelement read(const H5::H5File& file) {
  require(text_of(file, "format") == superelement_format, "it is no superelement of Plica");
  int number = 0;
  file.openAttribute("version").read(H5::PredType::NATIVE_INT, &number);
  require(number == superelement_version, "version " + std::to_string(number) +
                                              ", this program reads " +
                                              std::to_string(superelement_version));
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

} // namespace

Superelement read_hdf5(const std::filesystem::path& path) {
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
