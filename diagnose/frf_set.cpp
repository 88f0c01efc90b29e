#include "diagnose/frf_set.hpp"

#include <stdexcept>

namespace plica {

FrfSet within(const FrfSet& set, double low, double high) {
  std::vector<int> lines;
  for (int f = 0; f < set.hertz.size(); ++f)
    if (set.hertz[f] >= low && set.hertz[f] <= high) lines.push_back(f);
  if (lines.empty())
    throw std::invalid_argument("no measured line lies between " + std::to_string(low) + " and " +
                                std::to_string(high) + " Hz");
  FrfSet part = set;
  part.hertz = set.hertz(lines).eval();
  for (Eigen::MatrixXcd& H : part.H) H = H(lines, Eigen::all).eval();
  for (Eigen::MatrixXd& s : part.sigma) s = s(lines, Eigen::all).eval();
  return part;
}

} // namespace plica
