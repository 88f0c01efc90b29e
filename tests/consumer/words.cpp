// What users write: quantities with units and tolerances, and a word that is misspelt.
#include "expect.hpp"
#include "plica/words/did_you_mean.hpp"
#include "plica/words/tolerance.hpp"

#include <numbers>

int main() {
  using namespace plica;
  const auto read = [](const char* text, Dimension dimension, double value) {
    expect_near(parse_quantity(text, dimension).value, value, text, 1e-12);
  };
  read("0.25 mm", Dimension::length, 2.5e-4);
  read("3 g", Dimension::mass, 3e-3);
  read("3 g", Dimension::acceleration, 3 * 9.80665);
  read("90 deg", Dimension::angle, std::numbers::pi / 2);
  expect(!parse_quantity("3 kg", Dimension::length).wrong.empty(), "3 kg is no length");

  const TolerancedQuantity E = parse_toleranced("200 GPa +- 5 %", Dimension::pressure);
  expect(E.limits.has_value(), "a modulus with a tolerance has limits");
  if (E.limits) expect_near(E.limits->low, 190e9, "lower limit of 200 GPa +- 5 %");
  if (E.limits) expect_near(E.limits->high, 210e9, "upper limit of 200 GPa +- 5 %");
  expect(nearest_word("hieght", {"pitch", "height", "weld"}) == "height", "hieght means height");
  return differs;
}
