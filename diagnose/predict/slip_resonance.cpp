// Peaks of a state whose joints slip: the stiffness at which sliders and resonance agree about the
// amplitude.
#include "diagnose/predict/state_answers.hpp"

#include "words/directions.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace plica {
namespace {

using Eigen::Index;
using Complex = std::complex<double>;

double default_level(const Case& data) {
  return data.analyses.response ? data.analyses.response->level : 1;
}

// The modes of peaks over the stiffness of a group, straight between the points of its table; a
// point is looked at when it is first needed.
class PeaksOverStiffness {
public:
  // Motion per level at unit damping, zeta, energy share of the group per unit of its stiffness.
  using Row = std::array<double, 3>;
  using Rows = std::vector<std::optional<Row>>; // of each peak; none: it is not there
  PeaksOverStiffness(int low, int high, std::function<Rows(int)> look)
      : low_(low), look_(std::move(look)), first_(std::log(SlipTable::stiffness_of(low))),
        step_(std::log(SlipTable::stiffness_of(low + 1)) - first_),
        rows_(std::size_t(high - low + 1)) {}

  std::optional<Row> at(double stiffness, std::size_t peak) {
    const double x = std::clamp((std::log(std::max(stiffness, 1e-300)) - first_) / step_, 0.,
                                double(rows_.size()) - 1.000001);
    const auto place = std::size_t(x);
    const std::optional<Row> below = at_point(place)[peak], above = at_point(place + 1)[peak];
    if (!below || !above) return std::nullopt;
    Row row{};
    for (std::size_t k = 0; k < row.size(); ++k)
      row[k] = (*below)[k] + (x - double(place)) * ((*above)[k] - (*below)[k]);
    return row;
  }

private:
  const Rows& at_point(std::size_t place) {
    if (!rows_[place]) rows_[place] = look_(low_ + int(place));
    return *rows_[place];
  }

  int low_;
  std::function<Rows(int)> look_;
  double first_, step_;
  std::vector<std::optional<Rows>> rows_;
};

} // namespace

SlipTable& StateAnswers::table() {
  if (!table_) table_ = own_.tables.of(own_.free, acting_.all, *acting_.group);
  return *table_;
}

// The stiffness at which sliders and resonance agree about the amplitude of each peak. None: no
// stable structure.
std::optional<std::vector<StateAnswers::Slipping>>
StateAnswers::slipping(const Softening& softening, const Driven& driven, SlipTable& table) const {
  const SlipGroup& group = *acting_.group;
  const double stuck = acting_.all[group.change] + group.present;
  constexpr double most = 0.98; // of the share: something is always left
  const int low = SlipTable::point_at(stuck * (1 - most * softening.share)) - 1,
            high = SlipTable::point_at(stuck) + 1;
  if (!table.modes_at(low)) return std::nullopt; // the softest: what holds it holds the others
  PeaksOverStiffness peaks(low, high, [&](int point) {
    PeaksOverStiffness::Rows rows(driven.peaks);
    const AffineModes* m = table.modes_at(point);
    if (!m) return rows;
    const std::vector<Index> modes = driven.modes(*m);
    for (std::size_t p = 0; p < rows.size(); ++p) {
      const Index i = modes[p];
      if (i < 0) continue;
      const double stretch = std::sqrt(std::max(0., m->group(i, i)) / group.stiffness);
      rows[p] = {driven.amplitude(*m, i) * stretch, acting_.setup.damping * m->zeta[i],
                 group.stiffness * stretch * stretch / m->lambda[i]};
    }
    return rows;
  });
  const Sliders sliders(softening);
  std::vector<Slipping> found;
  for (std::size_t p = 0; p < driven.peaks; ++p) {
    const auto state_at = [&](double amplitude) { // and what the excitation makes of it
      const Complex gain = sliders.kept(amplitude);
      const double stiffness = stuck * (1 - softening.share * (1 - gain.real()));
      const auto row = peaks.at(stiffness, p);
      if (!row) return std::optional<std::pair<Slipping, double>>();
      const auto [motion, zeta, energy] = *row;
      const double damping = energy * stuck * softening.share * softening.loss * gain.imag() / 2;
      return std::optional(std::pair{Slipping{stiffness, damping},
                                     driven.level * motion / (driven.held ? 1 : zeta + damping)});
    };
    double below = std::log(1e-12), above = std::log(1.);
    constexpr int halvings = 40;
    auto state = state_at(std::exp(below));
    for (int i = 0; i < halvings && state; ++i) {
      const double middle = (below + above) / 2, amplitude = std::exp(middle);
      state = state_at(amplitude);
      if (state) (state->second > amplitude ? below : above) = middle;
    }
    if (state) state = state_at(std::exp(below));
    found.push_back(state ? state->first : Slipping{.stiffness = stuck}); // no such peak: as stuck
  }
  return found;
}

