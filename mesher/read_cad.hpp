// Faces of a CAD file by OpenCASCADE, wrapped once: read_cad.cpp is the only source that includes
// it.
#pragma once

#include <filesystem>
#include <memory>

class TopoDS_Shape;

namespace plica {

struct CadFaces {
  std::shared_ptr<TopoDS_Shape> shape; // a compound of the faces, in m, as Gmsh takes it
};

// Lengths of a BREP times `unit`. Throws std::runtime_error where the text of the file breaks the
// rules of its format, where OpenCASCADE reports a failure, leaves a face or an edge of the file
// out, or calls the shape invalid; where edges lie off their faces or vertices off their edges by
// more than 3e-4 of the root of the area; where there are solids, or no face.
CadFaces read_cad(const std::filesystem::path& file, double unit);

} // namespace plica
