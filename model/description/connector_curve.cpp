#include "model/description/connector_curve.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace plica {
namespace {

// Value of a piecewise linear function given by columns `x` and `y` of its points.
double interpolate(const ForceCurve& curve, std::size_t x, std::size_t y, double at) {
  std::size_t i = 1;
  while (i + 1 < curve.size() && curve[i][x] < at) ++i;
  const double t = (at - curve[i - 1][x]) / (curve[i][x] - curve[i - 1][x]);
  return curve[i - 1][y] + t * (curve[i][y] - curve[i - 1][y]);
}

// Displacement of one element in a direction.
double stretch(const ConnectorSpring& s, bool axial, double force) {
  const ForceCurve& curve = axial ? s.axial_curve : s.transverse_curve;
  if (!curve.empty()) return displacement_at(curve, force);
  return force / (axial ? s.axial : s.transverse);
}

// All springs of a chain from left to right.
std::vector<const ConnectorSpring*> springs_of(const ConnectorChain& chain) {
  std::vector<const ConnectorSpring*> all(std::size_t(chain.count), &chain.spring);
  if (chain.end_spring) all.front() = all.back() = &*chain.end_spring;
  return all;
}

double bending_compliance(const ConnectorChain& chain) {
  const auto springs = springs_of(chain);
  const double element = (chain.length - 2 * chain.arms) / chain.count;
  double weight = 0, mean = 0, sum = 0;
  for (std::size_t i = 0; i < springs.size(); ++i) {
    weight += 1 / springs[i]->bending;
    mean += (double(i) + 0.5) * element / springs[i]->bending;
  }
  mean /= weight;
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const double arm = (double(i) + 0.5) * element - mean;
    sum += arm * arm / springs[i]->bending;
  }
  return sum;
}

} // namespace

double stiffness_at_rest(const ForceCurve& curve) {
  for (std::size_t i = 1; i < curve.size(); ++i)
    if (curve[i][0] <= curve[i - 1][0] || curve[i][1] <= curve[i - 1][1])
      throw std::invalid_argument("a tabulated force does not increase");
  const auto rest =
      std::find_if(curve.begin(), curve.end(), [](const auto& p) { return p[0] == 0; });
  const auto before = rest == curve.begin() ? rest : rest - 1;
  const auto after = rest + 1 == curve.end() ? rest : rest + 1;
  return ((*after)[1] - (*before)[1]) / ((*after)[0] - (*before)[0]);
}

double displacement_at(const ForceCurve& curve, double force) {
  return interpolate(curve, 1, 0, force);
}

double force_at(const ForceCurve& curve, double displacement) {
  return interpolate(curve, 0, 1, displacement);
}

std::vector<StrokeCurve> stroke_curves(const ConnectorChain& chain) {
  std::vector<StrokeCurve> curves;
  for (const bool axial : {true, false}) {
    std::set<double> forces;
    for (const ConnectorSpring* s : springs_of(chain))
      for (const auto& point : axial ? s->axial_curve : s->transverse_curve)
        forces.insert(point[1]);
    if (forces.empty()) continue;
    const double bending = axial ? 0 : bending_compliance(chain);
    StrokeCurve curve{.direction = axial ? StrokeCurve::along : StrokeCurve::across, .points = {}};
    for (const double force : forces) {
      double u = force * bending;
      for (const ConnectorSpring* s : springs_of(chain)) u += stretch(*s, axial, force);
      curve.points.push_back({u, force});
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

} // namespace plica
