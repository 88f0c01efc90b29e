// Materials, sections of shells and beams, masses and springs of an Abaqus deck.
#pragma once

#include "elements/beam_section.hpp"
#include "io/decks/abaqus_mesh.hpp"
#include "io/decks/deck_sections.hpp"
#include "io/decks/nastran_laminate.hpp"

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
    std::optional<PlyMaterial> ply; // where it is not isotropic
    DeckExpansion expansion;
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
  const Material& isotropic_material_of(const Keyword& keyword) const;
  void elastic(const Keyword& keyword);
  void elastic_ply(const Keyword& keyword, Material& material, const std::string& type);
  PlyMaterial ply_of(const Material& material) const;
  void orientation(const Keyword& keyword);
  Eigen::Matrix3d axes_of(const Keyword& orientation, const Eigen::Vector3d& at) const;
  const Keyword* find_orientation(const Keyword& asker, const std::string& name) const;
  Eigen::Vector3d first_axis(const AbaqusElement& element, const Keyword* orientation);
  void note_first_of_many(const Keyword& keyword, std::size_t fields);
  void density(const Keyword& keyword);
  void expansion(const Keyword& keyword);
  void shell_section(const Keyword& keyword);
  void membrane_section(const Keyword& keyword);
  void solid_section(const Keyword& keyword); // of trusses
  struct Ply {
    const Material* material = nullptr;
    double thickness = 0, angle = 0;
    const Keyword* orientation = nullptr; // of its own, in place of the angle
  };
  std::vector<Ply> plies_of(const Keyword& keyword) const;
  ShellLaminate laminate_of(const std::vector<Ply>& plies, const AbaqusElement& element,
                            const Eigen::Vector3d& along);
  ShellLaminate given_matrix(const Keyword& keyword, double& thickness) const;
  int add_laminate(const ShellLaminate& wall);
  void laminated_section(const Keyword& keyword);
  void isotropic_wall(const Keyword& keyword, const ShellSection& section, double thickness,
                      const DeckExpansion& expansion);
  void wall_shear(const Keyword& keyword);
  struct ShellWall { // of the parts of an element
    int section = 0, laminate = -1;
    double thickness = 0, offset = 0;
    Eigen::Vector3d along = Eigen::Vector3d::Zero();
    DeckExpansion expansion = {};
  };
  void add_shells(AbaqusElement& element, const ShellWall& wall);
  void hold_in_plane(const AbaqusElement& element); // of the elements of plane frames
  void nodal_thickness(const Keyword& keyword);
  void normal(const Keyword& keyword);
  void check_beam_normals();
  void beam_section(const Keyword& keyword);
  void add_beam(AbaqusElement& element, std::size_t first, const Eigen::Vector3d& n1,
                const TurnedSection& section, const Eigen::Vector3d& to_shear_centre,
                const Eigen::Vector3d& to_neutral, const DeckExpansion& expansion);
  Eigen::Vector3d beam_offset(const Keyword& keyword, const std::string& shape) const;
  void user_element(const Keyword& keyword);
  double slope_at_rest(const Keyword& keyword, std::size_t first); // line of the curve
  void transverse_shear(const Keyword& keyword);
  void mass(const Keyword& keyword);
  void rotary_inertia(const Keyword& keyword);
  void spring(const Keyword& keyword);

  DeckModel& deck_;
  AbaqusMesh& mesh_;
  LeftOut& left_out_;
  std::map<std::string, Material> materials_;
  std::string material_;                                                // the one that is open
  std::map<std::pair<std::string, std::string>, Keyword> orientations_; // by scope and name
  std::vector<std::size_t> open_beams_;
  int open_section_ = -1; // the wall that is open: of DeckModel::sections, or the laminates since
  std::size_t first_of_section_ = 0;
  double open_thickness_ = 0;
  std::vector<int> of_nodal_thickness_; // shells
  struct Middle {
    int node = 0;
    std::vector<int> around; // four corners, four amid the sides
    double thickness = 0;    // where no node says its own
  };
  std::vector<Middle> middles_; // of eight-node shells
  int split_shells_ = 0, split_beams_ = 0;
  std::map<int, double> thickness_; // by node
  std::vector<Normal> normals_;
  std::vector<std::pair<int, Keyword>> beam_normals_; // elements
};

} // namespace plica
