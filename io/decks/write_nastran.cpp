#include "io/decks/write_nastran.hpp"

#include "io/decks/nastran_cards.hpp"
#include "solve/supports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>

namespace plica {
namespace {

std::string number(int i) {
  return std::to_string(i);
}
std::string real(double x) {
  return nastran_real(x);
}

// What a dependent node follows: one node rigidly, or several on average.
struct Following {
  std::set<int> dofs, masters;
  bool of_translations = true; // no term is a rotation

  bool rigid() const { return dofs.size() == 6 && masters.size() == 1; }
  bool average() const { return dofs.size() == 6 && masters.size() > 2 && of_translations; }
  bool by_equations() const { return dofs.size() == 6 && masters.size() > 1 && !of_translations; }
};

class NastranText {
public:
  NastranText(const Case& data, const BuiltCase& built)
      : case_(data), built_(built), model_(built.model) {}

  std::string text() {
    if (!model_.matrices.empty())
      throw std::runtime_error("a deck holds no elements that are given by their matrices");
    control();
    text_ += "BEGIN BULK\n";
    text_ += small_card("PARAM", {"COUPMASS", "1"});
    for (std::size_t i = 0; i < model_.mesh.nodes.size(); ++i) {
      const Eigen::Vector3d& x = model_.mesh.nodes[i];
      text_ += large_card("GRID", {grid(int(i)), "", real(x[0]), real(x[1]), real(x[2])});
    }
    shells();
    for (const BeamElement& b : model_.beams) beam(b);
    for (const MassElement& m : model_.masses) mass(m);
    for (const BushingElement& b : model_.bushings) spring(b);
    couplings();
    held();
    if (case_.analyses.modes) modes(*case_.analyses.modes);
    if (responds()) response();
    return text_ + "ENDDATA\n";
  }

private:
  static std::string grid(int node) { return number(node + 1); }

  bool responds() const {
    const auto& r = case_.analyses.response;
    return case_.analyses.modes && r && (!base_directions().empty() || !r->motions.empty());
  }
  // That there is an SPC1 card: a set that no card has is fatal.
  bool is_held() const { return !built_.held_nodes.empty() || has_supports(model_); }
  std::vector<int> base_directions() const { // translations
    std::vector<int> directions;
    for (int d : case_.analyses.response->bases)
      if (d < 3) directions.push_back(d);
    return directions;
  }

  void control() {
    text_ += fmt::format("$ {}; units: m kg s N rad\nSOL {}\nCEND\nTITLE = {}\n", case_.name,
                         responds() ? 111 : 103, case_.name);
    if (is_held()) text_ += "SPC = 1\n";
    if (has_equations()) text_ += "MPC = 1\n";
    text_ += "METHOD = 1\n";
    if (!responds()) {
      text_ += "DISPLACEMENT(PLOT) = ALL\n";
      return;
    }
    std::string set;
    for (const BuiltSensor& s : built_.sensors) set += (set.empty() ? "" : ", ") + grid(s.node);
    if (!set.empty()) text_ += "SET 1 = " + set + "\n";
    text_ += "SDAMPING = 1\nFREQUENCY = 1\n";
    int subcase = 0;
    const auto add = [&](const std::string& label, int load) {
      text_ += fmt::format("SUBCASE {}\n  LABEL = {}\n  DLOAD = {}\n{}", ++subcase, label, load,
                           set.empty() ? "" : "  ACCELERATION(SORT2,PHASE) = 1\n");
    };
    for (int d : base_directions()) add(fmt::format("BASE {}", "XYZ"[d]), 10 + d);
    const std::vector<Motion>& motions = case_.analyses.response->motions;
    for (std::size_t k = 0; k < motions.size(); ++k)
      add("MOTION " + name_of(motions[k]), 100 + int(k));
  }

  template <class F> void for_each_shell(F&& f) const {
    for (const ShellQuad& q : model_.mesh.quads) f(q);
    for (const ShellTriangle& t : model_.mesh.triangles) f(t);
  }

  void shells() {
    for (std::size_t s = 0; s < model_.shells.size(); ++s) {
      const ShellSection& section = model_.shells[s].section;
      const auto id = number(static_cast<int>(s) + 1);
      double thickness = 0;
      int corners = 0;
      for_each_shell([&](const auto& shell) {
        if (shell.section != static_cast<int>(s)) return;
        thickness += shell.thickness.sum();
        corners += static_cast<int>(shell.nodes.size());
      });
      text_ += fmt::format("$ {}\n", model_.components[model_.shells[s].component]);
      text_ += large_card("MAT1", {id, real(section.E), "", real(section.nu), real(section.rho)});
      text_ +=
          large_card("PSHELL", {id, id, real(thickness / corners), id, real(section.bending_factor),
                                id, real(section.shear_correction)});
    }
    for_each_shell([&](const auto& shell) {
      std::vector<std::string> fields{number(++elements_), number(shell.section + 1)};
      for (int node : shell.nodes) fields.push_back(grid(node));
      fields.resize(9);         // THETA, ZOFFS, blank
      fields.emplace_back("0"); // TFLAG
      for (double t : shell.thickness) fields.push_back(real(t));
      text_ += large_card(shell.nodes.size() == 4 ? "CQUAD4" : "CTRIA3", fields);
    });
  }

