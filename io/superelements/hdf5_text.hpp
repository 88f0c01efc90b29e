// Texts and numbers of versions as attributes of HDF5 files.
#pragma once

#include <H5Cpp.h>
#include <algorithm>
#include <string>

namespace plica {

inline void set_text(H5::H5Object& place, const std::string& key, const std::string& text) {
  const H5::StrType type(H5::PredType::C_S1, std::max<std::size_t>(1, text.size()));
  place.createAttribute(key, type, H5::DataSpace(H5S_SCALAR)).write(type, text);
}

inline void set_number(H5::H5Object& place, const std::string& key, int number) {
  place.createAttribute(key, H5::PredType::STD_I32LE, H5::DataSpace(H5S_SCALAR))
      .write(H5::PredType::NATIVE_INT, &number);
}

} // namespace plica
