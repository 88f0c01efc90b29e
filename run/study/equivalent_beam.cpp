#include "run/study/equivalent_beam.hpp"

#include "model/description/ejma.hpp"
#include "model/description/pipe_model.hpp"
#include "model/description/place_keys.hpp"
#include "model/description/profile.hpp"
#include "run/analyses/run.hpp"
#include "run/study/error_bars.hpp"
#include "run/study/reduce.hpp"
#include "solve/model_error.hpp"
#include "solve/statics.hpp"
#include "words/input_error.hpp"
#include "words/mode_kinds.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using std::numbers::pi;

constexpr double loss_factor = 0.02; // of the transfer stiffness, 1 % of critical

struct Ingredients {
  const Part* bellows_part = nullptr;
  const Bellows* bellows = nullptr;
  const Interlock* liner = nullptr;
};

Ingredients ingredients(const Case& data) {
  Ingredients found;
  for (const Part& part : data.parts) {
    if (const auto* b = std::get_if<Bellows>(&part.body)) {
      if (found.bellows) input_error("parts", "hold several bellows", "one, each by its own case");
      found.bellows = b;
      found.bellows_part = &part;
    } else if (const auto* liner = std::get_if<Interlock>(&part.body)) {
      found.liner = liner;
    } else {
      input_error(part_key(part.name), "is neither a bellows nor its liner",
                  "an equivalent beam stands for one bellows with or without a liner");
    }
  }
  if (!found.bellows) input_error("parts", "hold no bellows", "one bellows of shells");
  if (data.caps.size() != 2) input_error("caps", "are not two", "a cap on each end of the bellows");
  return found;
}

// Straight cylinders at both ends.
struct Cuffs {
  double left = 0, right = 0, radius = 0;
};

Cuffs cuffs_of(const Bellows& b) {
  const auto length = [](const MeridianSection& s) {
    return s.shape == SectionShape::cuff ? s.length : 0;
  };
  return {length(b.profile.front()), length(b.profile.back()), b.root_radius};
}

// The part of shells alone: no liner, no masses and springs of caps, nothing looked at.
Case bare(const Case& data, const Part& bellows) {
  Case alone = for_headline(data);
  alone.parts = {bellows};
  alone.analyses.modes.reset();
  alone.analyses.statics = true;
  alone.sensors.clear();
  alone.supports.clear();
  for (Cap& cap : alone.caps) {
    cap.mass = 0;
    cap.inertia = {};
    cap.ends.clear();
  }
  return alone;
}

double ejma_stiffness(const Bellows& b, const Material& m) {
  const auto u = std::find_if(b.profile.begin(), b.profile.end(),
                              [](const MeridianSection& s) { return s.shape == SectionShape::u; });
  if (u == b.profile.end() || u->count != convolutions(b)) return 0;
  const bool one_wall = b.wall.bond == 1;
  const double ply = one_wall ? total_thickness(b.wall) : b.wall.plies.front();
  const EjmaBellows ejma{.inner_diameter = 2 * b.root_radius - total_thickness(b.wall),
                         .depth = u->height,
                         .pitch = u->pitch,
                         .thickness = ply,
                         .plies = one_wall ? 1 : static_cast<int>(b.wall.plies.size()),
                         .convolutions = u->count,
                         .E = m.E,
                         .nu = m.nu,
                         .thinned = b.wall.thinning != Thinning::none};
  try {
    return ejma_convolution_stiffness(ejma, ejma_factors(ejma)) / u->count;
  } catch (const std::invalid_argument&) {
    return 0; // outside of the coefficients
  }
}

// k of the convolutions in series with two straight ends, from the k of all.
double without_ends(double k, double ends_compliance) {
  const double rest = 1 / k - ends_compliance;
  return rest > 0 ? 1 / rest : k;
}

// What the shells have between their ends, and the convolutions of it.
struct BellowsOfShells {
  EndStiffness whole;
  Cuffs cuffs;
  double mass = 0, length = 0, straight = 0, convoluted = 0;
  double axial = 0, torsion = 0, bending = 0; // of the convolutions
  double mass_of_convolutions = 0, polar = 0; // and their inertia about the axis
};

