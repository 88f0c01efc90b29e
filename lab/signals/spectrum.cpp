#include "lab/signals/spectrum.hpp"

#include "lab/signals/fourier.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plica {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd window_samples(Window window, int length) {
  // Sums of cosines a_0 - a_1 cos + a_2 cos 2 - ...; flat top after ISO 18431-2.
  static const std::vector<std::vector<double>> terms{
      {1}, {0.5, 0.5}, {0.54, 0.46}, {1, 1.933, 1.286, 0.388, 0.0322}};
  const std::vector<double>& a = terms[static_cast<std::size_t>(window)];
  VectorXd w = VectorXd::Zero(length);
  for (int n = 0; n < length; ++n)
    for (std::size_t j = 0; j < a.size(); ++j)
      w[n] += (j % 2 ? -1 : 1) * a[j] * std::cos(2 * std::numbers::pi * double(j) * n / length);
  return w;
}

double noise_bandwidth(const VectorXd& w) {
  return double(w.size()) * w.squaredNorm() / std::pow(w.sum(), 2);
}

namespace {

int hop_of(const WelchSettings& s) {
  return std::max(1, static_cast<int>(std::lround((1 - s.overlap) * s.block)));
}

void check(const MatrixXd& samples, double rate, const WelchSettings& s) {
  if (!(rate > 0)) throw std::invalid_argument("the sampling rate must be above zero");
  if (s.block < 8) throw std::invalid_argument("a block needs at least 8 samples");
  if (!(s.overlap >= 0 && s.overlap < 1))
    throw std::invalid_argument("the overlap must be at least 0 and below 1");
  if (samples.rows() < s.block)
    throw std::invalid_argument("the record of " + std::to_string(samples.rows()) +
                                " samples is shorter than one block of " + std::to_string(s.block));
}

// Transforms of the listed channels of one block: lines x channels.
MatrixXcd transformed(const MatrixXd& samples, const std::vector<int>& channels, Index start,
                      const VectorXd& w, Fourier& transform) {
  MatrixXcd X(w.size() / 2 + 1, Index(channels.size()));
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const VectorXd part = samples.col(channels[c]).segment(start, w.size());
    X.col(Index(c)) = transform.forward(((part.array() - part.mean()) * w.array()).matrix());
  }
  return X;
}

} // namespace

int usual_block(Index samples) {
  int block = 256;
  while (block * 20 <= samples) block *= 2;
  return block;
}

int block_count(Index samples, const WelchSettings& s) {
  return samples < s.block ? 0 : static_cast<int>((samples - s.block) / hop_of(s)) + 1;
}

double effective_averages(int blocks, const WelchSettings& s) {
  const VectorXd w = window_samples(s.window, s.block);
  const int hop = hop_of(s);
  double sum = 1;
  for (int q = 1; q < blocks && q * hop < s.block; ++q) {
    const int common = s.block - q * hop;
    const double rho = w.head(common).dot(w.tail(common)) / w.squaredNorm();
    sum += 2 * (1 - double(q) / blocks) * rho * rho;
  }
  return blocks / sum;
}

Spectra welch(const MatrixXd& samples, double rate, const std::vector<int>& references,
              const std::vector<int>& responses, const WelchSettings& s) {
  check(samples, rate, s);
  for (const auto* list : {&references, &responses})
    for (int channel : *list)
      if (channel < 0 || channel >= samples.cols())
        throw std::invalid_argument("there is no channel " + std::to_string(channel + 1));
  const VectorXd w = window_samples(s.window, s.block);
  const Index lines = s.block / 2 + 1, nx = Index(references.size()), ny = Index(responses.size());
  Spectra result;
  result.hertz = VectorXd::LinSpaced(lines, 0, double(lines - 1)) * rate / s.block;
  result.xx.assign(lines, MatrixXcd::Zero(nx, nx));
  result.xy.assign(lines, MatrixXcd::Zero(nx, ny));
  result.yy = MatrixXd::Zero(lines, ny);
  result.blocks = block_count(samples.rows(), s);
  result.averages = effective_averages(result.blocks, s);
  result.resolution = noise_bandwidth(w) * rate / s.block;
  Fourier transform(s.block);
  for (int k = 0; k < result.blocks; ++k) {
    const Index start = Index(k) * hop_of(s);
    const MatrixXcd X = transformed(samples, references, start, w, transform);
    const MatrixXcd Y = transformed(samples, responses, start, w, transform);
    for (Index f = 0; f < lines; ++f) {
      result.xx[f].noalias() += X.row(f).adjoint() * X.row(f);
      result.xy[f].noalias() += X.row(f).adjoint() * Y.row(f);
    }
    result.yy += Y.cwiseAbs2();
  }
  for (Index f = 0; f < lines; ++f) {
    const bool single = f == 0 || (s.block % 2 == 0 && f == lines - 1);
    const double scale = (single ? 1 : 2) / (result.blocks * rate * w.squaredNorm());
    result.xx[f] *= scale;
    result.xy[f] *= scale;
    result.yy.row(f) *= scale;
  }
  return result;
}

VectorXd band_rms(const VectorXd& hertz, const MatrixXd& density, double low, double high) {
  VectorXd square = VectorXd::Zero(density.cols());
  for (Index f = 0; f < hertz.size(); ++f) {
    const double below = f > 0 ? (hertz[f] - hertz[f - 1]) / 2 : 0;
    const double above = f + 1 < hertz.size() ? (hertz[f + 1] - hertz[f]) / 2 : 0;
    const double width = std::min(high, hertz[f] + above) - std::max(low, hertz[f] - below);
    if (width > 0) square += width * density.row(f).transpose();
  }
  return square.cwiseSqrt();
}

} // namespace plica
