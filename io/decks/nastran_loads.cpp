#include "io/decks/nastran_loads.hpp"

#include "io/decks/deck_beam_loads.hpp"
#include "io/decks/deck_pressure.hpp"
#include "io/decks/nastran_cards.hpp"
#include "io/decks/nastran_load_cards.hpp"
#include "io/decks/nastran_temperatures.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <functional>

namespace plica {
namespace {

using Eigen::Vector3d;

const std::set<std::string> followed_loads{"FORCE",   "FORCE1", "FORCE2", "MOMENT", "MOMENT1",
                                           "MOMENT2", "LOAD",   "GRAV",   "PLOAD",  "PLOAD2",
                                           "PLOAD1",  "PLOAD4", "SLOAD",  "SPCD"};
const std::set<std::string> loads_not_had{"RFORCE",  "ACCEL",   "ACCEL1",
                                          "PLOADX1", "PLOADB3", "FORCDST"};

Vector3d vector_of(const Card& card, std::size_t first) {
  return {card.real(first, 0), card.real(first + 1, 0), card.real(first + 2, 0)};
}

Vector3d direction(const Card& card, const Vector3d& d) {
  if (!(d.norm() > 0)) card.wrong("acts in no direction", "two different points, or a vector");
  return d.normalized();
}

class LoadReader {
public:
  LoadReader(const NastranReading& r, const CardsByName& loads, DeckLoadCase& into)
      : r_(r), loads_(loads), into_(into) {
    const auto& shells = r.deck.shells;
    for (std::size_t i = 0; i < shells.size(); ++i)
      shells_[shells[i].element].push_back(static_cast<int>(i));
    for (const auto& [i, bar] : r.deck.of_beams) beams_[bar.element] = i;
    for (const char* name :
         {"CTRIA3", "CQUAD4", "CTRIA6", "CQUAD8", "CTRIAR", "CQUADR", "CSHEAR", "CTRMEM", "CQDMEM"})
      if (const auto found = r.cards.find(name); found != r.cards.end())
        for (const Card* card : found->second)
          if (const auto number = whole_number_of(card->text(0))) surfaces_.insert(*number);
  }

  // S (S1 L1 + S2 L2 + ...) of LOAD, or the set itself.
  void add_set(int set) {
    std::map<int, double> factors;
    each("LOAD", [&](const Card& card) {
      if (card.whole(0) != set) return;
      const double all = card.real(1, 1);
      for (std::size_t i = 2; i < card.fields.size(); i += 2)
        if (card.has(i + 1)) factors[card.whole(i + 1)] += all * card.real(i, 1);
    });
    if (factors.empty()) factors[set] = 1;
    for (const auto& [number, factor] : factors) {
      acts_ = false;
      add(number, factor);
      if (!acts_)
        into_.not_had.push_back(
            "there is no load of set " + std::to_string(number) +
            (number == set ? "" : ", which LOAD " + std::to_string(set) + " names"));
    }
  }

private:
  template <class F> void each(const std::string& name, F&& f) {
    each_load_card(loads_, name, into_, f);
  }

  template <class F> void each_of(const std::string& name, int set, F&& f) {
    each(name, [&](const Card& card) {
      if (card.whole(0) != set) return;
      acts_ = true;
      f(card);
    });
  }

  void add(int set, double factor) {
    for (const char* name : {"FORCE", "FORCE1", "FORCE2"})
      each_of(name, set, [&](const Card& c) {
        into_.forces.push_back({.node = r_.grids.at(c, 1), .force = factor * concentrated(c)});
      });
    for (const char* name : {"MOMENT", "MOMENT1", "MOMENT2"})
      each_of(name, set, [&](const Card& c) {
        into_.forces.push_back({.node = r_.grids.at(c, 1), .moment = factor * concentrated(c)});
      });
    each_of("GRAV", set, [&](const Card& c) {
      const Eigen::Matrix3d axes = r_.grids.axes(c, 1, Vector3d(0, 0, 0));
      if (!axes.isApprox(r_.grids.axes(c, 1, Vector3d(1, 2, 3))))
        c.wrong("has a system whose axes turn from place to place", "a rectangular one");
      into_.gravity += factor * c.real(2) * (axes * vector_of(c, 3));
    });
    each_of("SLOAD", set, [&](const Card& c) {
      for (std::size_t i = 1; i < c.fields.size() && c.has(i); i += 2) {
        const int node = r_.grids.at(c, i);
        if (!r_.deck.scalars.contains(node))
          c.wrong("acts on grid point " + c.text(i), "scalar points; FORCE acts on grid points");
        into_.forces.push_back({.node = node, .force = {factor * c.real(i + 1), 0, 0}});
      }
    });
    each_of("SPCD", set, [&](const Card& c) {
      for (std::size_t i : {std::size_t{1}, std::size_t{4}})
        if (c.has(i)) spcd(c, i, factor);
    });
    add_pressures(set, factor);
    each_of("PLOAD1", set, [&](const Card& c) { on_beam(c, factor); });
    for (const std::string& name : loads_not_had)
      each_of(name, set, [](const Card& c) { c.wrong("is not had", "loads that are"); });
  }

