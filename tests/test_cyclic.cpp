// Rotational symmetry against the full mesh: the same numbers, harmonic by harmonic.
#include "tests/bellows_case.hpp"
#include "tests/support/fields.hpp"

#include "reduction/cyclic_modes.hpp"
#include "solve/statics.hpp"

#include <Eigen/Cholesky>

namespace plica::test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Two caps with mass, a liner between the caps or moving with the wall.
Case pipe(Attachment attachment, const std::optional<LinerContact>& contact = {}) {
  Case data = verification_case("bellows_a", {20, 2, 3}, 12);
  data.caps[0].mass = 0.2;
  data.caps[1].mass = 0.1;
  data.caps[1].offset = {0, 0.004, 0};
  data.caps[1].inertia = {1e-4, 2e-4, 1e-4, 0, 0, 0};
  data.parts.push_back({"liner", Interlock{.along = "bellows",
                                           .attachment = attachment,
                                           .stations = 3,
                                           .contact = contact,
                                           .EA = 2e3,
                                           .EI = 1,
                                           .GJ = 0.5,
                                           .mass = 0.1,
                                           .radius = 0.02}});
  return data;
}

CyclicModel symmetric(const Model& model) {
  auto view = cyclic_model(model);
  EXPECT_TRUE(std::holds_alternative<CyclicModel>(view)) << std::get<std::string>(view);
  return std::get<CyclicModel>(std::move(view));
}

std::vector<Harmonic> all_families(const CyclicModel& model) {
  std::vector<Harmonic> all;
  for (int n = 0; n < model.harmonics(); ++n)
    for (bool sine : {false, true}) all.push_back({n, sine});
  return all;
}

// T' K T over all harmonics is block diagonal with the blocks of `system`, and they are complete.
TEST(CyclicModel, splits_the_full_matrices_into_harmonics_without_loss) {
  const LinerContact springs{.axial = 2e4, .lateral = 3e4, .bending = 5, .torsion = 7};
  for (const Case& data : {pipe(Attachment::caps), pipe(Attachment::stations),
                           pipe(Attachment::synchronous), pipe(Attachment::stations, springs)}) {
    const BuiltCase built = build(data);
    const System full = assemble(built.model);
    const CyclicModel model = symmetric(built.model);
    Eigen::Index unknowns = 0;
    for (const Harmonic& h : all_families(model)) {
      if (h.n > 3 && h.n < model.harmonics() - 1) {
        unknowns += model.system(h).K.rows();
        continue;
      }
      const HarmonicSystem s = model.system(h);
      unknowns += s.K.rows();
      const VectorXd q = VectorXd::Random(s.K.rows());
      const VectorXd u = model.expand(s, q);
      // Independent DOFs of the field; the dependent ones follow by the same constraints.
      VectorXd independent(full.map.size());
      for (int i = 0; i < full.map.size(); ++i) independent[i] = u[full.map.full[i]];
      EXPECT_LT((expand(full.map, independent) - u).norm(), 1e-12 * u.norm()) << h.n << h.sine;
      const VectorXd force = symmetric_product(full.K, independent);
      VectorXd on_all = VectorXd::Zero(dof_count(built.model));
      for (int i = 0; i < full.map.size(); ++i) on_all[full.map.full[i]] = force[i];
      const VectorXd wanted = model.gather(s, on_all), found = symmetric_product(s.K, q);
      EXPECT_LT((found - wanted).norm(), 1e-9 * found.norm()) << h.n << h.sine;
      const VectorXd inertia = symmetric_product(full.M, independent);
      for (int i = 0; i < full.map.size(); ++i) on_all[full.map.full[i]] = inertia[i];
      const VectorXd Mq = symmetric_product(s.M, q);
      EXPECT_LT((Mq - model.gather(s, on_all)).norm(), 1e-9 * Mq.norm()) << h.n << h.sine;
    }
    EXPECT_EQ(unknowns, full.map.size()) << "every unknown of the full mesh in one harmonic";
  }
}