// What a sensor's channel sees of a mode of unit mass, 1/sqrt(kg).
double StateAnswers::seen_at(const AffineModes& m, Index mode, int sensor, int axis) const {
  return own_.nominal->axes[std::size_t(sensor)].row(axis).dot(
      m.marked.block<3, 1>(6 * Index(sensor), mode));
}

// A mode that is known by its kind, at what a shaker drives it to: at resonance the amplitude q is
// a / (w^2 phi) where the controller holds the acceleration a, F phi / (2 zeta w^2) under a force.
double StateAnswers::slipping_mode(const Reading& reading) {
  const auto [known, made] = driven_.try_emplace({reading.run, reading.peak}, 0., 0.);
  if (made) {
    const TestRun& run = test_.runs[std::size_t(reading.run)];
    const int sensor = own_.nominal->number_of(run.sensor);
    const Driven driven{
        .level = run.level,
        .held = !run.by_force,
        .modes = [&](const AffineModes& m) { return std::vector{labelled_mode(m, reading)}; },
        .amplitude =
            [&](const AffineModes& m, Index i) {
              const double phi = std::abs(seen_at(m, i, sensor, run.axis));
              return run.by_force ? phi / (2 * m.lambda[i]) : 1 / (m.lambda[i] * phi);
            }};
    if (sensor < 0) return not_given;
    const auto state = slipping(acting_.softening, driven, table());
    auto m = state ? table().modes(state->front().stiffness) : std::nullopt;
    if (!m) {
      stable_ = false;
      return not_given;
    }
    const Index mode = labelled_mode(*m, reading);
    if (mode >= 0)
      known->second = {m->hertz(mode),
                       acting_.setup.damping * m->zeta[mode] + state->front().damping};
  }
  const auto [hertz, zeta] = known->second;
  if (!(hertz > 0)) return not_given;
  return std::log(reading.kind == ReadingKind::damping ? zeta : hertz);
}

bool StateAnswers::predict_slipping_peaks(const TestRun& run, std::vector<Peak>& found) {
  Softening softening = acting_.softening;
  constexpr int along_the_pipe = 1;
  const int along = run.input.base >= 0 ? run.input.base : axis_of_channel(run.input.force);
  if (along != along_the_pipe) softening.distance *= softening.across;
  // Of a table that is not stated what the case says; a hammer's force moves little.
  constexpr double little = 1e-6;
  const double level = run.level > 0         ? run.level
                       : run.input.base >= 0 ? default_level(own_.nominal->data)
                                             : little;
  const Driven driven{
      .level = level,
      .peaks = run.peaks.size(),
      .modes = [&](const AffineModes& m) { return peak_modes(m, run); },
      .amplitude = [&](const AffineModes& m,
                       Index i) { return std::abs(input_of(m, run)[i]) / (2 * m.lambda[i]); }};
  const auto at_peaks = slipping(softening, driven, table());
  if (!at_peaks) return false;
  for (std::size_t p = 0; p < run.peaks.size(); ++p) {
    const Slipping& s = (*at_peaks)[p];
    auto m = table().modes(s.stiffness);
    if (!m) return false;
    m->zeta *= acting_.setup.damping;
    kept_.push_back(std::make_unique<AffineModes>(std::move(*m)));
    const AffineModes& own = *kept_.back();
    Peak peak{&own, own.zeta, peak_modes(own, run)[p], {}, {}};
    if (peak.mode >= 0) peak.zeta[peak.mode] += s.damping;
    found.push_back(std::move(peak));
  }
  return true;
}

} // namespace plica
