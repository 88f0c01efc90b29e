// What a planned test could tell, before it is made: which effects would look alike, how small an
// effect would still be found, and what to add for its cost.
#pragma once

#include "diagnose/results/diagnosis.hpp"
#include "model/description/case.hpp"

#include <functional>

namespace plica {

struct TestPlan {
  std::vector<int> bases;     // 0..2 = x y z; empty = those of the case's response, else y and x
  std::vector<double> levels; // m/s2; empty = those of the case, else its response's
  bool weighed = true,
       pulled = true; // scale; static rig along and across, where there are two caps
};

// What the plan does not have yet.
struct PlannedAddition {
  std::string what;
  double cost = 1; // 1: an hour at the rig
  double gain = 0; // of how far apart the effects lie, beyond what was added before it
};

struct Pretest {
  std::string case_name;
  std::vector<std::string> plan; // in words
  std::vector<std::string> effects;
  Eigen::MatrixXd likeness; // effects x effects
  std::vector<Mimic> mimics;
  std::vector<SmallestDetectable> detectable;
  std::vector<PlannedAddition> additions; // in the order in which they help most
};

// Sensors are those of the case. Throws as diagnose() does.
Pretest pretest(const Case& data, const TestPlan& plan,
                const std::function<void(const std::string&)>& stage);

} // namespace plica
