// Walls as NASTRAN had them before PSHELL: PQUAD1, PQUAD2, PQDMEM and those of triangles.
#include "io/decks/nastran_properties.hpp"

#include <cmath>

namespace plica {

// Membrane MID1, T1; bending MID2, I; shear MID3, T3, without which the wall is rigid in it.
NastranWall NastranProperties::pquad1(const Card& card) const {
  const bool membrane = card.has(1) && card.whole(1) != 0 && card.real(2, 0) != 0,
             bends = card.has(3) && card.whole(3) != 0 && card.real(4, 0) != 0,
             flexible = card.has(5) && card.whole(5) != 0 && card.real(6, 0) != 0;
  if (!membrane && !bends) card.wrong("has neither MID1 and T1 nor MID2 and I", "a wall");
  const NastranMaterial& m = wall_material(card, membrane ? 1 : 3);
  NastranWall wall{.section = {.E = m.E, .nu = m.nu, .rho = membrane ? m.rho : 0},
                   .thickness = membrane ? card.real(2) : std::cbrt(12 * card.real(4)),
                   .expansion = m.expansion};
  const double t = wall.thickness;
  if (!(t > 0)) card.wrong("has no thickness", "T1 and I above 0");
  wall.kind = !bends ? WallKind::membrane : membrane ? WallKind::all : WallKind::bending;
  ShellSection& s = wall.section;
  s.rho += mass_factor_ * card.real(7, 0) / t;
  if (!bends) {
    s.bending_factor = s.shear_correction = s.drilling = 0;
    return wall;
  }
  const NastranMaterial& bending = wall_material(card, 3);
  if (std::abs(bending.nu - m.nu) > 0.005)
    card.wrong("has other nu in bending than in its plane", "one nu");
  s.bending_factor = 12 * card.real(4) / (t * t * t) * bending.E / m.E;
  s.shear_correction =
      flexible ? card.real(6) / t * material(card, 5).G / m.isotropic_shear() : rigid_in_shear;
  if (!(s.bending_factor > 0 && s.shear_correction > 0))
    card.wrong("has a stiffness below zero", "I and T3 above 0");
  return wall;
}

// Of one material all through, without flexibility in shear; PQDMEM and its like without bending.
NastranWall NastranProperties::pquad2(const Card& card) const {
  const NastranMaterial& m = material(card, 1);
  NastranWall wall{.section = {.E = m.E, .nu = m.nu, .rho = m.rho},
                   .thickness = card.real(2),
                   .expansion = m.expansion};
  if (!(wall.thickness > 0)) card.wrong("has no thickness", "T above 0");
  wall.section.rho += mass_factor_ * card.real(3, 0) / wall.thickness;
  wall.section.shear_correction = rigid_in_shear;
  if (card.name.find("MEM") != std::string::npos) {
    wall.kind = WallKind::membrane;
    wall.section.bending_factor = wall.section.shear_correction = wall.section.drilling = 0;
  }
  if (m.not_a_wall.empty()) return wall;
  ShellLaminate all = solid_wall({ply_material(card, 1).Q, Eigen::Matrix2d::Zero(), 0});
  all.rho = wall.section.rho;
  if (wall.kind == WallKind::membrane) {
    all.D.setZero();
    all.S.setZero();
    all.drilling = 0;
  }
  wall.laminate = all;
  return wall;
}

} // namespace plica
