// Patch tests: states of constant strain must come out exactly on distorted meshes.
//
//   4-----------------3     0.24 x 0.12, E = 1e6, nu = 0.25, t = 0.001; the boundary is prescribed,
//   | \    8----7   / |     the four inner nodes are free.
//   |  5 ------- 6    |
//   1-----------------2     MacNeal & Harder, Finite Elem. Anal. Des. 1 (1985) 3-20.
#include "tests/support/patch.hpp"
#include "tests/support/shell_cases.hpp"
#include "words/directions.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace {

using namespace plica;
using namespace plica::test;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double exact = 1e-10; // relative

// The boundary follows the field, the inner nodes find their place.
VectorXd solve_patch(const Model& model, const Field& field) {
  const MatrixXd K = dense(assemble(model).K);
  VectorXd u = nodal_values(model.mesh, field);
  u.tail(24) = -K.bottomRightCorner(24, 24).ldlt().solve(K.bottomLeftCorner(24, 24) * u.head(24));
  return u;
}

class Patch : public testing::TestWithParam<std::pair<std::string, MembraneStrain>> {
protected:
  Model model = shell_model(patch_mesh(t), {.E = E, .nu = nu, .rho = 1}, GetParam().second);

  // Stress sigma11 sigma22 tau12 and shear strain in global axes, at every Gauss point.
  void for_each_point(const VectorXd& u,
                      const std::function<void(const Vector3d& stress, const Eigen::Vector2d& shear,
                                               double z)>& check) const {
    for (const ShellQuad& quad : model.mesh.quads) {
      const ShellGeometry g = shell_geometry(model.mesh, quad);
      VectorXd u_e(24);
      for (int i = 0; i < 4; ++i) u_e.segment<6>(6 * i) = u.segment<6>(6 * quad.nodes[i]);
      for (const ShellPoint& p :
           shell_mitc4_points(g, model.shells[0].section, GetParam().second)) {
        const Vector3d s = shell_law(model.shells[0].section).in_plane * p.strain.in_plane * u_e;
        Eigen::Matrix3d tensor;
        tensor << s[0], s[2], 0, s[2], s[1], 0, 0, 0, 0;
        tensor = p.strain.basis * tensor * p.strain.basis.transpose();
        const Vector3d gamma = p.strain.basis.leftCols<2>() * (p.strain.shear * u_e);
        check({tensor(0, 0), tensor(1, 1), tensor(0, 1)}, gamma.head<2>(), p.z);
      }
    }
  }

  void expect_field(const VectorXd& u, const Field& field) const {
    const VectorXd wanted = nodal_values(model.mesh, field);
    for (int d = 0; d < 6; ++d) { // each kind of DOF against its own size
      const VectorXd difference = (u - wanted).reshaped(6, 8).row(d);
      const double size = VectorXd(wanted.reshaped(6, 8).row(d)).norm();
      const double unit = d < 3 ? 1e-3 * 0.24 : 1e-3;
      EXPECT_LE(difference.norm(), exact * (size > 0 ? size : unit)) << dof_name(d);
    }
  }
};

// eps_x = eps_y = gamma = 1e-3: sigma = 1333.33, tau = 400. The drilling rotation follows the
// membrane's, (v,x - u,y)/2 = 0.
TEST_P(Patch, passes_membrane_patch) {
  const Field field = [](double x, double y) {
    return NodeMotion(1e-3 * NodeMotion(x + y / 2, y + x / 2, 0, 0, 0, 0));
  };
  const VectorXd u = solve_patch(model, field);
  expect_field(u, field);
  for_each_point(u, [](const Vector3d& stress, const Eigen::Vector2d&, double) {
    EXPECT_NEAR(stress[0], 4000. / 3, 1333 * exact);
    EXPECT_NEAR(stress[1], 4000. / 3, 1333 * exact);
    EXPECT_NEAR(stress[2], 400, 400 * exact);
  });
}

