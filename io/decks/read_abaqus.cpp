#include "io/decks/read_abaqus.hpp"

#include "io/decks/abaqus_joints.hpp"
#include "io/decks/abaqus_loads.hpp"
#include "io/decks/abaqus_sections.hpp"
#include "words/did_you_mean.hpp"

#include <algorithm>

namespace plica {
namespace {

std::string near(const Keyword& k, const std::vector<KeywordHandlers>& phases) {
  std::vector<std::string> names;
  for (const KeywordHandlers& phase : phases)
    for (const auto& [name, h] : phase) names.push_back(name);
  const std::string word = nearest_word(k.name, names);
  return word.empty() ? "" : ", did you mean *" + word + "?";
}

// Sorts a keyword: followed, with parameters that are known, passed over, or not had.
void check_known(const Keyword& k, const std::vector<KeywordHandlers>& phases,
                 MissingCards& missing, PassedCards& passed, PassedCards& acting,
                 LeftOut& left_out) {
  const KeywordHandler* handler = nullptr;
  for (const KeywordHandlers& phase : phases)
    if (const auto found = phase.find(k.name); found != phase.end()) handler = &found->second;
  const KeywordKind kind = kind_of_keyword(k.name);
  if (is_load_keyword(k.name)) return acting.add("*" + k.name);
  if (kind == KeywordKind::passed) return passed.add("*" + k.name);
  if (handler == nullptr)
    return missing.add(
        "*" + k.name,
        kind == KeywordKind::structural ? "is not had" : "is not known" + near(k, phases), k.at);
  for (const auto& [name, value] : k.parameters)
    if (!handler->parameters.contains(name))
      left_out.note(k, "has a parameter " + name + " that is not known", "without it");
}

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

// *ENDSTEP is *END STEP, REFNODE= is REF NODE=, *EXPANSION TYPE=ISO wants a comma: so CalculiX
// reads them, which looks at no blanks.
void name_as_known(Keyword& k, const std::vector<KeywordHandlers>& phases) {
  const auto is_known = [&](const std::string& name) {
    return kind_of_keyword(name) != KeywordKind::unknown || is_load_keyword(name) ||
           std::any_of(phases.begin(), phases.end(),
                       [&](const KeywordHandlers& phase) { return phase.contains(name); });
  };
  if (!is_known(k.name)) {
    std::vector<std::string> names = passed_or_structural_keywords();
    for (const KeywordHandlers& phase : phases)
      for (const auto& [name, handler] : phase) names.push_back(name);
    const std::size_t equals = k.name.find('=');
    const std::size_t blank = equals == std::string::npos ? equals : k.name.rfind(' ', equals);
    const std::string own = without_blanks(k.name.substr(0, blank));
    for (const std::string& name : names) {
      if (without_blanks(name) != own) continue;
      if (blank != std::string::npos)
        k.parameters.try_emplace(k.name.substr(blank + 1, equals - blank - 1),
                                 k.name.substr(equals + 1));
      k.name = name;
      break;
    }
  }
  for (const KeywordHandlers& phase : phases)
    if (const auto found = phase.find(k.name); found != phase.end())
      for (const std::string& name : found->second.parameters)
        if (!k.has(name))
          if (const auto close = k.parameters.find(without_blanks(name));
              close != k.parameters.end()) {
            k.parameters[name] = close->second;
            k.parameters.erase(without_blanks(name));
          }
}

void note_what_is_taken_elastic(const std::vector<Keyword>& keywords, DeckModel& deck) {
  const auto has = [&](const char* name) {
    return std::any_of(keywords.begin(), keywords.end(),
                       [&](const Keyword& k) { return k.name == name; });
  };
  if (has("PLASTIC") || has("CREEP") || has("VISCOELASTIC"))
    deck.notes.push_back("materials that yield, creep or relax are taken as elastic");
  if (has("SURFACE INTERACTION") && !has("CONTACT PAIR") && !has("CONTACT"))
    deck.notes.push_back("laws of contact are passed over: no contact uses them");
}

} // namespace

// What may be named before it is given comes first: nodes, elements and sets, then materials and
// surfaces, then what uses them.
DeckModel read_abaqus(const std::filesystem::path& file, UnknownCards unknown) {
  DeckModel deck;
  FlatDeck flat = flatten(read_keywords(file, deck.notes), deck.notes);
  std::vector<Keyword>& keywords = flat.keywords;
  for (const Keyword& k : keywords) {
    deck.files.insert(k.at.file);
    for (const DataLine& line : k.data) deck.files.insert(line.at.file);
  }
  LeftOut left_out(unknown, deck);
  MissingCards missing(unknown == UnknownCards::list);
  PassedCards passed, acting;
  AbaqusMesh mesh(deck, left_out, missing, flat.instances);
  AbaqusSections sections(deck, mesh, left_out);
  AbaqusJoints joints(deck, mesh);
  AbaqusLoads loads(deck, mesh, joints);
  const std::vector<KeywordHandlers> phases{mesh.points(),
                                            mesh.generated_points(),
                                            mesh.handlers(),
                                            mesh.generated_elements(),
                                            sections.materials(),
                                            mesh.axes(),
                                            joints.surfaces(),
                                            sections.handlers(),
                                            loads.with(joints.handlers())};
  constexpr std::size_t mesh_phases = 4; // the materials, which build on no mesh, come after them
  for (Keyword& k : keywords) name_as_known(k, phases);
  DeckProblems problems;
  for (const Keyword& k : keywords)
    problems.collect([&] { check_known(k, phases, missing, passed, acting, left_out); });
  note_what_is_taken_elastic(keywords, deck);
  passed.finish(deck);
  acting.finish(deck, loads_of_decks);
  for (std::size_t p = 0; p < phases.size(); ++p) {
    const std::size_t before = problems.count();
    for (const Keyword& k : keywords)
      if (const auto found = phases[p].find(k.name); found != phases[p].end())
        problems.collect([&] { found->second.read(k); });
    if (p + 1 == mesh_phases)
      missing.finish(problems, deck, "keywords of docs/decks.md, or unknown_cards: list");
    if (p == mesh_phases) {
      problems.collect([&] { mesh.read_sets(); });
      mesh.choose_sections(keywords);
    }
    if (p >= mesh_phases && problems.count() > before) problems.raise();
  }
  mesh.check_sections(problems);
  problems.collect([&] { sections.finish(); });
  problems.collect([&] { joints.finish(); });
  loads.finish();
  problems.raise();
  return deck;
}

} // namespace plica