  // FORCE and MOMENT along a vector, 1 from point to point, 2 across two lines.
  Vector3d concentrated(const Card& c) const {
    const int node = r_.grids.at(c, 1);
    if (r_.deck.scalars.contains(node)) c.wrong("acts on a scalar point", "SLOAD");
    const auto& x = r_.deck.nodes;
    if (c.name.ends_with('1'))
      return c.real(2) * direction(c, x[r_.grids.at(c, 4)] - x[r_.grids.at(c, 3)]);
    if (c.name.ends_with('2'))
      return c.real(2) * direction(c, (x[r_.grids.at(c, 4)] - x[r_.grids.at(c, 3)])
                                          .cross(x[r_.grids.at(c, 6)] - x[r_.grids.at(c, 5)]));
    return c.real(3) * (r_.grids.axes(c, 2, x[node]) * vector_of(c, 4));
  }

  void spcd(const Card& c, std::size_t at, double factor) {
    const int node = r_.grids.at(c, at);
    const std::vector<int> dofs = r_.deck.scalars.contains(node)
                                      ? std::vector{r_.grids.dof(c, node, at + 1)}
                                      : c.dofs(at + 1);
    for (int dof : dofs) {
      const bool held = std::any_of(into_.supports.begin(), into_.supports.end(),
                                    [&](const auto& s) { return s.node == node && s.dof == dof; });
      if (!held)
        c.wrong("moves " + c.text(at) + " " + std::to_string(dof + 1) + ", which no SPC holds",
                "DOFs of the SPC of the subcase");
      into_.moved[{node, dof}] = factor * c.real(at + 2, 0);
    }
  }

  void add_pressures(int set, double factor) {
    each_of("PLOAD", set, [&](const Card& c) {
      std::vector<int> nodes;
      for (std::size_t i = 2; i < 6; ++i)
        if (c.has(i) && (i < 5 || c.whole(i) != 0)) nodes.push_back(r_.grids.at(c, i));
      if (nodes.size() < 3)
        c.wrong("acts on " + std::to_string(nodes.size()) + " points", "3 or 4");
      add_pressure(into_.forces, r_.deck.nodes, nodes,
                   std::vector(nodes.size(), factor * c.real(1)), Vector3d(0, 0, 0));
    });
    each_of("PLOAD2", set, [&](const Card& c) {
      const bool range = in_capitals(c.text(3)) == "THRU";
      press(c, c.list(2), range, std::vector(4, factor * c.real(1)),
            [](const Vector3d&) { return Vector3d(0, 0, 0); });
    });
    each_of("PLOAD4", set, [&](const Card& c) {
      const double p = c.real(2);
      const std::vector<double> corner{factor * p, factor * c.real(3, p), factor * c.real(4, p),
                                       factor * c.real(5, p)};
      const bool range = in_capitals(c.text(6)) == "THRU";
      if (c.has(6) && !range) c.wrong("acts on a face of a solid", "shells");
      const int first = c.whole(1), last = range ? c.whole(7) : first;
      if (c.has(12) && in_capitals(c.text(12)) != "SURF")
        c.wrong("acts along " + c.text(12), "SURF, on the surface");
      const Vector3d n = vector_of(c, 9);
      const Along along = [&](const Vector3d& at) {
        return n.norm() > 0 ? Vector3d(r_.grids.axes(c, 8, at) * n.normalized()) : n;
      };
      std::vector<int> elements;
      if (!range) elements.push_back(first);
      for (auto e = surfaces_.lower_bound(first); range && e != surfaces_.end() && *e <= last; ++e)
        elements.push_back(*e);
      press(c, elements, range, corner, along);
    });
  }

