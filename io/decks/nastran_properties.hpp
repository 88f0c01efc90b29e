// Materials and properties of a Nastran deck, by their numbers.
#pragma once

#include "io/decks/deck_panels.hpp"
#include "io/decks/deck_sections.hpp"
#include "io/decks/nastran_grids.hpp"
#include "io/decks/nastran_laminate.hpp"
#include "model/description/deck_model.hpp"

namespace plica {

// E alone means nu = 0 and G = E/2 here. Of E, G and nu given together each is used where it
// enters.
struct NastranMaterial : BeamMaterial {
  double G = 0;
  int line = 0;
  DeckExpansion expansion;
  std::string not_a_wall;         // why no isotropic wall is made of it; empty: one is
  std::optional<PlyMaterial> ply; // in plane stress, where it is a material there
  double isotropic_shear() const { return E / (2 * (1 + nu)); }
};

// What a wall resists.
enum class WallKind { all, membrane, bending };

struct NastranWall {
  ShellSection section;
  WallKind kind = WallKind::all;
  double thickness = 0;                       // 0: of the elements
  double offset = 0;                          // nodes to the middle, along the normal
  std::optional<ShellLaminate> laminate = {}; // where it is not isotropic; section: of no meaning
  DeckExpansion expansion = {};
};

struct NastranRod {
  double EA = 0, GJ = 0, mass = 0; // per length
  DeckExpansion expansion = {};
};

// About the line of shear centres; the eccentricity along the unturned local axes (x, y, z).
struct NastranBeam : TurnedSection {
  Eccentricity eccentricity = {};
};

class NastranProperties {
public:
  // What is wrong goes into `problems`; what was refused is not complained of again where it is
  // used.
  NastranProperties(const CardsByName& cards, double mass_factor, DeckProblems& problems,
                    std::vector<std::string>& notes);

  const NastranMaterial& material(const Card& asker, std::size_t field) const;
  // Of a number; none where the property was refused. InputError when there is none.
  std::optional<NastranWall> wall(const Card& asker, int number) const;
  std::optional<NastranBeam> beam(const Card& asker, int number) const;
  DeckExpansion expansion_of_beam(int number) const;
  const Taper* taper_of_beam(int number) const; // null: its section is the same all along
  std::optional<NastranRod> rod(const Card& asker, int number) const; // of PROD or PTUBE
  NastranRod rod(const NastranMaterial& m, double A, double J, double extra) const;
  const Card& card(const char* name, int number, const Card& asker) const;
  double mass_factor() const { return mass_factor_; }

private:
  void read_mat1(const Card& card);
  void read_mat2(const Card& card);
  void read_mat8(const Card& card);
  void add_material(const Card& card, NastranMaterial m);
  const NastranMaterial& wall_material(const Card& card, std::size_t field) const;
  const PlyMaterial& ply_material(const Card& card, std::size_t field) const;
  NastranWall pshell(const Card& card) const;
  NastranWall general_pshell(const Card& card, NastranWall wall) const;
  NastranWall pcomp(const Card& card) const;
  NastranWall pquad1(const Card& card) const;
  NastranWall pquad2(const Card& card) const;
  NastranBeam beam_of(const Card& card);
  NastranBeam pbar(const Card& card, const NastranMaterial& m) const;
  NastranBeam pbeam(const Card& card, const NastranMaterial& m);
  NastranBeam shaped(const Card& card, const NastranMaterial& m);

  const CardsByName& cards_;
  double mass_factor_;
  std::map<int, NastranMaterial> materials_;
  std::map<int, std::optional<NastranWall>> walls_;
  std::map<int, std::optional<NastranBeam>> beams_;
  std::map<int, DeckExpansion> expansions_; // of beams
  std::map<int, Taper> tapers_;             // of those that have one
  std::map<std::string, std::map<int, std::optional<NastranRod>>> rods_;
};

// Profile of PBARL and PBEAML by the name and sizes of the MSC manual; the local z is the y of the
// element, whose z points the other way than our y. Throws InputError for one that is not had.
TurnedSection nastran_profile(const Card& card, const NastranMaterial& material,
                              const std::vector<double>& sizes);
std::size_t sizes_of_profile(const Card& card); // InputError for one that is not had

} // namespace plica
