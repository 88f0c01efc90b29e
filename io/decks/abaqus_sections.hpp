// Materials, sections of shells and beams, masses and springs of an Abaqus deck.
#pragma once

#include "elements/beam_section.hpp"
#include "io/decks/abaqus_mesh.hpp"

namespace plica {

class AbaqusSections {
public:
  AbaqusSections(DeckModel& deck, AbaqusMesh& mesh, LeftOut& left_out)
      : deck_(deck), mesh_(mesh), left_out_(left_out) {}

  KeywordHandlers materials(); // to be read before the others
  KeywordHandlers handlers();
  void finish(); // thicknesses of nodes, given normals, notes on what is split

private:
  struct Material : BeamMaterial {
    bool elastic = false;
    std::map<std::string, int> lines; // of what is given of it
  };
  struct Normal {
    int element = 0;
    std::size_t corner = 0;
    Eigen::Vector3d n;
  };

  void begin_material(const Keyword& keyword);
  Material& open_material(const Keyword& keyword); // for what is given once of a material
  const Material& material_of(const Keyword& keyword) const;
  void elastic(const Keyword& keyword);
  void note_first_of_many(const Keyword& keyword, std::size_t fields);
  void density(const Keyword& keyword);
  void shell_section(const Keyword& keyword);
  void membrane_section(const Keyword& keyword);
  void solid_section(const Keyword& keyword); // of trusses
  struct Wall {
    ShellSection section;
    double thickness = 0;
  };
  Wall composite(const Keyword& keyword) const;
  void add_shells(AbaqusElement& element, int section, double thickness, double offset);
  void hold_in_plane(const AbaqusElement& element); // of the elements of plane frames
  void nodal_thickness(const Keyword& keyword);
  void normal(const Keyword& keyword);
  void beam_section(const Keyword& keyword);
  void transverse_shear(const Keyword& keyword);
  void mass(const Keyword& keyword);
  void rotary_inertia(const Keyword& keyword);
  void spring(const Keyword& keyword);

  DeckModel& deck_;
  AbaqusMesh& mesh_;
  LeftOut& left_out_;
  std::map<std::string, Material> materials_;
  std::string material_; // the one that is open
  std::vector<std::size_t> open_beams_;
  std::vector<int> of_nodal_thickness_; // shells
  int split_shells_ = 0, split_beams_ = 0;
  std::map<int, double> thickness_; // by node
  std::vector<Normal> normals_;
};

} // namespace plica
