#include "mesher/surface_frame.hpp"
#include "mesher/surface_words.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>

namespace plica {
namespace {

using Json = nlohmann::json;

// Keys of glTF 2.0 (Khronos Group, chapter 5) of what a surface is made of. assimp passes over
// others, so that a misspelt "indices" would make other triangles.
const std::map<std::string, std::vector<std::string>> known{
    {"",
     {"extensionsUsed", "extensionsRequired", "accessors", "animations", "asset", "buffers",
      "bufferViews", "cameras", "images", "materials", "meshes", "nodes", "samplers", "scene",
      "scenes", "skins", "textures", "extensions", "extras"}},
    {"accessors",
     {"bufferView", "byteOffset", "componentType", "normalized", "count", "type", "max", "min",
      "sparse", "name", "extensions", "extras"}},
    {"buffers", {"uri", "byteLength", "name", "extensions", "extras"}},
    {"bufferViews",
     {"buffer", "byteOffset", "byteLength", "byteStride", "target", "name", "extensions",
      "extras"}},
    {"meshes", {"primitives", "weights", "name", "extensions", "extras"}},
    {"primitives",
     {"attributes", "indices", "material", "mode", "targets", "extensions", "extras"}},
    {"nodes",
     {"camera", "children", "skin", "matrix", "mesh", "rotation", "scale", "translation", "weights",
      "name", "extensions", "extras"}},
    {"scenes", {"nodes", "name", "extensions", "extras"}}};

void check_keys(const Json& object, const std::string& kind) {
  if (!object.is_object()) surface_error(0, "an entry of its " + kind + " is no object");
  const std::vector<std::string>& keys = known.at(kind);
  for (const auto& [key, value] : object.items()) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      surface_error(0,
                    shown_word(key) + " is no key of " + (kind.empty() ? "glTF" : "its " + kind));
    if (!known.contains(key) || (kind == "scenes" && key == "nodes")) continue;
    if (!value.is_array()) surface_error(0, "its " + key + " are no list");
    for (const Json& entry : value) check_keys(entry, key);
  }
}

} // namespace

void check_gltf(const std::string& text) {
  try {
    check_keys(Json::parse(text), "");
  } catch (const Json::exception&) {
    surface_error(0, "its JSON cannot be read");
  }
}

void check_glb(const std::string& bytes) {
  const auto word = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return std::size_t(value);
  };
  constexpr std::size_t header = 12, tag = 8, json = 0x4E4F534A;
  if (bytes.size() < header + tag || !bytes.starts_with("glTF") || word(4) != 2)
    surface_error(0, "is no binary glTF of version 2");
  if (word(8) != bytes.size())
    surface_error(0, "has " + std::to_string(bytes.size()) + " bytes, its header says " +
                         std::to_string(word(8)));
  for (std::size_t at = header; at < bytes.size();) {
    if (at + tag > bytes.size() || at + tag + word(at) > bytes.size())
      surface_error(0, "its chunks reach beyond its end");
    if (at == header && word(at + 4) != json) surface_error(0, "its first chunk is no JSON");
    if (at == header) check_gltf(bytes.substr(at + tag, word(at)));
    at += tag + word(at);
  }
}

} // namespace plica
