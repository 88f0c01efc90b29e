// plica_mesher SECONDS BYTES FILE UNIT SIZE TURN WELD: reads a file of geometry of others, meshes
// it, and writes the faces, or why there are none, on descriptor 3. Plica starts it; see
// mesh/generation/surface_mesher.hpp.
#include "mesh/generation/surface_mesher.hpp"
#include "mesh/generation/worker.hpp"
#include "mesher/mesh_faces.hpp"
#include "mesher/read_cad.hpp"
#include "mesher/surface_frame.hpp"
#include "mesher/triangles.hpp"
#include "words/short_text.hpp"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <new>
#include <unistd.h>

namespace {

using namespace plica;

SurfaceFaces faces_of(const std::filesystem::path& file, const SurfaceMeshing& meshing) {
  if (is_cad_file(file)) return mesh_cad(read_cad(file, meshing.unit), meshing);
  std::ifstream in(file, std::ios::binary);
  check_surface_bytes(lower_suffix(file), {std::istreambuf_iterator<char>(in), {}});
  const Surface surface = read_surface(file, meshing.unit, meshing.weld);
  require_single_wall(surface);
  require_no_gap(surface);
  return meshing.size > 0 ? remesh(surface, meshing.size) : as_they_are(surface);
}

void reply(const std::string& text) {
  constexpr int descriptor = 3;
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t count = write(descriptor, text.data() + at, text.size() - at);
    if (count <= 0) _exit(1);
    at += std::size_t(count);
  }
  _exit(0); // without the ends of libraries
}

// Libraries do not survive what is thrown where memory ends; so this is made beforehand.
std::string too_large;

std::string answer(const std::filesystem::path& file, const SurfaceMeshing& meshing) {
  const std::string name = file.filename().string() + ": ";
  try {
    return message_of(faces_of(file, meshing));
  } catch (const std::bad_alloc&) {
    return too_large;
  } catch (const std::exception& error) {
    return message_of_failure(name + error.what());
  }
}

} // namespace

int main(int argc, char** argv) {
  constexpr int words = 8;
  if (argc != words) {
    std::fputs("plica_mesher is started by plica\n", stderr);
    return 1;
  }
  const auto number = [&](int i) { return std::strtod(argv[i], nullptr); };
  const std::filesystem::path file = argv[3];
  too_large = message_of_failure(file.filename().string() + ": needs more than " +
                                 short_text(number(2) / 1e9, 3) +
                                 " GB to be read and meshed; PLICA_MESH_MEMORY gives it more");
  std::set_new_handler([] { reply(too_large); });
  become_worker({.seconds = number(1), .bytes = number(2)});
  reply(answer(file, {.unit = number(4), .size = number(5), .turn = number(6), .weld = number(7)}));
}
