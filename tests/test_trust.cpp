// Where a proof or an error bar once said more than was so: each claim is held against the whole
// model, a finer mesh, a closed form, or must fail.
#include "io/decks/write_nastran.hpp"
#include "io/files/files.hpp"
#include "run/study/error_bars.hpp"
#include "run/study/reduce.hpp"
#include "run/study/refine.hpp"
#include "solve/model_error.hpp"
#include "solve/modes.hpp"
#include "tests/bellows_case.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/temporary_folder.hpp"

#include <Eigen/Eigenvalues>
#include <numbers>

namespace plica::test {
namespace {

using std::numbers::pi;

Case case_of(const std::string& text) {
  const TemporaryFolder folder("trust");
  write_whole(folder.path / "case.yaml", text);
  return read_case((folder.path / "case.yaml").string()).data;
}

// Two bellows of 0.3 mm in line; `middle` is written into the cap between them.
std::string two_bellows(const std::string& mount, const std::string& middle,
                        const std::string& analyses) {
  const std::string bellows =
      "root_radius: 40 mm, profile: [{shape: U, count: 6, height: 8 mm, pitch: 8 mm}], wall: "
      "{plies: [0.3 mm], bond: 1}, mesh: {around: 24, arc: 2, wall: 3}}\n";
  return "case: line\nmaterials: {steel: {E: 200 GPa, nu: 0.3, rho: 8000}}\nparts:\n"
         "  b1: {type: bellows, material: steel, " +
         bellows + "  b2: {type: bellows, material: steel, start: 48 mm, " + bellows +
         "caps: {l: {of: b1.left}, m: {of: [b1.right, b2.left], mass: 0.1" + middle +
         "}, r: {of: b2.right}}\nmount: {l: " + mount + ", r: " + mount + "}\n" +
         "analyses: {static: false, " + analyses + "}\n";
}

Results with_clamp(const std::string& k) {
  const std::string all = k + ", " + k + ", " + k + ", " + k + ", " + k + ", " + k;
  return run_silently(case_of(
      two_bellows("free", ", stiffness: [" + all + "]", "modes: {count: 8}, error_bars: false")));
}

// Rounding of K gives the free motions frequencies of their own.
TEST(ProofBySymmetry, tests_residual_and_rounding) {
  const Results sound = with_clamp("1e9");
  EXPECT_TRUE(sound.verification.passed) << sound.verification.reason;
  EXPECT_NE(sound.route.find("symmetry"), std::string::npos);
  for (const char* k : {"1e14", "1e16"}) {
    const Verification v = with_clamp(k).verification;
    EXPECT_FALSE(v.passed) << k << ": residual " << v.max_residual << ", rounding " << v.rounding;
    EXPECT_EQ(v.inertia_count, v.found) << "the count alone does not see it";
    EXPECT_EQ(v.reason.find("0.000000"), std::string::npos) << v.reason;
    EXPECT_NE(v.reason.find("e-"), std::string::npos) << v.reason;
  }
  try { // the rounding is no longer positive: there may be no answer at all
    EXPECT_FALSE(with_clamp("1e18").verification.passed);
  } catch (const ModelError& error) {
    EXPECT_NE(std::string(error.what()).find("rounding"), std::string::npos);
  }
}

// Euler's cantilever; six elements and shear make 0.05 % of it.
TEST(Proof, springs_to_the_ground_may_be_as_stiff_as_they_like) {
  for (const char* k : {"1e12", "1e20", "1e22"}) {
    const std::string all = std::string(k) + ", " + k + ", " + k;
    const Results r = run_silently(case_of(
        "case: bar\nmaterials: {steel: {E: 200 GPa, nu: 0.3, rho: 8000}}\nparts:\n  b: {type: "
        "beam, points: [[0, 0, 0], [0, 1, 0]], elements: 6, up: [0, 0, 1], section: {shape: "
        "rectangle, material: steel, width: 20 mm, depth: 30 mm}}\ncaps: {a: {of: b.start}}\n"
        "mount: {a: {stiffness: [" +
        all + ", " + all +
        "]}}\nanalyses: {static: false, modes: {count: 12}, error_bars: false}"));
    ASSERT_TRUE(r.verification.passed) << k << ": " << r.verification.reason;
    EXPECT_EQ(r.modes.size(), 12u) << k;
    const double first = std::pow(1.8751, 2) / (2 * pi) * 0.02 * std::sqrt(2e11 / 8000 / 12);
    EXPECT_NEAR(r.modes[0].frequency / first, 1, 5e-4) << k;
    EXPECT_NEAR(r.modes[1].frequency / (1.5 * first), 1, 1e-3) << k;
  }
}

// The static stiffness is that of the part, and a stiff mount leaves no rounding in it.
TEST(StaticStiffness, does_not_see_how_stiff_the_mount_is) {
  const auto stiffness = [&](const std::string& mount, const std::string& symmetry) {
    const std::string text =
        "case: pipe\nmaterials: {steel: {E: 200 GPa, nu: 0.3, rho: 8000}}\nparts:\n  b: {type: "
        "bellows, material: steel, root_radius: 40 mm, profile: [{shape: U, count: 6, height: 8 "
        "mm, pitch: 8 mm}], wall: {plies: [0.3 mm], bond: 1}, mesh: {around: 24, arc: 2, wall: "
        "3}}\ncaps: {l: {of: b.left}, r: {of: b.right}}\nmount: {l: " +
        mount + ", r: " + mount + "}\nanalyses: {static: true, symmetry: " + symmetry +
        ", error_bars: false}\n";
    const Results results = run_silently(case_of(text));
    return results.statics.value().k_axial;
  };
  for (const char* symmetry : {"\"off\"", "required"})
    EXPECT_NEAR(stiffness("{stiffness: [1e18, 1e18, 1e18, 1e18, 1e18, 1e18]}", symmetry) /
                    stiffness("rigid", symmetry),
                1, 1e-8)
        << symmetry;
}

// Effective masses, free mass and its sums are those of the whole, whatever is reduced.
TEST(EffectiveMass, of_a_reduced_model_is_that_of_the_whole) {
  Case data = case_of(two_bellows("rigid", "", "modes: {count: 10}, error_bars: false"));
  const Results whole = run_silently(data);
  data.analyses.reduction = SuperelementsInRun{.cutoff = 8000};
  const Results reduced = run_silently(data);
  for (std::size_t j = 0; j < 6; ++j)
    EXPECT_NEAR(reduced.free_mass[j] / whole.free_mass[j], 1, 1e-9) << j;
  for (std::size_t i = 0; i < 10; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      EXPECT_NEAR(reduced.modes[i].effective_mass[j], whole.modes[i].effective_mass[j],
                  2e-3 * whole.free_mass[j])
          << "mode " << i + 1 << ", " << j;
}

// A support inside a superelement does not move with the boundary.
TEST(BaseMotion, of_a_reduced_model_with_a_support_inside_is_that_of_the_whole) {
  const std::string text = R"(case: pipe
materials: {steel: {E: 200 GPa, nu: 0.3, rho: 8000}}
parts:
  p: {type: beam, points: [[0, 0, 0], [0, 0.4, 0], [0, 1, 0]], elements: 8, up: [0, 0, 1], section: {shape: pipe, material: steel, radius: 30 mm, thickness: 1 mm}}
caps: {a: {of: p.start}, b: {of: p.end, mass: 0.5}}
mount: {a: rigid, b: free}
supports: [{set: "p.point[2]", fix: [uz]}]
sensors: [{name: tip, at: [0, 1, 0]}]
analyses: {static: false, modes: {count: 8}, damping: {modal: 1 %}, response: {base: [z, x], band: [10 Hz, 400 Hz], points: 200}, error_bars: false}
)";
  Case data = case_of(text);
  const Results whole = run_silently(data);
  data.analyses.reduction = SuperelementsInRun{.cutoff = 20000};
  const Results reduced = run_silently(data);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto &a = whole.responses[k].acceleration, &b = reduced.responses[k].acceleration;
    for (const double at : {0.1, 0.4, 0.8}) {
      const auto row = Eigen::Index(at * double(a.rows()));
      EXPECT_NEAR(std::abs(b.row(row).norm() / a.row(row).norm() - 1), 0, 5e-3) << k << " " << at;
    }
  }
  for (std::size_t j = 0; j < 3; ++j)
    EXPECT_NEAR(reduced.free_mass[j] / whole.free_mass[j], 1, 1e-9) << j;
}

std::string plate_with_body(const std::string& offset) {
  return "case: plate\nmaterials: {steel: {E: 193 GPa, nu: 0.3, rho: 8000}}\nparts:\n  p: {type: "
         "plate, material: steel, corners: [[-0.1, 0, -0.1], [0.1, 0, -0.1], [0.1, 0, 0.1], [-0.1, "
         "0, 0.1]], thickness: 2 mm, elements: [10, 10]}\n  m: {type: mass, at: p.corner1, mass: "
         "50 g, offset: " +
         offset +
         "}\ncaps: {a: {of: p.edge2}}\nmount: {a: rigid}\nanalyses: {static: false, modes: {count: "
         "4}, error_bars: false}\n";
}

bool warns_of(const Results& results, const std::string& what) {
  return std::any_of(results.warnings.begin(), results.warnings.end(),
                     [&](const std::string& w) { return w.find(what) != std::string::npos; });
}

TEST(Drilling, a_body_that_swings_on_it_is_warned_of) {
  const Results swings = run_silently(case_of(plate_with_body("[10 mm, 20 mm, 10 mm]")));
  EXPECT_TRUE(warns_of(swings, "about the normal of the wall"));
  EXPECT_TRUE(warns_of(swings, "mode 1")) << "the lowest one, which falls with the elements";
  const Results stands = run_silently(case_of(plate_with_body("[0, 20 mm, 0]")));
  EXPECT_FALSE(warns_of(stands, "about the normal of the wall"));
}

TEST(FoldedMesh, of_a_concave_plate_or_a_steep_dent_is_refused) {
  const auto message = [](const Case& data) { return first_problem_of([&] { build(data); }); };
  Case plate = case_of(plate_with_body("[0, 0, 0]"));
  auto& corners = std::get<Plate>(plate.parts.front().body).corners;
  EXPECT_EQ(message(plate), "no error");
  corners[2] = {-0.04, 0, -0.04};
  EXPECT_NE(message(plate).find("parts.p.corners: folds the mesh"), std::string::npos)
      << message(plate);
  Case dented = verification_case("bellows_a", {48, 4, 6}, 4);
  Bellows& bellows = bellows_of(dented);
  const double crown = bellows.root_radius + bellows.profile.front().height;
  double y = bellows.start;
  for (const MeridianSection& s : bellows.profile) y += s.length / 2 + s.count * s.pitch / 2;
  bellows.dents = {{.at = {0, y, crown}, .depth = 0.5e-3, .radius = 12e-3}};
  EXPECT_EQ(message(dented), "no error");
  bellows.dents[0].depth = 15e-3;
  EXPECT_NE(message(dented).find("dents[0]: folds the mesh"), std::string::npos) << message(dented);
}

// The truth is the whole model on the same mesh.
TEST(CutoffBar, holds_where_no_mode_lies_between_the_cutoff_and_its_double) {
  Case data = case_of(two_bellows("rigid", "", "modes: {count: 1}"));
  const double whole = run_silently(data).modes[0].frequency;
  data.analyses.reduction = SuperelementsInRun{.cutoff = 350};
  const Results reduced = run_silently(data);
  const double error = whole - reduced.modes[0].frequency;
  ASSERT_LT(error, -1e-2 * whole);
  const ErrorBars bars = error_bars(data, reduced, [](const std::string&) {});
  for (const ErrorBar& bar : bars.bars)
    if (bar.key == "f_axial") {
      EXPECT_NEAR(bar.mesh.cutoff / error, 1, 0.1);
    }
  EXPECT_NEAR(bars.modes[0].cutoff / error, 1, 0.1);
}

// Against three times as many elements each way, which still misses a ninth. Shell modes err most.
TEST(MeshError, of_every_mode_and_stress_is_estimated_with_its_sign) {
  Case data = verification_case("bellows_a", {32, 4, 5}, 24);
  data.analyses.stress.emplace();
  data.analyses.statics = true;
  const Results nominal = run_silently(data);
  const ErrorBars bars = error_bars(data, nominal, [](const std::string&) {});
  ASSERT_EQ(bars.modes.size(), nominal.modes.size());
  const Results fine = run_silently(refined(data, {.along = 3, .around = 3}));
  int shells = 0, compared = 0;
  for (std::size_t i = 0; i < nominal.modes.size(); ++i) {
    const ModeResult& mode = nominal.modes[i];
    const ModeResult* other = nullptr; // of the same name, the nearest
    for (const ModeResult& m : fine.modes)
      if (std::tie(mode.shape, mode.harmonic, mode.order, mode.direction) ==
              std::tie(m.shape, m.harmonic, m.order, m.direction) &&
          (!other ||
           std::abs(m.frequency - mode.frequency) < std::abs(other->frequency - mode.frequency)))
        other = &m;
    if (!other || std::abs(other->frequency / mode.frequency - 1) > 0.1) continue;
    const double missing = 9. / 8 * (other->frequency - mode.frequency);
    const MeshError& e = bars.modes[i];
    EXPECT_NEAR(e.total(), missing, 0.35 * (std::abs(e.along) + std::abs(e.around)))
        << "mode " << i + 1 << ", n = " << mode.harmonic;
    ++compared;
    shells += mode.harmonic >= 2;
  }
  EXPECT_GE(compared, 12);
  EXPECT_GE(shells, 1);
  ASSERT_EQ(bars.stresses.size(), nominal.stresses.size());
  for (std::size_t k = 0; k < 3; ++k) { // 1 mm axial, transverse x and z
    const double missing = 9. / 8 * (fine.stresses[k].largest - nominal.stresses[k].largest);
    const MeshError& e = bars.stresses[k];
    EXPECT_NEAR(e.total(), missing, 0.35 * (std::abs(e.along) + std::abs(e.around)))
        << fine.stresses[k].name << ": " << nominal.stresses[k].largest << " Pa, along " << e.along
        << ", around " << e.around;
  }
}

TEST(NastranDeck, names_a_set_of_supports_only_where_it_has_one) {
  const auto deck = [](const std::string& mount) {
    const Case data = case_of(two_bellows(mount, "", "modes: {count: 4}"));
    return nastran_model(data, build(data));
  };
  for (const char* open : {"free", "{stiffness: [1e6, 1e6, 1e6, 1e4, 1e4, 1e4]}"}) {
    EXPECT_EQ(deck(open).find("SPC = 1"), std::string::npos) << open;
    EXPECT_EQ(deck(open).find("SPC1"), std::string::npos) << open;
  }
  EXPECT_NE(deck("rigid").find("SPC = 1"), std::string::npos);
}

// Both edges of a band inside the rounding of a pair, by either route; and a band with nothing.
TEST(Band, cuts_no_pair_and_is_proved_when_empty) {
  Case data = case_of(two_bellows("rigid", "", "modes: {count: 6}, error_bars: false"));
  for (const Symmetry route : {Symmetry::off, Symmetry::required}) {
    data.analyses.symmetry = route;
    data.analyses.modes = Modes{.count = 6};
    const Results six = run_silently(data);
    const double pair = six.modes[1].frequency; // and 2
    for (const double nudge : {-1e-12, 0., 1e-12}) {
      const double edge = pair * (1 + nudge);
      data.analyses.modes = Modes{.count = 0, .band = {1, edge}};
      const std::size_t below = run_silently(data).modes.size();
      EXPECT_TRUE(below == 3 || below == 1) << below;
      data.analyses.modes = Modes{.count = 0, .band = {edge, 1.1 * pair}};
      const std::size_t above = run_silently(data).modes.size();
      EXPECT_TRUE(above == 2 || above == 0) << above;
    }
    data.analyses.modes = Modes{.count = 0, .band = {1, 2}};
    const Results none = run_silently(data);
    EXPECT_TRUE(none.modes.empty());
    EXPECT_TRUE(none.verification.made && none.verification.passed) << none.verification.reason;
  }
}

// Two masses, one 1e-13 of the other: what is left out is not said to be without mass.
TEST(FewerModes, than_asked_for_are_explained_truly) {
  const auto chain = [](const std::string& small) {
    return "case: two\nmaterials: {steel: {E: 200 GPa, nu: 0.3, rho: 8000}}\nparts:\n  r: {type: "
           "beam, points: [[0, 0, 0], [0, 1, 0], [0, 2, 0]], elements: 1, up: [0, 0, 1], section: "
           "{shape: general, EA: 1 MN, EI: 1000, GJ: 1000}}\n  a: {type: mass, at: \"r.point[2]\", "
           "mass: 1}\n  b: {type: mass, at: r.end, mass: " +
           small +
           "}\ncaps: {c: {of: r.start}}\nmount: {c: rigid}\nanalyses: {static: false, modes: "
           "{count: 10}, error_bars: false}\n";
  };
  const Results even = run_silently(case_of(chain("2")));
  EXPECT_EQ(even.modes.size(), 6u);
  EXPECT_TRUE(warns_of(even, "no more degrees of freedom have mass"));
  // Less far apart each is found, the last as the small mass on the EA of its beam.
  for (const auto& [small, m] : {std::pair{"1e-6", 1e-6}, {"1e-9", 1e-9}, {"1e-11", 1e-11}}) {
    const Results apart = run_silently(case_of(chain(small)));
    ASSERT_EQ(apart.modes.size(), 6u) << small;
    EXPECT_TRUE(apart.verification.passed) << small << ": " << apart.verification.reason;
    EXPECT_NEAR(apart.modes[5].frequency, std::sqrt(1e6 / m) / (2 * std::numbers::pi),
                1e-5 * apart.modes[5].frequency);
  }
  const Results uneven = run_silently(case_of(chain("1e-15")));
  EXPECT_FALSE(uneven.modes.size() < 6 && warns_of(uneven, "no more degrees of freedom have mass"));
}

// Mounts 1e7 times as stiff as what they hold have modes of their own, far up: not asked for.
TEST(ModesAsked, are_not_more_for_a_stiff_mount) {
  Case data = case_of(two_bellows("{stiffness: [1e15, 1e15, 1e15, 1e15, 1e15, 1e15]}", "",
                                  "modes: {count: 6}, error_bars: false"));
  for (const Symmetry route : {Symmetry::off, Symmetry::required}) {
    data.analyses.symmetry = route;
    const Results r = run_silently(data);
    EXPECT_TRUE(r.modes.size() == 6 || r.modes.size() == 7) << r.modes.size();
    EXPECT_TRUE(r.verification.passed) << r.verification.reason;
  }
}

// The part's own modes 7 and 8 stand in the other order than the reduced ones, by their shapes.
TEST(Certificate, pairs_frequencies_by_shape_where_they_cross) {
  Case data = case_of(two_bellows("free", "", "error_bars: false"));
  SuperelementRequest request;
  request.cutoff = 2000;
  const ReducedCase whole = reduce_case(data, request, [](const std::string&) {});
  const Superelement& s = whole.element;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(s.K, s.M);
  const Eigen::VectorXd lambda = modes.eigenvalues().head(14);
  int first = 6; // two modes that are no pair
  while (lambda[first + 1] < 1.001 * lambda[first]) ++first;
  PartReference part;
  part.rigid_mass.setIdentity();
  part.free_lambda = lambda;
  part.free_motion = modes.eigenvectors().topRows(s.boundary()).leftCols(14);
  part.free_motion.col(first).swap(part.free_motion.col(first + 1));
  const Certificate c = certificate(s, part);
  const auto check = [&](int i) { return c.free.at(std::size_t(i - 6)); };
  EXPECT_NEAR(check(first).reduced, frequency(lambda[first + 1]), 1e-6);
  EXPECT_NEAR(check(first + 1).reduced, frequency(lambda[first]), 1e-6);
  EXPECT_NEAR(check(6 + 7).reduced, check(6 + 7).full, 1e-6) << "the others stand as they were";
}

// Of a free body of which rigid modes alone are asked for, rounding is held against the elastic
// mode that lies beyond them, a hundred times `small`.
TEST(Rounding, of_rigid_modes_is_relative_to_the_first_elastic_one) {
  const Eigen::Vector2d rigid(1e-9, -2e-9), errors(1e-6, 3e-6);
  EXPECT_NEAR(relative_rounding(rigid, errors, 0.01), 3e-6 / 1, 1e-18);
  const Eigen::Vector3d lambda(1e-9, 4, 9), further(1e-6, 2e-6, 9e-6);
  EXPECT_NEAR(relative_rounding(lambda, further, 0.01), 9e-6 / 9, 1e-18);
}

TEST(ImpossibleModel, is_the_users_to_mend_and_says_why) {
  Case held = case_of(plate_with_body("[0, 0, 0]"));
  held.supports = {{.set = "p.all", .dofs = {0, 1, 2, 3, 4, 5}}};
  held.mount.clear();
  held.caps.clear();
  try {
    run_silently(held);
    FAIL() << "nothing can move";
  } catch (const ModelError& error) {
    EXPECT_NE(std::string(error.what()).find("nothing is free to move"), std::string::npos);
    EXPECT_EQ(error.sections.front(), "supports");
  }
  std::string massless = plate_with_body("[0, 0, 0]");
  massless.replace(massless.find("rho: 8000"), 9, "rho: 0");
  massless.replace(massless.find("  m: {"), massless.find("caps") - massless.find("  m: {"), "");
  EXPECT_THROW(run_silently(case_of(massless)), ModelError);
}

} // namespace
} // namespace plica::test
