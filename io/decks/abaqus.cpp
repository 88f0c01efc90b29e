#include "io/decks/abaqus.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

namespace plica {
namespace {

class AbaqusText {
public:
  AbaqusText(const Case& data, const BuiltCase& built)
      : case_(data), built_(built), model_(built.model),
        has_rotations_(model_.mesh.nodes.size(), false),
        rotation_node_(model_.mesh.nodes.size(), 0),
        next_node_(static_cast<int>(model_.mesh.nodes.size()) + 1) {
    for_each_shell([&](const auto& shell) {
      for (int node : shell.nodes) has_rotations_[node] = true;
    });
    for (const BeamElement& b : model_.beams)
      has_rotations_[b.node1] = has_rotations_[b.node2] = true;
    for (int node : built_.held_nodes)
      for (int dof = 0; dof < 6; ++dof) held_.insert({node, dof});
    for (const Constraint& c : model_.constraints)
      if (c.terms.empty()) held_.insert({c.node, c.dof});
  }

  std::string text() {
    if (!model_.matrices.empty())
      throw std::runtime_error("a deck holds no elements that are given by their matrices");
    add("*HEADING\n{}; units: m kg s N rad\n*NODE, NSET=NALL\n", case_.name);
    for (std::size_t i = 0; i < model_.mesh.nodes.size(); ++i)
      add_node(static_cast<int>(i) + 1, model_.mesh.nodes[i]);
    add_shells();
    add_beams();
    for (const MassElement& m : model_.masses) add_mass(m);
    for (const BushingElement& b : model_.bushings) add_spring(b);
    for (const Constraint& c : model_.constraints)
      if (!c.terms.empty()) add_equation(c);
    for (const BuiltSensor& s : built_.sensors)
      add("*NSET, NSET={}\n{}\n", upper(s.name), s.node + 1);
    add_held();
    add_steps();
    return std::move(text_);
  }

private:
  template <class... Args> void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  static std::string upper(std::string name) {
    for (char& c : name)
      c = std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::toupper(c)) : '_';
    return name;
  }

  void add_node(int number, const Eigen::Vector3d& x) {
    add("{}, {:.12e}, {:.12e}, {:.12e}\n", number, x[0], x[1], x[2]);
  }

  int new_node(const Eigen::Vector3d& x) {
    add("*NODE\n");
    add_node(next_node_, x);
    return next_node_++;
  }

  struct Dof {
    int node = 0, dof = 0;
  };

  // A held rotation of a node without rotations of its own is left out of the deck: as the
  // translation of a second node, motion of the base would turn it.
  bool is_left_out(int node, int dof) const {
    return dof >= 3 && !has_rotations_[node] && held_.contains({node, dof});
  }

  // Where a DOF of the model stands in the deck.
  Dof at(int node, int dof) {
    if (dof < 3 || has_rotations_[node]) return {node + 1, dof + 1};
    if (rotation_node_[node] == 0) rotation_node_[node] = new_node(model_.mesh.nodes[node]);
    return {rotation_node_[node], dof - 2};
  }

  template <class F> void for_each_shell(F&& f) const {
    for (const ShellQuad& q : model_.mesh.quads) f(q);
    for (const ShellTriangle& t : model_.mesh.triangles) f(t);
  }

  template <class Shells> void add_elements(const Shells& shells, int section, const char* type) {
    bool open = false;
    for (const auto& shell : shells) {
      if (shell.section != section) continue;
      if (!open) add("*ELEMENT, TYPE={}, ELSET=SHELL{}\n", type, section + 1);
      open = true;
      add("{}", ++elements_);
      for (int node : shell.nodes) add(", {}", node + 1);
      add("\n");
    }
  }

