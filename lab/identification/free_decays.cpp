#include "lab/identification/free_decays.hpp"

#include "lab/identification/decay_fit.hpp"
#include "lab/identification/mode_correlation.hpp"
#include "lab/identification/mode_of_fit.hpp"
#include "lab/identification/spread.hpp"
#include "lab/identification/state_space.hpp"
#include "lab/identification/time_band.hpp"
#include "lab/signals/decay_window.hpp"
#include "lab/signals/decimation.hpp"
#include "lab/signals/fourier.hpp"
#include "words/input_error.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr int usual_decay_order = 30; // pairs of poles

struct CutDecays {
  Decays y; // of one length
  std::vector<std::string> names, channels;
  double rate = 0, low = 0, high = 0;
};

void check_alike(const std::vector<TimeRecord>& records) {
  for (const TimeRecord& r : records) {
    if (r.channels != records[0].channels)
      input_error("channels", "differ from those of " + records[0].name,
                  "decays of the same channels, in one order");
    if (std::abs(r.rate / records[0].rate - 1) > 1e-6)
      input_error("rate",
                  fmt::format("is {:g} Hz, that of {} is {:g} Hz", r.rate, records[0].name,
                              records[0].rate),
                  "decays of one sampling rate");
  }
}

CutDecays cut_decays(const std::vector<TimeRecord>& records, const std::string& force,
                     const IdentifySettings& settings) {
  CutDecays cut;
  Decays whole;
  for (const TimeRecord& record : records) {
    const TimeRecord responses = without(record, force);
    check_record(responses);
    cut.channels = responses.channels;
    const std::vector<DecayWindow> windows = decay_windows(record, force);
    for (std::size_t w = 0; w < windows.size(); ++w) {
      TimeRecord one = responses;
      one.samples = responses.samples.middleRows(windows[w].first, windows[w].count).eval();
      cut.high = std::max(cut.high, highest_frequency(one));
      whole.push_back(one.samples);
      cut.names.push_back(record.name + (windows.size() > 1 ? fmt::format(", hit {}", w + 1) : ""));
    }
  }
  const double rate = records[0].rate;
  check_band(settings, rate);
  cut.low = settings.low;
  if (settings.high > 0) cut.high = settings.high;
  Index shortest = whole[0].rows();
  for (const MatrixXd& y : whole) {
    const Decimated d = decimated(y, rate, cut.high);
    // A filter that leaves too little of a short decay is not worth it.
    const bool worth = d.samples.rows() >= 64;
    cut.rate = worth ? d.rate : rate;
    cut.y.push_back(worth ? d.samples : y);
    shortest = std::min(shortest, cut.y.back().rows());
  }
  for (MatrixXd& y : cut.y) {
    y = y.topRows(shortest).eval();
    y.rowwise() -= y.colwise().mean().eval(); // the fit has an offset of its own
  }
  return cut;
}

// U S^1/2 of the block Hankel matrix of all decays, each channel over its RMS: at most 240 rows or
// ten blocks, and as many columns as change nothing.
MatrixXd observability(const CutDecays& cut, const VectorXd& scale, Index order) {
  const Index samples = cut.y[0].rows(), channels = cut.y[0].cols();
  const Index blocks =
      std::clamp<Index>(240 / channels, std::min<Index>(10, samples / 3), samples / 3);
  const Index columns = samples - blocks + 1;
  const Index stride = std::max<Index>(1, columns * Index(cut.y.size()) / 3000);
  const Index each = (columns - 1) / stride + 1;
  MatrixXd transposed(each * Index(cut.y.size()), blocks * channels);
  for (std::size_t d = 0; d < cut.y.size(); ++d) {
    const MatrixXd y = cut.y[d] * scale.cwiseInverse().asDiagonal();
    for (Index j = 0; j < each; ++j)
      for (Index i = 0; i < blocks; ++i)
        transposed.row(Index(d) * each + j).segment(i * channels, channels) = y.row(j * stride + i);
  }
  const Index rows = std::min(transposed.rows(), transposed.cols());
  const Eigen::HouseholderQR<MatrixXd> qr(transposed);
  const MatrixXd R = qr.matrixQR().topRows(rows).triangularView<Eigen::Upper>();
  const Eigen::BDCSVD<MatrixXd> svd(R.transpose(), Eigen::ComputeThinU);
  const Index most =
      std::min<Index>({2 * order, svd.singularValues().size(), (blocks - 1) * channels});
  return svd.matrixU().leftCols(most) * svd.singularValues().head(most).cwiseSqrt().asDiagonal();
}

