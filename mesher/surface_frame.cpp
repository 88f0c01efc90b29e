#include "mesher/surface_frame.hpp"

namespace plica {

void check_surface_bytes(const std::string& suffix, const std::string& bytes) {
  if (suffix == ".stl") check_stl(bytes);
  if (suffix == ".ply") check_ply(bytes);
  if (suffix == ".obj") check_obj(bytes);
  if (suffix == ".glb") check_glb(bytes);
  if (suffix == ".gltf") check_gltf(bytes);
}

} // namespace plica
