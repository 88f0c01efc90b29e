#include "diagnose/readings/shape_readings.hpp"

#include "words/directions.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <fmt/format.h>
#include <map>
#include <set>

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

// Channels that are read: those along the direction of the mode where they show most of it, and of
// many some that lie evenly along the list, for neighbours say the same.
std::vector<std::size_t> read_channels(const MeasuredVector& v, const VectorXd& real, int axis) {
  constexpr std::size_t most = 8;
  std::vector<std::size_t> all, along;
  double seen = 0;
  for (std::size_t i = 0; i < v.channels.size(); ++i) {
    all.push_back(i);
    if (axis_of_channel(v.channels[i]) != axis) continue;
    along.push_back(i);
    seen += std::pow(real[Eigen::Index(i)], 2);
  }
  const std::vector<std::size_t>& own =
      along.size() >= 2 && seen > real.squaredNorm() / 2 ? along : all;
  if (own.size() <= most) return own;
  std::vector<std::size_t> spread;
  for (std::size_t k = 0; k < most; ++k) spread.push_back(own[k * (own.size() - 1) / (most - 1)]);
  return spread;
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
  for (const std::string& channel : mode.vector->channels)
    if (!is_translation(channel)) {
      list.all.warnings.push_back(
          fmt::format("the shape of {} ({}) is no reading: channel {} is no "
                      "sensor and axis, such as mid.y",
                      frequency.name, frequency.entry, channel));
      return;
    }
  constexpr double nearly_real = 0.3;
  const Turned shape = turned(*mode.vector);
  if (!(shape.real.cwiseAbs().maxCoeff() > 0)) return;
  if (shape.complexity > nearly_real) {
    list.all.warnings.push_back(fmt::format(
        "the shape of {} ({}) is no reading: {:.0f} % of it is out of phase, more than {:.0f}",
        frequency.name, frequency.entry, 100 * shape.complexity, 100 * nearly_real));
    return;
  }
  const std::vector<std::size_t> chosen = read_channels(*mode.vector, shape.real, frequency.axis);
  double largest = 0;
  for (std::size_t i : chosen) largest = std::max(largest, std::abs(shape.real[Eigen::Index(i)]));
  if (!(largest > 0)) return;
  ReadShape read;
  for (std::size_t i : chosen) {
    const std::string& channel = mode.vector->channels[i];
    read.sensors.emplace_back(sensor_of_channel(channel));
    read.axes.push_back(axis_of_channel(channel));
    read.values.push_back(shape.real[Eigen::Index(i)] / largest);
  }
  turn_like_an_earlier_one(read, list.all.shapes);
  for (std::size_t c = 0; c < read.values.size(); ++c) {
    Reading reading = frequency;
    reading.kind = ReadingKind::component;
    reading.name = frequency.name + ": " + mode.vector->channels[chosen[c]];
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
    if (r.kind != ReadingKind::component) continue;
    Likeness& own = all[r.of_shape];
    own.measured += r.value * r.value;
    own.modelled += model * model; // scaled by least squares: its square is MAC times the other
    if (!own.first) own.first = &r;
  }
  std::set<int> left_out;
  for (const auto& [shape, own] : all) {
    if (own.modelled >= alike * own.measured) continue;
    left_out.insert(shape);
    test.warnings.push_back(fmt::format(
        "the shape of {} ({}) is no reading: the mode of the model that it is paired with looks "
        "different, MAC {:.2f}; it may be another mode, or one of a pair that lies close",
        own.first->name.substr(0, own.first->name.find(':')), own.first->entry,
        own.modelled / own.measured));
  }
  std::erase_if(test.readings, [&](const Reading& r) { return left_out.contains(r.of_shape); });
}

} // namespace plica
