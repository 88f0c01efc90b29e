// A bellows whose arcs do not fit its pitch: the rules say so, and a number put right by its path.
#include "expect.hpp"
#include "plica/model/description/case_checks.hpp"
#include "plica/model/description/case_path.hpp"
#include "plica/model/description/ejma.hpp"
#include "plica/model/description/profile.hpp"

int main() {
  using namespace plica;
  Case data;
  data.name = "bellows";
  data.materials["steel"] = {200e9, 0.3, 7850};
  Bellows bellows{.material = "steel", .root_radius = 0.05};
  bellows.profile = {{.shape = SectionShape::cuff, .length = 0.02},
                     {.count = 5, .height = 0.01, .pitch = 0.008, .root_arc_radius = 0.004}};
  bellows.wall.plies = {2e-4};
  bellows.mesh.accuracy = 0.01;
  data.parts.push_back({"bellows", bellows});
  data.caps = {{.name = "left", .of = {"bellows.left"}},
               {.name = "right", .of = {"bellows.right"}}};
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  data.analyses.modes = Modes{.count = 4};
  const auto problems = [&] { return check_case(data, {}, "."); };
  expect(problems().size() == 1 && problems()[0].key.starts_with("parts.bellows.profile[1]"),
         "one problem, of the second section");
  for (const InputProblem& problem : problems()) std::printf("%s\n", to_string(problem).c_str());

  double* arc = number_at(data, "parts.bellows.profile[1].root_arc_radius");
  expect(arc && *arc == 0.004, "the number at its path");
  if (arc) *arc = 0.002;
  expect(problems().empty(), "nothing is wrong any more");
  expect_near(axial_length(std::get<Bellows>(data.parts[0].body)), 0.06, "length");
  // Very many convolutions move as a rod does: f = sqrt(K / M) / 2.
  expect_near(ejma_axial_frequency(1, 500, 4e6, 0.25), 2000, "first axial frequency", 1e-6);
  return differs;
}
