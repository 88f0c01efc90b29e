// Modes that a test knows by their kind, without excitation: which of a model's they are.
#include "diagnose/predict/state_answers.hpp"

#include "diagnose/predict/passed_over.hpp"
#include "diagnose/predict/peak_choice.hpp"
#include "diagnose/predict/sensor_axes.hpp"
#include "lab/measured/measured_words.hpp"
#include "words/directions.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace plica {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// Whether a nominal mode is of the kind and direction that a mode was measured as.
bool is_of(const ModeLabel& label, MeasuredShape shape, int axis) {
  return shape == MeasuredShape::other ||
         (label.shape == word_of(shape) && (axis < 0 || label.direction == axis_word(axis)));
}

double looked_for(const Reading& r) { // Hz
  return r.paired_as > 0 ? r.paired_as : r.value;
}

} // namespace

// Modes of a kind, increasing: those that have more of nominal modes of this kind in them than of
// any other, and enough to be seen.
std::vector<Index> StateAnswers::modes_of_kind(const AffineModes& m, MeasuredShape shape,
                                               int axis) {
  if (const auto known = of_kind_.find({shape, axis}); is_linear(m) && known != of_kind_.end())
    return known->second;
  std::vector<Index> found;
  constexpr double seen = 0.01;
  const std::vector<ModeLabel>& labels = own_.nominal->labels;
  std::vector<int> other; // of each nominal mode: its kind, where it is not the one looked for
  for (std::size_t j = 0; j < labels.size(); ++j)
    other.push_back(is_of(labels[j], shape, axis) ? -1 : own_.nominal->kinds[j]);
  VectorXd shares(labels.size()); // of the others, by kind
  for (Index i = 0; i < m.lambda.size(); ++i) {
    double own = 0;
    shares.setZero();
    for (std::size_t j = 0; j < labels.size(); ++j)
      (other[j] < 0 ? own : shares[other[j]]) += std::pow(m.likeness(Index(j), i), 2);
    if (own > seen && own > shares.maxCoeff()) found.push_back(i);
  }
  if (is_linear(m)) of_kind_[{shape, axis}] = found;
  return found;
}

// Modes known by their kind: in their order, as they lie nearest.
double StateAnswers::labelled(const Reading& reading) {
  const bool is_component = reading.kind == ReadingKind::component;
  if (acting_.group && test_.runs[std::size_t(reading.run)].level > 0 && !is_component)
    return slipping_mode(reading);
  const AffineModes* m = linear_modes();
  if (!m) return not_given;
  const Index mode = labelled_mode(*m, reading);
  if (mode < 0) return not_given;
  if (is_component) return component(*m, mode, reading);
  return std::log(reading.kind == ReadingKind::damping ? damping_of(*m)[mode] : m->hertz(mode));
}

// A component of the shape of a mode as its sensor shows it, scaled as the measured shape is by
// least squares over the channels that the model has.
double StateAnswers::component(const AffineModes& m, Index mode, const Reading& reading) const {
  constexpr double moves = 1e-12; // of the square of all motions: below is rounding
  const ReadShape& shape = test_.shapes[std::size_t(reading.of_shape)];
  double along = 0, own = 0, here = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t c = 0; c < shape.values.size(); ++c) {
    const int sensor = own_.nominal->number_of(shape.sensors[c]);
    if (sensor < 0) continue;
    const Index row = 6 * Index(sensor);
    Eigen::Vector3d u = m.marked.block<3, 1>(row, mode);
    if (const auto moved = acting_.setup.moved.find(shape.sensors[c]);
        moved != acting_.setup.moved.end())
      u += Eigen::Vector3d(m.marked.block<3, 1>(row + 3, mode)).cross(moved->second);
    const auto turned = acting_.setup.reading.find(shape.sensors[c]);
    const double phi = seen_along(own_.nominal->axes[std::size_t(sensor)],
                                  turned == acting_.setup.reading.end() ? nullptr : &turned->second,
                                  shape.axes[c], u.cast<std::complex<double>>())[0]
                           .real();
    along += phi * shape.values[c];
    own += phi * phi;
    if (int(c) == reading.channel) here = phi;
  }
  if (own <= moves * m.marked.col(mode).squaredNorm()) return std::isfinite(here) ? 0 : here;
  return here * along / own;
}

// Where the kind of motion is known the order that the test states binds; where it states no
// direction, of those of that order along each axis the nearest.
Index StateAnswers::labelled_mode(const AffineModes& m, const Reading& reading) {
  if (reading.shape == MeasuredShape::other) {
    const std::map<int, Index> list = listed_modes(m, reading);
    const auto own = list.find(reading.order);
    return own == list.end() ? -1 : own->second;
  }
  Index nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  const bool either = reading.axis < 0 && reading.shape == MeasuredShape::transverse;
  for (int axis : either ? std::vector{0, 2} : std::vector{reading.axis}) {
    const std::vector<Index> modes = modes_of_kind(m, reading.shape, axis);
    if (reading.order > int(modes.size())) continue;
    const Index own = modes[std::size_t(reading.order - 1)];
    if (const double off = std::abs(std::log(m.hertz(own) / looked_for(reading))); off < least) {
      least = off;
      nearest = own;
    }
  }
  return nearest;
}

// Modes of unknown kind of one run and axis, by the order that the test gives them: in their order
// as they lie nearest, those passed over at a cost.
std::map<int, Index> StateAnswers::listed_modes(const AffineModes& m, const Reading& reading) {
  const std::pair of{reading.run, reading.axis};
  if (const auto known = listed_.find(of); is_linear(m) && known != listed_.end())
    return known->second;
  std::map<int, double> measured; // by order
  for (const Reading& r : test_.readings)
    if (r.kind == ReadingKind::frequency && r.run == reading.run && r.shape == reading.shape &&
        r.axis == reading.axis)
      measured[r.order] = looked_for(r);
  if (measured.empty()) return {};
  std::vector<Index> modes = modes_of_kind(m, reading.shape, reading.axis);
  const auto before = std::min(modes.size(), std::size_t(std::max(0, measured.begin()->first - 1)));
  modes.erase(modes.begin(), modes.begin() + Index(before));
  std::vector<double> wanted, hertz;
  Between between;
  int last = measured.begin()->first;
  for (const auto& [order, value] : measured) {
    wanted.push_back(value);
    between.missed.push_back(std::max(0, order - last - 1));
    last = order;
  }
  for (Index i : modes) {
    hertz.push_back(m.hertz(i));
    between.counts.push_back(
        may_move(own_.nominal->labels[std::size_t(m.nominal(i))], reading.axis));
  }
  std::map<int, Index> found;
  const std::vector<Index> pairs = paired(wanted, hertz, false, {}, between);
  for (auto next = pairs.begin(); const auto& [order, value] : measured) {
    found[order] = *next < 0 ? -1 : modes[std::size_t(*next)];
    ++next;
  }
  if (is_linear(m)) listed_[of] = found;
  return found;
}

} // namespace plica
