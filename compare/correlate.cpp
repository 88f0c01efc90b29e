#include "compare/correlate.hpp"

#include "lab/identification/mode_correlation.hpp"
#include "lab/measured/measured_words.hpp"
#include "words/sample_ranks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace plica {
namespace {

constexpr double alike = 0.5; // MAC above which shapes may be of one mode

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

bool has(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

// Channels that all shapes of the pairs have, on both sides.
std::vector<std::string> common_channels(const Measured& a, const Measured& b,
                                         const std::vector<PairedMode>& pairs) {
  std::vector<std::string> common;
  bool first = true;
  for (const PairedMode& p : pairs) {
    if (!p.mac) continue;
    for (const MeasuredMode* m : {&b.modes[p.measured], &a.modes[p.simulated]}) {
      if (first) common = m->vector->channels;
      first = false;
      std::erase_if(common, [&](const std::string& c) { return !has(m->vector->channels, c); });
    }
  }
  return common;
}

VectorXcd vector_of(const MeasuredVector& v, const std::vector<std::string>& channels) {
  VectorXcd x(Index(channels.size()));
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const auto at =
        std::find(v.channels.begin(), v.channels.end(), channels[c]) - v.channels.begin();
    x[Index(c)] = {v.real[at], v.imaginary.empty() ? 0 : v.imaginary[at]};
  }
  return x;
}

std::vector<int> with_shape(const Measured& m) {
  std::vector<int> modes;
  for (std::size_t i = 0; i < m.modes.size(); ++i)
    if (m.modes[i].vector) modes.push_back(static_cast<int>(i));
  return modes;
}

// Over the channels that both have; 0 below two of them.
double mac_of(const MeasuredVector& a, const MeasuredVector& b) {
  std::vector<std::string> common = a.channels;
  std::erase_if(common, [&](const std::string& c) { return !has(b.channels, c); });
  return common.size() < 2 ? 0 : mac(vector_of(a, common), vector_of(b, common));
}

MatrixXd mac_matrix_of(const Measured& a, const std::vector<int>& rows, const Measured& b,
                       const std::vector<int>& columns) {
  MatrixXd m(Index(rows.size()), Index(columns.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < columns.size(); ++j)
      m(Index(i), Index(j)) = mac_of(*a.modes[rows[i]].vector, *b.modes[columns[j]].vector);
  return m;
}

PairedMode paired(const Measured& a, const Measured& b, int i, int j, const std::string& by) {
  const MeasuredMode &s = a.modes[i], &t = b.modes[j];
  PairedMode p;
  p.simulated = i;
  p.measured = j;
  p.by = by;
  p.frequency_error = s.frequency / t.frequency - 1;
  const auto sigma = [](const std::optional<double>& x, const std::optional<double>& y) {
    return std::hypot(x.value_or(0), y.value_or(0));
  };
  if (const double e = sigma(s.sigma, t.sigma); e > 0)
    p.frequency_sigmas = (s.frequency - t.frequency) / e;
  if (s.damping && t.damping) {
    p.damping_error = *s.damping / *t.damping - 1;
    if (const double e = sigma(s.sigma_damping, t.sigma_damping); e > 0)
      p.damping_sigmas = (*s.damping - *t.damping) / e;
  }
  return p;
}

// The pairing with the best sum of scores, each mode once, by taking the best first and mending by
// exchanges of two until none helps: small lists, and the same result every time.
std::vector<std::array<int, 2>> best_pairs(const MatrixXd& score) {
  std::vector<std::array<int, 2>> pairs;
  std::set<Index> rows, columns;
  while (true) {
    double best = 0;
    std::array<int, 2> at{-1, -1};
    for (Index i = 0; i < score.rows(); ++i)
      for (Index j = 0; j < score.cols(); ++j)
        if (!rows.contains(i) && !columns.contains(j) && score(i, j) > best) {
          best = score(i, j);
          at = {static_cast<int>(i), static_cast<int>(j)};
        }
    if (at[0] < 0) break;
    rows.insert(at[0]);
    columns.insert(at[1]);
    pairs.push_back(at);
  }
  for (bool better = true; better;) {
    better = false;
    for (auto& p : pairs)
      for (auto& q : pairs)
        if (const double now = score(p[0], p[1]) + score(q[0], q[1]);
            score(p[0], q[1]) > 0 && score(q[0], p[1]) > 0 &&
            score(p[0], q[1]) + score(q[0], p[1]) > now + 1e-12) {
          std::swap(p[1], q[1]);
          better = true;
        }
  }
  return pairs;
}

// ln of the factor that all frequencies of one side have in common: the median over modes that are
// each other's most alike in shape.
double common_stretch(const TestData& a, const TestData& b, const Correlation& c) {
  std::vector<double> ratios;
  for (Index i = 0; i < c.mac.rows(); ++i) {
    Index j = 0, back = 0;
    const double most = c.mac.row(i).maxCoeff(&j);
    c.mac.col(j).maxCoeff(&back);
    if (back == i && most > alike)
      ratios.push_back(std::log(a.data.modes[c.mac_rows[i]].frequency /
                                b.data.modes[c.mac_columns[j]].frequency));
  }
  if (ratios.empty()) return 0;
  return median(std::move(ratios));
}

void pair_by_shape(const TestData& a, const TestData& b, Correlation& c) {
  c.mac_rows = with_shape(a.data);
  c.mac_columns = with_shape(b.data);
  if (c.mac_rows.empty() || c.mac_columns.empty()) return;
  c.mac = mac_matrix_of(a.data, c.mac_rows, b.data, c.mac_columns);
  c.auto_mac = mac_matrix_of(b.data, c.mac_columns, b.data, c.mac_columns);
  // A mode of like shape that is far off in frequency, beyond what all modes are, is another one.
  const double stretch = std::exp(common_stretch(a, b, c));
  MatrixXd score = c.mac;
  for (Index i = 0; i < score.rows(); ++i)
    for (Index j = 0; j < score.cols(); ++j) {
      const double e = a.data.modes[c.mac_rows[i]].frequency /
                           (stretch * b.data.modes[c.mac_columns[j]].frequency) -
                       1;
      score(i, j) = c.mac(i, j) > alike ? c.mac(i, j) - 10 * e * e : 0;
    }
  for (const auto& [i, j] : best_pairs(score)) {
    PairedMode p = paired(a.data, b.data, c.mac_rows[i], c.mac_columns[j], "shape");
    p.mac = c.mac(i, j);
    c.pairs.push_back(p);
  }
}

// Over the channels that all paired shapes have.
void add_comac(const TestData& a, const TestData& b, Correlation& c) {
  c.channels = common_channels(a.data, b.data, c.pairs);
  if (c.channels.empty()) return;
  MatrixXcd s(Index(c.channels.size()), Index(c.pairs.size())), t = s;
  Index count = 0;
  for (const PairedMode& p : c.pairs) {
    if (!p.mac) continue;
    s.col(count) = vector_of(*a.data.modes[p.simulated].vector, c.channels);
    t.col(count++) = vector_of(*b.data.modes[p.measured].vector, c.channels);
  }
  c.comac = comac(s.leftCols(count), t.leftCols(count));
}

bool same_name(const MeasuredMode& s, const MeasuredMode& t) {
  return s.shape == t.shape && s.order == t.order && s.shape != MeasuredShape::other &&
         (!s.direction || !t.direction || *s.direction == *t.direction);
}

void pair_by_name(const TestData& a, const TestData& b, Correlation& c) {
  for (std::size_t j = 0; j < b.data.modes.size(); ++j) {
    const auto free = [&](std::size_t i) {
      return std::none_of(c.pairs.begin(), c.pairs.end(), [&](const PairedMode& p) {
        return p.by == "shape" && (p.simulated == int(i) || p.measured == int(j));
      });
    };
    for (std::size_t i = 0; i < a.data.modes.size(); ++i)
      if (free(i) && same_name(a.data.modes[i], b.data.modes[j])) {
        c.pairs.push_back(paired(a.data, b.data, int(i), int(j), "name"));
        break;
      }
  }
}

// Linear between the lines of the simulation; hertz within them.
VectorXcd interpolated(const VectorXd& hertz, const VectorXcd& values, const VectorXd& at) {
  VectorXcd result(at.size());
  Index k = 0;
  for (Index i = 0; i < at.size(); ++i) {
    while (k + 2 < hertz.size() && hertz[k + 1] < at[i]) ++k;
    const double share = (at[i] - hertz[k]) / (hertz[k + 1] - hertz[k]);
    result[i] = (1 - share) * values[k] + share * values[k + 1];
  }
  return result;
}

VectorXd lines_within(const VectorXd& hertz, double low, double high) {
  std::vector<double> kept;
  for (double f : hertz)
    if (f >= low && f <= high) kept.push_back(f);
  return VectorXd::Map(kept.data(), Index(kept.size()));
}

// The stretch of the simulated frequencies, within a quarter, under which FRAC is largest.
void find_stretch(const VectorXd& hertz, const VectorXcd& simulated, ComparedResponse& r,
                  const VectorXd& test_hertz, const VectorXcd& test) {
  r.best_frac = r.frac;
  for (double stretch = -0.25; stretch <= 0.2501; stretch += 0.0025) {
    const VectorXd moved = hertz * (1 + stretch);
    const VectorXd lines = lines_within(test_hertz, std::max(r.low, moved[0]),
                                        std::min(r.high, moved[moved.size() - 1]));
    if (lines.size() < test_hertz.size() / 2 || lines.size() < 10) continue;
    const double f =
        mac(interpolated(moved, simulated, lines), interpolated(test_hertz, test, lines));
    if (f > r.best_frac) {
      r.best_frac = f;
      r.stretch = stretch;
    }
  }
}

// Simulated sets hold one reference each; of several levels the nearest to that of the test.
const FrfSet* partner(const std::vector<const FrfSet*>& simulated, const std::string& reference,
                      const std::optional<double>& level, FrfQuantity quantity) {
  const FrfSet* best = nullptr;
  for (const FrfSet* s : simulated) {
    if (!has(s->references, reference) || s->quantity != quantity) continue;
    const auto off = [&](const FrfSet& x) {
      return std::abs(x.level.value_or(0) - level.value_or(0));
    };
    if (!best || off(*s) < off(*best)) best = s;
  }
  return best;
}

// Nothing but rounding beside the largest response.
bool is_silent(const VectorXcd& response, const MatrixXcd& all) {
  return response.norm() <= 1e-6 * all.colwise().norm().maxCoeff();
}

void compare_responses(const TestData& a, const TestData& b, Correlation& c) {
  const std::vector<const FrfSet*> responses = all_responses(a);
  for (const FrfSet* tested : all_responses(b)) {
    const FrfSet& t = *tested;
    for (std::size_t k = 0; k < t.references.size(); ++k) {
      const FrfSet* s = partner(responses, t.references[k], t.level, t.quantity);
      if (!s || s->hertz.size() < 2) continue;
      const auto i = std::find(s->references.begin(), s->references.end(), t.references[k]) -
                     s->references.begin();
      const double low = std::max(s->hertz[0], t.hertz[0]);
      const double high = std::min(s->hertz[s->hertz.size() - 1], t.hertz[t.hertz.size() - 1]);
      const VectorXd lines = lines_within(t.hertz, low, high);
      if (lines.size() < 2) continue;
      std::vector<ComparedResponse> list;
      for (std::size_t o = 0; o < t.responses.size(); ++o) {
        const auto at = std::find(s->responses.begin(), s->responses.end(), t.responses[o]);
        if (at == s->responses.end()) continue;
        const VectorXcd simulated = s->H[i].col(at - s->responses.begin());
        const VectorXcd test = t.H[k].col(Index(o));
        if (is_silent(simulated, s->H[i])) continue; // nothing to compare but rounding
        ComparedResponse r{.response = t.responses[o],
                           .reference = t.references[k],
                           .level = t.level,
                           .low = low,
                           .high = high,
                           .hertz = lines,
                           .simulated = interpolated(s->hertz, simulated, lines),
                           .measured = interpolated(t.hertz, test, lines)};
        r.frac = mac(r.simulated, r.measured);
        find_stretch(s->hertz, simulated, r, t.hertz, test);
        list.push_back(std::move(r));
      }
      if (list.empty()) continue;
      MatrixXcd S(lines.size(), Index(list.size())), T = S;
      for (std::size_t r = 0; r < list.size(); ++r) {
        S.col(Index(r)) = list[r].simulated;
        T.col(Index(r)) = list[r].measured;
      }
      c.lines.push_back({t.references[k], lines, csac(S, T), csf(S, T)});
      std::move(list.begin(), list.end(), std::back_inserter(c.responses));
    }
  }
}

void compare_numbers(const TestData& a, const TestData& b, Correlation& c) {
  const auto either = [](const std::optional<double>& x, const std::optional<double>& y) {
    const double e = std::hypot(x.value_or(0), y.value_or(0));
    return e > 0 ? std::optional<double>(e) : std::nullopt;
  };
  const std::vector<MeasuredMass>& simulated = a.data.weighings;
  for (const MeasuredMass& t : b.data.weighings) {
    if (simulated.empty()) break;
    auto s = std::find_if(simulated.begin(), simulated.end(),
                          [&](const MeasuredMass& w) { return w.state == t.state; });
    if (s == simulated.end()) s = simulated.begin(); // a run names no state
    const bool several = b.data.weighings.size() > 1 && !t.state.empty();
    c.numbers.push_back({several ? "mass, " + t.state : "mass", "kg", s->value, t.value,
                         either(s->sigma, t.sigma)});
  }
  for (const MeasuredStatic& t : b.data.statics)
    for (const MeasuredStatic& s : a.data.statics)
      if (s.direction == t.direction)
        c.numbers.push_back({stiffness_name(t.direction), stiffness_unit(t.direction), s.value,
                             t.value, either(s.sigma, t.sigma)});
}

void add_limits(const TestData& a, const TestData& b, Correlation& c) {
  if (a.data.specimen != b.data.specimen)
    c.limits.push_back("anything, unless the specimens " + a.data.specimen + " and " +
                       b.data.specimen + " are the same");
  std::set<std::string> sensors;
  for (const std::string& channel : c.channels)
    sensors.insert(std::string(sensor_of_channel(channel)));
  if (c.channels.empty())
    c.limits.emplace_back(
        "no mode has a shape over common channels on both sides: modes are paired by "
        "their names alone");
  else if (sensors.size() == 1)
    c.limits.push_back(
        "one sensor (" + *sensors.begin() +
        ") gives directions only: modes of one direction and different order look alike, "
        "and MAC cannot tell them apart");
  else if (c.channels.size() < 6)
    c.limits.push_back("shapes over " + std::to_string(c.channels.size()) +
                       " channels: a high MAC is weak evidence");
  std::string pairs;
  for (Index i = 0; i < c.auto_mac.rows(); ++i)
    for (Index j = i + 1; j < c.auto_mac.cols(); ++j)
      if (c.auto_mac(i, j) > alike) {
        const auto hertz = [&](Index k) {
          return std::to_string(std::lround(b.data.modes[c.mac_columns[k]].frequency));
        };
        pairs += (pairs.empty() ? "" : ", ") + hertz(i) + " and " + hertz(j) + " Hz";
      }
  if (!pairs.empty())
    c.limits.push_back("measured modes look alike at these channels (MAC above 0.5): " + pairs);
  if (all_responses(b).empty())
    c.limits.emplace_back("no measured response: FRAC and CSAC are left out");
  else if (c.responses.empty())
    c.limits.emplace_back(
        "the simulation has none of the measured responses, or is silent there: FRAC "
        "and CSAC are left out");
}

} // namespace

Correlation correlate(const TestData& simulated, const TestData& measured) {
  Correlation c;
  pair_by_shape(simulated, measured, c);
  add_comac(simulated, measured, c);
  pair_by_name(simulated, measured, c);
  std::sort(c.pairs.begin(), c.pairs.end(),
            [](const PairedMode& p, const PairedMode& q) { return p.measured < q.measured; });
  const auto unpaired = [&](std::size_t count, int PairedMode::*side) {
    std::vector<int> left;
    for (int i = 0; i < static_cast<int>(count); ++i)
      if (std::none_of(c.pairs.begin(), c.pairs.end(),
                       [&](const PairedMode& p) { return p.*side == i; }))
        left.push_back(i);
    return left;
  };
  c.unpaired_measured = unpaired(measured.data.modes.size(), &PairedMode::measured);
  c.unpaired_simulated = unpaired(simulated.data.modes.size(), &PairedMode::simulated);
  compare_responses(simulated, measured, c);
  compare_numbers(simulated, measured, c);
  add_limits(simulated, measured, c);
  return c;
}

} // namespace plica
