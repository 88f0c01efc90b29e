#include "io/decks/read_nastran.hpp"

#include "io/decks/deck_sections.hpp"
#include "io/decks/keywords.hpp"
#include "io/decks/nastran_joints.hpp"
#include "words/did_you_mean.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plica {
namespace {

using Eigen::Vector3d;

const std::set<std::string> followed{
    "GRID",   "CORD2R", "CORD2C", "CORD2S", "MAT1",   "PSHELL", "CQUAD4", "CQUADR",
    "CTRIA3", "CTRIAR", "PBAR",   "PBARL",  "PBEAM",  "PBEAML", "CBAR",   "CBEAM",
    "CONM2",  "PBUSH",  "CBUSH",  "PELAS",  "CELAS1", "CELAS2", "RBE2",   "RBE3",
    "RBAR",   "MPC",    "MPCADD", "SPC",    "SPC1",   "SPCADD", "PARAM"};

// What asks for an analysis: that says the case.
const std::set<std::string> passed_cards{
    "EIGRL",  "EIGR",   "EIGB",  "TABDMP1", "FREQ",    "FREQ1",  "FREQ2", "FREQ3", "FREQ4",
    "RLOAD1", "RLOAD2", "DLOAD", "TABLED1", "TABRND1", "PLOTEL", "SPCD",  "DAREA", "RANDPS"};

// Parameters that change nothing here.
const std::set<std::string> idle{"POST",  "AUTOSPC", "COUPMASS", "GRDPNT",  "BAILOUT", "PRGPST",
                                 "K6ROT", "SNORM",   "PRTMAXIM", "OUGCORD", "RESVEC",  "MAXRATIO",
                                 "DDRMM", "G",       "W3",       "W4",      "OGEOM",   "INREL"};

// Numbered cards that others refer to; those of a group share their numbers.
const std::map<std::string, std::string> numbered{
    {"PSHELL", "PSHELL"}, {"PBUSH", "PBUSH"},  {"PELAS", "PELAS"}, {"CORD2R", "CORD2"},
    {"CORD2C", "CORD2"},  {"CORD2S", "CORD2"}, {"PBAR", "beam"},   {"PBARL", "beam"},
    {"PBEAM", "beam"},    {"PBEAML", "beam"}};

// Fields that a card can have, rounded up to whole lines; not of those with lists.
const std::map<std::string, std::size_t> longest{
    {"GRID", 8},    {"CORD2R", 16}, {"CORD2C", 16}, {"CORD2S", 16}, {"MAT1", 16},  {"PSHELL", 16},
    {"CQUAD4", 16}, {"CQUADR", 16}, {"CTRIA3", 16}, {"CTRIAR", 16}, {"PBAR", 24},  {"CBAR", 16},
    {"CBEAM", 24},  {"CONM2", 16},  {"CBUSH", 16},  {"PELAS", 8},   {"CELAS1", 8}, {"CELAS2", 8},
    {"RBAR", 16},   {"PARAM", 8},   {"SPC", 8}};

class NastranReader {
public:
  NastranReader(const BulkData& bulk, UnknownCards unknown) : unknown_(unknown) {
    for (const Card& card : bulk.cards) problems_.collect([&] { sort(card); });
    problems_.raise();
    read(bulk);
  }

  DeckModel deck;

private:
  template <class F> void for_each(const char* name, F&& f) {
    if (const auto found = cards_.find(name); found != cards_.end())
      for (const Card* card : found->second) problems_.collect([&] { f(*card); });
  }

  void sort(const Card& card) {
    if (followed.contains(card.name)) {
      cards_[card.name].push_back(&card);
      check_length(card);
      if (const auto group = numbered.find(card.name); group != numbered.end()) {
        const auto [line, first] = lines_.try_emplace({group->second, card.whole(0)}, card.at.line);
        if (!first)
          card.wrong(card.text(0) + " is there already in line " + std::to_string(line->second),
                     "a number once");
      }
      const bool element =
          (card.name[0] == 'C' && !card.name.starts_with("CORD")) || card.name.starts_with("RB");
      if (element && !elements_.insert(card.whole(0)).second)
        card.wrong("element " + card.text(0) + " is there twice", "a number once");
    } else if (!passed_cards.contains(card.name))
      leave_out(card, "is not known", near(card.name) + "cards of docs/decks.md");
  }

