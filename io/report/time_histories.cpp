#include "io/report/time_histories.hpp"

#include "io/report/markup.hpp"
#include "io/report/phase.hpp"
#include "io/report/plot.hpp"
#include "io/tables/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Channels = std::vector<std::pair<std::string, std::string>>;
constexpr std::size_t most_curves = 6;

std::string name_of(const Channels& channels, int c) {
  return channels[std::size_t(c)].first + " " + channels[std::size_t(c)].second;
}

// The channels of a list that reach farthest, as many as a picture can tell apart.
std::vector<int> farthest(std::vector<int> channels, const VectorXd& reach) {
  std::stable_sort(channels.begin(), channels.end(),
                   [&](int a, int b) { return reach[a] > reach[b]; });
  if (channels.size() > most_curves) channels.resize(most_curves);
  return channels;
}

// A signal over time, thinned to the lowest and highest of each of at most 2000 stretches.
PlotCurve thinned(const VectorXd& signal, double step, const std::string& name,
                  const ChannelStyle& style) {
  constexpr Index stretches = 2000;
  const Index per = std::max<Index>(1, signal.size() / stretches);
  std::vector<double> time, value;
  for (Index first = 0; first < signal.size(); first += per) {
    const Index count = std::min(per, signal.size() - first);
    Index low = 0, high = 0;
    signal.segment(first, count).minCoeff(&low);
    signal.segment(first, count).maxCoeff(&high);
    const auto [one, other] = std::minmax(low, high);
    for (const Index i : {one, other}) {
      if (!time.empty() && i == other && one == other) continue;
      time.push_back(double(first + i) * step);
      value.push_back(signal[first + i]);
    }
  }
  return {.x = VectorXd::Map(time.data(), Index(time.size())),
          .y = VectorXd::Map(value.data(), Index(value.size())),
          .name = name,
          .colour = style.colour,
          .dashes = style.dashes};
}

std::string transient_html(const TransientResult& t) {
  VectorXd reach(Index(t.extremes.size()));
  for (std::size_t c = 0; c < t.extremes.size(); ++c)
    reach[Index(c)] = std::abs(t.extremes[c].value);
  std::vector<PlotCurve> curves;
  const std::vector<int> drawn = farthest(t.shown, reach);
  const std::vector<ChannelStyle> styles = channel_styles(t.channels, drawn);
  for (std::size_t k = 0; k < drawn.size(); ++k)
    curves.push_back(
        thinned(t.acceleration.col(drawn[k]), t.step, name_of(t.channels, drawn[k]), styles[k]));
  std::vector<HtmlRow> rows;
  for (int c : t.shown)
    rows.push_back(
        {{html_escape(name_of(t.channels, c)), html_number(t.extremes[std::size_t(c)].value, 4),
          html_number(1e3 * t.extremes[std::size_t(c)].time, 4), html_number(t.rms[c], 3)},
         ""});
  const double largest = t.input.cwiseAbs().maxCoeff();
  return fmt::format("<h3>{}</h3>\n<p>Input {}, at most {} {}, {} s followed.</p>\n",
                     html_escape(t.name), html_escape(t.input_title), html_number(largest, 4),
                     html_unit(t.unit), html_number(double(t.input.size() - 1) * t.step, 4)) +
         plot_figure({.label = t.name + " over time",
                      .abscissa = "time, s",
                      .ordinate = "acceleration, m/s²",
                      .linear = true},
                     curves) +
         plot_legend(curves) +
         html_table("Absolute acceleration of the sensors.",
                    {{"sensor", "", false}, {"peak", "m/s²"}, {"at", "ms"}, {"RMS", "m/s²"}}, rows);
}

std::string spectra_html(const TransientResult& t) {
  const ShockSpectra& s = *t.spectra;
  std::vector<PlotCurve> curves;
  if (s.input.size() > 0)
    curves.push_back({.x = s.hertz, .y = s.input, .name = "input", .faint = true});
  const VectorXd reach = s.channels.colwise().maxCoeff().transpose();
  const std::vector<int> drawn = farthest(t.shown, reach);
  const std::vector<ChannelStyle> styles = channel_styles(t.channels, drawn);
  for (std::size_t k = 0; k < drawn.size(); ++k)
    curves.push_back({.x = s.hertz,
                      .y = s.channels.col(drawn[k]),
                      .name = name_of(t.channels, drawn[k]),
                      .colour = styles[k].colour,
                      .dashes = styles[k].dashes});
  return plot_figure({.label = t.name + ", shock response spectra",
                      .ordinate = fmt::format("maximax acceleration, m/s², Q = {:g}", s.quality)},
                     curves) +
         plot_legend(curves);
}

// Modes across, orders from the origin, a mark where they meet.
std::string campbell_html(const RunUpResult& r, const Results& results) {
  const double low = 60 * r.speed[0], high = 60 * r.speed[r.speed.size() - 1];
  double top = 0;
  for (const OrderCut& cut : r.orders) top = std::max(top, cut.order * high / 60);
  const auto line = [&](double from, double to, const std::string& name, int number, bool faint) {
    return PlotCurve{.x = Eigen::Vector2d(low, high),
                     .y = Eigen::Vector2d(from, to),
                     .name = name,
                     .colour = number,
                     .dashes = number,
                     .faint = faint};
  };
  std::vector<PlotCurve> curves;
  for (const OrderCut& cut : r.orders)
    curves.push_back(line(cut.order * low / 60, cut.order * high / 60,
                          fmt::format("order {:g}", cut.order), int(curves.size()), false));
  for (const ModeResult& mode : results.modes)
    if (mode.frequency < top) curves.push_back(line(mode.frequency, mode.frequency, "", 0, true));
  std::vector<PlotMark> marks;
  for (const OrderCrossing& c : r.crossings) marks.push_back({60 * c.speed, c.frequency / top});
  return plot_figure({.label = r.name + ", Campbell",
                      .abscissa = "speed, rpm",
                      .ordinate = "frequency, Hz",
                      .linear = true,
                      .range = {{0, top}}},
                     curves, marks) +
         plot_legend(curves);
}

