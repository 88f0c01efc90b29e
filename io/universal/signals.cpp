#include "io/universal/signals.hpp"

#include "words/directions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

struct Channel {
  std::string sensor;
  int axis = 0; // 1 x, 2 y, 3 z, 4 to 6 rotations, 0 none
};

Channel parted(const std::string& name) {
  const auto point = name.rfind('.');
  if (point != std::string::npos)
    if (const int at = place_among(direction_names, name.substr(point + 1)); at >= 0)
      return {name.substr(0, point), at + 1};
  return {name, 0};
}

std::vector<std::string> sensors_of(const std::vector<std::string>& channels) {
  std::vector<std::string> sensors;
  for (const std::string& c : channels)
    if (const std::string s = parted(c).sensor;
        std::find(sensors.begin(), sensors.end(), s) == sensors.end())
      sensors.push_back(s);
  return sensors;
}

int node_of(const std::vector<std::string>& sensors, const std::string& sensor) {
  const auto found = std::find(sensors.begin(), sensors.end(), sensor);
  return found == sensors.end() ? 0 : static_cast<int>(found - sensors.begin()) + 1;
}

UniversalDof dof_of(const std::vector<std::string>& sensors, const std::string& channel) {
  const Channel c = parted(channel);
  return {
      .entity = c.sensor.substr(0, 10), .node = node_of(sensors, c.sensor), .direction = c.axis};
}

UniversalAxis ordinate(FrfQuantity quantity) {
  constexpr std::array types{8, 11, 12, 12};
  constexpr std::array labels{"Displacement", "Velocity", "Acceleration", "Acceleration"};
  constexpr std::array units{"m", "m/s", "m/s2", "m/s2"};
  const auto q = static_cast<std::size_t>(quantity);
  return {.data_type = types[q], .label = labels[q], .unit = units[q]};
}

} // namespace

std::vector<UniversalFunction> universal_functions(const FrfSet& set) {
  const std::vector<std::string> sensors = sensors_of(set.responses);
  const Index n = set.hertz.size();
  const double step = n > 1 ? (set.hertz[n - 1] - set.hertz[0]) / double(n - 1) : 0;
  bool even = n > 1;
  for (Index i = 1; i < n; ++i)
    even =
        even && std::abs(set.hertz[i] - set.hertz[0] - double(i) * step) < 1e-9 * set.hertz[n - 1];
  const bool base = set.quantity == FrfQuantity::transmissibility;
  std::vector<UniversalFunction> functions;
  for (std::size_t i = 0; i < set.H.size(); ++i)
    for (std::size_t o = 0; o < set.responses.size(); ++o) {
      UniversalFunction f;
      f.ids[0] = set.responses[o] + " by " + set.references[i];
      f.type = base ? FunctionType::transmissibility : FunctionType::frequency_response;
      f.response = dof_of(sensors, set.responses[o]);
      f.reference = dof_of(sensors, set.references[i]);
      f.data_type = UniversalDataType::complex_double;
      f.even = even;
      f.x0 = even ? set.hertz[0] : 0;
      f.dx = even ? step : 0;
      if (!even) f.abscissa = set.hertz;
      f.abscissa_axis = {.data_type = 18, .label = "Frequency", .unit = "Hz"};
      f.numerator = ordinate(set.quantity);
      f.denominator = base ? UniversalAxis{.data_type = 12, .label = "Acceleration", .unit = "m/s2"}
                           : UniversalAxis{.data_type = 13, .label = "Force", .unit = "N"};
      f.real = set.H[i].col(Index(o)).real();
      f.imaginary = set.H[i].col(Index(o)).imag();
      functions.push_back(std::move(f));
    }
  return functions;
}

std::vector<UniversalShape> universal_shapes(const Identification& found) {
  const std::vector<std::string> sensors = sensors_of(found.set.responses);
  std::vector<UniversalShape> shapes;
  for (std::size_t r = 0; r < found.modes.size(); ++r) {
    const IdentifiedMode& m = found.modes[r];
    UniversalShape s;
    s.ids[0] = "Mode " + std::to_string(r + 1) + " of test data";
    s.data_characteristic = 2;
    s.data_type = UniversalDataType::complex_single;
    s.real = s.imaginary = Eigen::MatrixXd::Zero(Index(sensors.size()), 3);
    for (std::size_t c = 0; c < found.set.responses.size(); ++c) {
      const Channel channel = parted(found.set.responses[c]);
      const int column = channel.axis == 0 ? 0 : channel.axis - 1;
      if (column > 2) continue; // rotations have no place among three translations
      const int row = node_of(sensors, channel.sensor) - 1;
      s.real(row, column) = m.shape[Index(c)].real();
      s.imaginary(row, column) = m.shape[Index(c)].imag();
    }
    for (std::size_t k = 0; k < sensors.size(); ++k) s.nodes.push_back(static_cast<int>(k) + 1);
    const double w = 2 * std::numbers::pi * m.frequency;
    const double wd = w * std::sqrt(1 - m.damping * m.damping);
    // Residue = phi phi' / modal A; of a shape that is only relative A is not known.
    const std::complex<double> modal_a = m.mass_normalised ? std::complex<double>(0, 2 * wd) : 1.;
    const std::complex<double> eigenvalue(-m.damping * w, wd);
    describe(s, UniversalComplexMode{.load_case = 0,
                                     .mode = static_cast<int>(r) + 1,
                                     .eigenvalue = eigenvalue,
                                     .modal_a = modal_a,
                                     .modal_b = -eigenvalue * modal_a});
    shapes.push_back(std::move(s));
  }
  return shapes;
}

} // namespace plica