  void add_shells() {
    if (model_.shells.empty()) return;
    std::vector<double> thickness(model_.mesh.nodes.size(), 0), corners(thickness);
    for (std::size_t s = 0; s < model_.shells.size(); ++s) {
      add_elements(model_.mesh.quads, static_cast<int>(s), "S4");
      add_elements(model_.mesh.triangles, static_cast<int>(s), "S3");
      const ShellSection& section = model_.shells[s].section;
      const double root = std::sqrt(section.bending_factor);
      for_each_shell([&](const auto& shell) {
        for (std::size_t a = 0; shell.section == static_cast<int>(s) && a < shell.nodes.size();
             ++a) {
          thickness[shell.nodes[a]] += root * shell.thickness[Eigen::Index(a)];
          corners[shell.nodes[a]] += 1;
        }
      });
      add("** {}\n*MATERIAL, NAME=WALL{}\n*ELASTIC\n{:.12e}, {:.12e}\n*DENSITY\n{:.12e}\n"
          "*SHELL SECTION, ELSET=SHELL{}, MATERIAL=WALL{}, NODAL THICKNESS\n1.\n",
          model_.components[model_.shells[s].component], s + 1, section.E / root, section.nu,
          section.rho / root, s + 1, s + 1);
    }
    add("*NODAL THICKNESS\n");
    for (std::size_t i = 0; i < thickness.size(); ++i)
      if (corners[i] > 0) add("{}, {:.12e}\n", i + 1, thickness[i] / corners[i]);
  }

  void add_beams() {
    for (const BeamElement& b : model_.beams) {
      if (!b.offset1.isZero() || !b.offset2.isZero())
        throw std::runtime_error("a deck holds no beams beside their nodes");
      const BeamProperties& p = b.section;
      const Eigen::Vector3d x =
          (model_.mesh.nodes[b.node2] - model_.mesh.nodes[b.node1]).normalized();
      // Local 1 is our y; n1 = up x axis, so that 2 lies in the plane of axis and up.
      const Eigen::Vector3d n1 = b.up.cross(x).normalized();
      const int e = ++elements_;
      add("*ELEMENT, TYPE=B31, ELSET=BEAM{}\n{}, {}, {}\n", e, e, b.node1 + 1, b.node2 + 1);
      add("*BEAM GENERAL SECTION, ELSET=BEAM{}, DENSITY={:.12e}\n{:.12e}, {:.12e}, 0., {:.12e}, "
          "{:.12e}\n{:.9e}, {:.9e}, {:.9e}\n1., 1.\n",
          e, p.mass / std::max(p.EA, 1e-300), p.EA, p.EI_y, p.EI_z, p.GJ, n1[0], n1[1], n1[2]);
      if (std::isfinite(p.GA_y) && std::isfinite(p.GA_z))
        add("*TRANSVERSE SHEAR STIFFNESS\n{:.12e}, {:.12e}\n", p.GA_z, p.GA_y);
      if (p.inertia_x > 0)
        add("** rotary inertia per length is left out: {:.6g} {:.6g} {:.6g} kg m\n", p.inertia_x,
            p.inertia_y, p.inertia_z);
    }
  }

  // CalculiX spreads the mass of a node over those that it follows only where stiffness has tied
  // them already; a spring of next to nothing does.
  void add_feeble_springs(int node) {
    for (int d = 1; d <= 3; ++d) {
      const int e = ++elements_;
      add("*ELEMENT, TYPE=SPRING1, ELSET=FEEBLE{}\n{}, {}\n*SPRING, ELSET=FEEBLE{}\n{}\n1.e-6\n", e,
          e, node, e, d);
    }
  }

  void add_point_mass(int node, double mass) {
    add_feeble_springs(node);
    const int e = ++elements_;
    add("*ELEMENT, TYPE=MASS, ELSET=MASS{}\n{}, {}\n*MASS, ELSET=MASS{}\n{:.12e}\n", e, e, node, e,
        mass);
  }