  // Lines that continue another card than the one they stand behind make it too long.
  static void check_length(const Card& card) {
    const auto most = longest.find(card.name);
    for (std::size_t i = most == longest.end() ? card.fields.size() : most->second;
         i < card.fields.size(); ++i)
      if (card.has(i))
        card.wrong("goes on beyond its last field with \"" + card.text(i) + "\"",
                   "at most " + std::to_string(most->second) + " fields");
  }

  static std::string near(const std::string& name) {
    const std::string word = nearest_word(name, {followed.begin(), followed.end()});
    return word.empty() ? "" : "did you mean " + word + "? ";
  }

  void leave_out(const Card& card, const std::string& what, const std::string& allowed) {
    if (unknown_ == UnknownCards::error) card.wrong(what, allowed + ", or unknown_cards: list");
    deck.left_out.push_back(card.at.file + ":" + std::to_string(card.at.line) + ": " + card.name +
                            " " + what);
  }

  void read(const BulkData& bulk) {
    for_each("PARAM", [&](const Card& card) { parameter(card); });
    const NastranGrids grids(cards_, deck);
    grids_ = &grids;
    for_each("MAT1", [&](const Card& card) { material(card); });
    problems_.raise();
    for_each("PSHELL", [&](const Card& card) { shell_property(card); });
    for (const char* name : {"PBAR", "PBARL", "PBEAM", "PBEAML"})
      for_each(name, [&](const Card& card) { beam_property(card); });
    problems_.raise();
    for (const char* name : {"CQUAD4", "CQUADR", "CTRIA3", "CTRIAR"})
      for_each(name, [&](const Card& card) { shell(card); });
    for (const char* name : {"CBAR", "CBEAM"})
      for_each(name, [&](const Card& card) { beam(card); });
    for_each("CONM2", [&](const Card& card) { mass(card); });
    for_each("CBUSH", [&](const Card& card) { bush(card); });
    for_each("CELAS1", [&](const Card& card) {
      spring(card, by_number("PELAS", card.whole(1), card).real(1), 2);
    });
    for_each("CELAS2", [&](const Card& card) { spring(card, card.real(1), 2); });
    problems_.raise();
    read_rigid_elements(cards_, grids, deck);
    read_constraints(cards_, bulk, grids, deck);
  }

  void parameter(const Card& card) {
    const std::string name = in_capitals(card.text(0));
    if (name == "WTMASS") {
      if (wtmass_line_ > 0)
        card.wrong("WTMASS is there already in line " + std::to_string(wtmass_line_), "once");
      wtmass_line_ = card.at.line;
      mass_factor_ = card.real(1);
      if (!(mass_factor_ > 0)) card.wrong("WTMASS is " + card.text(1), "above 0");
    } else if (!idle.contains(name))
      leave_out(card, name + " is not known",
                "WTMASS, or one that changes nothing here, such as POST or AUTOSPC");
  }

  const Card& by_number(const char* name, int number, const Card& asker) const {
    if (const auto all = cards_.find(name); all != cards_.end())
      for (const Card* card : all->second)
        if (card->whole(0) == number) return *card;
    asker.wrong("there is no " + std::string(name) + " " + std::to_string(number),
                "one of the deck");
  }

  // --- materials and properties

  struct Material : BeamMaterial {
    double G = 0; // of beams: as given, whatever E and nu say
    int line = 0;
    double isotropic_shear() const { return E / (2 * (1 + nu)); }
  };

