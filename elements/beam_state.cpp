#include "elements/beam_state.hpp"

#include "elements/strain_forms.hpp"

#include <cmath>
#include <vector>

namespace plica {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Vector6 = Eigen::Matrix<double, 6, 1>;

// Vectors of two nodes: place, arm to the end of the axis, and three axes of each.
constexpr int place_of = 0, arm_of = 1, axes_of = 2, of_one_node = 5;
using Vectors10 = Eigen::Matrix<double, 3, 2 * of_one_node>;
using Vector10 = Eigen::Matrix<double, 2 * of_one_node, 1>;
using Matrix10 = Eigen::Matrix<double, 2 * of_one_node, 2 * of_one_node>;

const std::array<CarriedBy, 2 * of_one_node>& line_carriers() {
  static const std::array<CarriedBy, 2 * of_one_node> all{{{0, false},
                                                           {0, true},
                                                           {0, true},
                                                           {0, true},
                                                           {0, true},
                                                           {1, false},
                                                           {1, true},
                                                           {1, true},
                                                           {1, true},
                                                           {1, true}}};
  return all;
}

Vector10 unit(int node, int which) {
  return Vector10::Unit(of_one_node * node + which);
}

// Symmetric matrix A of the strain 1/2 sum A_pq y_p . y_q.
Matrix10 dot(const Vector10& a, const Vector10& b) {
  return a * b.transpose() + b * a.transpose();
}

// Rotation of the second triad against the first about axis k, half the sum of two products.
Matrix10 turn_about(int k, const std::array<Vector10, 3>& first,
                    const std::array<Vector10, 3>& second) {
  const auto m = std::size_t((k + 1) % 3), n = std::size_t((k + 2) % 3);
  return (dot(first[n], second[m]) - dot(first[m], second[n])) / 2;
}

struct LineStrains {
  std::array<Matrix10, 6> forms;
  Vector6 at_rest = Vector6::Zero();

  Vector6 value(const Vectors10& y) const {
    Vector6 v;
    for (std::size_t k = 0; k < 6; ++k)
      v[Eigen::Index(k)] = (y * forms[k]).cwiseProduct(y).sum() / 2;
    return v - at_rest;
  }

