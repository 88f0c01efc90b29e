// A data set 58 as a laboratory writes it: its numbers, and the same lines when it is written.
#include "expect.hpp"
#include "plica/io/universal/reader.hpp"
#include "plica/io/universal/writer.hpp"

int main() {
  using namespace plica;
  const std::string file = // accelerance of node 7 in z by a force at node 3 in -x
      "    -1\n"
      "    58\n"
      "hammer\nNONE\nNONE\nNONE\nNONE\n"
      "    4         1    0         0 tip                7   3 NONE               3  -1\n"
      "         5         2         1  1.00000E+01  5.00000E-01  0.00000E+00\n"
      "        18    0    0    0 Frequency            Hz                  \n"
      "        12    0    0    0 Acceleration         m/s^2               \n"
      "        13    0    0    0 Force                N                   \n"
      "         0    0    0    0 NONE                 NONE                \n"
      "  1.25000E+00 -2.00000E+00  3.50000E-03  4.00000E+00\n"
      "    -1\n";
  UniversalReader reader = UniversalReader::of_text(file, "hammer.uff");
  const std::optional<UniversalDataset> set = reader.next();
  const UniversalFunction* f = set ? std::get_if<UniversalFunction>(&*set) : nullptr;
  expect(f && !reader.next(), "one function");
  if (!f) return differs;
  expect(f->warnings.empty() && f->type == FunctionType::frequency_response, "its type");
  expect(f->response.node == 7 && f->response.direction == 3, "node 7 along z answers");
  expect(f->reference.node == 3 && f->reference.direction == -1, "node 3 against x is hit");
  expect(abscissa(*f) == Eigen::Vector2d(10, 10.5), "10 Hz and half a hertz on");
  expect(f->real == Eigen::Vector2d(1.25, 3.5e-3), "real parts");
  expect(f->imaginary == Eigen::Vector2d(-2, 4), "imaginary parts");

  const std::string written = universal_text(*f);
  expect(written == file, "the same lines");
  if (written != file) std::printf("%s", written.c_str());
  return differs;
}