  void add_mass(const MassElement& m) {
    int node = m.node + 1;
    if (!m.body.offset.isZero()) { // a rigid arm to the centre of mass
      const Eigen::Vector3d& c = m.body.offset;
      node = new_node(model_.mesh.nodes[m.node] + c);
      for (int d = 0; d < 3; ++d) {
        std::vector<Term> terms{{{node, d + 1}, 1}, {at(m.node, d), -1}};
        for (int r = 0; r < 3; ++r)
          add_term(terms, m.node, 3 + r, -Eigen::Vector3d::Unit(r).cross(c)[d]);
        write_equation(terms);
      }
    }
    if (m.body.mass > 0) add_point_mass(node, m.body.mass);
    if (m.body.inertia.isZero()) return;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(m.body.inertia);
    for (int k = 0; k < 3; ++k) {
      const double J = principal.eigenvalues()[k];
      if (J <= 1e-12 * principal.eigenvalues()[2]) continue;
      // Its translation 1 is the turn about the principal axis.
      const int turn = new_node(model_.mesh.nodes[m.node]);
      std::vector<Term> terms{{{turn, 1}, 1}};
      for (int r = 0; r < 3; ++r) add_term(terms, m.node, 3 + r, -principal.eigenvectors()(r, k));
      if (terms.size() > 1)
        write_equation(terms);
      else
        boundary_.push_back({turn, 1});
      boundary_.push_back({turn, 2});
      boundary_.push_back({turn, 3});
      add_point_mass(turn, J);
    }
  }

  void add_spring(const BushingElement& b) {
    const Matrix6& law = b.bushing.law;
    if (!law.isDiagonal() || !b.bushing.axes.isIdentity())
      throw std::runtime_error("a deck holds springs along the global axes only");
    for (int d = 0; d < 6; ++d) {
      if (law(d, d) == 0 || is_left_out(b.node1, d)) continue;
      const int e = ++elements_;
      const Dof p = at(b.node1, d);
      if (b.node2 < 0) {
        add("*ELEMENT, TYPE=SPRING1, ELSET=SPRING{}\n{}, {}\n*SPRING, ELSET=SPRING{}\n{}\n"
            "{:.12e}\n",
            e, e, p.node, e, p.dof, law(d, d));
        continue;
      }
      const Dof q = at(b.node2, d);
      add("*ELEMENT, TYPE=SPRING2, ELSET=SPRING{}\n{}, {}, {}\n*SPRING, ELSET=SPRING{}\n{}, {}\n"
          "{:.12e}\n",
          e, e, p.node, q.node, e, p.dof, q.dof, law(d, d));
    }
  }

  void add_equation(const Constraint& c) {
    std::vector<Term> terms{{at(c.node, c.dof), 1}};
    for (const ConstraintTerm& t : c.terms) add_term(terms, t.node, t.dof, -t.factor);
    if (terms.size() > 1)
      write_equation(terms);
    else
      boundary_.push_back(terms.front().first);
  }

  using Term = std::pair<Dof, double>;

  void add_term(std::vector<Term>& terms, int node, int dof, double factor) {
    constexpr double rounding = 1e-15; // m: arms of a circle about its own centre
    if (std::abs(factor) > rounding && !is_left_out(node, dof))
      terms.push_back({at(node, dof), factor});
  }

  void write_equation(const std::vector<Term>& terms) {
    constexpr std::size_t per_line = 4;
    add("*EQUATION\n{}\n", terms.size());
    for (std::size_t i = 0; i < terms.size(); ++i)
      add("{}, {}, {:.12e}{}", terms[i].first.node, terms[i].first.dof, terms[i].second,
          i + 1 == terms.size() || (i + 1) % per_line == 0 ? "\n" : ", ");
  }

  void add_held() {
    for (const auto& [node, dof] : held_)
      if (!is_left_out(node, dof)) boundary_.push_back(at(node, dof));
    if (boundary_.empty()) return;
    add("*BOUNDARY\n");
    for (const Dof& h : boundary_) add("{}, {}, {}\n", h.node, h.dof, h.dof);
  }

  void add_steps() {
    if (!case_.analyses.modes) return;
    const Modes& modes = *case_.analyses.modes;
    constexpr int room = 1000; // for a band: as many as there are in it
    add("*STEP\n** CalculiX: add STORAGE=YES to *FREQUENCY when steps of motion of the base "
        "or its ends follow.\n"
        "*FREQUENCY\n");
    if (modes.count > 0)
      add("{}\n", modes.count);
    else
      add("{}, {:.9e}, {:.9e}\n", room, modes.band[0], modes.band[1]);
    add("*NODE FILE\nU\n*END STEP\n");
    if (!case_.analyses.response) return;
    add_base_steps(*case_.analyses.response, modes.count > 0 ? modes.count : room);
    add_end_steps(*case_.analyses.response, modes.count > 0 ? modes.count : room);
  }

