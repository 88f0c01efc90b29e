// Fatigue life of the shells of a run: what each duty does to every place, and its sum (Miner).
//
// A site is a point of the shells on one face. Damages add up at each site and, with
// StressMeasure::critical_direction, in each of 18 directions; the life is that of the direction
// with most. Strokes and dwells are counted at every site. Histories, random excitations and sweeps
// are counted where a place and face has its largest RMS of the stress that counts, in any
// direction, and stand for all of that place and face. A stress of a state is the mean to which all
// of it adds.
//
// Below its last number of cycles a curve says "at least", so that a damage is "at most": where it
// is worst goes by what is certain, then by the range of stress.
//
//   sweep    n = df / (R ln 2) cycles between two frequencies, R octaves per second
//   random   damage per second of the spectral method (life/spectral.hpp) of the normal stress in
//            each direction, or of the von Mises stress whose density is s' A s over the densities
//            of the components (Preumont and Pitoiset 1994)
//   history  rainflow; of von Mises stress with its sign over time
#pragma once

#include "run/analyses/shell_points.hpp"
#include "run/analyses/stress.hpp"
#include "run/analyses/stress_coordinates.hpp"

#include <functional>

namespace plica {

// Of one duty, over sites and directions.
struct DutyMap {
  DutyResult head;
  Eigen::MatrixXf damage, range, mean; // sites x directions; Pa
  Eigen::MatrixXf certain;             // damage without cycles that lie below the curve
  Eigen::Matrix<unsigned char, Eigen::Dynamic, Eigen::Dynamic> bounds; // 1 at most, 2 at least
  std::vector<int> counted; // sites that stand for their place and face; empty: all by themselves
  std::function<RandomStress(int site, int direction)> random = {};
};

class LifeCount {
public:
  LifeCount(const Case& data, const BuiltCase& built);

  // Strokes and histories of movement of the second of two caps, K their stiffness. `built`: the
  // model of the route. Gives the stress of the strokes.
  StaticStress add_movements(const BuiltCase& built, Route& route, const std::array<int, 2>& caps,
                             const Matrix1212& K);
  // All that acts by excitations, without friction. Throws InputError for what has no answer.
  void add_dynamic(const DampedModes& modes, const Excitations& excited);
  // Sweeps with friction; `slipping` as jointed_model() takes it.
  void add_friction_sweeps(const BuiltCase& slipping, Route& route, const StageListener& stage);

  LifeResult result() const;
  const std::vector<StressPlace>& places() const { return points_.places; }

private:
  Eigen::MatrixXd plane_of(const StressField& field) const; // of the thickest ply
  DutyMap new_duty(DutyKind kind, const std::string& name, const std::string& what, double count,
                   const std::string& unit) const;
  void add_stroke(const LifeStroke& stroke, const Eigen::MatrixXd& plane, const Eigen::VectorXd& q);
  void add_history(const LifeHistory& history, const std::string& what,
                   const Eigen::MatrixXd& plane, const Eigen::MatrixXd& q);
  void add_random(const LifeRandom& asked, const Excitation& e,
                  const StressCoordinates& coordinates,
                  const std::shared_ptr<const Eigen::MatrixXd>& plane,
                  const Eigen::VectorXd& hertz);
  // Of accelerations and forces over time.
  void add_excited_history(const LifeHistory& history, const std::string& key,
                           const Eigen::MatrixXd& plane, const DampedModes& modes,
                           const Excitations& excited);
  void add_sweep(const LifeSweep& asked, const Excitation& e, const StressCoordinates& coordinates,
                 const Eigen::MatrixXd& plane, const DampedModes& modes);
  void add_friction_sweep(const LifeSweep& asked, const BuiltCase& slipping, Route& route,
                          const StageListener& stage);
  void add_dwell(const LifeDwell& asked, const Excitation& e, const std::string& key,
                 const StressCoordinates& coordinates, const Eigen::MatrixXd& plane,
                 const DampedModes& modes);
  // Worst site of each place and face under coordinates with the covariance C.
  std::vector<int> worst_sites(const Eigen::MatrixXd& plane, const Eigen::MatrixXd& C) const;
  void count(DutyMap& duty, int site, Eigen::Index direction, const StressCycle& cycle,
             double times) const;
  // A cycle between both ends of a harmonic stress.
  void count_amplitude(DutyMap& duty, int site, Eigen::Index direction,
                       const Eigen::Vector3cd& stress, double times) const;
  void spread(DutyMap& duty) const;
  LifeSpot spot_at(Eigen::Index site, Eigen::Index direction, double damage) const;

  const Case& case_;
  const Life& life_;
  const Model& model_;
  ShellPoints points_;
  int nodes_ = 0;
  std::vector<Eigen::Vector3d> at_; // of points
  Eigen::MatrixXd directions_;      // x 3: normal stress of (11, 22, 12); one row of von Mises: 0
  Eigen::VectorXd state_;           // 3 site + component, Pa
  std::vector<DutyMap> duties_;
  std::vector<std::string> warnings_;
};

// "base y, 20 m/s2, 10 to 500 Hz at 1 octave/min"
std::string sweep_words(const LifeSweep& sweep, const std::string& title, const std::string& unit);

} // namespace plica
