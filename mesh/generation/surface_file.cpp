#include "mesh/generation/surface_file.hpp"

#include "words/short_text.hpp"

#include <Eigen/Geometry>
#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <memory>
#include <stdexcept>

namespace plica {
namespace {

aiVector3D vector_of(const Eigen::Vector3d& x) {
  return {ai_real(x.x()), ai_real(x.y()), ai_real(x.z())};
}

// assimp's own arrays, which its scene frees.
template <std::size_t corners>
std::unique_ptr<aiMesh> mesh_of(const Surface& surface,
                                const std::vector<std::array<int, corners>>& elements,
                                const std::vector<SurfaceShape>& shapes) {
  auto mesh = std::make_unique<aiMesh>();
  mesh->mName = corners == 3 ? "surface" : "lines";
  mesh->mPrimitiveTypes = corners == 3 ? aiPrimitiveType_TRIANGLE : aiPrimitiveType_LINE;
  mesh->mMaterialIndex = 0;
  mesh->mNumVertices = unsigned(surface.nodes.size());
  mesh->mVertices = new aiVector3D[surface.nodes.size()];
  for (std::size_t i = 0; i < surface.nodes.size(); ++i)
    mesh->mVertices[i] = vector_of(surface.nodes[i]);
  mesh->mNumFaces = unsigned(elements.size());
  mesh->mFaces = new aiFace[elements.size()];
  for (std::size_t e = 0; e < elements.size(); ++e) {
    aiFace& face = mesh->mFaces[e];
    face.mNumIndices = corners;
    face.mIndices = new unsigned[corners];
    for (std::size_t c = 0; c < corners; ++c) face.mIndices[c] = unsigned(elements[e][c]);
  }
  if (shapes.empty()) return mesh;
  mesh->mMethod = aiMorphingMethod_MORPH_RELATIVE;
  mesh->mNumAnimMeshes = unsigned(shapes.size());
  mesh->mAnimMeshes = new aiAnimMesh*[shapes.size()];
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    auto* shape = mesh->mAnimMeshes[s] = new aiAnimMesh;
    shape->mName = shapes[s].name;
    shape->mWeight = 0;
    shape->mNumVertices = mesh->mNumVertices;
    shape->mVertices = new aiVector3D[surface.nodes.size()];
    for (std::size_t i = 0; i < surface.nodes.size(); ++i)
      shape->mVertices[i] = vector_of(
          surface.nodes[i] + shapes[s].displacement.row(Eigen::Index(i)).head<3>().transpose());
  }
  return mesh;
}

std::unique_ptr<aiScene> scene_of(const Surface& surface, const std::vector<SurfaceShape>& shapes,
                                  bool y_up) {
  auto scene = std::make_unique<aiScene>();
  scene->mNumMaterials = 1;
  scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
  std::vector<std::unique_ptr<aiMesh>> meshes;
  if (!surface.triangles.empty()) meshes.push_back(mesh_of(surface, surface.triangles, shapes));
  if (!surface.lines.empty()) meshes.push_back(mesh_of(surface, surface.lines, shapes));
  scene->mNumMeshes = unsigned(meshes.size());
  scene->mMeshes = new aiMesh*[meshes.size()];
  scene->mRootNode = new aiNode("part");
  scene->mRootNode->mNumMeshes = scene->mNumMeshes;
  scene->mRootNode->mMeshes = new unsigned[meshes.size()];
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    scene->mMeshes[i] = meshes[i].release();
    scene->mRootNode->mMeshes[i] = unsigned(i);
  }
  if (y_up) // (x, y, z) becomes (x, z, -y)
    scene->mRootNode->mTransformation =
        aiMatrix4x4(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1);
  return scene;
}

void require_shapes_of(const Surface& surface, const std::vector<SurfaceShape>& shapes) {
  for (const SurfaceShape& s : shapes)
    if (s.displacement.rows() != Eigen::Index(surface.nodes.size()) || s.displacement.cols() < 3)
      throw std::invalid_argument("a shape of a surface needs a row of x y z per node: " + s.name);
}

// One blob, without files beside it.
std::string exported(const Surface& surface, const std::vector<SurfaceShape>& shapes,
                     const char* format, bool y_up) {
  require_shapes_of(surface, shapes);
  const std::unique_ptr<aiScene> scene = scene_of(surface, shapes, y_up);
  Assimp::Exporter exporter;
  const aiExportDataBlob* blob = exporter.ExportToBlob(scene.get(), format);
  if (!blob) throw std::runtime_error(exporter.GetErrorString());
  return {static_cast<const char*>(blob->data), blob->size};
}

// Numbers vertices so that those within a distance share one.
class Welder {
public:
  Welder(std::vector<Eigen::Vector3d>& nodes, double distance)
      : nodes_(nodes), distance_(distance) {}

  int number(const Eigen::Vector3d& x) {
    const Cell own = cell_of(x);
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        for (long k = -1; k <= 1; ++k)
          if (const auto found = cells_.find({own[0] + i, own[1] + j, own[2] + k});
              found != cells_.end())
            for (int node : found->second)
              if ((nodes_[std::size_t(node)] - x).norm() <= distance_) return node;
    cells_[own].push_back(int(nodes_.size()));
    nodes_.push_back(x);
    return int(nodes_.size()) - 1;
  }

private:
  using Cell = std::array<long, 3>;
  Cell cell_of(const Eigen::Vector3d& x) const {
    const double size = std::max(distance_, 1e-12);
    return {std::lround(x.x() / size), std::lround(x.y() / size), std::lround(x.z() / size)};
  }

  std::vector<Eigen::Vector3d>& nodes_;
  double distance_;
  std::map<Cell, std::vector<int>> cells_;
};