  // Section and material of stiffness given as numbers: E = G = 1.
  void beam(const BeamElement& b) {
    if (!b.offset1.isZero() || !b.offset2.isZero())
      throw std::runtime_error("a deck holds no beams beside their nodes");
    const BeamProperties& p = b.section;
    const int e = ++elements_, property = 100 + e;
    const auto shear = [&](double GA) {
      return std::isfinite(GA) && p.EA > 0 ? real(GA / p.EA) : std::string();
    };
    text_ += large_card("MAT1", {number(property), "1.", "1."});
    text_ += large_card("PBAR", {number(property), number(property), real(p.EA), real(p.EI_y),
                                 real(p.EI_z), real(p.GJ), real(p.mass), "", "", "", "", "", "", "",
                                 "", "", shear(p.GA_z), shear(p.GA_y)});
    text_ += large_card("CBAR", {number(e), number(property), grid(b.node1), grid(b.node2),
                                 real(b.up[0]), real(b.up[1]), real(b.up[2])});
    rotary_inertia(b);
  }

  // Bars have none: half of it is a body without mass at each end.
  void rotary_inertia(const BeamElement& b) {
    const BeamProperties& p = b.section;
    const Eigen::Vector3d inertia(p.inertia_x, p.inertia_y, p.inertia_z);
    if (inertia.isZero()) return;
    const Eigen::Vector3d along = model_.mesh.nodes[b.node2] - model_.mesh.nodes[b.node1];
    Eigen::Matrix3d axes; // x along, z in the plane of x and up
    axes.col(0) = along.normalized();
    axes.col(1) = b.up.cross(axes.col(0)).normalized();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    RigidMass half{.mass = 0, .offset = {0, 0, 0}, .inertia = {}};
    half.inertia = along.norm() / 2 * axes * inertia.asDiagonal() * axes.transpose();
    text_ += "$ rotary inertia of the beam\n";
    for (int node : {b.node1, b.node2}) mass({.node = node, .body = half});
  }

  void mass(const MassElement& m) {
    const Eigen::Matrix3d& J = m.body.inertia; // CONM2 wants products of inertia as integrals
    text_ += large_card("CONM2", {number(++elements_), grid(m.node), "0", real(m.body.mass),
                                  real(m.body.offset[0]), real(m.body.offset[1]),
                                  real(m.body.offset[2]), "", real(J(0, 0)), real(-J(1, 0)),
                                  real(J(1, 1)), real(-J(2, 0)), real(-J(2, 1)), real(J(2, 2))});
  }

  void spring(const BushingElement& b) {
    const Matrix6& law = b.bushing.law;
    if (!law.isDiagonal() || !b.bushing.axes.isIdentity())
      throw std::runtime_error("a deck holds springs along the global axes only");
    const int e = ++elements_, property = 100 + e;
    std::vector<std::string> fields{number(property), "K"};
    for (int d = 0; d < 6; ++d) fields.push_back(real(law(d, d)));
    text_ += large_card("PBUSH", fields);
    text_ += large_card("CBUSH", {number(e), number(property), grid(b.node1),
                                  b.node2 < 0 ? "" : grid(b.node2), "", "", "", "0"});
  }

  // A place on a shell: its row as it is, two terms a line.
  void equation(const Constraint& c) {
    std::vector<std::string> fields{"1", grid(c.node), number(c.dof + 1), "1."};
    for (std::size_t i = 0; i < c.terms.size(); ++i) {
      if (i % 2 == 1) fields.insert(fields.end(), {"", ""});
      const ConstraintTerm& t = c.terms[i];
      fields.insert(fields.end(), {grid(t.node), number(t.dof + 1), real(-t.factor)});
    }
    text_ += large_card("MPC", fields);
  }

  std::map<int, Following> followers() const {
    std::map<int, Following> following;
    for (const Constraint& c : model_.constraints) {
      if (c.terms.empty()) continue;
      Following& f = following[c.node];
      f.dofs.insert(c.dof);
      for (const ConstraintTerm& t : c.terms) {
        f.masters.insert(t.node);
        f.of_translations = f.of_translations && t.dof < 3;
      }
    }
    return following;
  }

  bool has_equations() const {
    const std::map<int, Following> following = followers();
    return std::any_of(following.begin(), following.end(),
                       [](const auto& entry) { return entry.second.by_equations(); });
  }

