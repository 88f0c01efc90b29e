#include "elements/shell_mitc4_state.hpp"

#include "elements/shell_mitc4_kinematics.hpp"
#include "elements/strain_forms.hpp"

#include <Eigen/LU>

namespace plica {

using namespace mitc4;

namespace {

using Vector8 = Eigen::Matrix<double, 8, 1>;
using Matrix8 = Eigen::Matrix<double, 8, 8>;
using Vectors8 = Eigen::Matrix<double, 3, 8>; // corners, then directors
using Vector5 = Eigen::Matrix<double, 5, 1>;

Vectors8 vectors_of(const ShellGeometry& g) {
  Vectors8 y;
  y << g.X, g.directors;
  return y;
}

Vector8 at_height(const Vector4d& corners, double z) {
  Vector8 a;
  a << corners, z * corners;
  return a;
}

Vector8 of_directors(const Vector4d& corners) {
  Vector8 a;
  a << Vector4d::Zero(), corners;
  return a;
}

// A covariant strain a . b, half of it where a = b.
struct Form {
  Vector8 a, b;
  double factor;

  double value(const Vectors8& y) const { return factor * (y * a).dot(y * b); }
  void add(double stress, Matrix8& H) const {
    H += stress * factor * (a * b.transpose() + b * a.transpose());
  }
};
Form square(const Vector8& a) {
  return {a, a, 0.5};
}
Form product(const Vector8& a, const Vector8& b) {
  return {a, b, 1};
}

std::array<Form, 3> in_plane_forms(double r, double s, double z) {
  const Shape n = shape_functions(r, s);
  const Vector8 a_r = at_height(n.dr, z), a_s = at_height(n.ds, z);
  return {square(a_r), square(a_s), product(a_r, a_s)};
}

Form shear_form(double r, double s, bool along_r) {
  const Shape n = shape_functions(r, s);
  return product(at_height(along_r ? n.dr : n.ds, 0), of_directors(n.N));
}

// rr_A rr_B ss_C ss_D rs_E of MITC4+.
std::array<Form, 5> tied_forms() {
  Form rs = in_plane_forms(0, 0, 0)[2];
  rs.factor /= 2;
  return {in_plane_forms(0, 1, 0)[0], in_plane_forms(0, -1, 0)[0], in_plane_forms(1, 0, 0)[1],
          in_plane_forms(-1, 0, 0)[1], rs};
}

// The forms of all strains at one point, with what they are multiplied by.
struct PointForms {
  double r, s, z;
  MembraneStrain membrane;
  const MembraneTies& ties;

  template <class F> void in_plane(F&& f) const { // f(row, factor, form)
    const auto here = in_plane_forms(r, s, z);
    for (int k = 0; k < 3; ++k) f(k, 1., here[std::size_t(k)]);
    if (membrane != MembraneStrain::mitc4_plus) return;
    const auto middle = in_plane_forms(r, s, 0);
    for (int k = 0; k < 3; ++k) f(k, -1., middle[std::size_t(k)]);
    static const auto tied = tied_forms();
    for (int k = 0; k < 3; ++k)
      for (int t = 0; t < 5; ++t) f(k, ties(k, t), tied[std::size_t(t)]);
  }

