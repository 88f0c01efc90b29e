#include "metrics.hpp"

#include <cmath>

namespace sealed {

Metric share(int number, const std::string& name, int good, int of, double accept, bool at_most) {
  Metric m{
      .number = number, .name = name, .good = good, .of = of, .accept = accept, .at_most = at_most};
  if (of == 0) return m;
  const double n = of, p = good / n, z = 1.96, centre = (p + z * z / (2 * n)) / (1 + z * z / n);
  const double half = z / (1 + z * z / n) * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  m.value = p;
  m.low = good == 0 ? 0 : std::max(0., centre - half);
  m.high = good == of ? 1 : centre + half;
  if (good == 0) m.high = std::min(1., 3 / n); // the rule of three
  if (good == of) m.low = std::max(0., 1 - 3 / n);
  return m;
}

Metric share_of(int number, const std::string& name, const std::vector<Scored>& all,
                const Test& counts, const Test& good, double accept, bool at_most) {
  int n = 0, k = 0;
  for (const Scored& s : all)
    if (counts(s)) {
      ++n;
      k += good(s);
    }
  return share(number, name, k, n, accept, at_most);
}

Metric median_of(int number, const std::string& name, std::vector<double> values, double accept,
                 bool at_most) {
  std::erase_if(values, [](double v) { return std::isnan(v); });
  Metric m{.number = number,
           .name = name,
           .of = int(values.size()),
           .accept = accept,
           .at_most = at_most};
  if (values.empty()) return m;
  std::sort(values.begin(), values.end());
  m.value = values[values.size() / 2];
  m.good = m.of;
  m.low = values[values.size() / 10];
  m.high = values[values.size() * 9 / 10];
  m.note = "10 and 90 % of the cases in place of bounds";
  return m;
}

} // namespace sealed