  void couplings() {
    const std::map<int, Following> following = followers();
    for (const Constraint& c : model_.constraints)
      if (!c.terms.empty() && following.at(c.node).by_equations()) equation(c);
    std::map<int, std::vector<int>> bodies; // by reference node
    for (const auto& [node, f] : following) {
      if (f.by_equations()) continue;
      if (f.rigid()) {
        bodies[*f.masters.begin()].push_back(node);
      } else if (f.average()) {
        std::vector<std::string> fields{number(++elements_), "", grid(node), "123456", "1.", "123"};
        for (int master : f.masters) fields.push_back(grid(master));
        text_ += small_card("RBE3", fields);
      } else {
        throw std::runtime_error("a deck for Nastran holds rigid and distributing couplings only");
      }
    }
    for (const auto& [reference, nodes] : bodies) {
      std::vector<std::string> fields{number(++elements_), grid(reference), "123456"};
      for (int node : nodes) fields.push_back(grid(node));
      text_ += small_card("RBE2", fields);
    }
  }

  void held() {
    for (int node : built_.held_nodes) text_ += small_card("SPC1", {"1", "123456", grid(node)});
    for (const Constraint& c : model_.constraints)
      if (c.terms.empty()) text_ += small_card("SPC1", {"1", number(c.dof + 1), grid(c.node)});
  }

  void modes(const Modes& asked) {
    if (asked.count > 0)
      text_ += large_card("EIGRL", {"1", "", "", number(asked.count), "", "", "", "MASS"});
    else
      text_ += large_card("EIGRL",
                          {"1", real(asked.band[0]), real(asked.band[1]), "", "", "", "", "MASS"});
  }

  void response() {
    const Response& asked = *case_.analyses.response;
    const Damping& damping = case_.analyses.damping;
    if (!damping.ranges.empty() || !damping.modes.empty() || !damping.loss_factors.empty() ||
        has_damped_springs(case_))
      text_ += "$ damping by ranges, modes, loss factors and springs is left out\n";
    text_ += large_card("TABDMP1", {"1", "CRIT", "", "", "", "", "", "", "0.", real(damping.modal),
                                    "100000.", real(damping.modal), "ENDT"});
    text_ += large_card("FREQ1", {"1", real(asked.band[0]),
                                  real((asked.band[1] - asked.band[0]) / (asked.points - 1)),
                                  number(asked.points - 1)});
    // Five frequencies within 2 % of every mode besides.
    text_ += large_card("FREQ4", {"1", real(asked.band[0]), real(asked.band[1]), ".02", "5"});
    text_ += large_card("TABLED1",
                        {"1", "", "", "", "", "", "", "", "0.", "1.", "100000.", "1.", "ENDT"});
    for (int d : base_directions()) {
      text_ += large_card("RLOAD1", {number(10 + d), number(20 + d), "", "", "1", "", "ACCE"});
      for (int node : built_.held_nodes)
        text_ += large_card("SPCD", {number(20 + d), grid(node), number(d + 1), real(asked.level)});
    }
    for (std::size_t k = 0; k < asked.motions.size(); ++k)
      motion(asked.motions[k], asked.level, 100 + int(k));
  }

  // Each way in which ends move is a load of its own, with its phase.
  void motion(const Motion& m, double level, int dload) {
    std::vector<EndMotion> ends{m};
    ends.insert(ends.end(), m.with.begin(), m.with.end());
    std::vector<std::string> fields{number(dload), "1."};
    int load = 100 * dload;
    for (const EndMotion& end : ends)
      for (const std::string& cap : end.move) {
        const int node = built_.cap_nodes.at(cap);
        if (std::find(built_.held_nodes.begin(), built_.held_nodes.end(), node) ==
            built_.held_nodes.end()) {
          text_ += fmt::format("$ the ground behind the springs of {} is left out\n", cap);
          continue;
        }
        const std::string id = number(++load), dof = number(end.direction + 1);
        const bool ahead = end.phase != 0;
        text_ += large_card("RLOAD1", {id, id, "", ahead ? id : "", "1", "", "ACCE"});
        text_ += large_card("SPCD", {id, grid(node), dof, real(level * end.amplitude)});
        if (ahead)
          text_ +=
              large_card("DPHASE", {id, grid(node), dof, real(end.phase * 180 / std::numbers::pi)});
        fields.insert(fields.end(), {"1.", id});
      }
    if (fields.size() > 2) text_ += large_card("DLOAD", fields);
  }

  const Case& case_;
  const BuiltCase& built_;
  const Model& model_;
  int elements_ = 0;
  std::string text_;
};

} // namespace

std::string nastran_model(const Case& data, const BuiltCase& built) {
  return NastranText(data, built).text();
}

} // namespace plica
