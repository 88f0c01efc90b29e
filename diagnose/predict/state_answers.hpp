// What the readings of one state of the specimen would be, parameters given.
//
// Without slip: modes of the reduced model, peaks where their sum is largest. A group of springs
// that slips: at each level and peak the amplitude is sought at which the stiffness that the
// sliders keep (describing function, one for the whole group, over the stretch of its energy) gives
// a resonance of that amplitude, with the damping that they take.
#pragma once

#include "diagnose/predict/rig_dynamics.hpp"
#include "diagnose/predict/rig_stiffness.hpp"
#include "diagnose/predict/state_model.hpp"

#include <limits>
#include <map>
#include <tuple>

namespace plica {

// What acts: coefficients of the changes on the table and in the rig, the test, the slip.
struct Acting {
  Eigen::VectorXd all, rig;
  TestSetup setup;
  std::optional<SlipGroup> group;
  Softening softening;
  // Modes in place of those that follow, and factors of the damping of each, which do not choose
  // what peak is of what mode.
  const AffineModes* given = nullptr;
  Eigen::VectorXd mode_damping = {}; // empty: 1
};

class StateAnswers {
public:
  // `seen`: how many of the observed places of the state the test looks at, those before the last.
  StateAnswers(const StateModel& state, const TestReadings& test, const Acting& acting,
               Eigen::Index seen)
      : own_(state), test_(test), acting_(acting), seen_(seen) {}

  // Logarithm of what the reading would be (a component of a shape as it is); none where the model
  // does not give it.
  std::optional<double> answer(const Reading& reading);

  // False once an answer asked for modes of a structure that is not stable, alone or as softly as
  // its group may slip: then no answer stands. Mass and static stiffness ask for none.
  bool is_stable() const { return stable_; }

  // Of a reading along another axis: what a sensor that is turned and a table that moves across
  // would add to its square (Answered).
  Eigen::Vector2d scatter_across(const Reading& reading);

  // Number of the nominal mode that a reading is of; -1 = none.
  int nominal_mode(const Reading& reading);

  // A channel of a run over frequencies of one's own, per unit of the input, nothing slipping.
  std::optional<Eigen::VectorXcd> response(const TestRun& run, const Eigen::VectorXd& hertz);

private:
  // What the model does not give, within here.
  static constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

  // A peak of a run: the modes at its amplitude, and which of them it is.
  struct Peak {
    const AffineModes* modes = nullptr;
    Eigen::VectorXd zeta;
    Eigen::Index mode = 0;
    Eigen::MatrixXcd near;   // motions within its width
    Eigen::MatrixXcd around; // where cross responses are sought, when first asked for
    double omega() const { return modes->omega(mode); }
    double damping() const { return zeta[mode]; }
  };
  // What the group keeps at a peak, and what damping it takes.
  struct Slipping {
    double stiffness = 1, damping = 0; // stiffness: in terms of the group's own
  };
  // How peaks are driven: which modes they are of (-1: none), and the amplitude of a mode, sqrt(kg)
  // m, per level: of unit damping, or whatever its damping where it is `held`.
  struct Driven {
    double level = 1;
    bool held = false;
    std::size_t peaks = 1;
    std::function<std::vector<Eigen::Index>(const AffineModes&)> modes;
    std::function<double(const AffineModes&, Eigen::Index)> amplitude;
  };

  const AffineModes* linear_modes(); // none: not stable
  Eigen::VectorXd damping_of(const AffineModes& linear) const;
  Eigen::Vector3d base_of(const TestRun& run) const {
    return acting_.setup.base.col(run.input.base);
  }
  double mass() const;
  std::optional<EndStiffness> ends_at(double kept) const;
  std::optional<double> stiffness_at(StaticDirection direction, double kept);
  double static_stiffness(const Reading& reading);
  double rig_answer(const Reading& reading);
  std::complex<double> softer_by(const Reading& reading, const RigDynamics& rig) const;
  bool answers_to(const TestRun& run) const;
  int driven_sensor(const TestRun& run) const;
  Eigen::VectorXd input_of(const AffineModes& m, const TestRun& run) const;
  Eigen::MatrixXcd motion(const AffineModes& m, const Eigen::VectorXd& zeta, const TestRun& run,
                          const std::vector<double>& omega) const;
  Eigen::RowVectorXcd reading_of(const Eigen::MatrixXcd& motion, int sensor, int axis) const;
  Eigen::VectorXd heights(const AffineModes& m, const Eigen::VectorXd& zeta,
                          const TestRun& run) const;
  std::vector<Eigen::Index> peak_modes(const AffineModes& m, const TestRun& run) const;
  std::optional<std::vector<Slipping>> slipping(const Softening& softening, const Driven& driven,
                                                SlipTable& table) const;
  double slipping_mode(const Reading& reading);
  SlipTable& table();
  bool predict_peaks(int run);
  bool predict_slipping_peaks(const TestRun& run, std::vector<Peak>& found);
  void respond(Peak& peak, const TestRun& run) const;
  void respond_around(Peak& peak, const TestRun& run) const;
  std::pair<double, double> summit(const Peak& peak, int sensor, int axis) const;
  double width(const Peak& peak, const TestRun& run) const;
  double highest(const Peak& peak, const TestRun& run, int sensor, int axis) const;
  double dynamic(const Reading& reading);
  double cross_resonance(const Reading& reading, const TestRun& run, int sensor);
  double labelled(const Reading& reading);
  std::vector<Eigen::Index> modes_of_kind(const AffineModes& m, MeasuredShape shape, int axis);
  bool is_linear(const AffineModes& m) const { return linear_ && *linear_ && &m == &**linear_; }
  Eigen::Index labelled_mode(const AffineModes& m, const Reading& reading);
  std::map<int, Eigen::Index> listed_modes(const AffineModes& m, const Reading& reading);
  double seen_at(const AffineModes& m, Eigen::Index mode, int sensor, int axis) const;
  double component(const AffineModes& m, Eigen::Index mode, const Reading& reading) const;

  const StateModel& own_;
  const TestReadings& test_;
  const Acting& acting_;
  const Eigen::Index seen_;
  bool stable_ = true;
  std::optional<std::optional<AffineModes>> linear_;
  std::map<double, std::optional<EndStiffness>> rig_; // by what the group keeps
  // By the ends: a rig, what a group has less by amplitude and direction, and Z by frequency,
  // amplitude and direction.
  struct Rig {
    RigDynamics dynamics;
    std::map<std::pair<double, int>, std::complex<double>> softer = {};
    std::map<std::tuple<double, double, int>, std::optional<Complex1212>> at = {};
  };
  std::map<std::vector<std::string>, Rig> rigs_;
  std::map<int, std::vector<Peak>> peaks_;
  // Of linear modes: by kind and axis; of modes of unknown kind by run and axis, then by order.
  std::map<std::pair<MeasuredShape, int>, std::vector<Eigen::Index>> of_kind_;
  std::map<std::pair<int, int>, std::map<int, Eigen::Index>> listed_;
  std::shared_ptr<SlipTable> table_; // what it holds stands as long as this
  // Of modes that a shaker drives, by run and peak: Hz, damping.
  std::map<std::pair<int, int>, std::pair<double, double>> driven_;
  std::vector<std::unique_ptr<AffineModes>> kept_;
};

} // namespace plica