TEST(CyclicModel, holds_the_rigid_motions) {
  const BuiltCase built = build(pipe(Attachment::synchronous));
  const System full = assemble(built.model);
  const CyclicModel model = symmetric(built.model);
  const MatrixXd wanted =
      expand(full.map, rigid_body_motions(built.model, full.map, Eigen::Vector3d::Zero()));
  MatrixXd found = MatrixXd::Zero(wanted.rows(), 6);
  for (const Harmonic h :
       {Harmonic{0, false}, Harmonic{0, true}, Harmonic{1, false}, Harmonic{1, true}}) {
    const HarmonicSystem s = model.system(h);
    found += model.expand(s, model.rigid_motions(s));
  }
  EXPECT_LT((found - wanted).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(CyclicModel, quarter_turned_family_is_the_sine_family) {
  const BuiltCase built = build(pipe(Attachment::stations));
  const CyclicModel model = symmetric(built.model);
  for (int n : {1, 2, 5}) {
    const HarmonicSystem turned = model.quarter_turned(model.system({n, false}));
    const HarmonicSystem sine = model.system({n, true});
    EXPECT_LT((turned.K - sine.K).norm(), 1e-12 * sine.K.norm());
    const VectorXd q = VectorXd::Random(sine.K.rows());
    EXPECT_LT((model.expand(turned, q) - model.expand(sine, q)).norm(), 1e-12 * q.norm());
  }
}

TEST(CyclicModes, are_those_of_the_full_mesh_and_counted) {
  for (const bool held : {true, false}) {
    const BuiltCase built = build(pipe(Attachment::synchronous));
    const CyclicModel model = symmetric(built.model);
    std::vector<int> caps;
    for (const auto& [name, node] : built.cap_nodes) caps.push_back(node);
    const System full = assemble(built.model);
    std::vector<int> held_dofs;
    if (held)
      for (int node : caps)
        for (int dof = 6 * node; dof < 6 * node + 6; ++dof)
          held_dofs.push_back(full.map.independent[dof]);
    std::sort(held_dofs.begin(), held_dofs.end());
    const std::vector<int> free = complement(full.map.size(), held_dofs);
    const SparseMatrix K = restrict_to(full.K, free), M = restrict_to(full.M, free);
    BaseFactor base = factor_below_spectrum(K, M);
    const ModeSet wanted = plica::find_modes(K, M, {.count = 30}, base);
    ASSERT_TRUE(wanted.proof.passed);
    const CyclicModes found =
        find_cyclic_modes(model, held ? caps : std::vector<int>{}, {.count = 30});
    EXPECT_TRUE(found.proof.passed) << found.proof.reason;
    ASSERT_GE(found.modes.size(), 30u);
    const double elastic = wanted.lambda[29];
    for (int i = 0; i < 30; ++i)
      EXPECT_NEAR(found.modes[i].lambda, wanted.lambda[i],
                  1e-8 * std::max(wanted.lambda[i], 1e-3 * elastic))
          << i;
    EXPECT_LT(found.proof.max_residual, 1e-6);
  }
}

// The torsion of a free bellows has one rigid mode, far nearer to the first shift than all others,
// and rotations without inertia, which rounding must not let grow.
TEST(CyclicModes, of_torsion_bear_a_shift_near_the_rigid_mode) {
  const BuiltCase built = build(verification_case("bellows_a", {20, 2, 3}, 12));
  const CyclicFamily family = cyclic_family(symmetric(built.model), {0, true}, {});
  BaseFactor base = factor_below_spectrum(family.K, family.M);
  const VectorXd wanted = plica::find_modes(family.K, family.M, {.count = 8}, base).lambda;
  for (const double nearness : {1e-2, 1e-4, 1e-6, 1e-7, 1e-8}) {
    const double sigma = -nearness * wanted[1];
    SparseFactor factor(family.K);
    ASSERT_TRUE(factor.factorise(shifted(family.K, family.M, sigma)).ok) << nearness;
    const EigenPairs pairs = lanczos(family.M, factor, sigma, {.count = 20});
    ASSERT_TRUE(pairs.converged) << nearness << ": " << pairs.reason;
    for (int i = 1; i < 8; ++i)
      EXPECT_NEAR(pairs.values[i] / wanted[i], 1, 1e-8 + 1e-13 / nearness)
          << nearness << ", mode " << i + 1;
  }
}

TEST(CyclicModes, in_a_band_are_all_there) {
  const BuiltCase built = build(verification_case("cylinder_clamped"));
  const CyclicModel model = symmetric(built.model);
  const CyclicModes some = find_cyclic_modes(model, built.held_nodes, {.count = 20});
  ASSERT_TRUE(some.proof.passed) << some.proof.reason;
  const double high = frequency(some.modes[13].lambda) * 1.0001,
               low = frequency(some.modes[2].lambda) * 0.9999;
  const CyclicModes band = find_cyclic_modes(model, built.held_nodes, {.band = {low, high}});
  EXPECT_TRUE(band.proof.passed) << band.proof.reason;
  EXPECT_EQ(band.modes.size(), 12u);
}

TEST(CyclicSymmetry, says_what_breaks_it) {
  const auto reason = [](const std::function<void(Model&)>& harm) {
    BuiltCase built = build(pipe(Attachment::synchronous));
    harm(built.model);
    const auto view = cyclic_model(built.model);
    return std::holds_alternative<std::string>(view) ? std::get<std::string>(view) : "";
  };
  EXPECT_EQ(reason([](Model&) {}), "");
  EXPECT_NE(reason([](Model& m) { m.mesh.nodes[25].x() += 1e-4; }).find("node 26 is off its ring"),
            std::string::npos);
  EXPECT_NE(reason([](Model& m) { m.mesh.quads[7].thickness *= 0.9; }).find("wall of sector 8"),
            std::string::npos);
  EXPECT_NE(reason([](Model& m) {
              m.masses.push_back({30, {.mass = 0.01}});
            }).find("sits on the wall"),
            std::string::npos);
  EXPECT_NE(reason([](Model& m) {
              m.masses.back().body.offset = {0.01, 0, 0};
            }).find("not the same in all directions"),
            std::string::npos);
  EXPECT_NE(reason([](Model& m) { add_support(m, {40}, {1}, "clamp"); }).find("not held evenly"),
            std::string::npos);
  EXPECT_NE(reason([](Model& m) {
              add_support(m, {m.masses[0].node}, {0}, "guide");
            }).find("held in x or z alone"),
            std::string::npos);
  EXPECT_NE(reason([](Model& m) { m.mesh.rings.clear(); }).find("no shell of revolution"),
            std::string::npos);
}

} // namespace
} // namespace plica::test