// assimp takes a text that ends within a facet for whole.
void require_whole_stl(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (text.starts_with("solid") && text.find("facet") != std::string::npos &&
      text.find("endsolid") == std::string::npos)
    throw std::runtime_error(file.string() + ": ends before its endsolid: it was cut short");
}

// Lines that ran together make a polygon across the part. How far its corners lie off a plane is
// measured by its size, the root of its area.
void require_flat(const aiMesh& mesh, const aiFace& polygon) {
  std::vector<Eigen::Vector3d> corners;
  for (unsigned c = 0; c < polygon.mNumIndices; ++c) {
    const aiVector3D& v = mesh.mVertices[polygon.mIndices[c]];
    corners.emplace_back(v.x, v.y, v.z);
  }
  Eigen::Vector3d area = Eigen::Vector3d::Zero(); // twice (Newell)
  for (std::size_t c = 0; c < corners.size(); ++c)
    area += (corners[c] - corners[0]).cross(corners[(c + 1) % corners.size()] - corners[0]);
  if (!(area.norm() > 0)) return;
  double low = 0, high = 0;
  for (const Eigen::Vector3d& x : corners) {
    const double height = (x - corners[0]).dot(area.normalized());
    low = std::min(low, height);
    high = std::max(high, height);
  }
  constexpr double bent = 0.2; // the halves of a square fold by about 30 degrees
  if (high - low <= bent * std::sqrt(area.norm() / 2)) return;
  throw std::runtime_error("the polygon of " + std::to_string(corners.size()) +
                           " corners, one at " + short_text(corners[0]) +
                           " in the unit of the file, is not flat: damaged, or to be "
                           "written as triangles");
}

// Those of lines and points, and of triangles without an area: nothing would hold them.
void drop_unused_nodes(Surface& surface) {
  std::vector<int> number(surface.nodes.size(), -1);
  for (const auto& t : surface.triangles)
    for (int node : t) number[std::size_t(node)] = 0;
  std::vector<Eigen::Vector3d> kept;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = int(kept.size());
    kept.push_back(surface.nodes[i]);
  }
  for (auto& t : surface.triangles)
    for (int& node : t) node = number[std::size_t(node)];
  surface.nodes = std::move(kept);
}

} // namespace

std::string lower_suffix(const std::filesystem::path& file) {
  std::string suffix = file.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return suffix;
}

bool is_surface_file(const std::filesystem::path& file) {
  const std::string suffix = lower_suffix(file);
  return suffix == ".stl" || suffix == ".obj" || suffix == ".ply" || suffix == ".glb" ||
         suffix == ".gltf";
}

Surface read_surface(const std::filesystem::path& file, double unit, double weld) {
  const std::string suffix = lower_suffix(file);
  if (suffix == ".stl") require_whole_stl(file);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(file.string(), 0);
  for (unsigned m = 0; scene && m < scene->mNumMeshes; ++m)
    for (unsigned f = 0; f < scene->mMeshes[m]->mNumFaces; ++f)
      if (const aiFace& face = scene->mMeshes[m]->mFaces[f]; face.mNumIndices > 3)
        require_flat(*scene->mMeshes[m], face);
  if (scene)
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_PreTransformVertices);
  if (!scene) throw std::runtime_error(file.string() + ": " + importer.GetErrorString());
  const bool y_up = suffix == ".glb" || suffix == ".gltf";
  Surface surface;
  Welder welder(surface.nodes, weld);
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    std::vector<int> number;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D& v = mesh.mVertices[i];
      const Eigen::Vector3d x =
          unit * (y_up ? Eigen::Vector3d(v.x, -v.z, v.y) : Eigen::Vector3d(v.x, v.y, v.z));
      if (!x.allFinite())
        throw std::runtime_error(file.string() + ": a vertex is not a finite number");
      number.push_back(welder.number(x));
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      if (mesh.mFaces[f].mNumIndices != 3) continue; // lines and points
      std::array<int, 3> t{};
      for (unsigned c = 0; c < 3; ++c) t[c] = number[mesh.mFaces[f].mIndices[c]];
      const auto& x = surface.nodes;
      const Eigen::Vector3d area = (x[std::size_t(t[1])] - x[std::size_t(t[0])])
                                       .cross(x[std::size_t(t[2])] - x[std::size_t(t[0])]);
      if (area.norm() > 0) surface.triangles.push_back(t);
    }
  }
  if (surface.triangles.empty()) throw std::runtime_error(file.string() + ": holds no triangle");
  drop_unused_nodes(surface);
  return surface;
}

std::string glb_of(const Surface& surface, const std::vector<SurfaceShape>& shapes) {
  return exported(surface, shapes, "glb2", true);
}

void write_surface(const Surface& surface, const std::vector<SurfaceShape>& shapes,
                   const std::filesystem::path& file) {
  const std::map<std::string, const char*> formats{
      {".glb", "glb2"}, {".obj", "objnomtl"}, {".ply", "plyb"}, {".stl", "stlb"}};
  const auto format = formats.find(file.extension().string());
  if (format == formats.end())
    throw std::invalid_argument(file.string() + ": a surface is written as .glb, .obj, .ply, .stl");
  const bool gltf = format->first == ".glb";
  const std::string text =
      exported(surface, gltf ? shapes : std::vector<SurfaceShape>{}, format->second, gltf);
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

Surface deformed(const Surface& surface, const SurfaceShape& shape) {
  require_shapes_of(surface, {shape});
  Surface moved = surface;
  for (std::size_t i = 0; i < moved.nodes.size(); ++i)
    moved.nodes[i] += shape.displacement.row(Eigen::Index(i)).head<3>().transpose();
  return moved;
}

} // namespace plica
