#include "diagnose/weigh/rig_errors.hpp"

#include "compare/compare_stiffness.hpp"
#include "run/study/part_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

bool same_motion(const Reading& a, const Reading& b) {
  return is_of_rig(a) && is_of_rig(b) && a.kind == b.kind && a.state == b.state &&
         a.entry == b.entry && a.axis == b.axis && rig_motion(a) == rig_motion(b);
}

MeasuredStiffness number_of(const Reading& r) {
  return {.hertz = r.rig.hertz,
          .direction = r.axis,
          .kind = r.rig.driving_point ? StiffnessKind::driving_point : StiffnessKind::transfer,
          .quantity = r.kind == ReadingKind::loss ? StiffnessQuantity::loss_angle
                      : r.rig.storage             ? StiffnessQuantity::storage
                                                  : StiffnessQuantity::magnitude};
}

} // namespace

std::string rig_motion(const Reading& r) {
  std::string motion = r.rig.driving_point ? "driving point" : "transfer";
  for (const std::string& end : r.rig.ends) motion += ", " + end;
  return motion;
}

void add_common_rig_error(const TestReadings& test, MatrixXd& measurement) {
  constexpr double common = 0.5;
  for (Index i = 0; i < measurement.rows(); ++i)
    for (Index j = 0; j < measurement.cols(); ++j) {
      const Reading &a = test.readings[std::size_t(i)], &b = test.readings[std::size_t(j)];
      if (i != j && same_motion(a, b)) measurement(i, j) += common * a.sigma * b.sigma;
    }
}

MatrixXd shared_rig_loss(const TestReadings& test, double sigma) {
  const auto n = Index(test.readings.size());
  MatrixXd S = MatrixXd::Zero(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      const Reading &a = test.readings[std::size_t(i)], &b = test.readings[std::size_t(j)];
      if (a.kind == ReadingKind::loss && same_motion(a, b)) S(i, j) = sigma * sigma;
    }
  return S;
}

RigMeshCorrection rig_mesh_correction(const Case& data, const Measured& measured,
                                      const TestReadings& test, const VectorXd& coarse) {
  const auto corrected = [&](const Reading& r) {
    return is_of_rig(r) && std::none_of(measured.states.begin(), measured.states.end(),
                                        [&](const MeasuredState& s) {
                                          return s.name == r.state && !s.numbers.empty();
                                        });
  };
  RigMeshCorrection correction{VectorXd::Zero(coarse.size()),
                               std::vector<std::string>(std::size_t(coarse.size()))};
  std::set<std::vector<std::string>> ends;
  for (const Reading& r : test.readings)
    if (corrected(r)) ends.insert(r.rig.ends);
  for (const std::vector<std::string>& own : ends) {
    StiffnessRequest request;
    request.ends = own;
    request.hertz = VectorXd::Zero(1);
    std::vector<MeasuredStiffness> numbers;
    std::vector<Index> rows;
    for (Index i = 0; i < coarse.size(); ++i) {
      const Reading& r = test.readings[std::size_t(i)];
      if (!corrected(r) || r.rig.ends != own) continue;
      numbers.push_back(number_of(r));
      rows.push_back(i);
      request.hertz[0] = std::max(request.hertz[0], r.rig.hertz);
    }
    std::vector<StiffnessComparison> fine;
    try {
      const EndDynamicStiffness found = part_stiffness(data, request, [](const std::string&) {});
      fine = compare_stiffness(found, numbers, request.harmonics, request.samples);
    } catch (const std::runtime_error& error) { // what the case says, or no equilibrium
      for (const Index i : rows) correction.refused[std::size_t(i)] = error.what();
      continue;
    }
    constexpr double so_far = 0.3; // more is another resonance
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const bool loss = numbers[k].quantity == StiffnessQuantity::loss_angle;
      const double value = loss ? std::sin(fine[k].computed) : fine[k].computed;
      const double off = std::log(std::abs(value)) - coarse[rows[k]];
      if (std::abs(off) < so_far) correction.log[rows[k]] = off;
    }
  }
  return correction;
}

} // namespace plica