  void on_beam(const Card& c, double factor) {
    const int element = c.whole(1);
    const auto found = beams_.find(element);
    if (found == beams_.end())
      c.wrong("acts on element " + std::to_string(element) +
                  ", which is no beam of the deck, or one with released ends or a taper",
              "CBAR and CBEAM without pin flags, of a constant section");
    const BeamElement& beam = r_.deck.beams[std::size_t(found->second)];
    const std::string type = in_capitals(c.text(2)), scale = in_capitals(c.text(3));
    static const std::set<std::string> types{"FX", "FY", "FZ", "FXE", "FYE", "FZE"};
    if (!types.contains(type)) c.wrong("acts as " + c.text(2), "FX, FY, FZ, FXE, FYE, FZE, forces");
    if (scale != "LE" && scale != "FR")
      c.wrong("is given over " + c.text(3), "LE or FR, along the beam");
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    const Vector3d x = r_.deck.nodes[std::size_t(beam.node2)] + beam.offset2 -
                       r_.deck.nodes[std::size_t(beam.node1)] - beam.offset1;
    const double L = x.norm();
    if (type.size() == 3) {
      axes.col(0) = x / L;
      axes.col(1) = r_.deck.of_beams.at(found->second).y;
      axes.col(2) = axes.col(0).cross(axes.col(1));
    }
    const double unit = scale == "LE" ? L : 1;
    BeamLine load{.start = c.real(4, 0) / unit,
                  .p1 = factor * c.real(5),
                  .direction = axes.col(type[1] - 'X')};
    load.end = c.has(6) ? c.real(6) / unit : load.start;
    load.p2 = load.end > load.start ? factor * c.real(7, c.real(5)) : load.p1;
    constexpr double rounding = 1e-6;
    if (!(load.start >= 0 && load.end >= load.start && load.end <= 1 + rounding))
      c.wrong("goes from " + c.text(4) + " to " + c.text(6), "places on the beam, X1 before X2");
    add_beam_load(into_.forces, r_.deck, beam, load);
    into_.along_beams = true;
  }

  using Along = std::function<Vector3d(const Vector3d&)>; // by place; zero: along the normal

  // `range`: of a range of numbers those count that there are.
  void press(const Card& c, const std::vector<int>& elements, bool range,
             const std::vector<double>& corner, const Along& along) {
    bool met = false;
    for (int element : elements) {
      if (range && !surfaces_.contains(element)) continue;
      on_element(c, element, corner, along);
      met = true;
    }
    if (!met) c.wrong("acts on no shell of the deck", "elements of the deck");
  }

  void on_element(const Card& c, int element, const std::vector<double>& corner,
                  const Along& along) {
    const auto found = shells_.find(element);
    if (found == shells_.end())
      c.wrong("acts on element " + std::to_string(element) + ", which is no shell of the deck",
              "shells that bend");
    const bool varies =
        std::any_of(corner.begin(), corner.end(), [&](double p) { return p != corner[0]; });
    if (varies && found->second.size() > 1)
      c.wrong("varies over an element of six or eight nodes", "one pressure");
    for (int e : found->second) {
      const std::vector<int>& nodes = r_.deck.shells[std::size_t(e)].nodes;
      Vector3d middle(0, 0, 0);
      for (int node : nodes) middle += r_.deck.nodes[std::size_t(node)] / double(nodes.size());
      add_pressure(into_.forces, r_.deck.nodes, nodes,
                   {corner.begin(), corner.begin() + std::ptrdiff_t(nodes.size())}, along(middle));
    }
  }