// EMAC of the outputs of each pole at one order, by its shape at the first and the last block.
double output_coherence(const MatrixXd& O, Index channels, double rate, const Pole& pole,
                        int order) {
  const MatrixXd of_order = O.leftCols(2 * order);
  const MatrixXd A = transition(of_order, channels);
  const std::complex<double> mu = std::exp(pole.lambda / rate);
  // The state of the mode: least of |A x - mu x|.
  const MatrixXcd shifted =
      A.cast<std::complex<double>>() - mu * MatrixXcd::Identity(A.rows(), A.cols());
  const Eigen::JacobiSVD<MatrixXcd> svd(shifted, Eigen::ComputeFullV);
  const VectorXcd x = svd.matrixV().rightCols(1);
  const Index blocks = O.rows() / channels;
  const VectorXcd first = of_order.topRows(channels) * x;
  const VectorXcd last = of_order.bottomRows(channels) * x;
  const VectorXcd expected = first * std::pow(mu, double(blocks - 1));
  double weighted = 0;
  for (Index c = 0; c < channels; ++c) {
    const double a = std::abs(last[c]), b = std::abs(expected[c]);
    if (!(a > 0 && b > 0)) continue;
    const double turn = std::abs(std::arg(last[c] / expected[c])) / (std::numbers::pi / 4);
    weighted += std::norm(first[c]) * std::min(a / b, b / a) * std::max(0., 1 - turn);
  }
  return weighted / first.squaredNorm();
}

double rms_of(const Decays& decays) {
  double square = 0;
  for (const MatrixXd& y : decays) square += y.squaredNorm();
  return std::sqrt(square);
}

Decays difference(Decays a, const Decays& b) {
  for (std::size_t d = 0; d < a.size(); ++d) a[d] -= b[d];
  return a;
}

// Whether what the fit leaves is three times as large in the first fiftieth as behind it: a force
// still acts.
bool head_is_forced(const Decays& rest) {
  const Index head = std::max<Index>(4, rest[0].rows() / 50);
  double first = 0, later = 0;
  for (const MatrixXd& e : rest) {
    first += e.topRows(head).squaredNorm() / double(head);
    later += e.middleRows(head, 4 * head).squaredNorm() / double(4 * head);
  }
  return first > 9 * later && later > 0;
}

// Stable poles that stand out of the noise where they are: the others would be moved for long.
Poles poles_that_matter(const CutDecays& cut, const std::vector<StableGroup>& groups) {
  Poles all, kept;
  for (const StableGroup& g : groups) all.push_back(g.pole.lambda);
  for (const FittedMode& m : fit_decays(cut.y, cut.rate, all, 0).modes)
    if (!is_noise(m, cut.low, cut.high)) kept.push_back(m.lambda);
  return kept;
}

void add_spectra(const CutDecays& cut, const ModalFit& fit, Identification& found) {
  FrfSet& set = found.set;
  set.quantity = FrfQuantity::receptance;
  set.responses = cut.channels;
  set.references = cut.names;
  const Index samples = cut.y[0].rows();
  const double line = cut.rate / double(samples);
  std::vector<Index> kept;
  for (Index k = 1; k <= samples / 2; ++k)
    if (double(k) * line >= cut.low && double(k) * line <= cut.high) kept.push_back(k);
  check_lines(kept.size(), cut.low, cut.high);
  set.hertz.resize(Index(kept.size()));
  for (std::size_t k = 0; k < kept.size(); ++k) set.hertz[Index(k)] = double(kept[k]) * line;
  Fourier transform{int(samples)};
  const auto spectra = [&](const Decays& decays) {
    std::vector<MatrixXcd> all;
    for (const MatrixXd& y : decays) {
      MatrixXcd H(set.hertz.size(), y.cols());
      for (Index c = 0; c < y.cols(); ++c) H.col(c) = transform.forward(y.col(c))(kept) / cut.rate;
      all.push_back(std::move(H));
    }
    return all;
  };
  set.H = spectra(cut.y);
  found.synthesised = spectra(synthesised_decays(fit, cut.rate, samples));
  found.frac.resize(Index(cut.channels.size()), Index(cut.y.size()));
  for (std::size_t d = 0; d < cut.y.size(); ++d)
    found.frac.col(Index(d)) = frac(set.H[d], found.synthesised[d]);
}

std::vector<PartialIdentification> parts_of(const CutDecays& cut, const Poles& poles) {
  std::vector<PartialIdentification> parts;
  for (std::size_t d = 0; d < cut.y.size(); ++d) {
    const auto fit_one = [&](const Poles& p) { return fit_decays({cut.y[d]}, cut.rate, p); };
    parts.push_back(
        partial_identification(cut.names[d], fit_significant(fit_one, poles, cut.low, cut.high)));
  }
  return parts;
}

void warn_of_decays(const CutDecays& cut, Identification& found) {
  const double seconds = double(cut.y[0].rows()) / cut.rate;
  for (const IdentifiedMode& m : found.modes) {
    if (m.frequency * seconds < 3)
      found.warnings.push_back(fmt::format("mode at {:.5g} Hz: {:.2g} of its periods lie in the "
                                           "decays of {:.3g} s, three are needed for its damping",
                                           m.frequency, m.frequency * seconds, seconds));
    if (m.consistency < 0.5)
      found.warnings.push_back(fmt::format("mode at {:.5g} Hz: its consistency is {:.2f}, it may "
                                           "be of the noise",
                                           m.frequency, m.consistency));
    if (m.rank > 0.3)
      found.warnings.push_back(fmt::format("mode at {:.5g} Hz: the decays show it in different "
                                           "shapes: a close pair, or not one structure",
                                           m.frequency));
  }
  add_common_warnings(found, "the decays");
}

