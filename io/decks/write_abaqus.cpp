#include "io/decks/write_abaqus.hpp"

#include "io/decks/write_abaqus_motion.hpp"
#include "io/decks/write_abaqus_state.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace plica {
namespace {

class AbaqusText {
public:
  AbaqusText(const Case& data, const BuiltCase& built, std::optional<AbaqusState> state)
      : case_(data), built_(built), model_(built.model), state_(std::move(state)),
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
    if (!state_) return;
    for (const auto& [node, leader] : state_->carried)
      for (int dof = 0; dof < 6; ++dof) held_.insert({node, dof});
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
      add("*NSET, NSET={}\n{}\n", abaqus_name(s.name), s.node + 1);
    add_held();
    if (state_) add_state();
    add_steps();
    return std::move(text_);
  }

private:
  template <class... Args> void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
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
      const int before = elements_;
      add_elements(model_.mesh.quads, static_cast<int>(s), "S4");
      add_elements(model_.mesh.triangles, static_cast<int>(s), "S3");
      if (elements_ == before) continue; // what was cold at rest
      heavy_.push_back(fmt::format("SHELL{}", s + 1));
      const ShellSection& section = model_.shells[s].section;
      const double root = std::sqrt(section.bending_factor);
      for_each_shell([&](const auto& shell) {
        for (std::size_t a = 0; shell.section == static_cast<int>(s) && a < shell.nodes.size();
             ++a) {
          thickness[shell.nodes[a]] += root * shell.thickness[Eigen::Index(a)];
          corners[shell.nodes[a]] += 1;
        }
      });
      add("** {}\n*MATERIAL, NAME=WALL{}\n*ELASTIC\n{:.12e}, {:.12e}\n*DENSITY\n{:.12e}\n",
          model_.components[model_.shells[s].component], s + 1, section.E / root, section.nu,
          section.rho / root);
      if (section.thermal_strain != 0)
        add("*EXPANSION, ZERO=0.\n{:.12e}\n", section.thermal_strain);
      add("*SHELL SECTION, ELSET=SHELL{}, MATERIAL=WALL{}, NODAL THICKNESS\n1.\n", s + 1, s + 1);
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
      heavy_.push_back(fmt::format("BEAM{}", e));
      add("*BEAM GENERAL SECTION, ELSET=BEAM{}, DENSITY={:.12e}{}\n{:.12e}, {:.12e}, 0., {:.12e}, "
          "{:.12e}\n{:.9e}, {:.9e}, {:.9e}\n1., 1.{}\n",
          e, p.mass / std::max(p.EA, 1e-300), p.thermal_strain != 0 ? ", ZERO=0." : "", p.EA,
          p.EI_y, p.EI_z, p.GJ, n1[0], n1[1], n1[2],
          p.thermal_strain != 0 ? fmt::format(", {:.12e}", p.thermal_strain) : "");
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
    if (m.body.mass > 0) {
      add_point_mass(node, m.body.mass);
      masses_[node] += m.body.mass;
    }
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
    if (state_ && state_->carried.contains(c.node)) return;
    std::vector<Term> terms{{at(c.node, c.dof), 1}};
    for (const ConstraintTerm& t : c.terms) add_term(terms, t.node, t.dof, -t.factor);
    if (state_ && c.dof < 3) add_growth(terms, c);
    if (terms.size() > 1)
      write_equation(terms);
    else
      boundary_.push_back(terms.front().first);
  }

  using Term = std::pair<Dof, double>;

  // What follows a hot cap is further away from it by a share of its arm.
  void add_growth(std::vector<Term>& terms, const Constraint& c) {
    const auto strain = state_->growth.find(c.node);
    if (strain == state_->growth.end()) return;
    const auto& x = model_.mesh.nodes;
    const double arm = x[c.node][c.dof] - x[c.terms.front().node][c.dof];
    if (std::abs(strain->second * arm) < 1e-15) return;
    if (heat_ == 0) {
      heat_ = new_node({0, 0, 0});
      boundary_.push_back({heat_, 1});
    }
    terms.push_back({{heat_, 1}, -strain->second * arm});
  }

  void add_term(std::vector<Term>& terms, int node, int dof, double factor) {
    constexpr double rounding = 1e-15; // m: arms of a circle about its own centre
    if (state_ && dof >= 3 && state_->turned.contains(node))
      throw std::runtime_error("a deck in a state holds no couplings that follow a turned cap in "
                               "part");
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

  void add_state() {
    const auto place = [&](int node, int dof) -> std::optional<std::pair<int, int>> {
      if (is_left_out(node, dof)) return std::nullopt;
      const Dof d = at(node, dof);
      return std::pair(d.node, d.dof);
    };
    const DeckOfState deck{.place = place, .heavy = heavy_, .masses = masses_, .heat = heat_};
    const std::string step = abaqus_state_step(built_, *state_, deck);
    add("{}", step);
  }

  void add_steps() {
    if (!case_.analyses.modes) return;
    const Modes& modes = *case_.analyses.modes;
    constexpr int room = 1000; // for a band: as many as there are in it
    if (state_)
      add("** modes around it; motion of the base and of ends is left out\n*STEP, PERTURBATION\n");
    else
      add("*STEP\n** CalculiX: add STORAGE=YES to *FREQUENCY when steps of motion of the base or "
          "its ends follow.\n");
    add("*FREQUENCY\n");
    if (modes.count > 0)
      add("{}\n", modes.count);
    else
      add("{}, {:.9e}, {:.9e}\n", room, modes.band[0], modes.band[1]);
    add("*NODE FILE\nU\n*END STEP\n");
    if (!case_.analyses.response || state_) return;
    const std::string motion = abaqus_motion_steps(
        case_, built_, modes.count > 0 ? modes.count : room, [&](int node, int dof) {
          const Dof d = at(node, dof);
          return std::pair(d.node, d.dof);
        });
    add("{}", motion);
  }

  const Case& case_;
  const BuiltCase& built_;
  const Model& model_;
  std::optional<AbaqusState> state_;
  std::vector<bool> has_rotations_;
  std::vector<int> rotation_node_; // 0 = none yet
  int next_node_, elements_ = 0;
  std::set<std::pair<int, int>> held_; // DOFs of the model
  std::vector<Dof> boundary_;          // of the deck
  std::vector<std::string> heavy_;     // sets of elements with mass
  std::map<int, double> masses_;       // kg, by their nodes in the deck
  int heat_ = 0;                       // node of the growth of hot caps; 0 = none yet
  std::string text_;
};

} // namespace

std::string abaqus_model(const Case& data, const BuiltCase& built) {
  return AbaqusText(data, built, std::nullopt).text();
}

std::string abaqus_model_in_state(const Case& data, const BuiltCase& built,
                                  const StateLoads& loads) {
  return AbaqusText(data, built, abaqus_state(data, built, loads)).text();
}

} // namespace plica