  void begin_steady_state(const Response& response, int modes) {
    add("*STEP\n*STEADY STATE DYNAMICS\n{:.9e}, {:.9e}, 20, 3.\n", response.band[0],
        response.band[1]);
    const Damping& damping = case_.analyses.damping;
    if (!damping.ranges.empty() || !damping.modes.empty() || !damping.loss_factors.empty() ||
        has_damped_springs(case_))
      add("** damping by ranges, modes, loss factors and springs is left out\n");
    add("*MODAL DAMPING\n1, {}, {:.9e}\n", modes, damping.modal);
  }

  void end_steady_state() {
    for (const BuiltSensor& s : built_.sensors) add("*NODE PRINT, NSET={}\nU\n", upper(s.name));
    add("*END STEP\n");
  }

  void add_base_steps(const Response& response, int modes) {
    if (response.bases.empty()) return;
    add("*AMPLITUDE, NAME=BASE\n{:.9e}, {:.9e}, {:.9e}, {:.9e}\n", response.band[0], response.level,
        response.band[1], response.level);
    for (int direction : response.bases) {
      if (direction > 2) {
        add("** turns of the base are left out\n");
        continue;
      }
      begin_steady_state(response, modes);
      add("*BASE MOTION, DOF={}, AMPLITUDE=BASE\n", direction + 1);
      end_steady_state();
    }
  }

  // Ends that move by 1 m or 1 rad times their amplitudes: what is printed is the transmissibility.
  // The ground behind springs moves by the force that it exerts through them.
  void add_end_steps(const Response& response, int modes) {
    for (const Motion& motion : response.motions) {
      add("** motion {}: displacements, so that U is the transmissibility\n", name_of(motion));
      begin_steady_state(response, modes);
      std::vector<EndMotion> ends{motion};
      ends.insert(ends.end(), motion.with.begin(), motion.with.end());
      for (const auto& [load_case, part] : {std::pair{1, 0.}, {2, std::numbers::pi / 2}}) {
        std::string moved, pushed;
        for (const EndMotion& end : ends)
          for (const std::string& cap : end.move) {
            const double displacement = end.amplitude * std::cos(end.phase - part);
            (is_held(cap) ? moved : pushed) += end_line(cap, end.direction, displacement);
          }
        if (!moved.empty() && load_case == 2)
          add("** CalculiX 2.20 breaks off here: give it this part as the load case 1 of a step of "
              "its own\n");
        if (!moved.empty()) add("*BOUNDARY, LOAD CASE={}\n{}", load_case, moved);
        if (!pushed.empty()) add("*CLOAD, LOAD CASE={}\n{}", load_case, pushed);
      }
      end_steady_state();
    }
  }

  bool is_held(const std::string& cap) const {
    const int node = built_.cap_nodes.at(cap);
    return std::find(built_.held_nodes.begin(), built_.held_nodes.end(), node) !=
           built_.held_nodes.end();
  }

  std::string end_line(const std::string& cap, int direction, double displacement) {
    constexpr double rounding = 1e-15;
    if (std::abs(displacement) < rounding) return "";
    const Dof d = at(built_.cap_nodes.at(cap), direction);
    if (is_held(cap))
      return fmt::format("{}, {}, {}, {:.12e}\n", d.node, d.dof, d.dof, displacement);
    const auto mount = std::find_if(case_.mount.begin(), case_.mount.end(),
                                    [&](const Mount& m) { return m.cap == cap; });
    return fmt::format("{}, {}, {:.12e}\n", d.node, d.dof,
                       mount->stiffness[std::size_t(direction)] * displacement);
  }

  const Case& case_;
  const BuiltCase& built_;
  const Model& model_;
  std::vector<bool> has_rotations_;
  std::vector<int> rotation_node_; // 0 = none yet
  int next_node_, elements_ = 0;
  std::set<std::pair<int, int>> held_; // DOFs of the model
  std::vector<Dof> boundary_;          // of the deck
  std::string text_;
};

} // namespace

std::string abaqus_model(const Case& data, const BuiltCase& built) {
  return AbaqusText(data, built).text();
}

} // namespace plica
