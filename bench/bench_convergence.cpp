// Convergence of the three membrane choices on four bellows: axial stiffness, first axial and first
// transverse frequency, refining the circumference and the meridian apart from each other, and the
// values extrapolated in both directions at order 2.
#include "run/analyses/run.hpp"
#include "solve/blas_kernels.hpp"
#include "solve/sparse_factor.hpp"

#include <fmt/core.h>

namespace {

using namespace plica;

struct Drawing {
  const char* name;
  double root_radius, height, pitch, wall, E, rho;
  int count;
  std::array<double, 3> reference; // kN/m, Hz, Hz: axisymmetric-harmonic shell, another program
};

constexpr std::array drawings{
    Drawing{"A2", 65e-3, 8e-3, 6.58e-3, 0.5e-3, 193e9, 8000, 27, {253.8, 261.6, 362.7}},
    Drawing{"A", 26e-3, 9e-3, 6e-3, 0.3e-3, 193e9, 7900, 10, {54.18, 376.5, 598.1}},
    Drawing{
        "B", 44.9072e-3, 37.1856e-3, 31.75e-3, 0.76454e-3, 197e9, 7900, 4, {128.49, 191.4, 293.7}},
    Drawing{"C", 50e-3, 12e-3, 12e-3, 0.5e-3, 200e9, 7850, 8, {237.10, 423.6, 708.9}}};

Case clamped(const Drawing& d, MembraneStrain membrane, const MeshDensity& mesh) {
  Bellows bellows;
  bellows.material = "steel";
  bellows.root_radius = d.root_radius;
  MeridianSection convolutions, cuff;
  convolutions.count = d.count;
  convolutions.height = d.height;
  convolutions.pitch = d.pitch;
  cuff.shape = SectionShape::cuff;
  cuff.length = 2.1e-3;
  cuff.elements = 3;
  if (d.count == 27)
    bellows.profile = {cuff, convolutions, cuff};
  else
    bellows.profile = {convolutions};
  bellows.wall.plies = {d.wall};
  bellows.mesh = mesh;
  bellows.membrane = membrane;
  Case data;
  data.materials["steel"] = {d.E, 0.3, d.rho};
  data.parts = {{"bellows", bellows}};
  data.caps = {{.name = "left", .of = {"bellows.left"}},
               {.name = "right", .of = {"bellows.right"}}};
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  data.analyses.modes = Modes{.count = 3};
  data.analyses.modes->proof = false;
  return data;
}

std::array<double, 3> headline_of(const Drawing& d, MembraneStrain membrane, int around, int arc,
                                  int wall) {
  const auto h = headline(run(clamped(d, membrane, {around, arc, wall, 0}), [](const auto&) {}));
  const std::array<double, 3> values{h.at("k_axial") / 1e3, h.at("f_axial"), h.at("f_transverse")};
  fmt::print("  {:>3} x ({},{:>2})   ", around, arc, wall);
  for (int i = 0; i < 3; ++i)
    fmt::print(" {:>9.2f} ({:+.2f} %)", values[i], 100 * (values[i] / d.reference[i] - 1));
  fmt::print("\n");
  return values;
}

} // namespace

int main(int, char** argv) {
  avoid_faulty_blas_kernels(argv);
  set_threads(0);
  constexpr std::array names{"displacement", "mitc4+", "incompatible"};
  for (const Drawing& d : drawings)
    for (int m = 0; m < 3; ++m) {
      fmt::print("{} {}: around x (quarter arc, wall); k_axial kN/m, f axial Hz, f transverse Hz\n",
                 d.name, names[m]);
      const auto membrane = static_cast<MembraneStrain>(m);
      const auto coarse = headline_of(d, membrane, 36, 4, 5);
      const auto around = headline_of(d, membrane, 72, 4, 5);
      const auto along = headline_of(d, membrane, 36, 8, 10);
      fmt::print("  extrapolated  ");
      for (int i = 0; i < 3; ++i) {
        const double limit = coarse[i] + 4. / 3 * (around[i] - coarse[i] + along[i] - coarse[i]);
        fmt::print(" {:>9.2f} ({:+.2f} %)", limit, 100 * (limit / d.reference[i] - 1));
      }
      fmt::print("\n");
    }
}
