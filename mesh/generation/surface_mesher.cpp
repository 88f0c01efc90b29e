#include "mesh/generation/surface_mesher.hpp"

#include "mesh/generation/surface_file.hpp"
#include "mesh/generation/worker.hpp"
#include "words/short_text.hpp"

#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace plica {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view faces_follow = "PLICAFACES 1\n", failure_follows = "PLICAERROR 1\n";

template <class T> void append(std::string& text, const std::vector<T>& list) {
  const std::uint64_t count = list.size();
  text.append(reinterpret_cast<const char*>(&count), sizeof count);
  text.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T));
}

template <class T> void take(std::string_view& text, std::vector<T>& list) {
  std::uint64_t count = 0;
  if (text.size() < sizeof count) throw std::runtime_error("the mesher's answer was cut short");
  std::memcpy(&count, text.data(), sizeof count);
  text.remove_prefix(sizeof count);
  if (text.size() / sizeof(T) < count)
    throw std::runtime_error("the mesher's answer was cut short");
  list.resize(count);
  if (count > 0) std::memcpy(static_cast<void*>(list.data()), text.data(), count * sizeof(T));
  text.remove_prefix(count * sizeof(T));
}

std::string exact(double value) {
  return short_text(value, 17);
}

} // namespace

bool has_unit(const fs::path& cad_file) {
  return lower_suffix(cad_file) != ".brep";
}

bool is_cad_file(const fs::path& file) {
  const std::string suffix = lower_suffix(file);
  return suffix == ".step" || suffix == ".stp" || suffix == ".iges" || suffix == ".igs" ||
         suffix == ".brep";
}

fs::path mesher_program() {
  if (const char* told = std::getenv("PLICA_MESHER")) return told;
  std::error_code ignored;
  std::vector<fs::path> folders;
  if (const fs::path program = fs::read_symlink("/proc/self/exe", ignored); !program.empty()) {
    const fs::path beside = program.parent_path().parent_path();
    folders = {beside / "mesher", beside / PLICA_MESHER_FOLDER};
  }
  folders.insert(folders.end(), {PLICA_MESHER_INSTALLED, PLICA_MESHER_PACKAGED});
  std::string all;
  for (const fs::path& folder : folders) {
    const fs::path place = folder / "plica_mesher";
    if (fs::is_regular_file(place, ignored)) return place;
    all += (all.empty() ? "" : ", ") + place.string();
  }
  throw std::runtime_error("the program plica_mesher, which reads files of geometry, is not at " +
                           all + "; the environment variable PLICA_MESHER says where it is");
}

SurfaceFaces mesh_surface_file(const fs::path& file, const SurfaceMeshing& meshing) {
  const std::string reply = run_worker(mesher_program().string(),
                                       {file.string(), exact(meshing.unit), exact(meshing.size),
                                        exact(meshing.turn), exact(meshing.weld)},
                                       worker_limits(), file.filename().string());
  return faces_of_message(reply);
}

std::string message_of(const SurfaceFaces& faces) {
  std::string text(faces_follow);
  append(text, faces.nodes);
  append(text, faces.faces);
  append(text, faces.normals);
  return text;
}

std::string message_of_failure(const std::string& what) {
  return std::string(failure_follows) + what;
}

SurfaceFaces faces_of_message(const std::string& message) {
  std::string_view text = message;
  if (text.starts_with(failure_follows))
    throw std::runtime_error(message.substr(failure_follows.size()));
  if (!text.starts_with(faces_follow))
    throw std::runtime_error("the mesher gave no answer of this version of Plica");
  text.remove_prefix(faces_follow.size());
  SurfaceFaces faces;
  take(text, faces.nodes);
  take(text, faces.faces);
  take(text, faces.normals);
  return faces;
}

} // namespace plica