BellowsOfShells bellows_of_shells(const Superelement& shells, const Bellows& b, const Material& m) {
  BellowsOfShells s{.whole = end_stiffness(shells.K.block<6, 6>(6, 6)), .cuffs = cuffs_of(b)};
  const MassProperties body = mass_properties(shells);
  s.mass = body.mass;
  s.length = axial_length(b);
  s.straight = s.cuffs.left + s.cuffs.right;
  s.convoluted = s.length - s.straight;
  const double radius = s.cuffs.radius, R2 = radius * radius;
  const double A = 2 * pi * radius * total_thickness(b.wall);
  const double G = m.E / (2 * (1 + m.nu));
  s.axial = without_ends(s.whole.axial, s.straight / (m.E * A));
  s.torsion = without_ends(s.whole.torsion, s.straight / (G * A * R2));
  s.bending = without_ends(s.whole.bending_x, s.straight / (m.E * A * R2 / 2));
  s.mass_of_convolutions = s.mass - s.straight * A * m.rho;
  s.polar = body.inertia(1, 1) - s.straight * A * m.rho * R2;
  return s;
}

PipeLayer layer_of(const Interlock& liner, double convoluted) {
  PipeLayer inner{.radius = liner.radius, .mass = liner.mass, .mass_radius = liner.radius};
  inner.axial = liner.EA / convoluted;
  inner.torsion = liner.GJ / convoluted;
  if (liner.EA > 0 && liner.EI > 0) inner.radius = std::sqrt(2 * liner.EI / liner.EA);
  return inner;
}

EquivalentPipe pipe_of(const BellowsOfShells& s, const Bellows& b, const Material& m) {
  EquivalentPipe pipe;
  pipe.material = b.material;
  pipe.start = b.start;
  pipe.length = s.length;
  pipe.convoluted = s.convoluted;
  pipe.outer.radius = std::sqrt(2 * s.bending / s.axial);
  pipe.outer.wall = s.mass_of_convolutions / s.convoluted / (2 * pi * pipe.outer.radius * m.rho);
  pipe.outer.axial = s.axial;
  pipe.outer.mass_radius = std::sqrt(s.polar / s.mass_of_convolutions);
  pipe.outer.torsion = s.torsion;
  pipe.end_radius = s.cuffs.radius;
  pipe.end_wall = total_thickness(b.wall);
  return pipe;
}

ConnectorChain chain_of(const BellowsOfShells& s, const Bellows& b, const Interlock* liner) {
  ConnectorChain chain;
  chain.start = b.start;
  chain.length = s.length;
  chain.arms = s.straight / 2;
  chain.count = std::max(1, convolutions(b));
  chain.mass = s.mass_of_convolutions;
  chain.arm_mass = (s.mass - s.mass_of_convolutions) / 2;
  double polar = s.polar;
  // The arms are rigid: the springs have the compliance of the straight ends too.
  double k = s.whole.axial, c = s.whole.torsion, bend = s.whole.bending_x;
  if (liner) {
    const PipeLayer inner = layer_of(*liner, s.convoluted);
    const double between = liner->mass * s.convoluted / s.length;
    chain.mass += between;
    chain.arm_mass += (liner->mass - between) / 2;
    polar += between * liner->radius * liner->radius;
    k += inner.axial;
    c += inner.torsion;
    bend += inner.axial * inner.radius * inner.radius / 2;
  }
  chain.radius = std::sqrt(polar / chain.mass);
  // Elements as short beams: their law acts midway, so n of them have the statics of the whole.
  const double element = s.convoluted / chain.count, n = chain.count;
  chain.spring = {.axial = n * k,
                  .transverse = 12 * n * bend / (element * element),
                  .bending = n * bend,
                  .torsion = n * c};
  return chain;
}

class Simplifier {
public:
  Simplifier(const Case& data, const StageListener& stage)
      : case_(data), stage_(stage), own_(ingredients(data)) {}

  EquivalentBeam simplify() {
    const Bellows& b = *own_.bellows;
    const Material& m = case_.materials.at(b.material);
    stage_("statics of the shells");
    const ReducedCase alone = reduce_case(bare(case_, *own_.bellows_part),
                                          {.cutoff = 1, .boundary = {}}, [](const std::string&) {});
    const BellowsOfShells shells = bellows_of_shells(alone.element, b, m);
    if (std::abs(shells.cuffs.left - shells.cuffs.right) > 0.01 * shells.length)
      remarks_.push_back("the straight ends differ; both simple models have their mean length");
    EquivalentPipe pipe = pipe_of(shells, b, m);
    if (own_.liner) {
      pipe.inner = layer_of(*own_.liner, shells.convoluted);
      if (own_.liner->contact)
        remarks_.push_back("the liner leans on the bellows by springs; in the simple models it "
                           "follows it rigidly");
      else if (own_.liner->attachment != Attachment::synchronous)
        remarks_.push_back("the liner is tied to the bellows at some places only; in the simple "
                           "models it follows it everywhere");
    }
    EquivalentBeam beam;
    beam.pipe = with_part(pipe);
    beam.connector = with_part(chain_of(shells, b, own_.liner));
    beam.ejma_axial = ejma_stiffness(b, m);
    compare(beam);
    beam.remarks = remarks_;
    return beam;
  }

private:
  template <class Body> Case with_part(const Body& body) const {
    Case simple = case_;
    simple.parts = {{own_.bellows_part->name, body}};
    simple.tolerances.clear();
    simple.variants.clear();
    return simple;
  }