  template <class F> void shear(F&& f) const {
    f(0, (1 + s) / 2, shear_form(0, 1, true));
    f(0, (1 - s) / 2, shear_form(0, -1, true));
    f(1, (1 + r) / 2, shear_form(1, 0, false));
    f(1, (1 - r) / 2, shear_form(-1, 0, false));
  }
};

// Rows of the covariant strains over increments from the shape now, with the ties of that at rest.
CovariantStrain strain_now(const ShellGeometry& now, MembraneStrain membrane,
                           const MembraneTies& ties, double r, double s) {
  const bool tied = membrane == MembraneStrain::mitc4_plus;
  CovariantStrain c = covariant_strain(now, tied ? MembraneStrain::displacement : membrane, r, s);
  if (tied) c.e = ties * tied_membrane(now);
  return c;
}

struct StatePoint {
  double r, s, z, weight;
  LaminaFrame frame;
  ShellStrainMatrix B;   // over increments
  Vector3d strain;       // in the lamina at rest
  Eigen::Vector2d shear; // transverse
  MembraneTies ties;
};

StatePoint state_point(const ShellGeometry& rest, const ShellGeometry& now, MembraneStrain membrane,
                       double thermal_strain, double r, double s, double z) {
  const Shape n = shape_functions(r, s);
  StatePoint p{.r = r,
               .s = s,
               .z = z,
               .weight = 0,
               .frame = {},
               .B = {},
               .strain = {},
               .shear = {},
               .ties = membrane_ties(rest, r, s)};
  p.frame = local_frame(rest, membrane, n, z);
  p.B = local_strain(strain_now(now, membrane, p.ties, r, s), p.frame, z);
  const Vectors8 y = vectors_of(now), y_rest = vectors_of(rest);
  Vector3d covariant = Vector3d::Zero();
  Eigen::Vector2d across = Eigen::Vector2d::Zero();
  const PointForms forms{r, s, z, membrane, p.ties};
  const double grown = (1 + thermal_strain) * (1 + thermal_strain); // squares of lengths
  const auto change = [&](const Form& form) { return form.value(y) - grown * form.value(y_rest); };
  forms.in_plane([&](int k, double f, const Form& form) { covariant[k] += f * change(form); });
  forms.shear([&](int k, double f, const Form& form) { across[k] += f * change(form); });
  p.strain = p.frame.in_plane * covariant;
  p.shear = p.frame.shear * across + p.frame.into_shear * covariant;
  return p;
}

// Adds the incompatible modes, condensed, to rows and strains.
struct InternalState {
  Matrix4x24 amplitudes = Matrix4x24::Zero(); // per increment
  Vector4d reached = Vector4d::Zero();
  LaminaFrame centre;

  InternalState(const ShellGeometry& rest, const Matrix3d& C, const std::vector<StatePoint>& points)
      : centre(centre_frame(rest)) {
    Eigen::Matrix4d K_aa = Eigen::Matrix4d::Zero();
    Matrix4x24 K_au = Matrix4x24::Zero();
    Vector4d f = Vector4d::Zero();
    for (const StatePoint& p : points) {
      const Matrix3x4 modes = internal_modes(centre, p.r, p.s, p.frame.volume);
      const Eigen::Matrix<double, 4, 3> weighted = p.weight * modes.transpose() * C;
      K_aa += weighted * modes;
      K_au += weighted * p.B.in_plane;
      f += weighted * p.strain;
    }
    const Eigen::Matrix4d inverse = K_aa.inverse();
    amplitudes = -inverse * K_au;
    reached = -inverse * f;
  }

