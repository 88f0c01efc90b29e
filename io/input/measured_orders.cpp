#include "io/input/measured_orders.hpp"

#include "lab/measured/measured_words.hpp"
#include "model/description/check_log.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace plica {
namespace {

// What the modes of one direction are counted in, in one state and run: all of these increase.
std::string counted_with(const MeasuredMode& m) {
  std::string text = std::string(word_of(m.shape)) + m.state + "/" + m.sensor + "/" + m.drive;
  if (m.direction) text += word_of(*m.direction);
  if (m.base) text += std::string("/") + word_of(*m.base);
  for (const std::optional<double>& held : {m.level, m.acceleration, m.force})
    text += held ? "/" + std::to_string(*held) : "/";
  return text;
}

// Two of one order are one mode that was measured again; known by its kind alone it is one reading.
// Transverse modes without a direction may be the two of a pair, which a part that is not round has
// far apart.
bool are_two_modes(const MeasuredMode& a, const MeasuredMode& b) {
  constexpr double measured_again = 1.2; // largest ratio of frequencies
  const bool may_be_a_pair = a.shape == MeasuredShape::transverse && !a.direction;
  return !a.base && !may_be_a_pair &&
         std::max(a.frequency, b.frequency) > measured_again * std::min(a.frequency, b.frequency);
}

} // namespace

void check_orders(const Measured& m, ReadLog& log) {
  for (std::size_t i = 0; i < m.modes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const MeasuredMode &a = m.modes[k], &b = m.modes[i];
      if (counted_with(a) != counted_with(b)) continue;
      if (a.order == b.order) {
        if (!are_two_modes(a, b)) continue;
        const std::string own = item("modes", i), order = own + ".order";
        log.add(log.lines.contains(order) ? order : own,
                fmt::format("is mode {} at {:.6g} Hz, as is the one of the same kind at {:.6g} Hz",
                            b.order, b.frequency, a.frequency),
                "orders count modes upwards from 1, which is taken where none is given; a mode "
                "that was measured again lies within a fifth");
        break;
      }
      if ((a.order < b.order) == (a.frequency < b.frequency)) continue;
      log.add(item("modes", i) + ".order",
              fmt::format("order {} at {:.6g} Hz, order {} of the same kind at {:.6g} Hz", b.order,
                          b.frequency, a.order, a.frequency),
              "orders count modes upwards; one of them is taken for another");
      break;
    }
}

} // namespace plica