// Surface stress 0.6667, 0.6667, 0.2000, changing sign through the wall: m = D (1 + nu) 1e-3.
TEST_P(Patch, passes_bending_patch) {
  const Field field = [](double x, double y) {
    return NodeMotion(1e-3 *
                      NodeMotion(0, 0, (x * x + x * y + y * y) / 2, y + x / 2, -(x + y / 2), 0));
  };
  const VectorXd u = solve_patch(model, field);
  expect_field(u, field);
  const double D = E * t * t * t / (12 * (1 - nu * nu));
  EXPECT_NEAR(D * (1 + nu) * 1e-3, 1.1111e-7, 1e-11);
  for_each_point(u, [](const Vector3d& stress, const Eigen::Vector2d& shear, double z) {
    const double at_surface = -t / 2 / z; // w,xx > 0 compresses the upper side
    EXPECT_NEAR(stress[0] * at_surface, 2. / 3, exact);
    EXPECT_NEAR(stress[1] * at_surface, 2. / 3, exact);
    EXPECT_NEAR(stress[2] * at_surface, 0.2, exact);
    EXPECT_LE(shear.norm(), 1e-6 * exact / 1e-3);
  });
}

// w = c x y: twist alone, tau at the surface G t c.
TEST_P(Patch, passes_twist_patch) {
  const Field field = [](double x, double y) {
    return NodeMotion(1e-3 * NodeMotion(0, 0, x * y, x, -y, 0));
  };
  const VectorXd u = solve_patch(model, field);
  expect_field(u, field);
  for_each_point(u, [](const Vector3d& stress, const Eigen::Vector2d&, double z) {
    EXPECT_NEAR(stress[0], 0, 0.4 * exact);
    EXPECT_NEAR(stress[1], 0, 0.4 * exact);
    EXPECT_NEAR(stress[2] * -t / 2 / z, E / (2 * (1 + nu)) * t * 1e-3, 0.4 * exact);
  });
}

// w = a x + b y with directors at rest. Constant transverse shear is no equilibrium state of a
// plate (it bends), so the strains are tested: exact in every distorted element, nothing else.
TEST_P(Patch, constant_transverse_shear_is_exact_on_distorted_elements) {
  const VectorXd u = nodal_values(model.mesh, [](double x, double y) {
    return NodeMotion(1e-3 * NodeMotion(0, 0, x + 0.5 * y, 0, 0, 0));
  });
  for_each_point(u, [](const Vector3d& stress, const Eigen::Vector2d& shear, double) {
    EXPECT_LE(stress.norm(), E * 1e-3 * exact);
    EXPECT_NEAR(shear[0], 1e-3, 1e-3 * exact);
    EXPECT_NEAR(shear[1], 0.5e-3, 1e-3 * exact);
  });
}

// The same patch, turned in space: nothing depends on the axes.
TEST_P(Patch, passes_membrane_and_bending_patch_turned_in_space) {
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(0.8, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  Field field = [](double x, double y) {
    return NodeMotion(1e-3 * NodeMotion(x + y / 2, y + x / 2, (x * x + x * y + y * y) / 2,
                                        y + x / 2, -(x + y / 2), 0));
  };
  const VectorXd flat = nodal_values(model.mesh, field);
  Model turned = model;
  for (Vector3d& x : turned.mesh.nodes) x = R * x;
  for (ShellQuad& quad : turned.mesh.quads) quad.directors = R * quad.directors;
  VectorXd wanted(48);
  for (int k = 0; k < 16; ++k) wanted.segment<3>(3 * k) = R * flat.segment<3>(3 * k);
  const MatrixXd K = dense(assemble(turned).K);
  const VectorXd inner =
      -K.bottomRightCorner(24, 24).ldlt().solve(K.bottomLeftCorner(24, 24) * wanted.head(24));
  EXPECT_LE((inner - wanted.tail(24)).norm(), exact * wanted.tail(24).norm());
}

INSTANTIATE_TEST_SUITE_P(Membranes, Patch, testing::ValuesIn(membranes),
                         [](const auto& choice) { return choice.param.first; });

} // namespace
