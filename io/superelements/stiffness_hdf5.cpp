#include "io/superelements/stiffness_hdf5.hpp"

#include "io/superelements/hdf5_text.hpp"

#include <H5Cpp.h>

namespace plica {
namespace {

void put(H5::H5File& file, const std::string& name, const std::vector<hsize_t>& size,
         const std::vector<double>& numbers) {
  H5::DSetCreatPropList checked; // a checksum with every chunk
  std::vector<hsize_t> chunk = size;
  if (chunk.size() > 3)
    for (std::size_t k = 0; k + 3 < chunk.size(); ++k) chunk[k] = 1;
  checked.setChunk(int(chunk.size()), chunk.data());
  checked.setFletcher32();
  file.createDataSet(name, H5::PredType::IEEE_F64LE, H5::DataSpace(int(size.size()), size.data()),
                     checked)
      .write(numbers.data(), H5::PredType::NATIVE_DOUBLE);
}

void put(H5::H5File& file, const std::string& name, const std::vector<std::string>& texts) {
  const H5::StrType type(H5::PredType::C_S1, H5T_VARIABLE);
  const hsize_t size = texts.size();
  std::vector<const char*> list;
  for (const std::string& text : texts) list.push_back(text.c_str());
  file.createDataSet(name, type, H5::DataSpace(1, &size)).write(list.data(), type);
}

std::vector<double> listed(const Eigen::VectorXd& x) {
  return {x.data(), x.data() + x.size()};
}

} // namespace

void write_stiffness_hdf5(const EndDynamicStiffness& s, const std::filesystem::path& path) {
  H5::H5File file(path.string(), H5F_ACC_TRUNC);
  set_text(file, "format", "plica dynamic stiffness");
  set_text(file, "name", s.case_name);
  set_text(file, "units", "m kg s N rad");
  set_number(file, "version", 1);
  const StiffnessOverFrequency& first = s.states.front().over;
  const PartBetweenEnds& part = s.states.front().part;
  std::vector<double> amplitude, angle, places, real, imaginary, statics;
  for (const MotionLevel& level : first.levels) {
    amplitude.push_back(level.translation);
    angle.push_back(level.rotation);
  }
  for (const Eigen::Vector3d& x : part.places) places.insert(places.end(), {x[0], x[1], x[2]});
  std::vector<std::string> states;
  for (const StateStiffness& state : s.states) {
    states.push_back(state.name);
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j < 12; ++j) statics.push_back(state.part.K(i, j));
    for (const auto& level : state.over.at)
      for (const Complex1212& Z : level)
        for (int i = 0; i < 12; ++i)
          for (int j = 0; j < 12; ++j) {
            real.push_back(Z(i, j).real());
            imaginary.push_back(Z(i, j).imag());
          }
  }
  const std::vector<hsize_t> size{s.states.size(), first.levels.size(), hsize_t(first.hertz.size()),
                                  12, 12};
  put(file, "frequency", {hsize_t(first.hertz.size())}, listed(first.hertz));
  put(file, "amplitude", {amplitude.size()}, amplitude);
  put(file, "angle", {angle.size()}, angle);
  put(file, "places", {2, 3}, places);
  put(file, "states", states);
  put(file, "coordinates", end_coordinate_names(part.names));
  put(file, "static", {s.states.size(), 12, 12}, statics);
  put(file, "real", size, real);
  put(file, "imaginary", size, imaginary);
}

} // namespace plica
