#include "diagnose/predict/menu.hpp"

#include "lab/measured/states.hpp"
#include "model/description/end_caps.hpp"
#include "words/directions.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace plica {
namespace {

class Menu {
public:
  Menu(const Case& data, const Measured& measured, const TestReadings& test)
      : case_(data), measured_(measured), test_(test) {
    for (const TestRun& run : test.runs) {
      if (run.input.base < 0) continue;
      done_.insert(run.input.base);
      lowest_ = lowest_ > 0 ? std::min(lowest_, run.level) : run.level;
      highest_ = std::max(highest_, run.level);
    }
  }

  std::vector<Offer> offers(const std::vector<std::string>& further) const {
    std::vector<Offer> all;
    if (std::all_of(measured_.weighings.begin(), measured_.weighings.end(),
                    [&](const MeasuredMass& w) { return is_baseline(measured_, w.state); }))
      all.push_back({"weigh the specimen", 0.2, numbers(ReadingKind::mass, {})});
    if (!end_caps(case_).empty())
      for (const auto& [direction, name] :
           {std::pair{StaticDirection::axial, "static stiffness along the axis"},
            {StaticDirection::transverse_x, "static stiffness across, in x"},
            {StaticDirection::transverse_z, "static stiffness across, in z"},
            {StaticDirection::bending_x, "static bending about x"},
            {StaticDirection::torsion, "static torsion"}})
        if (std::none_of(measured_.statics.begin(), measured_.statics.end(),
                         [d = direction](const MeasuredStatic& k) { return k.direction == d; }))
          all.push_back({name, 1, numbers(ReadingKind::stiffness, direction)});
    const double level = lowest_ > 0 ? lowest_ : 1;
    std::string main = "";
    for (const TestRun& run : test_.runs)
      if (!run.sensor.empty()) main = run.sensor;
    if (main.empty() && !case_.sensors.empty()) main = case_.sensors.front().name;
    for (int base = 0; base < 3; ++base) {
      const std::string axis = axis_word(base);
      if (!done_.contains(base))
        all.push_back({"a sweep along " + axis + at(level), 1,
                       sweep_readings(case_, base, level, main, {main})});
      else {
        all.push_back({"a sweep along " + axis + " at a tenth of the lowest level" + at(level / 10),
                       1, sweep_readings(case_, base, level / 10, main, {main})});
        all.push_back({"a sweep along " + axis + " at three times the highest level" +
                           at(3 * std::max(highest_, level)),
                       1,
                       sweep_readings(case_, base, 3 * std::max(highest_, level), main, {main})});
        for (const std::string& place : further)
          all.push_back({"an accelerometer at " + place + ", sweep along " + axis, 1.5,
                         sweep_readings(case_, base, level, main, {place})});
      }
    }
    return all;
  }

private:
  static std::string at(double level) { return fmt::format(" ({:g} m/s2)", level); }

  static TestReadings numbers(ReadingKind kind, StaticDirection direction) {
    TestReadings t;
    Reading r;
    r.kind = kind;
    r.direction = direction;
    t.readings.push_back(r);
    return t;
  }

  const Case& case_;
  const Measured& measured_;
  const TestReadings& test_;
  std::set<int> done_;
  double lowest_ = 0, highest_ = 0;
};

} // namespace

double usual_sigma(ReadingKind kind) {
  constexpr std::array sigmas{0.005, 0.025, 0.008, 0.1, 0.1, 0.25, 0.03, 0.2};
  return sigmas[static_cast<std::size_t>(kind)];
}

TestReadings sweep_readings(const Case& data, int base, double level, const std::string& main,
                            const std::vector<std::string>& sensors) {
  TestReadings t;
  t.runs.push_back(
      {.state = "",
       .input = {.base = base, .force = ""},
       .level = level,
       .sensor = main,
       .axis = base,
       .peaks = {0, 0},
       .first = true,
       .band = data.analyses.response ? data.analyses.response->band : std::array<double, 2>{}});
  for (int peak = 0; peak < 2; ++peak) {
    Reading r;
    r.run = 0;
    r.peak = peak;
    r.sensor = main;
    r.axis = base;
    for (ReadingKind kind : {ReadingKind::frequency, ReadingKind::damping}) {
      r.kind = kind;
      t.readings.push_back(r);
    }
  }
  for (const std::string& sensor : sensors)
    for (int axis = 0; axis < 3; ++axis) {
      Reading r;
      r.run = 0;
      r.sensor = sensor;
      r.axis = axis;
      r.kind = axis == base ? ReadingKind::amplitude : ReadingKind::cross;
      t.readings.push_back(r);
    }
  return t;
}

void drop_unanswered(const Nominal& nominal, TestReadings& test,
                     const std::shared_ptr<StateModels>& models) {
  const Predictor predict(nominal, test, {}, models);
  const auto y = predict(Eigen::VectorXd());
  if (!y) throw std::runtime_error("the nominal structure has no stable answer");
  const std::vector<int> modes = predict.nominal_modes();
  std::set<std::pair<int, int>> first; // runs, and the mode of their first peak
  for (std::size_t i = 0; i < modes.size(); ++i)
    if (const Reading& r = test.readings[i]; r.run >= 0 && r.peak == 0)
      first.insert({r.run, modes[i]});
  std::vector<Reading> kept;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const Reading& r = test.readings[i];
    if (std::isfinite((*y)[Eigen::Index(i)]) && !(r.peak > 0 && first.contains({r.run, modes[i]})))
      kept.push_back(r);
  }
  test.readings = std::move(kept);
}

void append_readings(TestReadings& all, const TestReadings& part) {
  for (Reading r : part.readings) {
    if (r.run >= 0) r.run += int(all.runs.size());
    all.readings.push_back(std::move(r));
  }
  all.runs.insert(all.runs.end(), part.runs.begin(), part.runs.end());
}

OfferedReadings in_one_list(std::vector<Offer> offers) {
  OfferedReadings all{.offers = std::move(offers), .readings = {}};
  for (const Offer& offer : all.offers) {
    append_readings(all.readings, offer.readings);
    all.first.push_back(Eigen::Index(all.readings.readings.size()));
  }
  return all;
}

OfferedReadings offered_beside(const Case& data, const Nominal& nominal, const Measured& measured,
                               const TestReadings& test,
                               const std::shared_ptr<StateModels>& models) {
  std::vector<Offer> offers = menu(data, measured, test, nominal.states.front().further_places());
  for (Offer& offer : offers) drop_unanswered(nominal, offer.readings, models);
  return in_one_list(std::move(offers));
}

double OfferedReadings::apart(std::size_t offer, const Eigen::VectorXd& a,
                              const Eigen::VectorXd& b) const {
  double sum = 0;
  for (Eigen::Index k = first[offer]; k < first[offer + 1]; ++k)
    if (const double d = a[k] - b[k]; std::isfinite(d))
      sum += std::pow(d / usual_sigma(readings.readings[std::size_t(k)].kind), 2);
  return sum;
}

std::vector<Offer> menu(const Case& data, const Measured& measured, const TestReadings& test,
                        const std::vector<std::string>& further) {
  return Menu(data, measured, test).offers(further);
}

} // namespace plica
