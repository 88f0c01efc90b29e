// What could be measured besides, each as readings a model can be asked for.
#pragma once

#include "diagnose/predict/predictor.hpp"

namespace plica {

// Two hypotheses that readings put further apart than this, in squared standard deviations, are
// told apart no better; from three standard deviations on they are told apart.
inline constexpr double beyond_doubt = 25, well_apart = 9;

struct Offer {
  std::string what;
  double cost = 1; // 1: an hour at the rig
  TestReadings readings;
};

// Static directions and axes of the table that a test leaves out, a lower and a higher level, an
// accelerometer at each further place.
std::vector<Offer> menu(const Case& data, const Measured& measured, const TestReadings& test,
                        const std::vector<std::string>& further);

// One test after the other, in one list.
void append_readings(TestReadings& all, const TestReadings& part);

// Standard deviation of a log reading, scatter of specimens included.
double usual_sigma(ReadingKind kind);

// Takes out what the nominal case does not answer, and peaks that it has not.
void drop_unanswered(const Nominal& nominal, TestReadings& test,
                     const std::shared_ptr<StateModels>& models = nullptr);

// Offers with all their readings in one list, for a predictor that answers them at once.
struct OfferedReadings {
  std::vector<Offer> offers;
  TestReadings readings = {};
  std::vector<Eigen::Index> first{0}; // reading of each offer, and the end

  // How far apart an offer puts two specimens that would show log readings `a` and `b`, in squared
  // standard deviations.
  double apart(std::size_t offer, const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
};
OfferedReadings in_one_list(std::vector<Offer> offers);
// The menu beside a test; what the nominal case does not answer is left out.
OfferedReadings offered_beside(const Case& data, const Nominal& nominal, const Measured& measured,
                               const TestReadings& test,
                               const std::shared_ptr<StateModels>& models);

// The first two peaks along the axis of the table, seen by one sensor, and what sensors show,
// within the band of the case's response where it has one.
TestReadings sweep_readings(const Case& data, int base, double level, const std::string& main,
                            const std::vector<std::string>& sensors);

} // namespace plica
