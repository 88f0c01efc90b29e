#include "io/decks/abaqus_loads.hpp"

#include "io/decks/deck_beam_loads.hpp"
#include "io/decks/deck_pressure.hpp"

#include <algorithm>

namespace plica {
namespace {

using Eigen::Vector3d;

const std::set<std::string> loads_that_are_not_had{"CHANGE FRICTION", "INERTIA RELIEF",
                                                   "EMBEDDED LOAD",   "SECTION FORCE",
                                                   "INCIDENT WAVE",   "LOAD CASE"};

// Their steps are small changes of the state before, and leave nothing of their own to those
// behind.
const std::set<std::string> perturbations{
    "FREQUENCY",     "COMPLEX FREQUENCY", "BUCKLE",          "STEADY STATE DYNAMICS", "GREEN",
    "MODAL DYNAMIC", "SPECTRUM",          "RANDOM RESPONSE", "RESPONSE SPECTRUM"};

} // namespace

bool is_load_keyword(const std::string& name) {
  static const std::set<std::string> followed{"CLOAD", "DLOAD", "DSLOAD", "TEMPERATURE",
                                              "EXPANSION"};
  return followed.contains(name) || loads_that_are_not_had.contains(name);
}

KeywordHandlers AbaqusLoads::with(KeywordHandlers joints) {
  const auto both = [&](const char* name, const std::function<void(const Keyword&)>& more) {
    KeywordHandler& handler = joints[name];
    handler.read = [first = handler.read, more](const Keyword& k) {
      if (first) first(k);
      more(k);
    };
  };
  both("STEP", [this](const Keyword& k) { begin_step(k); });
  both("END STEP", [this](const Keyword&) { end_step(); });
  both("STATIC", [this](const Keyword& k) {
    static_ = true;
    riks_ = k.has("RIKS");
  });
  for (const std::string& name : perturbations)
    both(name.c_str(), [this](const Keyword&) { perturbation_ = true; });
  both("CLOAD", [this](const Keyword& k) { read(k, &AbaqusLoads::cload); });
  both("DLOAD", [this](const Keyword& k) { read(k, &AbaqusLoads::dload); });
  both("DSLOAD", [this](const Keyword& k) { read(k, &AbaqusLoads::dsload); });
  both("TEMPERATURE", [this](const Keyword& k) { read(k, &AbaqusLoads::temperature); });
  both("INITIAL CONDITIONS", [this](const Keyword& k) { initial_conditions(k); });
  for (const std::string& name : loads_that_are_not_had)
    both(name.c_str(), [this](const Keyword& k) {
      if (open_)
        now_.not_had.insert(k.at.file + ":" + std::to_string(k.at.line) + ": *" + k.name +
                            " is not had");
    });
  return joints;
}

void AbaqusLoads::begin_step(const Keyword& k) {
  end_step();
  ++steps_;
  open_ = true;
  static_ = riks_ = false;
  before_ = now_;
  moved_before_ = joints_.moved();
  held_before_ = deck_.supports.size();
  perturbation_ = k.has("PERTURBATION");
  if (perturbation_) {
    now_ = {};
    joints_.move_by({});
  }
  forces_of_step_.clear();
  pressures_of_step_.clear();
  gravity_of_step_.clear();
  new_.clear();
  large_ = k.has("NLGEOM") && in_capitals(k.parameters.at("NLGEOM")) != "NO";
}

void AbaqusLoads::end_step() {
  if (!std::exchange(open_, false)) return;
  std::vector<std::string> doubts = joints_.take_doubts();
  now_.not_had.insert(doubts.begin(), doubts.end());
  if (static_) add_case();
  if (!perturbation_) return;
  now_ = std::move(before_);
  joints_.move_by(std::move(moved_before_));
  if (deck_.supports.size() != held_before_)
    now_.not_had.insert("step " + std::to_string(steps_) +
                        ", a perturbation, changes what *BOUNDARY holds, and steps follow it");
}

void AbaqusLoads::add_case() {
  DeckLoadCase made;
  made.name = "step " + std::to_string(steps_);
  for (const auto& [at, value] : now_.forces) {
    const auto own = deck_.axes.find(at.first);
    const Vector3d axis = own == deck_.axes.end() ? Vector3d::Unit(at.second % 3)
                                                  : Vector3d(own->second.col(at.second % 3));
    DeckForce f{.node = at.first};
    (at.second < 3 ? f.force : f.moment) = value * axis;
    made.forces.push_back(f);
  }
  add_distributed(made);
  add_strains(made);
  for (const auto& [elements, g] : now_.gravity) made.gravity += g;
  if (large_) made.notes = {"asks for large displacements (NLGEOM) and is solved linearly"};
  if (riks_) made.notes.emplace_back("asks for RIKS; its loads act once, without a load factor");
  made.supports = deck_.supports;
  made.moved = joints_.moved();
  made.not_had.insert(made.not_had.end(), now_.not_had.begin(), now_.not_had.end());
  if (made.forces.empty() && made.strains.empty() && made.gravity.isZero(0) && made.moved.empty() &&
      made.not_had.empty())
    return; // nothing acts
  deck_.load_cases.push_back(std::move(made));
}

void AbaqusLoads::finish() {
  end_step();
}

// What is wrong concerns who asks for the loads alone.
void AbaqusLoads::read(const Keyword& k, void (AbaqusLoads::*how)(const Keyword&)) {
  try {
    for (const char* parameter :
         {"AMPLITUDE", "FOLLOWER", "TIME DELAY", "USER", "SUBMODEL", "SECTOR"})
      if (k.has(parameter))
        deck_error(k.at, "*" + k.name, std::string("has ") + parameter, "loads that are constant");
    if (k.word_or("LOAD CASE", "1") != "1")
      deck_error(k.at, "*" + k.name, "has LOAD CASE=" + k.word("LOAD CASE"), "LOAD CASE=1");
    if (k.word_or("OP", "MOD") == "NEW" && new_.insert(k.name).second) {
      if (k.name == "CLOAD") now_.forces.clear();
      const auto of_sides = [](const auto& p) { return p.first.second[0] == 'S'; };
      if (k.name == "DLOAD") {
        std::erase_if(now_.pressures, [&](const auto& p) { return !of_sides(p); });
        now_.gravity.clear();
      }
      if (k.name == "DSLOAD") std::erase_if(now_.pressures, of_sides);
      if (k.name == "TEMPERATURE") now_.temperatures.clear();
    }
    (this->*how)(k);
  } catch (const InputError& error) {
    for (const InputProblem& p : error.problems()) now_.not_had.insert(to_string(p));
  }
}

void AbaqusLoads::cload(const Keyword& k) {
  for (const DataLine& line : k.data) {
    if (line.fields.size() < 3)
      deck_error(line.at, "*CLOAD", "is no load", "node, degree of freedom, force");
    const int dof = dof_in(k, line, 1);
    const double value = number_in(k, line, 2);
    for (int node : mesh_.nodes(k, line, line.fields[0])) {
      double& force = now_.forces[{node, dof}];
      force = (forces_of_step_.insert({node, dof}).second ? 0 : force) + value;
    }
  }
}

void AbaqusLoads::dload(const Keyword& k) {
  for (const DataLine& line : k.data) {
    const std::string label = line.fields.size() > 1 ? in_capitals(line.fields[1]) : "";
    if (label == "GRAV") {
      gravity(k, line);
      continue;
    }
    static const std::set<std::string> of_beams{"PX", "PY", "PZ", "P1", "P2"};
    const bool beam = of_beams.contains(label);
    if (label != "P" && !beam)
      deck_error(line.at, "*DLOAD", "is of the kind \"" + label + "\"",
                 "P on shells, PX, PY, PZ, P1, P2 on beams, GRAV");
    const double p = number_in(k, line, 2);
    for (int index : mesh_.elements(k, line, line.fields[0])) {
      const AbaqusElement& e = mesh_.element(index);
      if (beam ? e.beams.empty() : e.shells.empty())
        deck_error(line.at, "*DLOAD",
                   "acts by " + label + " on " + e.origin + ", which is no " +
                       (beam ? "beam" : "shell"),
                   "P on shells, PX, PY, PZ, P1, P2 on beams");
      press(index, label, p);
    }
  }
}

// Pressure into a side of shells.
void AbaqusLoads::dsload(const Keyword& k) {
  for (const DataLine& line : k.data) {
    const std::string label = line.fields.size() > 1 ? in_capitals(line.fields[1]) : "";
    if (label != "P") deck_error(line.at, "*DSLOAD", "is of the kind \"" + label + "\"", "P");
    for (const auto& [index, positive] : joints_.shell_faces(k, line, in_capitals(line.fields[0])))
      press(index, positive ? "SPOS" : "SNEG", number_in(k, line, 2));
  }
}

void AbaqusLoads::press(int element, const std::string& label, double value) {
  double& pressure = now_.pressures[{element, label}];
  pressure = (pressures_of_step_.insert({element, label}).second ? 0 : pressure) + value;
}

void AbaqusLoads::add_distributed(DeckLoadCase& made) const {
  for (const auto& [of, value] : now_.pressures) {
    const auto& [index, label] = of;
    const AbaqusElement& e = mesh_.element(index);
    for (int shell : e.shells) {
      const std::vector<int>& nodes = deck_.shells[std::size_t(shell)].nodes;
      const double p = label == "SPOS" ? -value : value;
      add_pressure(made.forces, deck_.nodes, nodes, std::vector(nodes.size(), p),
                   Vector3d(0, 0, 0));
    }
    for (int i : e.beams) {
      const BeamElement& beam = deck_.beams[std::size_t(i)];
      const Vector3d axis = deck_.nodes[std::size_t(beam.node2)] -
                            deck_.nodes[std::size_t(beam.node1)],
                     first = deck_.of_beams.at(i).y;
      const Vector3d along = label == "P1"   ? first
                             : label == "P2" ? Vector3d(axis.cross(first).normalized())
                                             : Vector3d(Vector3d::Unit(label[1] - 'X'));
      add_beam_load(made.forces, deck_, beam, {.p1 = value, .p2 = value, .direction = along});
      made.along_beams = true;
    }
  }
}

// Of the whole model, or of a set that holds all that has mass.
void AbaqusLoads::gravity(const Keyword& k, const DataLine& line) {
  const std::string name = in_capitals(line.fields[0]);
  if (!name.empty()) {
    const std::vector<int> of = mesh_.elements(k, line, name);
    const std::set<int> set(of.begin(), of.end());
    const auto& all = mesh_.elements();
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool massless = is_idle_type(all[i].type) || all[i].type.starts_with("SPRING") ||
                            all[i].type == "DCOUP3D" || all[i].type == "ROTARYI";
      if (!massless && !set.contains(int(i)))
        deck_error(line.at, "*DLOAD",
                   "GRAV acts on a part of the elements alone, not on " + all[i].origin,
                   "a set of all elements that have mass, or no name");
    }
  }
  const Vector3d d(number_in(k, line, 3, 0), number_in(k, line, 4, 0), number_in(k, line, 5, 0));
  if (!(d.norm() > 0)) deck_error(line.at, "*DLOAD", "GRAV has no direction", "three components");
  Vector3d& g = now_.gravity.try_emplace(name, 0, 0, 0).first->second;
  if (gravity_of_step_.insert(name).second) g.setZero();
  g += number_in(k, line, 2) * d.normalized();
}

} // namespace plica
