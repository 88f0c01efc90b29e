#include "io/tables/levels_csv.hpp"

#include "io/tables/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

std::string channel(const LevelFamily& family, int c) {
  const auto& [sensor, axis] = family.channels[std::size_t(c)];
  return sensor + " " + axis;
}

std::string excitation_cells(const LevelFamily& family, double level) {
  return csv_cell(levels_title(family)) + "," + csv_number(level) + "," + family.unit + ",";
}

void add_peaks(std::string& text, const LevelFamily& family, const LevelCurve& curve,
               const std::vector<LevelPeak>& peaks, const char* sweep) {
  for (const LevelPeak& p : peaks)
    text += excitation_cells(family, curve.level) +
            fmt::format("{},{},{},{},{},{}\n", sweep, csv_cell(channel(family, p.channel)),
                        csv_number(p.frequency), csv_number(p.amplitude), csv_number(p.damping),
                        csv_number(p.energy_damping));
}

} // namespace

std::string levels_name(const LevelFamily& family) {
  return std::string("levels_") + (family.is_force ? "force_" : "") + family.excitation;
}

std::string levels_title(const LevelFamily& family) {
  return (family.is_force ? "Force " : "Base moved in ") + family.excitation;
}

std::string levels_csv(const LevelFamily& family) {
  std::string text =
      fmt::format("level [{}],frequency [Hz],stable,sweep up,sweep down", family.unit);
  const std::string per = " [m/s2 per " + family.unit + "]";
  const std::vector<int> orders =
      family.curves.empty() ? std::vector<int>{} : family.curves.front().orders;
  for (int c : family.shown) {
    for (const char* part : {" real", " imaginary"})
      text += "," + csv_cell(channel(family, c) + part + per);
    for (int n : orders)
      text += "," + csv_cell(fmt::format("{} harmonic {}{}", channel(family, c), n, per));
  }
  text += "\n";
  for (const LevelCurve& curve : family.curves)
    for (Eigen::Index i = 0; i < curve.hertz.size(); ++i) {
      const auto seen = [&](const std::vector<int>& sweep) {
        return std::find(sweep.begin(), sweep.end(), int(i)) != sweep.end() ? 1 : 0;
      };
      text += fmt::format("{},{},{},{},{}", csv_number(curve.level), csv_number(curve.hertz[i]),
                          curve.stable[std::size_t(i)] ? 1 : 0, seen(curve.up), seen(curve.down));
      for (int c : family.shown) {
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
  for (const LevelFamily& family : results.families)
    for (const LevelCurve& curve : family.curves) {
      add_peaks(text, family, curve, curve.peaks_up, "up");
      add_peaks(text, family, curve, curve.peaks_down, "down");
    }
  return text;
}

std::string level_joints_csv(const Results& results) {
  std::string text = "excitation,level,unit,joint,motion [m or rad],energy per cycle [J]\n";
  for (const LevelFamily& family : results.families)
    for (const LevelCurve& curve : family.curves)
      for (const JointMotion& j : curve.joints)
        text += excitation_cells(family, curve.level) + csv_cell(j.joint) + "," +
                csv_number(j.motion) + "," + csv_number(j.energy) + "\n";
  return text;
}

std::string level_backbones_csv(const Results& results) {
  std::string text = "excitation,frequency stuck [Hz],amplitude [m/s2],frequency [Hz],"
                     "damping [fraction of critical]\n";
  for (const LevelFamily& family : results.families)
    for (const BackboneCurve& b : family.backbones)
      for (Eigen::Index i = 0; i < b.amplitude.size(); ++i)
        text += fmt::format("{},{},{},{},{}\n", csv_cell(levels_title(family)),
                            csv_number(b.stuck_frequency), csv_number(b.amplitude[i]),
                            csv_number(b.frequency[i]), csv_number(b.damping[i]));
  return text;
}

} // namespace plica