  // Two of E, G and nu give the third; of all three each is used where it enters.
  void material(const Card& card) {
    Material m;
    m.line = card.at.line;
    m.E = card.real(1, 0);
    m.G = card.real(2, 0);
    m.nu = card.real(3, 0);
    if (!(card.has(3) ? m.nu > -1 && m.nu <= 0.5 : true))
      card.wrong("has nu = " + card.text(3), "above -1 and at most 0.5");
    if (card.has(1) && card.has(2) && !card.has(3) && m.G > 0) m.nu = m.E / (2 * m.G) - 1;
    if (!card.has(1) && card.has(2) && card.has(3)) m.E = 2 * (1 + m.nu) * m.G;
    if (!card.has(2)) m.G = m.isotropic_shear();
    m.rho = mass_factor_ * card.real(4, 0);
    if (!(m.E > 0 && m.G > 0) || m.rho < 0)
      card.wrong("is no material", "two of E, G and nu, E and G above 0, density at least 0");
    if (card.real(7, 0) != 0)
      leave_out(card, "has structural damping GE", "loss factors in the damping of the case");
    if (!materials_.try_emplace(card.whole(0), m).second)
      card.wrong("material " + card.text(0) + " is there twice", "a number once");
  }

  const Material& material_of(const Card& card, std::size_t field) const {
    const auto found = materials_.find(card.whole(field));
    if (found == materials_.end())
      card.wrong("there is no MAT1 " + card.text(field), "a material of the deck");
    return found->second;
  }

  // The wall of a shell is isotropic here: its G follows from E and nu.
  const Material& isotropic(const Card& card) const {
    const Material& m = material_of(card, 1);
    constexpr double rounded = 0.02;
    if (std::abs(m.G / m.isotropic_shear() - 1) > rounded)
      card.wrong(fmt::format("has a wall of MAT1 {} in line {} with G = {:g}, which E and nu make "
                             "{:g}",
                             card.text(1), m.line, m.G, m.isotropic_shear()),
                 "G within 2 % of E/2/(1+nu), or blank: walls are isotropic");
    return m;
  }

  struct ShellProperty {
    int section = 0;
    double thickness = 0;
  };

  void shell_property(const Card& card) {
    const Material& m = isotropic(card);
    if (!(m.nu < 0.5)) card.wrong("has a material with nu of 0.5 or more", "nu below 0.5");
    const double t = card.real(2, 0);
    for (std::size_t field : {std::size_t{3}, std::size_t{5}})
      if (card.has(field) ? card.whole(field) != card.whole(1) : field == 3)
        card.wrong(field == 3 ? "has no bending, or of another material"
                              : "has transverse shear of another material",
                   "MID2 and MID3 the same as MID1");
    if (card.has(10)) card.wrong("couples membrane and bending (MID4)", "MID4 blank");
    ShellSection section{.E = m.E, .nu = m.nu, .rho = m.rho};
    if (const double extra = mass_factor_ * card.real(7, 0); extra != 0) {
      if (!(t > 0)) card.wrong("has NSM but no thickness", "a thickness");
      section.rho += extra / t;
    }
    section.bending_factor = card.real(4, 1);
    section.shear_correction = card.real(6, 5. / 6);
    if (!(section.bending_factor > 0 && section.shear_correction > 0))
      card.wrong("has a factor of zero", "12I/T**3 and TS/T above 0");
    shell_properties_[card.whole(0)] = {static_cast<int>(deck.sections.size()), t};
    deck.sections.push_back(section);
  }

  // Our local z is the y of the element, the direction of its orientation vector.
  void beam_property(const Card& card) {
    const Material& m = material_of(card, 1);
    const bool shape = card.name == "PBARL" || card.name == "PBEAML";
    BeamProperties section = shape ? shaped(card, m) : given(card, m);
    const double shear = m.G / m.isotropic_shear();
    section.GJ *= shear;
    section.GA_y *= shear;
    section.GA_z *= shear;
    beam_properties_[card.whole(0)] = section;
  }

  BeamProperties shaped(const Card& card, const BeamMaterial& m) const {
    const std::string type = in_capitals(card.text(3));
    const auto size = [&](std::size_t i) {
      if (!(card.real(8 + i) > 0)) card.wrong("has a size of " + card.text(8 + i), "above 0");
      return card.real(8 + i);
    };
    const std::size_t sizes = type == "ROD" ? 1 : 2;
    BeamProperties section;
    if (type == "ROD")
      section = round_section(m, size(0));
    else if (type == "TUBE" && size(0) > size(1))
      section = pipe_section(m, (size(0) + size(1)) / 2, size(0) - size(1));
    else if (type == "BAR")
      section = rectangle_section(m, size(0), size(1));
    else
      card.wrong("has the shape " + type, "ROD, TUBE with its outer radius first, or BAR");
    section.mass += mass_factor_ * card.real(8 + sizes, 0);
    for (std::size_t i = 9 + sizes; i < card.fields.size(); ++i)
      if (card.has(i)) card.wrong("goes on with \"" + card.text(i) + "\"", "a constant section");
    return section;
  }

