#include "io/superelement_labels.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace plica {

namespace fs = std::filesystem;

CoordinateLabel coordinate_label(const Superelement& s, int coordinate) {
  if (coordinate < s.boundary()) return {first_grid + coordinate / 6, coordinate % 6 + 1};
  return {first_scalar + coordinate - s.boundary(), 0};
}

void write_whole(const fs::path& target, const std::string& content) {
  const fs::path temporary = target.parent_path() / ("." + target.filename().string() + ".part");
  errno = 0;
  std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
  if (stream) stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  std::error_code error;
  if (stream) fs::rename(temporary, target, error);
  if (!stream || error) {
    const std::string why = error ? error.message() : std::strerror(errno);
    fs::remove(temporary, error);
    throw std::runtime_error("cannot write " + target.string() + ": " + why);
  }
}

std::string read_whole(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + path.string());
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void bad_line(const fs::path& path, int line, const std::string& what) {
  throw std::runtime_error(path.string() + ":" + std::to_string(line) + ": " + what);
}

} // namespace plica
