// What a consumer expects of the installed package: it says what is otherwise, and returns that.
#pragma once

#include <cmath>
#include <cstdio>

inline int differs = 0; // 1 once anything was otherwise

inline void expect(bool holds, const char* what) {
  if (holds) return;
  std::printf("does not hold: %s\n", what);
  differs = 1;
}

// `share`: relative, of a number that is not zero.
inline void expect_near(double found, double exact, const char* what, double share = 1e-9) {
  if (std::abs(found - exact) <= share * std::abs(exact)) return;
  std::printf("%s: %.12g in place of %.12g\n", what, found, exact);
  differs = 1;
}