  const NastranReading& r_;
  const CardsByName& loads_;
  DeckLoadCase& into_;
  std::map<int, std::vector<int>> shells_; // by the number of their element
  std::map<int, int> beams_;               // likewise
  std::set<int> surfaces_;                 // numbers of all elements that are surfaces
  bool acts_ = false;
};

std::set<int> sums_spelt_out(const NastranReading& r, int set) {
  std::set<int> sets{set};
  if (const auto sums = r.cards.find("SPCADD"); sums != r.cards.end())
    for (const Card* card : sums->second)
      if (card->whole(0) == set)
        for (int other : card->list(1)) sets.insert(other);
  return sets;
}

int chosen(const Subcase& above, const Subcase& own, const std::string& kind) {
  const auto choice = own.chosen.find(kind);
  if (choice != own.chosen.end()) return choice->second;
  const auto general = above.chosen.find(kind);
  return general == above.chosen.end() ? 0 : general->second;
}

} // namespace

bool is_load_card(const std::string& name) {
  return followed_loads.contains(name) || loads_not_had.contains(name) || is_temperature_card(name);
}

HeldBySets held_by(const NastranReading& r, const std::set<int>& sets,
                   std::vector<Constraint> supports) {
  HeldBySets all;
  all.supports = std::move(supports);
  std::set<std::pair<int, int>> held;
  for (const Constraint& row : all.supports) held.insert({row.node, row.dof});
  const auto hold = [&](const Card& card, int node, std::size_t field, double value) {
    const bool one = r.deck.scalars.contains(node);
    for (int dof : one ? std::vector{r.grids.dof(card, node, field)} : card.dofs(field)) {
      if (held.insert({node, dof}).second)
        all.supports.push_back({node, dof, {}, "SPC " + card.text(0)});
      if (value != 0) all.moved[{node, dof}] = value;
    }
    std::vector<int>& set = all.sets["SPC[" + card.text(0) + "]"];
    if (std::find(set.begin(), set.end(), node) == set.end()) set.push_back(node);
  };
  r.each("SPC", [&](const Card& card) {
    if (!sets.contains(card.whole(0))) return;
    for (std::size_t at : {std::size_t{1}, std::size_t{4}}) {
      if (!card.has(at)) continue;
      const double value = card.real(at + 2, 0);
      all.moved_cards += value != 0;
      hold(card, r.grids.at(card, at), at + 1, value);
    }
  });
  r.each("SPC1", [&](const Card& card) {
    if (!sets.contains(card.whole(0))) return;
    for (int node : r.grids.list(card, 2)) hold(card, node, 1, 0);
  });
  return all;
}

namespace {

void add_load_case(const NastranReading& r, const CardsByName& loads, const std::string& name,
                   int set, DeckLoadCase made) {
  made.name = name;
  if (set != 0) LoadReader(r, loads, made).add_set(set);
  r.deck.load_cases.push_back(std::move(made));
}

// Without case control a single set of loads is meant.
void read_uncontrolled_loads(const NastranReading& r, const CardsByName& loads,
                             const std::vector<Constraint>& supports) {
  std::set<int> sums, single;
  bool warm = false;
  for (const auto& of_name : loads) {
    warm = warm || is_temperature_card(of_name.first);
    if (is_temperature_card(of_name.first)) continue;
    for (const Card* card : of_name.second)
      r.problems.collect([&] { (of_name.first == "LOAD" ? sums : single).insert(card->whole(0)); });
  }
  const std::set<int>& there = sums.empty() ? single : sums;
  DeckLoadCase open;
  std::set<int> holding;
  for (const char* name : {"SPC", "SPC1"})
    r.each(name, [&](const Card& card) { holding.insert(card.whole(0)); });
  HeldBySets held = held_by(r, holding, supports);
  open.supports = std::move(held.supports);
  open.moved = std::move(held.moved);
  if (warm) open.not_had = {"has temperatures, which no case control chooses"};
  if (there.empty() && open.moved.empty() && !warm) return;
  if (there.empty()) return add_load_case(r, loads, "its supports", 0, open);
  if (there.size() == 1)
    return add_load_case(r, loads, "load " + std::to_string(*there.begin()), *there.begin(), open);
  open.name = "its loads";
  open.not_had.push_back("belong to " + std::to_string(there.size()) +
                         " sets, and no case control chooses one");
  r.deck.load_cases.push_back(open);
}

} // namespace

void read_loads(const NastranReading& r, const CardsByName& loads, const BulkData& bulk,
                const std::vector<Constraint>& supports) {
  if (!bulk.has_control) return read_uncontrolled_loads(r, loads, supports);
  if (bulk.subcases.empty()) return;
  const Subcase& above = bulk.subcases.front();
  const bool alone = bulk.subcases.size() == 1;
  const auto mpcs = bulk.chosen.find("MPC");
  const int mpc_in_force =
      mpcs == bulk.chosen.end() || mpcs->second.empty() ? 0 : mpcs->second.front();
  for (std::size_t i = alone ? 0 : 1; i < bulk.subcases.size(); ++i) {
    const Subcase& own = bulk.subcases[i];
    const int load = chosen(above, own, "LOAD"), spc = chosen(above, own, "SPC");
    DeckLoadCase made;
    HeldBySets held;
    held.supports = supports;
    const std::size_t before = r.problems.count();
    if (spc != 0) held = held_by(r, sums_spelt_out(r, spc), supports);
    const int warm = chosen(above, own, "TEMP");
    if (load == 0 && held.moved.empty() && warm == 0 && !own.chosen.contains("DEFORM")) continue;
    if (r.problems.count() > before)
      made.not_had.push_back("cards of SPC " + std::to_string(spc) + " are wrong");
    made.supports = std::move(held.supports);
    made.moved = std::move(held.moved);
    if (chosen(above, own, "MPC") != mpc_in_force)
      made.not_had.push_back("chooses another set of MPC than that in force, " +
                             std::to_string(mpc_in_force));
    for (const std::string& what : bulk.control_not_had)
      made.not_had.push_back(what + " of case control is not had");
    if (warm != 0) read_temperatures(r, loads, warm, chosen(above, own, "INITIAL"), made);
    if (chosen(above, own, "DEFORM") != 0) made.not_had.push_back("DEFORM is not had");
    add_load_case(r, loads,
                  !alone                   ? "subcase " + std::to_string(own.number)
                  : load == 0 && warm != 0 ? "temperature " + std::to_string(warm)
                  : load == 0              ? "its supports"
                                           : "load " + std::to_string(load),
                  load, std::move(made));
  }
}

} // namespace plica
