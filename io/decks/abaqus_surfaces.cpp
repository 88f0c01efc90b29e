// Surfaces of an Abaqus deck: of nodes, or of shells.
#include "io/decks/abaqus_joints.hpp"

#include <Eigen/Geometry>

namespace plica {

using Eigen::Vector3d;

KeywordHandlers AbaqusJoints::surfaces() {
  return {{"SURFACE",
           {[this](const Keyword& k) {
              const auto [known, is_new] = surfaces_.try_emplace({k.scope, k.word("NAME")}, k);
              if (!is_new)
                deck_error(k.at, "*SURFACE",
                           "surface " + k.word("NAME") + " is there already in line " +
                               std::to_string(known->second.at.line),
                           "a name once");
            },
            {"NAME", "TYPE", "INTERNAL"}}}};
}

const Keyword& AbaqusJoints::surface(const Keyword& of, const DeckPosition& at,
                                     const std::string& name) const {
  auto found = surfaces_.find({of.scope, name});
  if (const std::size_t dot = name.find('.'); dot != std::string::npos && found == surfaces_.end())
    found = surfaces_.find({name.substr(0, dot), name.substr(dot + 1)});
  if (found == surfaces_.end()) found = surfaces_.find({"", name});
  if (found == surfaces_.end())
    deck_error(at, "*" + of.name, "there is no surface " + name, "*SURFACE, NAME=...");
  return found->second;
}

std::vector<std::pair<int, bool>> AbaqusJoints::shell_faces(const Keyword& of, const DataLine& line,
                                                            const std::string& name) const {
  const Keyword& k = surface(of, line.at, name);
  if (k.word_or("TYPE", "ELEMENT") != "ELEMENT")
    deck_error(line.at, "*" + of.name, "acts on surface " + name + " of nodes",
               "a surface of shells");
  std::vector<std::pair<int, bool>> faces;
  for (const DataLine& own : k.data) {
    const std::string side = own.fields.size() > 1 ? in_capitals(own.fields[1]) : "";
    const bool positive = side == "SPOS" || side == "S2", negative = side == "SNEG" || side == "S1";
    for (int index : mesh_.elements(k, own, own.fields.at(0))) {
      if (mesh_.element(index).shells.empty() || !(positive || negative))
        deck_error(line.at, "*" + of.name,
                   "acts on surface " + name + ", which is on \"" + side + "\" of " +
                       mesh_.element(index).origin,
                   "SPOS or SNEG of shells");
      faces.emplace_back(index, positive);
    }
  }
  return faces;
}

AbaqusJoints::SurfaceNodes AbaqusJoints::surface_nodes(const Keyword& of,
                                                       const std::string& name) const {
  const Keyword& k = surface(of, of.at, name);
  const std::string type = k.word_or("TYPE", "ELEMENT");
  std::map<int, double> area;
  std::set<int> nodes;
  for (const DataLine& line : k.data) {
    if (type == "NODE") {
      for (int n : mesh_.nodes(k, line, line.fields.at(0))) nodes.insert(n);
      if (line.fields.size() > 1 && number_in(k, line, 1) != 1)
        deck_error(line.at, "*SURFACE", "gives a weight to nodes", "nodes alone");
    } else if (type == "ELEMENT") {
      for (int label : mesh_.elements(k, line, line.fields.at(0))) {
        const AbaqusElement& e = mesh_.element(label);
        if (line.fields.size() > 1 && line.fields[1].size() == 2)
          deck_error(line.at, "*SURFACE", "is on an edge of elements", "SPOS, SNEG or nodes");
        for (int n : e.nodes) {
          nodes.insert(n);
          area[n] += shell_area(e) / double(e.nodes.size());
        }
      }
    } else {
      deck_error(k.at, "*SURFACE", "has TYPE=" + type, "TYPE=NODE or TYPE=ELEMENT");
    }
  }
  SurfaceNodes all{{nodes.begin(), nodes.end()}, {}};
  if (type == "ELEMENT")
    for (int n : all.nodes) all.weights.push_back(area[n]);
  return all;
}

double AbaqusJoints::shell_area(const AbaqusElement& e) const {
  const auto& x = deck_.nodes;
  if (e.nodes.size() < 3)
    deck_error(e.at, "*SURFACE", "is on an element that is no shell", "shells or nodes");
  const bool quad = e.nodes.size() == 4 || e.nodes.size() == 8;
  const Vector3d a = x[e.nodes[2]] - x[e.nodes[0]];
  const Vector3d b = quad ? x[e.nodes[3]] - x[e.nodes[1]] : x[e.nodes[1]] - x[e.nodes[0]];
  return a.cross(b).norm() / 2;
}

} // namespace plica
