// A plate of S8R, 300 by 200 mm and curved along its length, held at one short side, as a deck.
#pragma once

#include <fmt/format.h>

#include <string>

namespace plica::test {

struct CurvedPlate {
  std::string mesh; // *NODE of the set ALL, *ELEMENT of the set PLATE
  std::string held; // data of *BOUNDARY
  int corner = 0, other = 0;
};

inline CurvedPlate curved_plate() {
  constexpr int along = 24, across = 16;
  const auto number = [](int i, int j) { return 1000 * j + i + 1; };
  CurvedPlate plate{.mesh = "*NODE, NSET=ALL\n",
                    .held = "",
                    .corner = number(2 * along, 0),
                    .other = number(2 * along, 2 * across)};
  for (int j = 0; j <= 2 * across; ++j)
    for (int i = 0; i <= 2 * along; ++i) {
      if (i % 2 == 1 && j % 2 == 1) continue;
      plate.mesh += fmt::format("{}, {:.9g}, {:.9g}, {:.9g}\n", number(i, j), 150. * i / along,
                                100. * j / across, 20. * i * i / (4. * along * along));
      if (i == 0) plate.held += fmt::format("{}, 1, 6\n", number(i, j));
    }
  plate.mesh += "*ELEMENT, TYPE=S8R, ELSET=PLATE\n";
  for (int j = 0, e = 0; j < 2 * across; j += 2)
    for (int i = 0; i < 2 * along; i += 2)
      plate.mesh +=
          fmt::format("{}, {}, {}, {}, {}, {}, {}, {}, {}\n", ++e, number(i, j), number(i + 2, j),
                      number(i + 2, j + 2), number(i, j + 2), number(i + 1, j),
                      number(i + 2, j + 1), number(i + 1, j + 2), number(i, j + 1));
  return plate;
}

} // namespace plica::test
