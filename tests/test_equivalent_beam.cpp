// Equivalent pipe and connectors computed from shells, nothing fitted, against independent values
// of the shells: bellows A, B, C by an axisymmetric-harmonic shell with 8 elements per quarter arc.
#include "run/study/equivalent_beam.hpp"

#include "io/write/write_beam.hpp"
#include "tests/bellows_case.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/written.hpp"

#include <filesystem>
#include <fstream>

namespace plica::test {
namespace {

struct Reference {
  const char* name;
  double k_axial, k_torsion, EI;
  double axial1, axial2, bending1, bending2, torsion1;
  double first, second; // tolerance of the bending modes
};

class BeamOf : public testing::TestWithParam<Reference> {};

TEST_P(BeamOf, bellows_meets_its_shell) {
  const Reference& ref = GetParam();
  Case data = verification_case(ref.name, {.around = 96, .arc = 8, .wall = 10}, 24);
  const EquivalentBeam beam = equivalent_beam(data, [](const std::string&) {});
  const auto& pipe = std::get<EquivalentPipe>(beam.pipe.parts[0].body);
  const double EI = pipe.outer.axial * pipe.convoluted * pipe.outer.radius * pipe.outer.radius / 2;
  compare(ref.name, "axial stiffness", beam.pipe_static.k_axial, ref.k_axial, 0.04);
  compare(ref.name, "torsional stiffness", beam.pipe_static.k_torsion, ref.k_torsion, 0.02);
  compare(ref.name, "EI", EI, ref.EI, 0.04);
  const auto frequency = [&](const std::string& shape, int order) {
    for (const SimplifiedMode& m : beam.modes)
      if (m.shape == shape && m.order == order) return m.pipe.value_or(0);
    return 0.;
  };
  compare(ref.name, "axial mode 1", frequency("axial", 1), ref.axial1, 0.02);
  compare(ref.name, "axial mode 2", frequency("axial", 2), ref.axial2, 0.03);
  compare(ref.name, "bending mode 1", frequency("transverse", 1), ref.bending1, ref.first);
  if (ref.bending2 > 0)
    compare(ref.name, "bending mode 2", frequency("transverse", 2), ref.bending2, ref.second);
  EXPECT_NEAR(beam.pipe_mass / beam.mass, 1, 1e-6);
  EXPECT_NEAR(beam.connector_mass / beam.mass, 1, 1e-6);
  // The chain of short beams has the statics of the shells by construction.
  EXPECT_NEAR(beam.connector_static.k_axial / beam.shell_static.k_axial, 1, 1e-3);
  EXPECT_NEAR(beam.connector_static.k_torsion / beam.shell_static.k_torsion, 1, 1e-3);
  EXPECT_NEAR(beam.connector_static.k_bending_x / beam.shell_static.k_bending_x, 1, 1e-3);
  if (beam.ejma_axial > 0) compare(ref.name, "EJMA", beam.ejma_axial, ref.k_axial, 0.10);
}

// The convolutions at clamped ends are stiffer than the others (C: 2.8 % of the stiffness), which a
// uniform beam spreads over its length: its frequencies are 1 to 2.5 % low. Bellows B, of four
// convolutions, bends less like a beam.
INSTANTIATE_TEST_SUITE_P(Bellows, BeamOf,
                         testing::Values(Reference{"bellows_a", 5.418e4, 1.7541e4, 1.5367, 376.5,
                                                   754.8, 598.1, 995.7, 6862.5, 0.025, 0.05},
                                         Reference{"bellows_b", 1.2849e5, 1.9853e5, 33.712, 191.4,
                                                   383.2, 293.7, 465.1, 3488, 0.03, 0.10},
                                         Reference{"bellows_c", 2.3710e5, 1.6687e5, 36.078, 423.6,
                                                   851.8, 708.9, 1144.4, 6196.8, 0.025, 0.05}),
                         [](const auto& r) { return std::string(r.param.name); });

TEST(EquivalentBeam, comes_back_as_models_of_a_case_file) {
  const std::string a2 = std::string(PLICA_SOURCE_DIR) + "/cases/bellow_a2/bellow_a2.yaml";
  Case data = read_case(a2).data;
  bellows_of(data).mesh = {.around = 24, .arc = 2, .wall = 3};
  const EquivalentBeam beam = equivalent_beam(data, [](const std::string&) {});
  int compared = 0;
  for (const TransferStiffness& t : beam.transfer)
    if (t.hertz < 100) {
      EXPECT_NEAR(t.pipe[0] / t.shell[0], 1, 0.03) << t.hertz;
      ++compared;
    }
  EXPECT_GT(compared, 0);
  // The case with beam.yaml in place of its own models.
  const TemporaryFolder temporary("beam_models");
  const auto& folder = temporary.path;
  written(folder, [&](OutputFolder& out) { write_beam(beam, out); });
  std::ifstream in(a2);
  std::string text((std::istreambuf_iterator<char>(in)), {});
  text = text.substr(0, text.find("\nmodels:"));
  text = text.substr(0, text.find("\nvariants:")) + "\n";
  std::ofstream(folder / "case.yaml") << text << beam_yaml(beam);
  const Results pipe =
      run_silently(read_case((folder / "case.yaml").string(), "pipe_of_shell").data);
  EXPECT_NEAR(pipe.statics->k_axial / beam.pipe_static.k_axial, 1, 1e-5);
  const Results chain =
      run_silently(read_case((folder / "case.yaml").string(), "connector_of_shell").data);
  EXPECT_NEAR(chain.statics->k_transverse_x / beam.connector_static.k_transverse_x, 1, 1e-5);
}

TEST(EquivalentBeam, refuses_what_is_no_single_bellows) {
  const Case assembly =
      read_case(std::string(PLICA_SOURCE_DIR) + "/cases/dual_assembly/dual_assembly.yaml").data;
  EXPECT_THROW(equivalent_beam(assembly, [](const std::string&) {}), InputError);
}

} // namespace
} // namespace plica::test
