#include "io/report/levels.hpp"

#include "io/report/markup.hpp"
#include "io/report/phase.hpp"
#include "io/report/plot.hpp"
#include "io/tables/levels_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

std::string channel(const LevelResponses& responses, int c) {
  const auto& [sensor, axis] = responses.channels[std::size_t(c)];
  return html_escape(sensor) + " " + axis;
}

const LevelPeak* first_peak(const std::vector<LevelPeak>& peaks, int channel) {
  for (const LevelPeak& p : peaks)
    if (p.channel == channel) return &p;
  return nullptr;
}

std::vector<PlotCurve> curves(const LevelResponses& responses) {
  std::vector<PlotCurve> list;
  for (std::size_t k = 0; k < responses.curves.size(); ++k) {
    const LevelCurve& c = responses.curves[k];
    if (c.hertz.size() < 2) continue;
    list.push_back({.x = c.hertz,
                    .y = c.first.col(responses.strongest).cwiseAbs(),
                    .name = fmt::format("{:g} {}", c.level, responses.unit),
                    .colour = int(list.size()),
                    .dashes = int(k % 4),
                    .faint = k % 8 >= 4});
  }
  return list;
}

std::vector<PlotCurve> phases(const LevelResponses& responses,
                              const std::vector<PlotCurve>& curves) {
  std::vector<PlotCurve> list;
  for (const LevelCurve& c : responses.curves)
    if (c.hertz.size() >= 2)
      list.push_back(phase_curve(curves[list.size()], c.first.col(responses.strongest).cwiseArg()));
  return list;
}

std::string peaks_html(const LevelResponses& responses) {
  std::vector<HtmlRow> rows;
  for (const LevelCurve& c : responses.curves) {
    const LevelPeak* up = first_peak(c.peaks_up, responses.strongest);
    const LevelPeak* down = first_peak(c.peaks_down, responses.strongest);
    std::string jumps;
    for (const auto& [list, name] : {std::pair{&c.jumps_up, "up"}, {&c.jumps_down, "down"}})
      for (double f : *list)
        jumps += fmt::format("{}{} at {} Hz", jumps.empty() ? "" : ", ", name, html_fixed(f, 1));
    if (!c.complete) jumps += (jumps.empty() ? "" : "; ") + html_escape(c.reason);
    rows.push_back(
        {{html_number(c.level, 4), up ? html_fixed(up->frequency, 1) : "–",
          down ? html_fixed(down->frequency, 1) : "–", up ? html_number(up->amplitude, 3) : "–",
          up ? html_number(100 * up->damping, 3) : "–",
          up ? html_number(100 * up->energy_damping, 3) : "–", jumps},
         ""});
  }
  return html_table(fmt::format("First peak of {}.", channel(responses, responses.strongest)),
                    {{"level", responses.unit},
                     {"sweep up", "Hz"},
                     {"sweep down", "Hz"},
                     {"amplitude", "m/s² per " + responses.unit},
                     {"half-power damping", "%"},
                     {"damping by energy", "%"},
                     {"jumps", "", false}},
                    rows);
}

std::string backbones_html(const LevelResponses& responses) {
  std::string html;
  for (const BackboneCurve& b : responses.backbones) {
    std::vector<HtmlRow> rows;
    const Eigen::Index n = b.amplitude.size(), step = std::max<Eigen::Index>(1, n / 10);
    for (Eigen::Index i = 0; i < n; i += step)
      rows.push_back({{html_number(b.amplitude[i], 3), html_fixed(b.frequency[i], 2),
                       html_number(100 * b.damping[i], 3)},
                      ""});
    html +=
        html_table(fmt::format("Backbone of the mode that is at {} Hz while all joints stick{}.",
                               html_fixed(b.stuck_frequency, 1),
                               b.complete ? "" : "; " + html_escape(b.reason)),
                   {{"amplitude of " + channel(responses, responses.strongest), "m/s²"},
                    {"frequency", "Hz"},
                    {"damping", "%"}},
                   rows);
  }
  return html;
}

// Joints that take most of the energy at the highest level.
std::string joints_html(const LevelResponses& responses) {
  if (responses.curves.empty()) return "";
  const LevelCurve& last = responses.curves.back();
  double sum = 0;
  for (const JointMotion& j : last.joints) sum += j.energy;
  if (!(sum > 0)) return "";
  std::vector<JointMotion> joints = last.joints;
  std::stable_sort(joints.begin(), joints.end(),
                   [](const auto& a, const auto& b) { return a.energy > b.energy; });
  joints.resize(std::min<std::size_t>(joints.size(), 8));
  std::vector<HtmlRow> rows;
  for (const JointMotion& j : joints)
    rows.push_back(
        {{html_escape(j.joint), html_number(1e6 * j.motion, 3), html_number(1e6 * j.mean, 3),
          html_number(j.energy, 3), html_fixed(100 * j.energy / sum, 1)},
         ""});
  return html_table(fmt::format("Where friction takes the energy, at the peak of {:g} {}.",
                                last.level, responses.unit),
                    {{"joint", "", false},
                     {"motion", "µm or µrad"},
                     {"mean", "µm or µrad"},
                     {"energy per cycle", "J"},
                     {"share", "%"}},
                    rows);
}

std::string checks_html(const LevelResponses& responses) {
  std::string text;
  double worst = 0;
  for (const LinearisedError& e : responses.linearised)
    worst = std::max(worst, std::abs(e.frequency));
  if (!responses.linearised.empty())
    text += fmt::format("Equivalent linearisation misses the first peak by at most {} %. ",
                        html_number(100 * worst, 2));
  if (!responses.referee.empty()) {
    text += "Integration in time against the harmonic balance: ";
    for (std::size_t i = 0; i < responses.referee.size(); ++i) {
      const RefereeCheck& r = responses.referee[i];
      text += fmt::format("{}{} % at {:g} {}, {} Hz{}", i > 0 ? "; " : "",
                          html_number(100 * r.difference, 2), r.level, responses.unit,
                          html_fixed(r.frequency, 1), r.settled ? "" : " (not settled)");
    }
    text += ".";
  }
  return text.empty() ? "" : "<p>" + text + "</p>\n";
}

} // namespace

std::string levels_html(const Results& results) {
  std::string html;
  for (const LevelResponses& responses : results.level_responses) {
    const std::vector<PlotCurve> list = curves(responses);
    html += fmt::format("<h3>{}</h3>\n", html_escape(levels_title(responses)));
    const PlotFrame frame{.label = levels_title(responses), .ordinate = "acceleration, m/s²"};
    if (!list.empty())
      html += plot_figure(frame, list) + phase_figure(frame, phases(responses, list)) +
              plot_legend(list);
    html += fmt::format("<p>First harmonic of {} over the level; {} over {} joints and {} modes, "
                        "harmonics up to {}.</p>\n",
                        channel(responses, responses.strongest), responses.method, responses.joints,
                        responses.modes, responses.harmonics) +
            peaks_html(responses) + backbones_html(responses) + joints_html(responses) +
            checks_html(responses);
  }
  return html;
}

} // namespace plica