  static Case for_modes(const Case& data) {
    Case few = for_headline(data);
    few.sensors.clear();
    if (!few.analyses.modes) few.analyses.modes = Modes{.count = 12, .band = {}, .proof = false};
    few.analyses.statics = true;
    return few;
  }

  static std::optional<double> frequency_of(const Results& r, const std::string& shape, int order) {
    for (const ModeResult& m : r.modes)
      if (m.shape == shape && m.order == order) return m.frequency;
    return std::nullopt;
  }

  // Highest frequency that the case asks for.
  static double highest(const Case& data, const Results& results) {
    double top = data.analyses.response ? data.analyses.response->band[1] : 0;
    if (!results.modes.empty()) top = std::max(top, results.modes.back().frequency);
    return top > 0 ? top : 500;
  }

  void compare(EquivalentBeam& beam) {
    const auto quiet = [](const std::string&) {};
    stage_("modes of the shells");
    const Results shell = run(for_modes(case_), quiet);
    Case pipe_case = for_modes(beam.pipe), chain_case = for_modes(beam.connector);
    pipe_case.analyses.modes->count = chain_case.analyses.modes->count = 24;
    pipe_case.analyses.modes->band = chain_case.analyses.modes->band = {};
    const Results pipe = run(pipe_case, quiet), chain = run(chain_case, quiet);
    if (!shell.statics || !pipe.statics || !chain.statics)
      throw ModelError("a model has no static stiffness");
    beam.shell_static = *shell.statics;
    beam.pipe_static = *pipe.statics;
    beam.connector_static = *chain.statics;
    beam.mass = shell.model.mass;
    beam.pipe_mass = pipe.model.mass;
    beam.connector_mass = chain.model.mass;
    for (const char* shape : mode_kind::of_a_rod)
      for (int order = 1; order <= 4; ++order)
        if (const auto own = frequency_of(shell, shape, order))
          beam.modes.push_back({shape, order, *own, frequency_of(pipe, shape, order),
                                frequency_of(chain, shape, order)});
    stage_("transfer stiffness");
    const double top = highest(case_, shell);
    const SuperelementRequest request{.cutoff = 2 * top, .boundary = {}};
    const std::array<ReducedCase, 3> reduced{reduce_case(case_, request, quiet),
                                             reduce_case(beam.pipe, request, quiet),
                                             reduce_case(beam.connector, request, quiet)};
    constexpr int points = 40;
    for (int i = 0; i < points; ++i) {
      const double hertz = top * (i + 0.5) / points;
      beam.transfer.push_back({hertz, transfer(reduced[0].element, hertz),
                               transfer(reduced[1].element, hertz),
                               transfer(reduced[2].element, hertz)});
    }
  }

  // Axial, transverse, bending, torsion of D(w) = K (1 + i eta) - w^2 M without its modes.
  static std::array<double, 4> transfer(const Superelement& s, double hertz) {
    const double w = 2 * pi * hertz;
    const MatrixXcd D = s.K.cast<std::complex<double>>() * std::complex<double>(1, loss_factor) -
                        (w * w * s.M).cast<std::complex<double>>();
    const Index b = s.boundary(), m = s.modal();
    MatrixXcd held = D.topLeftCorner(b, b);
    if (m > 0)
      held -= D.topRightCorner(b, m) *
              D.bottomRightCorner(m, m).partialPivLu().solve(MatrixXcd(D.bottomLeftCorner(m, b)));
    const auto between = [&](int dof) { return std::abs(held(dof, 6 + dof)); };
    return {between(1), between(0), between(3), between(4)};
  }

  const Case& case_;
  const StageListener& stage_;
  Ingredients own_;
  std::vector<std::string> remarks_;
};

} // namespace

EquivalentBeam equivalent_beam(const Case& data, const StageListener& stage) {
  return Simplifier(data, stage).simplify();
}

} // namespace plica
