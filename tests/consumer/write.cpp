// Everything at once: a case is read from its file and checked.
#include "plica/io/tables/text.hpp"
#include "plica/io/write/write_results.hpp"

#include <cstdio>

int main() {
  std::printf("%s\n", plica::significant(116.2345, 4).c_str());
  return plica::significant(116.2345, 4) == "116.2" && !plica::result_files({}).empty() ? 0 : 1;
}