  // Over increments of the twelve DOFs.
  Eigen::Matrix<double, 6, 12> rows(const Vectors10& y) const {
    Eigen::Matrix<double, 6, 12> B = Eigen::Matrix<double, 6, 12>::Zero();
    for (std::size_t k = 0; k < 6; ++k) {
      const Vectors10 f = y * forms[k];
      for (int p = 0; p < 2 * of_one_node; ++p) {
        const CarriedBy c = line_carriers()[std::size_t(p)];
        const Vector3d force = f.col(p);
        B.block<1, 3>(Eigen::Index(k), 6 * c.node + (c.turns ? 3 : 0)) +=
            (c.turns ? Vector3d(y.col(p)).cross(force) : force).transpose();
      }
    }
    return B;
  }
};

// Stress of the strains and how it changes with them, both per whole element.
struct LineLaw {
  Vector6 stress;
  Matrix6 C;
};

ElementTangent<12> tangent_of(const LineStrains& strains, const Vectors10& y, const LineLaw& law) {
  const Eigen::Matrix<double, 6, 12> B = strains.rows(y);
  ElementTangent<12> tangent{B.transpose() * law.C * B, B.transpose() * law.stress};
  Matrix10 H = Matrix10::Zero();
  for (std::size_t k = 0; k < 6; ++k) H += law.stress[Eigen::Index(k)] * strains.forms[k];
  add_geometric_stiffness(H, y, line_carriers(), tangent.K);
  tangent.K = ((tangent.K + tangent.K.transpose()) / 2).eval();
  return tangent;
}

Matrix3d beam_triad(const BeamGeometry& g) {
  const Vector3d x = (g.node2 + g.offset2 - g.node1 - g.offset1).normalized();
  const Vector3d z = (g.up - g.up.dot(x) * x).normalized();
  Matrix3d R;
  R << x, z.cross(x), z;
  return R;
}

double beam_length(const BeamGeometry& g) {
  return (g.node2 + g.offset2 - g.node1 - g.offset1).norm();
}

LineStrains beam_strains(double L) {
  const auto arm_end = [](int node) -> Vector10 {
    return unit(node, place_of) + unit(node, arm_of);
  };
  const Vector10 slope = (arm_end(1) - arm_end(0)) / L;
  std::array<Vector10, 3> middle, change;
  for (int k = 0; k < 3; ++k) {
    const Vector10 first = unit(0, axes_of + k), second = unit(1, axes_of + k);
    middle[std::size_t(k)] = (first + second) / 2;
    change[std::size_t(k)] = (second - first) / L;
  }
  LineStrains s;
  for (int k = 0; k < 3; ++k) {
    s.forms[std::size_t(k)] = dot(middle[std::size_t(k)], slope);
    s.forms[std::size_t(3 + k)] = turn_about(k, middle, change);
  }
  s.at_rest[0] = 1;
  return s;
}

double in_series(double GA, double EI, double L) {
  if (EI == 0) return 0;
  return 1 / (1 / GA + L * L / (12 * EI));
}

double shear_share(double GA, double EI, double L) {
  const double phi = std::isinf(GA) ? 0 : 12 * EI / (GA * L * L);
  return 1 + 0.2 / ((1 + phi) * (1 + phi));
}

// What the squares of the strains add to the axial one.
Vector6 lengthening(const BeamProperties& s, double L) {
  Vector6 longer;
  longer << 0, shear_share(s.GA_y, s.EI_z, L), shear_share(s.GA_z, s.EI_y, L),
      s.EA > 0 ? (s.EI_y + s.EI_z) / s.EA : 0, L * L / 3, L * L / 3;
  return longer;
}

double axial(const Vector6& strain, const Vector6& longer) {
  return strain[0] + longer.dot(strain.cwiseProduct(strain)) / 2;
}

LineLaw beam_law(const BeamProperties& s, double L, const Vector6& strain, StiffnessPart part) {
  const Vector6 longer = lengthening(s, L);
  Vector6 stiffness; // of the other strains
  stiffness << 0, in_series(s.GA_y, s.EI_z, L), in_series(s.GA_z, s.EI_y, L), s.GJ, s.EI_y, s.EI_z;
  const double e = axial(strain, longer) - s.thermal_strain;
  const double N = s.tightened ? *s.tightened : s.EA * e;
  Vector6 along = longer.cwiseProduct(strain); // of e
  along[0] = 1;
  LineLaw law{.stress = L * (stiffness + N * longer).cwiseProduct(strain),
              .C = (s.tightened ? 0 : L * s.EA) * along * along.transpose()};
  law.stress[0] = L * N;
  if (part == StiffnessPart::by_stress) {
    stiffness.setZero();
    law.C.setZero();
  }
  law.C.diagonal() += L * (stiffness + N * longer);
  return law;
}

Vectors10 line_vectors(const std::array<Vector3d, 2>& place, const std::array<Vector3d, 2>& arm,
                       const std::array<Matrix3d, 2>& axes) {
  Vectors10 y;
  for (std::size_t i = 0; i < 2; ++i)
    y.middleCols<of_one_node>(of_one_node * Eigen::Index(i)) << place[i], arm[i], axes[i];
  return y;
}

Vectors10 beam_vectors(const BeamGeometry& rest, const Vector3d& node1, const Vector3d& node2,
                       const NodeRotations<2>& turned) {
  const Matrix3d triad = beam_triad(rest);
  return line_vectors({node1, node2}, {turned[0] * rest.offset1, turned[1] * rest.offset2},
                      {turned[0] * triad, turned[1] * triad});
}

LineStrains bushing_strains() {
  const auto at_point = [](int node) -> Vector10 {
    return unit(node, place_of) + unit(node, arm_of);
  };
  std::array<Vector10, 3> first, second;
  for (int k = 0; k < 3; ++k) {
    first[std::size_t(k)] = unit(0, axes_of + k);
    second[std::size_t(k)] = unit(1, axes_of + k);
  }
  LineStrains strains;
  for (int k = 0; k < 3; ++k) {
    strains.forms[std::size_t(k)] = dot(first[std::size_t(k)], at_point(1) - at_point(0));
    strains.forms[std::size_t(3 + k)] = turn_about(k, first, second);
  }
  return strains;
}

Vectors10 bushing_vectors(const Bushing& bushing, const MovedNode& node1, const MovedNode& node2,
                          const Vector3d& point) {
  return line_vectors({node1.now, node2.now},
                      {node1.turned * (point - node1.rest), node2.turned * (point - node2.rest)},
                      {node1.turned * bushing.axes, node2.turned * bushing.axes});
}

} // namespace