std::string crossings_html(const RunUpResult& r, const Results& results) {
  const bool hastes = std::any_of(r.crossings.begin(), r.crossings.end(),
                                  [](const OrderCrossing& c) { return c.haste.has_value(); });
  std::vector<HtmlColumn> columns{{"speed", "rpm"},      {"order", ""},
                                  {"mode", "", false},   {"frequency", "Hz"},
                                  {"sensor", "", false}, {"amplitude", "m/s²"}};
  if (hastes) columns.push_back({"sweep over the fastest that is steady", ""});
  if (r.sweeps) columns.push_back({"in time", "m/s²"});
  std::vector<HtmlRow> rows;
  for (const OrderCrossing& c : r.crossings) {
    HtmlRow row{{html_fixed(60 * c.speed, 0), html_number(c.order, 3),
                 html_escape(mode_label(results.modes[std::size_t(c.mode)])),
                 html_fixed(c.frequency, 1), html_escape(name_of(r.channels, c.channel)),
                 html_number(c.amplitude, 3)},
                ""};
    if (hastes) row.cells.push_back(html_number(c.haste, 2));
    if (r.sweeps) row.cells.push_back(html_number(*c.reached, 3));
    rows.push_back(std::move(row));
  }
  if (rows.empty()) return "<p>No order runs through a mode.</p>\n";
  return html_table("Where orders run through modes, and the sensor that moves most there. A sweep "
                    "faster than 1 (ISO 7626-2) does not reach the amplitude.",
                    columns, rows);
}

// The strongest orders of a channel while the speed runs.
std::string sweeps_html(const RunUpResult& r, int channel) {
  const OrderSweeps& s = *r.sweeps;
  std::vector<PlotCurve> curves{{.x = s.time,
                                 .y = std::sqrt(2.) * s.overall.col(channel),
                                 .name = "all orders, √2 RMS",
                                 .faint = true}};
  for (const OrderCut& cut : s.orders) {
    const int number = int(curves.size()) - 1;
    if (curves.size() > most_curves) break;
    curves.push_back({.x = s.time,
                      .y = cut.acceleration.col(channel).cwiseAbs(),
                      .name = fmt::format("order {:g}", cut.order),
                      .colour = number,
                      .dashes = number});
  }
  const std::string name = name_of(r.channels, channel);
  std::vector<PlotCurve> phases;
  for (std::size_t k = 1; k < curves.size(); ++k)
    phases.push_back(phase_curve(curves[k], s.orders[k - 1].acceleration.col(channel).cwiseArg()));
  const PlotFrame frame{.label = r.name + ", orders of " + name + " in time",
                        .abscissa = "time, s",
                        .ordinate = "acceleration of " + name + ", m/s²",
                        .linear = true};
  return plot_figure(frame, curves) + phase_figure(frame, phases) + plot_legend(curves) +
         fmt::format(
             "<p>While the speed runs from {} to {} rpm as given, beginning steadily: order "
             "by order without a filter, the model being linear.</p>\n",
             html_fixed(60 * s.speed[0], 0), html_fixed(60 * s.speed[s.speed.size() - 1], 0));
}

std::string run_up_html(const RunUpResult& r, const Results& results) {
  const VectorXd rpm = 60 * r.speed;
  std::vector<PlotCurve> overall, cuts, phases;
  const VectorXd reach = r.overall.colwise().maxCoeff().transpose();
  const std::vector<int> channels = farthest(r.shown, reach);
  const std::vector<ChannelStyle> styles = channel_styles(r.channels, channels);
  for (std::size_t k = 0; k < channels.size(); ++k)
    overall.push_back({.x = rpm,
                       .y = r.overall.col(channels[k]),
                       .name = name_of(r.channels, channels[k]),
                       .colour = styles[k].colour,
                       .dashes = styles[k].dashes});
  std::string html = fmt::format("<h3>{}</h3>\n", html_escape(r.name)) + campbell_html(r, results) +
                     crossings_html(r, results);
  if (channels.empty()) return html;
  for (const OrderCut& cut : r.orders) {
    cuts.push_back({.x = rpm,
                    .y = cut.acceleration.col(channels[0]).cwiseAbs(),
                    .name = fmt::format("order {:g}", cut.order),
                    .colour = int(cuts.size()),
                    .dashes = int(cuts.size())});
    phases.push_back(phase_curve(cuts.back(), cut.acceleration.col(channels[0]).cwiseArg()));
  }
  const std::string strongest = name_of(r.channels, channels[0]);
  const PlotFrame frame{.label = r.name + ", orders of " + strongest,
                        .abscissa = "speed, rpm",
                        .ordinate = "acceleration of " + strongest + ", m/s²"};
  return html +
         plot_figure({.label = r.name + ", all orders",
                      .abscissa = "speed, rpm",
                      .ordinate = "acceleration, m/s² RMS"},
                     overall) +
         plot_legend(overall) + plot_figure(frame, cuts) + phase_figure(frame, phases) +
         plot_legend(cuts) + (r.sweeps ? sweeps_html(r, channels[0]) : "");
}

} // namespace

std::string transients_html(const Results& results) {
  std::string html;
  for (const TransientResult& t : results.transients)
    html += transient_html(t) + (t.spectra ? spectra_html(t) : "");
  return html;
}

std::string run_ups_html(const Results& results) {
  std::string html;
  for (const RunUpResult& r : results.run_ups) html += run_up_html(r, results);
  return html;
}

} // namespace plica
