#include "io/report/response.hpp"

#include "io/report/markup.hpp"
#include "io/report/phase.hpp"
#include "io/report/plot.hpp"
#include "io/tables/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

std::string channel(const ResponseResult& r, int c) {
  return html_escape(r.channels[c].first) + " " + r.channels[c].second;
}

// Channels that one picture can tell apart: all; where they are too many, or a test's stand beside
// several of one sensor, those of one axis each.
std::vector<std::vector<int>> panels(const ResponseResult& r) {
  constexpr std::size_t most = 6;
  const auto twice = [&](int c) {
    return std::count_if(r.shown.begin(), r.shown.end(), [&](int other) {
             return r.channels[std::size_t(other)].first == r.channels[std::size_t(c)].first;
           }) > 1;
  };
  const bool repeated = std::any_of(r.shown.begin(), r.shown.end(), twice);
  if (r.shown.size() <= most && (!repeated || r.test.empty())) return {r.shown};
  std::vector<std::string> axes;
  for (int c : r.shown)
    if (const std::string& axis = r.channels[std::size_t(c)].second;
        std::find(axes.begin(), axes.end(), axis) == axes.end())
      axes.push_back(axis);
  std::vector<std::vector<int>> list;
  for (const std::string& axis : axes) {
    list.emplace_back();
    for (int c : r.shown) {
      if (r.channels[std::size_t(c)].second != axis) continue;
      if (list.back().size() == most) list.emplace_back();
      list.back().push_back(c);
    }
  }
  return list;
}

// One curve per channel, in the colour of its sensor.
template <class Values>
std::vector<PlotCurve> drawn(const ResponseResult& r, const std::vector<int>& channels,
                             Values&& values) {
  const std::vector<ChannelStyle> styles = channel_styles(r.channels, channels);
  std::vector<PlotCurve> list;
  for (std::size_t k = 0; k < channels.size(); ++k) {
    const auto& [sensor, axis] = r.channels[std::size_t(channels[k])];
    list.push_back({.x = r.hertz,
                    .y = values(channels[k]),
                    .name = sensor + " " + axis,
                    .colour = styles[k].colour,
                    .dashes = styles[k].dashes});
  }
  return list;
}

// Of the model full, of the test dashed in the colour of its sensor.
std::vector<PlotCurve> curves(const ResponseResult& r, const std::vector<int>& channels) {
  std::vector<PlotCurve> list = drawn(
      r, channels, [&](int c) -> Eigen::VectorXd { return r.acceleration.col(c).cwiseAbs(); });
  for (const TestCurve& t : r.test)
    if (const auto own = std::find(channels.begin(), channels.end(), t.channel);
        own != channels.end())
      list.push_back({.x = t.hertz,
                      .y = t.magnitude,
                      .name = fmt::format(
                          "test {} {}{}", r.channels[t.channel].first, r.channels[t.channel].second,
                          t.level ? fmt::format(", {:g} {}", *t.level, r.unit) : ""),
                      .colour = list[std::size_t(own - channels.begin())].colour,
                      .dashes = 1});
  return list;
}

// In the order and style of curves(); tests of magnitudes alone have none.
std::vector<PlotCurve> phases(const ResponseResult& r, const std::vector<int>& channels,
                              const std::vector<PlotCurve>& magnitudes) {
  std::vector<PlotCurve> list;
  std::size_t next = 0;
  for (const int c : channels)
    list.push_back(phase_curve(magnitudes[next++], r.acceleration.col(c).cwiseArg()));
  for (const TestCurve& t : r.test) {
    if (std::find(channels.begin(), channels.end(), t.channel) == channels.end()) continue;
    const PlotCurve& magnitude = magnitudes[next++];
    if (t.phase.size() > 0) list.push_back(phase_curve(magnitude, t.phase));
  }
  return list;
}

std::vector<PlotCurve> densities(const ResponseResult& r, const std::vector<int>& channels) {
  std::vector<PlotCurve> list =
      drawn(r, channels, [&](int c) -> Eigen::VectorXd { return r.random->density.col(c); });
  const auto add_rms = [](PlotCurve& curve, double rms, const std::string& unit) {
    curve.name += fmt::format(", {} {} RMS", significant(rms, 3), unit);
  };
  const BandRms* whole = r.random->bands.empty() ? nullptr : &r.random->bands.front();
  for (std::size_t k = 0; whole && k < channels.size(); ++k)
    add_rms(list[k], whole->rms[channels[k]], "m/s²");
  if (r.random->input.size() > 0 && r.random->input.maxCoeff() > 0) {
    list.insert(list.begin(), {.x = r.hertz, .y = r.random->input, .name = "input", .faint = true});
    if (whole) add_rms(list.front(), whole->input, html_unit(r.unit));
  }
  return list;
}