struct FittedDecays {
  std::vector<DiagramPole> diagram;
  std::vector<StableGroup> groups;
  MatrixXd O;
  ModalFit fit;
  bool forced = false; // at the head, whatever was cut off
};

FittedDecays fitted_decays(const CutDecays& cut, int order) {
  VectorXd scale = VectorXd::Zero(Index(cut.channels.size()));
  for (const MatrixXd& y : cut.y) scale += y.cwiseAbs2().colwise().sum().transpose();
  FittedDecays f{
      .diagram = {}, .groups = {}, .O = observability(cut, scale.cwiseSqrt(), order), .fit = {}};
  f.diagram = stabilisation(poles_of_rising_order(f.O, scale.size(), cut.rate));
  f.groups = stable_groups(f.diagram);
  const auto fit = [&](const Poles& p) { return fit_decays(cut.y, cut.rate, p); };
  f.fit = fit_significant(fit, poles_that_matter(cut, f.groups), cut.low, cut.high);
  const Decays all = synthesised_decays(f.fit, cut.rate, cut.y[0].rows());
  f.forced = head_is_forced(difference(cut.y, all));
  return f;
}

// Heads of the decays are cut off as long as a force seems to act there.
FittedDecays free_part(CutDecays& cut, int order) {
  const Index whole = cut.y[0].rows(), head = std::max<Index>(4, whole / 50);
  FittedDecays f = fitted_decays(cut, order);
  while (f.forced && !f.fit.modes.empty()) {
    const Index left = cut.y[0].rows() - head;
    if (left < whole - whole / 6 || left < 32) break;
    for (MatrixXd& y : cut.y) y = y.bottomRows(left).eval();
    f = fitted_decays(cut, order);
  }
  return f;
}

// A component scatters over the largest, which is 1 by definition.
void scatter_over_largest(IdentifiedMode& mode) {
  Index largest = 0;
  mode.shape.cwiseAbs().maxCoeff(&largest);
  const double own = mode.sigma_shape[largest];
  for (Index c = 0; c < mode.shape.size(); ++c)
    mode.sigma_shape[c] =
        c == largest ? 0 : std::hypot(mode.sigma_shape[c], std::abs(mode.shape[c]) * own);
}

IdentifiedMode described_decay(const CutDecays& cut, const FittedDecays& f, const FittedMode& m) {
  IdentifiedMode mode = mode_of(m);
  scatter_over_largest(mode);
  mode.orders = orders_that_show(f.diagram, mode);
  ModalFit alone = f.fit;
  alone.modes = {m};
  alone.lower.setZero();
  mode.share = rms_of(synthesised_decays(alone, cut.rate, cut.y[0].rows())) / rms_of(cut.y);
  const auto group = std::min_element(
      f.groups.begin(), f.groups.end(), [&](const StableGroup& a, const StableGroup& b) {
        return std::abs(a.pole.lambda - m.lambda) < std::abs(b.pole.lambda - m.lambda);
      });
  mode.consistency =
      output_coherence(f.O, Index(cut.channels.size()), cut.rate, group->pole, group->order) *
      mode.collinearity;
  Index o = 0, d = 0;
  m.residue.cwiseAbs().maxCoeff(&o, &d);
  mode.strongest = cut.channels[std::size_t(o)] + " in " + cut.names[std::size_t(d)];
  return mode;
}

} // namespace

Identification identify_decays(const std::vector<TimeRecord>& records, const std::string& force,
                               const IdentifySettings& settings) {
  check_alike(records);
  CutDecays cut = cut_decays(records, force, settings);
  FittedDecays f =
      free_part(cut, settings.highest_order > 0 ? settings.highest_order : usual_decay_order);
  Identification found;
  found.source = IdentifiedFrom::decays;
  for (const TimeRecord& r : records)
    found.warnings.insert(found.warnings.end(), r.warnings.begin(), r.warnings.end());
  if (f.forced)
    found.warnings.emplace_back("the head of the decays is not explained by free modes: a force "
                                "still acts there, or the structure is not linear");
  add_spectra(cut, f.fit, found);
  const Decays all = synthesised_decays(f.fit, cut.rate, cut.y[0].rows());
  const double size = rms_of(cut.y);
  found.misfit = size > 0 ? rms_of(difference(cut.y, all)) / size : 0;
  MatrixXcd shapes(Index(cut.channels.size()), Index(f.fit.modes.size()));
  Poles poles;
  for (const FittedMode& m : f.fit.modes) {
    found.modes.push_back(described_decay(cut, f, m));
    shapes.col(Index(poles.size())) = found.modes.back().shape;
    poles.push_back(m.lambda);
  }
  found.diagram = std::move(f.diagram);
  if (cut.y.size() > 1) widen_by_parts(parts_of(cut, poles), found.modes, found.warnings);
  found.auto_mac = mac_matrix(shapes, shapes);
  warn_of_decays(cut, found);
  return found;
}

} // namespace plica
