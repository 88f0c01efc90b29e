// Lower sampling rates: a low-pass of finite length, of which only the output is kept where it lies
// wholly within the record.
//
// A sum of damped sinusoids stays one with the same poles: each is multiplied by the response of
// the filter at its own pole, the same in all channels. Linear phase, Kaiser's window for 80 dB
// (Kaiser, IEEE ISCAS 1974; Oppenheim and Schafer, Discrete-Time Signal Processing, 7.5).
#pragma once

#include <Eigen/Core>

namespace plica {

struct Decimated {
  Eigen::MatrixXd samples; // time x channels
  double rate = 0;         // Hz
  int factor = 1;          // 1 = as it was
};

// To the lowest whole part of the rate that is at least four times `high`; what folds into 0 to
// `high` is 80 dB down. Ten of the new samples are lost. Unchanged where no factor of two fits.
Decimated decimated(const Eigen::MatrixXd& samples, double rate, double high);

} // namespace plica
