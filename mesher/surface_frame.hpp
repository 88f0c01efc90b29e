// The frame of a file of triangles held against its own grammar and its own counts, before assimp
// reads it: that passes over what it does not understand.
//
// Refused are: a text STL with anything but solids of facets of three vertices; a binary one whose
// length is not that of its count; a PLY whose lines or bytes are not those of its header, or whose
// faces name vertices that it does not have; an OBJ with words that it cannot have, or faces of
// missing vertices, or vertices of no face, or counts in its comments that it does not keep; a GLB
// whose length and chunks do not fit into each other; numbers that are none.
#pragma once

#include <string>

namespace plica {

// By the suffix, ".stl" and so on. Throws std::runtime_error, "line 12: what is wrong".
void check_surface_bytes(const std::string& suffix, const std::string& bytes);

void check_stl(const std::string& bytes);
void check_ply(const std::string& bytes);
void check_obj(const std::string& bytes);
void check_glb(const std::string& bytes);
void check_gltf(const std::string& text); // its JSON

} // namespace plica