  BeamProperties given(const Card& card, const BeamMaterial& m) const {
    const bool beam = card.name == "PBEAM"; // has I12 before J, and shear factors of 1
    const std::size_t after = beam ? 1 : 0, factors = 16;
    if (card.real(beam ? 5 : 18, 0) != 0) card.wrong("has a product of inertia", "I12 blank");
    if (beam && card.has(factors) && !card.is_real(factors))
      card.wrong("has stations along the beam", "a constant section");
    for (std::size_t i = factors + 2; beam && i < card.fields.size(); ++i)
      if (card.has(i) && card.real(i) != 0)
        card.wrong("goes on with \"" + card.text(i) + "\"", "a constant section");
    BeamProperties section =
        general_section(m, card.real(2), card.real(3), card.real(4), card.real(5 + after, 0));
    section.mass += mass_factor_ * card.real(6 + after, 0);
    const double GA = m.E / (2 * (1 + m.nu)) * card.real(2); // of an isotropic material
    const double K1 = card.real(factors, beam ? 1 : 0), K2 = card.real(factors + 1, beam ? 1 : 0);
    if (K1 > 0) section.GA_z = K1 * GA;
    if (K2 > 0) section.GA_y = K2 * GA;
    return section;
  }

  // --- elements

  void shell(const Card& card) {
    const std::size_t n = card.name.starts_with("CQUAD") ? 4 : 3;
    const auto property = shell_properties_.find(card.whole(1));
    if (property == shell_properties_.end())
      card.wrong("there is no PSHELL " + card.text(1), "a property of the deck");
    DeckShell shell{
        .nodes = {}, .section = property->second.section, .thickness = {}, .normal = {}};
    for (std::size_t i = 0; i < n; ++i) shell.nodes.push_back(grids_->at(card, 2 + i));
    const double t = property->second.thickness;
    const bool relative = card.whole(9, 0) == 1;
    for (std::size_t i = 0; i < n; ++i) {
      shell.thickness.push_back(relative ? t * card.real(10 + i, 1) : card.real(10 + i, t));
      if (!(shell.thickness.back() > 0)) card.wrong("has no thickness", "T of PSHELL, or T1 ...");
    }
    shell.offset = card.real(n + 3, 0);
    shell.origin = card.name + " " + card.text(0) + " in line " + std::to_string(card.at.line);
    deck.shells.push_back(std::move(shell));
  }

  void beam(const Card& card) {
    const auto property = beam_properties_.find(card.whole(1));
    if (property == beam_properties_.end())
      card.wrong("there is no property " + card.text(1) + " of a beam",
                 "PBAR, PBARL, PBEAM, PBEAML");
    BeamElement beam{
        .node1 = grids_->at(card, 2), .node2 = grids_->at(card, 3), .section = property->second};
    const auto vector = [&](std::size_t first) {
      return Vector3d(card.real(first, 0), card.real(first + 1, 0), card.real(first + 2, 0));
    };
    const std::string axes = in_capitals(card.text(7));
    if (!axes.empty() && axes != "GGG") card.wrong("has OFFT " + axes, "GGG or blank");
    if (card.has(8) || card.has(9)) card.wrong("has released ends (PA, PB)", "PA and PB blank");
    const bool by_grid = card.has(4) && !card.is_real(4) && !card.has(5) && !card.has(6);
    beam.up =
        by_grid ? Vector3d(deck.nodes[grids_->at(card, 4)] - deck.nodes[beam.node1]) : vector(4);
    beam.offset1 = vector(10);
    beam.offset2 = vector(13);
    const Vector3d axis =
        deck.nodes[beam.node2] + beam.offset2 - deck.nodes[beam.node1] - beam.offset1;
    if (!(axis.cross(beam.up).norm() > 1e-6 * axis.norm() * beam.up.norm()))
      card.wrong("has no length, or an orientation along its axis", "a vector across the axis");
    deck.beams.push_back(beam);
  }

