#include "io/tables/levels_csv.hpp"

#include "io/tables/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

std::string channel(const LevelResponses& responses, int c) {
  const auto& [sensor, axis] = responses.channels[std::size_t(c)];
  return sensor + " " + axis;
}

std::string excitation_cells(const LevelResponses& responses, double level) {
  return csv_cell(levels_title(responses)) + "," + csv_number(level) + "," + responses.unit + ",";
}

void add_peaks(std::string& text, const LevelResponses& responses, const LevelCurve& curve,
               const std::vector<LevelPeak>& peaks, const char* sweep) {
  for (const LevelPeak& p : peaks)
    text += excitation_cells(responses, curve.level) +
            fmt::format("{},{},{},{},{},{}\n", sweep, csv_cell(channel(responses, p.channel)),
                        csv_number(p.frequency), csv_number(p.amplitude), csv_number(p.damping),
                        csv_number(p.energy_damping));
}

} // namespace

std::string levels_name(const LevelResponses& responses) {
  return std::string("levels_") + (responses.is_force ? "force_" : "") + responses.excitation;
}

std::string levels_title(const LevelResponses& responses) {
  return (responses.is_force ? "Force " : "Base moved in ") + responses.excitation;
}

std::string levels_csv(const LevelResponses& responses) {
  std::string text =
      fmt::format("level [{}],frequency [Hz],stable,sweep up,sweep down", responses.unit);
  const std::string per = " [m/s2 per " + responses.unit + "]";
  const std::vector<int> orders =
      responses.curves.empty() ? std::vector<int>{} : responses.curves.front().orders;
  for (int c : responses.shown) {
    for (const char* part : {" real", " imaginary"})
      text += "," + csv_cell(channel(responses, c) + part + per);
    for (int n : orders)
      text += "," + csv_cell(fmt::format("{} harmonic {}{}", channel(responses, c), n, per));
  }
  text += "\n";
  for (const LevelCurve& curve : responses.curves)
    for (Eigen::Index i = 0; i < curve.hertz.size(); ++i) {
      const auto seen = [&](const std::vector<int>& sweep) {
        return std::find(sweep.begin(), sweep.end(), int(i)) != sweep.end() ? 1 : 0;
      };
      text += fmt::format("{},{},{},{},{}", csv_number(curve.level), csv_number(curve.hertz[i]),
                          curve.stable[std::size_t(i)] ? 1 : 0, seen(curve.up), seen(curve.down));
      for (int c : responses.shown) {
        text +=
            "," + csv_number(curve.first(i, c).real()) + "," + csv_number(curve.first(i, c).imag());
        for (const Eigen::MatrixXd& higher : curve.higher) text += "," + csv_number(higher(i, c));
      }
      text += "\n";
    }
  return text;
}

std::string level_peaks_csv(const Results& results) {
  std::string text = "excitation,level,unit,sweep,channel,frequency [Hz],amplitude,"
                     "half-power damping [fraction of critical],"
                     "damping by energy [fraction of critical]\n";
  for (const LevelResponses& responses : results.level_responses)
    for (const LevelCurve& curve : responses.curves) {
      add_peaks(text, responses, curve, curve.peaks_up, "up");
      add_peaks(text, responses, curve, curve.peaks_down, "down");
    }
  return text;
}

std::string level_joints_csv(const Results& results) {
  std::string text =
      "excitation,level,unit,joint,motion [m or rad],mean [m or rad],energy per cycle [J]\n";
  for (const LevelResponses& responses : results.level_responses)
    for (const LevelCurve& curve : responses.curves)
      for (const JointMotion& j : curve.joints)
        text += excitation_cells(responses, curve.level) + csv_cell(j.joint) + "," +
                csv_number(j.motion) + "," + csv_number(j.mean) + "," + csv_number(j.energy) + "\n";
  return text;
}

std::string level_backbones_csv(const Results& results) {
  std::string text = "excitation,frequency stuck [Hz],amplitude [m/s2],frequency [Hz],"
                     "damping [fraction of critical]\n";
  for (const LevelResponses& responses : results.level_responses)
    for (const BackboneCurve& b : responses.backbones)
      for (Eigen::Index i = 0; i < b.amplitude.size(); ++i)
        text += fmt::format("{},{},{},{},{}\n", csv_cell(levels_title(responses)),
                            csv_number(b.stuck_frequency), csv_number(b.amplitude[i]),
                            csv_number(b.frequency[i]), csv_number(b.damping[i]));
  return text;
}

} // namespace plica
