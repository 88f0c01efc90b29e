// The sheet of hand formulas that a maker of bellows hands over (model/description/ejma.hpp),
// beside the shells of the same bellows alone, both ends held (run/study/bellows_shells.hpp).
#pragma once

#include "life/curves.hpp"
#include "model/description/case.hpp"
#include "model/description/ejma.hpp"
#include "run/stages.hpp"

namespace plica {

struct EjmaRequest {
  double pressure = 0;               // inside over outside, Pa
  EjmaMovement movement = {};        // from one end position to the other
  std::optional<double> cycles = {}; // asked for; damage by Miner
  double Kg = 1;                     // fatigue strength reduction, 1 to 4
  std::optional<double> yield = {};  // of the formed wall, Pa, for in-plane squirm
  bool shells = true;                // false: formulas alone
};

struct SheetLine {
  std::string group;                     // "geometry", "coefficients", ...
  std::string key, text, unit;           // "S5", "meridional membrane stress by movement", "Pa"
  std::optional<double> formula, shells; // SI; none where one of them has no such number
};

struct EjmaSheet {
  std::string bellows; // part
  std::string refused; // why the formulas do not apply; empty = they do
  std::vector<SheetLine> lines;
  std::optional<CurveLife> life, shell_life; // cycles allowed for St
  std::string curve;                         // name, source and what is inside of it
  std::vector<std::string> remarks;
};

// A sheet of every bellows of the case. The wall of the case is taken as it is drawn: tp = t unless
// it says how it is thinned. `stage` is told what runs. Throws InputError for a case without a
// bellows with convolutions, and for a request that no bellows can follow.
std::vector<EjmaSheet> ejma_sheets(const Case& data, const EjmaRequest& request,
                                   const StageListener& stage);

} // namespace plica
