// The part and its modes for other programs: `plica run --geometry`.
//
//   msh            mesh.msh: nodes, quads, lines, node sets, for Gmsh
//   uff            geometry.uff: data sets 164, 15, 2412 and 55 per mode, SI, for test software
//   glb            part.glb: surface and lines, a morph target per mode
//   obj, ply, stl  part.<format> and mode_01.<format> ...: the deformed surface of each mode
//
// Of what a surface shows, the largest displacement of a mode is 5 % of the size of the part.
#pragma once

#include "io/files/output_folder.hpp"
#include "run/results/results.hpp"

namespace plica {

const std::vector<std::string>& geometry_formats();

// Names of the files of a part with so many modes. `formats` from those above.
std::vector<std::string> geometry_files(const std::vector<std::string>& formats, int modes);

// InputError where a file cannot be written.
void write_geometry(const Results& results, const std::vector<std::string>& formats,
                    OutputFolder& out);

std::string geometry_uff(const Results& results);

} // namespace plica
