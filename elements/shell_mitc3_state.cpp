#include "elements/shell_mitc3_state.hpp"

#include "elements/shell_mitc3_kinematics.hpp"
#include "elements/strain_forms.hpp"

#include <Eigen/LU>

namespace plica {

using namespace mitc3;

namespace {

using Eigen::Vector2d;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6x6 = Eigen::Matrix<double, 6, 6>;
using Vectors6 = Eigen::Matrix<double, 3, 6>; // corners, then directors

Vectors6 vectors_of(const TriangleGeometry& g) {
  Vectors6 y;
  y << g.X, g.directors;
  return y;
}

Vector6 at_height(const Vector3d& corners, double z) {
  Vector6 a;
  a << corners, z * corners;
  return a;
}

// Symmetric matrix A of the covariant strain 1/2 sum A_pq y_p . y_q.
using Form = Matrix6x6;

Form product(const Vector6& a, const Vector6& b) {
  return a * b.transpose() + b * a.transpose();
}

double value(const Form& A, const Vectors6& y) {
  return (y * A).cwiseProduct(y).sum() / 2;
}

std::array<Form, 3> in_plane_forms(double z) {
  const Vector6 a_r = at_height(dr, z), a_s = at_height(ds, z);
  return {product(a_r, a_r) / 2, product(a_s, a_s) / 2, product(a_r, a_s)};
}

std::array<Form, 2> shear_forms(double r, double s) {
  static const TiedShear<Form> tied([](double a, double b, bool along_r) -> Form {
    Vector6 director;
    director << Vector3d::Zero(), shape_functions(a, b);
    return product(at_height(along_r ? dr : ds, 0), director);
  });
  return {tied.rz(s), tied.sz(r)};
}

struct StatePoint {
  double weight, z;
  LaminaFrame frame;
  std::array<Form, 3> in_plane_form;
  std::array<Form, 2> shear_form;
  Eigen::Matrix<double, 5, 18> B;     // in-plane and shear over increments
  Eigen::Matrix<double, 5, 2> bubble; // of the shape at rest
  Eigen::Matrix<double, 5, 1> strain;
};

StatePoint state_point(const TriangleGeometry& rest, const TriangleGeometry& now,
                       double thermal_strain, double r, double s, double z) {
  const Kinematics at_rest{rest}, at_state{now};
  StatePoint p{.weight = 0,
               .z = z,
               .frame = at_rest.frame(r, s, z),
               .in_plane_form = in_plane_forms(z),
               .shear_form = shear_forms(r, s),
               .B = {},
               .bubble = {},
               .strain = {}};
  const auto local = [&](const auto& e, const auto& shear) {
    Eigen::Matrix<double, 5, std::decay_t<decltype(e)>::ColsAtCompileTime> all;
    all << p.frame.in_plane * e, p.frame.shear * shear + p.frame.into_shear * e;
    return all;
  };
  p.B = local(at_state.in_plane(r, s, z), tied_shear(tied_rows(at_state), r, s))
            .template leftCols<18>();
  p.bubble = local(at_rest.in_plane(r, s, z), tied_shear(tied_rows(at_rest), r, s))
                 .template rightCols<2>();
  const Vectors6 y = vectors_of(now), y_rest = vectors_of(rest);
  const double grown = (1 + thermal_strain) * (1 + thermal_strain); // squares of lengths
  Vector3d e;
  Vector2d shear;
  for (std::size_t k = 0; k < 3; ++k)
    e[Eigen::Index(k)] = value(p.in_plane_form[k], y) - grown * value(p.in_plane_form[k], y_rest);
  for (std::size_t k = 0; k < 2; ++k)
    shear[Eigen::Index(k)] = value(p.shear_form[k], y) - grown * value(p.shear_form[k], y_rest);
  p.strain = local(e, shear);
  return p;
}

std::vector<StatePoint> state_points(const TriangleGeometry& rest, const TriangleGeometry& now,
                                     const ShellSection& section) {
  std::vector<StatePoint> points;
  points.reserve(12);
  for (const auto& [r, s, weight] : plane_points) {
    const double t = rest.thickness.dot(shape_functions(r, s));
    for (double side : {-1., 1.}) {
      const double z = side * std::sqrt(section.bending_factor) * t / 2 / std::sqrt(3.);
      points.push_back(state_point(rest, now, section.thermal_strain, r, s, z));
      points.back().weight =
          weight * points.back().frame.volume * t / 2 / (1 + section.thermal_strain);
    }
  }
  return points;
}

Eigen::Matrix<double, 5, 5> law_of(const ShellSection& section) {
  const ShellLaw law = shell_law(section);
  Eigen::Matrix<double, 5, 5> C = Eigen::Matrix<double, 5, 5>::Zero();
  C.topLeftCorner<3, 3>() = law.in_plane;
  C.bottomRightCorner<2, 2>() = law.shear;
  return C;
}

// The bubble's amplitudes, reached and per increment.
struct BubbleState {
  Eigen::Matrix<double, 2, 18> amplitudes;
  Vector2d reached;

