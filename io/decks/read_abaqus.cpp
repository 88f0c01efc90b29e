#include "io/decks/read_abaqus.hpp"

#include "io/decks/abaqus_joints.hpp"
#include "io/decks/abaqus_sections.hpp"
#include "words/did_you_mean.hpp"

#include <algorithm>

namespace plica {
namespace {

// What stands in a step and does not change the structure.
const std::set<std::string> passed_keywords{"HEADING",
                                            "PREPRINT",
                                            "RESTART",
                                            "OUTPUT",
                                            "NODE OUTPUT",
                                            "ELEMENT OUTPUT",
                                            "ENERGY OUTPUT",
                                            "NODE PRINT",
                                            "EL PRINT",
                                            "NODE FILE",
                                            "EL FILE",
                                            "MODAL FILE",
                                            "FILE FORMAT",
                                            "MONITOR",
                                            "STEP",
                                            "END STEP",
                                            "FREQUENCY",
                                            "STEADY STATE DYNAMICS",
                                            "MODAL DYNAMIC",
                                            "RANDOM RESPONSE",
                                            "MODAL DAMPING",
                                            "SELECT EIGENMODES",
                                            "BASE MOTION",
                                            "AMPLITUDE",
                                            "DAMPING",
                                            "GLOBAL DAMPING",
                                            "PHYSICAL CONSTANTS",
                                            "SECTION CONTROLS",
                                            "DIAGNOSTICS"};

void check_known(const Keyword& k, const std::vector<KeywordHandlers>& phases, LeftOut& left_out) {
  if (passed_keywords.contains(k.name)) return;
  if (k.name == "PART" || k.name == "INSTANCE" || k.name == "ASSEMBLY")
    deck_error(k.at, "*" + k.name, "is not read: the deck has parts and instances",
               "a flat deck; in Abaqus/CAE, model attribute \"do not use parts and assemblies in "
               "input files\"");
  if (k.name == "SYSTEM" || k.name == "TRANSFORM" || (k.name == "NODE" && k.has("SYSTEM")))
    deck_error(k.at, "*" + k.name, "gives coordinates in axes that are not followed",
               "nodes and degrees of freedom in global axes");
  const KeywordHandler* handler = nullptr;
  for (const KeywordHandlers& phase : phases)
    if (const auto found = phase.find(k.name); found != phase.end()) handler = &found->second;
  if (handler == nullptr) {
    std::vector<std::string> names;
    for (const KeywordHandlers& phase : phases)
      for (const auto& [name, h] : phase) names.push_back(name);
    const std::string near = nearest_word(k.name, names);
    left_out.note(k, "is not known",
                  (near.empty() ? "" : "did you mean *" + near + "? ") +
                      "keywords of docs/decks.md");
    return;
  }
  for (const auto& [name, value] : k.parameters)
    if (!handler->parameters.contains(name))
      left_out.note(k, "has a parameter " + name + " that is not known", "without it");
}

} // namespace

// What may be named before it is given comes first: nodes, elements and sets, then materials and
// surfaces, then what uses them.
DeckModel read_abaqus(const std::filesystem::path& file, UnknownCards unknown) {
  const std::vector<Keyword> keywords = read_keywords(file);
  DeckModel deck;
  for (const Keyword& k : keywords) {
    deck.files.insert(k.at.file);
    for (const DataLine& line : k.data) deck.files.insert(line.at.file);
  }
  LeftOut left_out(unknown, deck);
  AbaqusMesh mesh(deck, left_out);
  AbaqusSections sections(deck, mesh, left_out);
  AbaqusJoints joints(deck, mesh);
  const std::vector<KeywordHandlers> phases{mesh.handlers(), sections.materials(),
                                            joints.surfaces(), sections.handlers(),
                                            joints.handlers()};
  DeckProblems problems;
  for (const Keyword& k : keywords) problems.collect([&] { check_known(k, phases, left_out); });
  for (std::size_t p = 0; p < phases.size(); ++p) {
    for (const Keyword& k : keywords)
      if (const auto found = phases[p].find(k.name); found != phases[p].end())
        problems.collect([&] { found->second.read(k); });
    if (p == 0) continue; // materials build on no mesh
    problems.raise();
    if (p == 1) mesh.read_sets();
  }
  mesh.check_sections();
  sections.finish();
  joints.finish();
  return deck;
}

} // namespace plica
