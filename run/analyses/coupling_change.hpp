// What damping that couples modes, and stiffness over frequency, change in the motion of the
// sensors beside each mode by itself: the difference of the two steady responses at the lines of a
// Fourier transform. Only this difference sees a transform, motion in time mode by mode does not.
#pragma once

#include "run/analyses/sensor_model.hpp"

#include <functional>
#include <optional>
#include <string>

namespace plica {

// Samples of dt until the mode that rings longest has died out to e^-10, not rounded.
double ringing_samples(const DampedModes& modes, double dt);

struct TransformLines {
  Eigen::Index length = 0; // samples, a power of two
  Eigen::Index count = 0;  // lines from zero up to twice the highest mode
  double spacing = 0;      // Hz
};

// Of a transform of at least `samples` of dt; `series`: of the lines that are kept at a time,
// `room` numbers at most. Empty where that is too much, or four million samples.
std::optional<TransformLines> transform_lines(double samples, double dt, const ModalModel& by_mode,
                                              Eigen::Index series, double room);

// Takes the change of the absolute accelerations over the excitation block by block: its first
// line, the circular frequencies of its lines (rad/s), lines x channels.
using TakeChange =
    std::function<void(Eigen::Index, const Eigen::VectorXd&, const Eigen::MatrixXcd&)>;

// At every line but that of zero. `by_mode`: of `excited` as its one load, each mode with its own
// damping; `carried`: what it carries of each channel.
void for_each_change(const TransformLines& lines, const SensorModel& model,
                     const ExcitedColumns& excited, const ModalModel& by_mode,
                     const Eigen::RowVectorXd& carried, const TakeChange& take);

// Why the difference is left out where there are no lines: "WHAT is long: ...".
std::string too_long_for_coupling(const std::string& what);

} // namespace plica