ElementTangent<12> beam_tangent(const BeamGeometry& rest, const BeamProperties& section,
                                const Vector3d& node1, const Vector3d& node2,
                                const NodeRotations<2>& turned, StiffnessPart part) {
  const double L = beam_length(rest);
  const LineStrains strains = beam_strains(L);
  const Vectors10 y = beam_vectors(rest, node1, node2, turned);
  return tangent_of(strains, y, beam_law(section, L, strains.value(y), part));
}

double beam_axial_strain(const BeamGeometry& rest, const BeamProperties& section,
                         const Vector3d& node1, const Vector3d& node2,
                         const NodeRotations<2>& turned) {
  const double L = beam_length(rest);
  return axial(beam_strains(L).value(beam_vectors(rest, node1, node2, turned)),
               lengthening(section, L));
}

VectorXd beam_state_stress(const BeamGeometry& rest, const BeamProperties& section,
                           const Vector3d& node1, const Vector3d& node2,
                           const NodeRotations<2>& turned) {
  const double L = beam_length(rest);
  const LineStrains strains = beam_strains(L);
  const Vector6 strain = strains.value(beam_vectors(rest, node1, node2, turned));
  const Vector6 force = beam_law(section, L, strain, StiffnessPart::all).stress / L;
  const auto count = Eigen::Index(section.fibres.size());
  VectorXd stress(2 * count);
  for (int end : {0, 1}) {
    // The moment of the middle, and what the shear adds over half the length.
    const double half = end == 0 ? -L / 2 : L / 2;
    const double M_y = force[4] + half * force[2], M_z = force[5] - half * force[1];
    for (Eigen::Index k = 0; k < count; ++k) {
      const auto& [y, z] = section.fibres[std::size_t(k)];
      stress[end * count + k] =
          section.E * (force[0] / section.EA + z * M_y / section.EI_y - y * M_z / section.EI_z);
    }
  }
  return stress;
}

BushingMotion bushing_motion(const Bushing& bushing, const MovedNode& node1, const MovedNode& node2,
                             const Vector3d& point) {
  const LineStrains strains = bushing_strains();
  const Vectors10 y = bushing_vectors(bushing, node1, node2, point);
  return {strains.value(y), strains.rows(y)};
}

ElementTangent<12> bushing_tangent(const Bushing& bushing, const MovedNode& node1,
                                   const MovedNode& node2, const Vector3d& point,
                                   StiffnessPart part) {
  const LineStrains strains = bushing_strains();
  const Vectors10 y = bushing_vectors(bushing, node1, node2, point);
  const Matrix6 law = part == StiffnessPart::all ? bushing.law : Matrix6(Matrix6::Zero());
  return tangent_of(strains, y, {bushing.law * strains.value(y) + bushing.preload, law});
}

} // namespace plica