std::string peaks_html(const ResponseResult& r) {
  std::vector<HtmlRow> rows;
  for (const ResponsePeak& p : r.peaks)
    rows.push_back(
        {{channel(r, p.channel), html_fixed(p.frequency, 1), html_number(p.amplitude, 3),
          html_fixed(p.phase * 180 / std::numbers::pi, 0), html_number(100 * p.damping, 3)},
         ""});
  return html_table("",
                    {{"sensor", "", false},
                     {"peak", "Hz"},
                     {"acceleration", html_unit(response_unit(r, "m/s²"))},
                     {"phase", "°"},
                     {"half-power damping", "%"}},
                    rows);
}

std::string tone_html(const ToneResult& t, const ResponseResult& r) {
  std::vector<HtmlRow> rows;
  for (int c : r.shown)
    rows.push_back({{channel(r, c), html_fixed(t.frequency[c], 1), html_number(t.sine[c], 3),
                     html_number(t.rms[c], 3)},
                    ""});
  return html_table(
      fmt::format("With a sine of {} {} that sweeps from {:g} to {:g} Hz, where it is "
                  "worst for each sensor.",
                  html_number(t.amplitude, 3), html_unit(r.unit), t.band[0], t.band[1]),
      {{"sensor", "", false}, {"at", "Hz"}, {"sine", "m/s²"}, {"RMS of both", "m/s²"}}, rows);
}

std::string direct_html(const ResponseResult& r) {
  if (r.direct.empty()) return "";
  const DirectCheck worst = farthest(r.direct);
  return fmt::format(
      "<p>Beside a direct solution of the whole mesh at {} frequencies: at most {} % "
      "off, at {} Hz (<code>direct</code> in <code>results.json</code>).</p>\n",
      r.direct.size(), html_number(100 * worst.difference, 2), html_fixed(worst.frequency, 1));
}

std::string random_html(const ResponseResult& r) {
  if (!r.random) return "";
  const bool alone = r.random->input.size() > 0;
  std::vector<HtmlColumn> columns{{"in", "Hz", false}, {"", "", false}};
  if (alone) columns.push_back({"input", html_unit(r.unit)});
  for (int c : r.shown) columns.push_back({channel(r, c), "m/s²"});
  std::vector<HtmlRow> rows;
  for (const BandRms& b : r.random->bands) {
    for (const auto& [times, name] : {std::pair{1, "RMS"}, {3, "3 σ"}}) {
      HtmlRow row{{times == 1 ? fmt::format("{:g} to {:g}", b.band[0], b.band[1]) : "", name}, ""};
      if (alone) row.cells.push_back(html_number(times * b.input, 3));
      for (int c : r.shown) row.cells.push_back(html_number(times * b.rms[c], 3));
      rows.push_back(std::move(row));
    }
  }
  std::string html;
  for (const std::vector<int>& channels : panels(r))
    html += plot_figure({.label = response_title(r) + ", random",
                         .ordinate = "spectral density, (m/s²)²/Hz"},
                        densities(r, channels)) +
            plot_legend(densities(r, channels));
  html += html_table("Under the random input of the case; 3 σ is passed in 0.3 % of the time.",
                     columns, rows);
  for (const ToneResult& t : r.random->tones) html += tone_html(t, r);
  return html;
}

} // namespace

std::string responses_html(const Results& results) {
  std::string html;
  bool base = false;
  for (const ResponseResult& r : results.responses) {
    if (r.channels.empty() || r.hertz.size() < 2) continue;
    base = base || r.source != Source::force;
    html += fmt::format("<h3>{}</h3>\n", html_escape(response_title(r)));
    for (const std::vector<int>& channels : panels(r)) {
      const PlotFrame frame{.label = response_title(r),
                            .ordinate = "acceleration, " + html_unit(response_unit(r, "m/s²"))};
      const std::vector<PlotCurve> magnitudes = curves(r, channels);
      html += plot_figure(frame, magnitudes) +
              phase_figure(frame, phases(r, channels, magnitudes)) + plot_legend(magnitudes);
    }
    html += peaks_html(r) + direct_html(r) + random_html(r);
  }
  if (base)
    html += "<p>Absolute acceleration of the sensor in its own axes over that of the base.</p>\n";
  if (!results.unanswered.empty())
    html += "<h3>What this model cannot show</h3>\n" + html_list(results.unanswered);
  return html;
}

} // namespace plica