  BubbleState(const ShellSection& section, const std::vector<StatePoint>& points) {
    const Eigen::Matrix<double, 5, 5> C = law_of(section);
    Eigen::Matrix2d K_aa = Eigen::Matrix2d::Zero();
    Eigen::Matrix<double, 2, 18> K_au = Eigen::Matrix<double, 2, 18>::Zero();
    Vector2d f = Vector2d::Zero();
    for (const StatePoint& p : points) {
      const Eigen::Matrix<double, 2, 5> weighted = p.weight * p.bubble.transpose() * C;
      K_aa += weighted * p.bubble;
      K_au += weighted * p.B;
      f += weighted * p.strain;
    }
    const Eigen::Matrix2d inverse = K_aa.inverse();
    amplitudes = -inverse * K_au;
    reached = -inverse * f;
  }

  void add_to(StatePoint& p) const {
    p.B += p.bubble * amplitudes;
    p.strain += p.bubble * reached;
  }
};

const std::array<CarriedBy, 6>& carriers() {
  static const std::array<CarriedBy, 6> all{
      {{0, false}, {1, false}, {2, false}, {0, true}, {1, true}, {2, true}}};
  return all;
}

} // namespace

ElementTangent<18> shell_mitc3_tangent(const TriangleGeometry& rest, const TriangleGeometry& cold,
                                       const NodeRotations<3>& turned, const ShellSection& section,
                                       StiffnessPart part) {
  const TriangleGeometry now = with_grown_wall(cold, section.thermal_strain);
  const Eigen::Matrix<double, 5, 5> C = law_of(section);
  std::vector<StatePoint> points = state_points(rest, now, section);
  const BubbleState bubble(section, points);
  ElementTangent<18> tangent{Matrix18::Zero(), Eigen::Matrix<double, 18, 1>::Zero()};
  Matrix6x6 H = Matrix6x6::Zero();
  for (StatePoint& p : points) {
    bubble.add_to(p);
    const Eigen::Matrix<double, 5, 1> stress = p.weight * C * p.strain;
    if (part == StiffnessPart::all)
      tangent.K.noalias() += p.weight * p.B.transpose() * (C * p.B).eval();
    tangent.force += p.B.transpose() * stress;
    const Vector3d covariant = p.frame.in_plane.transpose() * stress.head<3>() +
                               p.frame.into_shear.transpose() * stress.tail<2>();
    const Vector2d across = p.frame.shear.transpose() * stress.tail<2>();
    for (std::size_t k = 0; k < 3; ++k) H += covariant[Eigen::Index(k)] * p.in_plane_form[k];
    for (std::size_t k = 0; k < 2; ++k) H += across[Eigen::Index(k)] * p.shear_form[k];
  }
  add_geometric_stiffness(H, vectors_of(now), carriers(), tangent.K);
  const double modulus = part == StiffnessPart::all ? shell_law(section).drilling : 0;
  for (const auto& [r, s, weight] : drilling_points) {
    const Vector3d h = shape_functions(r, s);
    const DrillingTie<3> tie = drilling_tie<3>(rest.X, now.X, turned, h, dr, ds);
    const double stiffness = weight * twice_area(rest) * modulus * rest.thickness.dot(h);
    tangent.K.noalias() += stiffness * tie.row.transpose() * tie.row;
    tangent.force += stiffness * tie.value * tie.row.transpose();
  }
  tangent.K = ((tangent.K + tangent.K.transpose()) / 2).eval();
  return tangent;
}

Eigen::Matrix<double, 36, 1> shell_mitc3_state_stress(const TriangleGeometry& rest,
                                                      const TriangleGeometry& cold,
                                                      const ShellSection& section) {
  const TriangleGeometry now = with_grown_wall(cold, section.thermal_strain);
  const BubbleState bubble(section, state_points(rest, now, section));
  const double fibre = std::sqrt(section.bending_factor) / 2;
  Eigen::Matrix<double, 36, 1> stress;
  for (int corner = 0; corner < 3; ++corner) {
    const double r = corner == 1, s = corner == 2;
    for (int face : {0, 1}) {
      const double z = (face == 0 ? -fibre : fibre) * rest.thickness[corner];
      StatePoint p = state_point(rest, now, section.thermal_strain, r, s, z);
      bubble.add_to(p);
      stress.segment<6>(12 * corner + 6 * face) =
          stress_to_global(Kinematics{now}.frame(r, s, z).basis) *
          (law_of(section) * p.strain).head<3>() / std::pow(1 + section.thermal_strain, 2);
    }
  }
  return stress;
}

} // namespace plica