  void mass(const Card& card) {
    MassElement element{.node = grids_->at(card, 1), .body = {}};
    const int system = card.whole(2, 0);
    if (system != 0 && system != -1) card.wrong("is in system " + card.text(2), "0 or -1");
    RigidMass& body = element.body;
    body.mass = mass_factor_ * card.real(3, 0);
    body.offset = {card.real(4, 0), card.real(5, 0), card.real(6, 0)};
    if (system == -1) body.offset -= deck.nodes[element.node];
    const auto J = [&](std::size_t field) { return mass_factor_ * card.real(field, 0); };
    // Products of inertia are integrals: the matrix has them with the other sign.
    body.inertia << J(8), -J(9), -J(11), -J(9), J(10), -J(12), -J(11), -J(12), J(13);
    if (!is_body(body))
      card.wrong("is no body", "a mass of at least 0, moments of inertia none above the sum of the "
                               "other two");
    deck.masses.push_back(element);
  }

  void bush(const Card& card) {
    BushingElement element{.node1 = grids_->at(card, 2),
                           .node2 = card.has(3) ? grids_->at(card, 3) : -1,
                           .bushing = {}};
    if (card.whole(7, -1) != 0) card.wrong("has axes of its own", "CID 0: along the basic system");
    if (card.real(8, 0.5) != 0.5 || card.has(9)) card.wrong("does not act half way", "S = 0.5");
    const Card& property = by_number("PBUSH", card.whole(1), card);
    for (std::size_t row = 0; row < property.fields.size(); row += 8) {
      const std::string kind = in_capitals(property.text(row + 1));
      if (kind == "K")
        for (int d = 0; d < 6; ++d)
          element.bushing.law(d, d) = property.real(row + 2 + std::size_t(d), 0);
      else if (!kind.empty())
        leave_out(property, "has values of " + kind, "K alone");
    }
    deck.bushings.push_back(element);
  }

  void spring(const Card& card, double stiffness, std::size_t first) {
    MatrixElement element;
    std::vector<std::pair<int, double>> stretch; // DOF of the element, sign
    for (std::size_t at : {first, first + 2}) {
      if (!card.has(at)) continue;
      const std::vector<int> dofs = card.dofs(at + 1);
      if (dofs.size() != 1)
        card.wrong("acts on components \"" + card.text(at + 1) + "\"", "one component");
      stretch.emplace_back(6 * int(element.nodes.size()) + dofs[0], at == first ? 1. : -1.);
      element.nodes.push_back(grids_->at(card, at));
    }
    if (element.nodes.empty()) card.wrong("is tied to nothing", "a grid point");
    const auto size = static_cast<Eigen::Index>(6 * element.nodes.size());
    Eigen::VectorXd b = Eigen::VectorXd::Zero(size);
    for (const auto& [dof, sign] : stretch) b[dof] = sign;
    element.K = stiffness * b * b.transpose();
    element.M = Eigen::MatrixXd::Zero(size, size);
    deck.springs.push_back(std::move(element));
  }

  UnknownCards unknown_;
  DeckProblems problems_;
  CardsByName cards_;
  std::set<int> elements_;                           // numbers
  std::map<std::pair<std::string, int>, int> lines_; // of numbered cards, by group
  const NastranGrids* grids_ = nullptr;
  double mass_factor_ = 1;
  int wtmass_line_ = 0;
  std::map<int, Material> materials_;
  std::map<int, ShellProperty> shell_properties_;
  std::map<int, BeamProperties> beam_properties_;
};

} // namespace

DeckModel read_nastran(const std::filesystem::path& file, UnknownCards unknown) {
  const BulkData bulk = read_bulk_data(file);
  DeckModel deck = NastranReader(bulk, unknown).deck;
  for (const Card& card : bulk.cards) deck.files.insert(card.at.file);
  return deck;
}

} // namespace plica