  void add_to(StatePoint& p) const {
    const Matrix3x4 modes = internal_modes(centre, p.r, p.s, p.frame.volume);
    p.B.in_plane += modes * amplitudes;
    p.strain += modes * reached;
  }
};

std::vector<StatePoint> state_points(const ShellGeometry& rest, const ShellGeometry& now,
                                     const ShellSection& section, MembraneStrain membrane) {
  std::vector<StatePoint> points;
  points.reserve(8);
  for (int i = 0; i < 4; ++i) {
    const double r = gauss_point * corner_r[i], s = gauss_point * corner_s[i];
    const double t = rest.thickness.dot(shape_functions(r, s).N);
    for (double side : {-1., 1.}) {
      const double z = side * std::sqrt(section.bending_factor) * t / 2 * gauss_point;
      points.push_back(state_point(rest, now, membrane, section.thermal_strain, r, s, z));
      points.back().weight = points.back().frame.volume * t / 2 / (1 + section.thermal_strain);
    }
  }
  return points;
}

const std::array<CarriedBy, 8>& carriers() {
  static const std::array<CarriedBy, 8> all{
      {{0, false}, {1, false}, {2, false}, {3, false}, {0, true}, {1, true}, {2, true}, {3, true}}};
  return all;
}

void add_drilling(const ShellGeometry& rest, const ShellGeometry& now,
                  const NodeRotations<4>& turned, double modulus, ElementTangent<24>& tangent) {
  for (int i = 0; i < 4; ++i) {
    const Shape n = shape_functions(gauss_point * corner_r[i], gauss_point * corner_s[i]);
    const DrillingTie<4> tie = drilling_tie<4>(rest.X, now.X, turned, n.N, n.dr, n.ds);
    const double stiffness = modulus * rest.thickness.dot(n.N) * area(rest, n);
    tangent.K.noalias() += stiffness * tie.row.transpose() * tie.row;
    tangent.force += stiffness * tie.value * tie.row.transpose();
  }
}

} // namespace

ElementTangent<24> shell_mitc4_tangent(const ShellGeometry& rest, const ShellGeometry& cold,
                                       const NodeRotations<4>& turned, const ShellSection& section,
                                       MembraneStrain membrane, StiffnessPart part) {
  const ShellGeometry now = with_grown_wall(cold, section.thermal_strain);
  const ShellLaw law = shell_law(section);
  std::vector<StatePoint> points = state_points(rest, now, section, membrane);
  if (membrane == MembraneStrain::incompatible) {
    const InternalState internal(rest, law.in_plane, points);
    for (StatePoint& p : points) internal.add_to(p);
  }
  ElementTangent<24> tangent{Matrix24::Zero(), Eigen::Matrix<double, 24, 1>::Zero()};
  Matrix8 H = Matrix8::Zero();
  for (const StatePoint& p : points) {
    const Vector3d in_plane = p.weight * law.in_plane * p.strain;
    const Eigen::Vector2d shear = p.weight * law.shear * p.shear;
    if (part == StiffnessPart::all)
      tangent.K.noalias() +=
          p.weight * (p.B.in_plane.transpose() * (law.in_plane * p.B.in_plane).eval() +
                      p.B.shear.transpose() * (law.shear * p.B.shear).eval());
    tangent.force += p.B.in_plane.transpose() * in_plane + p.B.shear.transpose() * shear;
    const Vector3d covariant =
        p.frame.in_plane.transpose() * in_plane + p.frame.into_shear.transpose() * shear;
    const Eigen::Vector2d across = p.frame.shear.transpose() * shear;
    const PointForms forms{p.r, p.s, p.z, membrane, p.ties};
    forms.in_plane([&](int k, double f, const Form& form) { form.add(f * covariant[k], H); });
    forms.shear([&](int k, double f, const Form& form) { form.add(f * across[k], H); });
  }
  add_geometric_stiffness(H, vectors_of(now), carriers(), tangent.K);
  if (part == StiffnessPart::all) add_drilling(rest, now, turned, law.drilling, tangent);
  tangent.K = ((tangent.K + tangent.K.transpose()) / 2).eval();
  return tangent;
}

Eigen::Matrix<double, 48, 1> shell_mitc4_state_stress(const ShellGeometry& rest,
                                                      const ShellGeometry& cold,
                                                      const ShellSection& section,
                                                      MembraneStrain membrane) {
  const ShellGeometry now = with_grown_wall(cold, section.thermal_strain);
  const Matrix3d C = shell_law(section).in_plane;
  const double fibre = std::sqrt(section.bending_factor) / 2;
  const InternalState internal(rest, C, state_points(rest, now, section, membrane));
  Eigen::Matrix<double, 48, 1> stress;
  for (int corner = 0; corner < 4; ++corner) {
    const double r = corner_r[corner], s = corner_s[corner];
    for (int face : {0, 1}) {
      const double z = (face == 0 ? -fibre : fibre) * rest.thickness[corner];
      StatePoint p = state_point(rest, now, membrane, section.thermal_strain, r, s, z);
      if (membrane == MembraneStrain::incompatible) internal.add_to(p);
      const LaminaFrame here = local_frame(now, membrane, shape_functions(r, s), z);
      stress.segment<6>(12 * corner + 6 * face) =
          stress_to_global(here.basis) * C * p.strain / std::pow(1 + section.thermal_strain, 2);
    }
  }
  return stress;
}

} // namespace plica
