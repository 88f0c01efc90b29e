#include "diagnose/readings/shape_readings.hpp"

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <fmt/format.h>
#include <map>

namespace plica {
namespace {

using Eigen::VectorXd;

// What stays complex of a vector where it is turned to be most real, of its length.
struct Turned {
  VectorXd real;
  double complexity = 0;
};

Turned turned(const MeasuredVector& v) {
  Eigen::VectorXcd z(v.real.size());
  for (std::size_t i = 0; i < v.real.size(); ++i)
    z[Eigen::Index(i)] = {v.real[i], v.imaginary.empty() ? 0 : v.imaginary[i]};
  const std::complex<double> square = z.array().square().sum();
  z *= std::polar(1., -std::arg(square) / 2);
  return {z.real(), z.imag().norm() / std::max(z.norm(), 1e-300)};
}

// The sign of a shape is nobody's: that of an earlier one of the same mode, which looks like it.
void turn_like_an_earlier_one(ReadShape& shape, const std::vector<ReadShape>& earlier) {
  constexpr double alike = 0.7; // correlation
  const auto of = [](const ReadShape& s) {
    return VectorXd::Map(s.values.data(), Eigen::Index(s.values.size()));
  };
  double most = alike;
  bool turn = false;
  for (const ReadShape& other : earlier) {
    if (other.sensors != shape.sensors || other.axes != shape.axes) continue;
    const double correlation = of(shape).dot(of(other)) / (of(shape).norm() * of(other).norm());
    if (std::abs(correlation) <= most) continue;
    most = std::abs(correlation);
    turn = correlation < 0;
  }
  if (turn)
    for (double& x : shape.values) x = -x;
}

} // namespace

void add_shape_readings(const MeasuredMode& mode, const Reading& frequency, ReadingList& list) {
  if (!mode.vector || mode.vector->channels.size() < 2) return;
  constexpr double nearly_real = 0.3;
  const Turned shape = turned(*mode.vector);
  const double largest = shape.real.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return;
  if (shape.complexity > nearly_real) {
    list.all.warnings.push_back(fmt::format(
        "the shape of {} ({}) is no reading: {:.0f} % of it is out of phase, more than {:.0f}",
        frequency.name, frequency.entry, 100 * shape.complexity, 100 * nearly_real));
    return;
  }
  ReadShape read;
  for (const std::string& channel : mode.vector->channels) {
    read.sensors.push_back(channel.substr(0, channel.rfind('.')));
    read.axes.push_back(channel.back() - 'x');
    read.values.push_back(shape.real[Eigen::Index(read.values.size())] / largest);
  }
  turn_like_an_earlier_one(read, list.all.shapes);
  for (std::size_t c = 0; c < read.values.size(); ++c) {
    Reading reading = frequency;
    reading.kind = ReadingKind::component;
    reading.name = frequency.name + ": " + mode.vector->channels[c];
    reading.unit = "";
    reading.of_shape = int(list.all.shapes.size());
    reading.channel = int(c);
    reading.value = read.values[c];
    reading.paired_as = frequency.value;
    reading.sigma = shape_sigma;
    reading.assumed = true;
    list.add(std::move(reading));
  }
  list.all.shapes.push_back(std::move(read));
}

void leave_out_unlike_shapes(const VectorXd& nominal, TestReadings& test) {
  constexpr double alike = 0.5; // share of a shape that the model's has, of its square
  struct Likeness {
    double measured = 0, modelled = 0;
    const Reading* first = nullptr;
  };
  std::map<int, Likeness> all;
  for (std::size_t i = 0; i < test.readings.size(); ++i) {
    const Reading& r = test.readings[i];
    const double model = nominal[Eigen::Index(i)];
    if (r.kind != ReadingKind::component || !std::isfinite(model)) continue;
    Likeness& own = all[r.of_shape];
    own.measured += r.value * r.value;
    own.modelled += model * model; // scaled by least squares: its square is MAC times the other
    if (!own.first) own.first = &r;
  }
  std::map<int, bool> left_out;
  for (const auto& [shape, own] : all) {
    left_out[shape] = own.modelled < alike * own.measured;
    if (left_out[shape])
      test.warnings.push_back(fmt::format(
          "the shape of {} ({}) is no reading: the mode of the model that it is paired with looks "
          "different, MAC {:.2f}; it may be another mode, or one of a pair that lies close",
          own.first->name.substr(0, own.first->name.find(':')), own.first->entry,
          own.modelled / own.measured));
  }
  std::erase_if(test.readings, [&](const Reading& r) {
    return r.kind == ReadingKind::component && left_out[r.of_shape];
  });
}

} // namespace plica
