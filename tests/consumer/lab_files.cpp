// Tables of a laboratory in its units: a response in g per lbf, a stiffness in N/mm, a unit alone.
#include "expect.hpp"
#include "plica/io/lab_files/measured_data.hpp"
#include "plica/io/lab_files/stiffness_table.hpp"

#include <fstream>

int main() {
  using namespace plica;
  constexpr double g = 9.80665, lbf = 4.4482216152605;
  std::ofstream("consumer_frf.csv") << "frequency [Hz];mid y real [g/lbf];mid y imag [g/lbf]\n"
                                       "10;1,5;-2\n20;0,25;4\n";
  const FrfSet set = load_frf_files({"consumer_frf.csv"}, FrfQuantity::accelerance);
  expect(set.responses == std::vector<std::string>{"mid.y"} && set.hertz.size() == 2,
         "one channel");
  expect_near(set.H[0](0, 0).real(), 1.5 * g / lbf, "real part at 10 Hz, with a decimal comma");
  expect_near(set.H[0](1, 0).imag(), 4 * g / lbf, "imaginary part at 20 Hz");

  std::ofstream("consumer_stiffness.csv") << "frequency [Hz],y storage [N/mm],rx loss [Nm/rad]\n"
                                             "5,250,0.75\n";
  const std::vector<MeasuredStiffness> rig = read_stiffness_table("consumer_stiffness.csv");
  expect(rig.size() == 2 && rig[1].direction == 3 && rig[1].quantity == StiffnessQuantity::loss,
         "two numbers, the second one a loss about x");
  expect_near(rig[0].value, 250e3, "storage along y");

  const std::optional<LabUnit> unit = lab_unit("in/sec^2");
  expect(unit && unit->powers == powers::acceleration, "in/sec^2 is an acceleration");
  if (unit) expect_near(unit->factor, 0.0254, "in/sec^2");
  return differs;
}
