#include "mesh/surface_file.hpp"

#include <assimp/Exporter.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
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

} // namespace

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
