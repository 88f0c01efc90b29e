// Structures of the suite "changes": what they really are, by theories of the suite's own, with
// what their models leave out, and what may change in them.
#pragma once

#include "../draws.hpp"
#include "../specimen.hpp"

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <memory>

namespace sealed {

// What the model of the case leaves out, and how much of it there is.
struct Mechanism {
  std::string name;       // of `mechanisms`
  double amount = 0;      // 0 = the model is right
  std::uint64_t seed = 0; // of fields along the structure
};

// The first of them may choose thresholds, metrics are of the others.
//   boundary  what holds the structure gives way
//   cables    mass along it that nobody drew
//   taper     the wall is thicker here, thinner there
//   places    lengths and places are millimetres off
//   theory    a refinement of its theory: joints of finite size, a sheet that is stiffer along than
//             across
inline const std::vector<std::string> mechanisms{"boundary", "cables", "taper", "places", "theory"};
inline bool chooses_thresholds(const std::string& mechanism) {
  return mechanism == "boundary" || mechanism == "cables";
}

// A change whose place is drawn and whose size is open.
struct Change {
  Effect effect;    // without its size
  std::string size; // key of the value that says how large: "mass"
  double smallest = 0, largest = 0;
  bool inverse = false;   // the value is one over the size: springs of a clamp
  bool about_one = false; // the value is the exponential of the size, of this sign
  double sign = 1;
  double value(double s) const;
};

// What a test of modes finds: frequencies, Hz, and of each mode what its channels show; no shapes
// where the test lists frequencies alone.
struct FoundModes {
  Eigen::VectorXd frequencies;
  std::vector<Eigen::VectorXd> shapes = {};
};

// Where a hammer strikes that the case knows no sensor at.
struct Station {
  std::string name;
  double along = 0; // m
};

class ChangedStructure {
public:
  virtual ~ChangedStructure() = default;
  virtual std::string name() const = 0;
  // Of the modes in a row, as keys of an entry of `modes`.
  virtual std::vector<std::string> labels() const = 0;
  virtual double damping() const = 0;
  virtual FoundModes modes(const Mechanism& mechanism, const Effect& change) const = 0;
  Eigen::VectorXd frequencies(const Mechanism& mechanism, const Effect& change) const {
    return modes(mechanism, change).frequencies;
  }
  virtual std::vector<Station> stations() const { return {}; }
  // Of the shape of a mode, counted from 0.
  virtual std::vector<std::string> channels(std::size_t /*mode*/) const { return {}; }
  virtual Change draw_change(Draws& draws) const = 0;
  // Where a place of a diagnosis is, m along the structure; NaN: nowhere.
  virtual double position(const std::string& /*place*/) const {
    return std::numeric_limits<double>::quiet_NaN();
  }
  // The same, of a plate along and across; empty: nowhere.
  virtual std::vector<double> point(const std::string& place) const {
    const double along = position(place);
    return std::isnan(along) ? std::vector<double>() : std::vector<double>{along};
  }
  virtual double length() const = 0;
  virtual bool symmetric() const { return false; } // what sits at s or at length - s is alike
  // Where what sits at a point sits as well.
  virtual std::vector<double> mirrored(std::vector<double> point) const {
    if (symmetric()) point[0] = length() - point[0];
    return point;
  }
  // Whether two changes of one place each cannot be told apart by any frequency.
  virtual bool alike(const std::string& /*effect*/, const std::string& /*place*/,
                     const std::string& /*other_effect*/,
                     const std::string& /*other_place*/) const {
    return false;
  }
};

std::vector<std::unique_ptr<ChangedStructure>> changed_structures();

// Smooth in s from 0 to 1, about zero, of unit scale.
double smooth_field(std::uint64_t seed, double s);

} // namespace sealed
