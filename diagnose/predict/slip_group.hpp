// A group of springs that slips, seen as a spring whose stiffness and loss depend on its stretch.
#pragma once

#include "diagnose/effects/effect.hpp"
#include "diagnose/predict/affine_modes.hpp"
#include "elements/joint_law.hpp"

#include <complex>
#include <map>
#include <memory>
#include <mutex>

namespace plica {

// Which of the changes of a model it is, and what the stretch of its energy means.
struct SlipGroup {
  int change = 0;
  double stiffness = 0; // N/m: stretch = sqrt(2 energy / this)
  double present = 1;   // how often the nominal model has what the change adds
};

// The sliders of a group that slips.
class Sliders {
public:
  explicit Sliders(const Softening& s);
  // How much of the stuck stiffness they keep at an amplitude (real part) and lose (imaginary).
  std::complex<double> kept(double amplitude) const;

private:
  JointLaw law_;
};

// Modes over the group's stiffness, all other changes held: at points in equal ratios, solved when
// first asked for, and between them in the space of the nearest point's modes. May be used by
// several threads.
class SlipTable {
public:
  SlipTable(const FreeAffineModel& model, const Eigen::VectorXd& coefficients,
            const SlipGroup& group);

  static int point_at(double stiffness); // the nearest; stiffness in terms of the group's own
  static double stiffness_of(int point);
  const AffineModes* modes_at(int point); // null: no stable structure
  std::optional<AffineModes> modes(double stiffness);

private:
  const FreeAffineModel& free_;
  Eigen::VectorXd coefficients_;
  SlipGroup group_;
  std::mutex mutex_;
  std::map<int, std::optional<AffineModes>> points_;
};

// The tables of late: what a fit varies beside the group comes back.
class SlipTables {
public:
  std::shared_ptr<SlipTable> of(const FreeAffineModel& model, Eigen::VectorXd coefficients,
                                const SlipGroup& group);

private:
  std::mutex mutex_;
  std::vector<std::pair<Eigen::VectorXd, std::shared_ptr<SlipTable>>> known_; // latest last
};

} // namespace plica
