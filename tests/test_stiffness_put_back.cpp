// The dynamic stiffness of a part, put into CalculiX one direction at a time as springs and
// dashpots of that frequency and amplitude, with a mass behind it: beside Plica's response of the
// whole, part and mass.
#include "tests/sliding_chain.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tube_case.hpp"

#include "compare/compare_stiffness.hpp"
#include "io/files/files.hpp"
#include "run/study/part_stiffness.hpp"

#include <cmath>
#include <complex>
#include <cstdlib>
#include <iomanip>
#include <map>
#include <numbers>
#include <sstream>

namespace plica::test {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

// Motion along one line: a foot (node 1), the part as a spring and a dashpot, the mass (node 2),
// and from there to the ground (node 3) a second pair, which holds the inertia of the part. For a
// rotation N stands for Nm and kg for kg m2.
struct OneDirection {
  double hertz = 0, mass = 0;
  Complex part = 0, ground = 0; // N/m
  bool foot_moves = false;
};

// The foot is held and 1 N pushes the mass, or it is a mass of 1e7 kg that a force moves by 1 m.
// Stiff masses beside it, since CalculiX looks for no modes of a few degrees of freedom.
std::string deck_in_one_direction(const OneDirection& d) {
  constexpr double seismic = 1e7;
  const double omega = 2 * pi * d.hertz;
  std::ostringstream deck, others, springs, masses, held;
  for (int i = 0; i < 9; ++i) {
    others << 110 + i << "," << i + 1 << ",0.5,0\n" << 120 + i << "," << i + 1 << ",0,0\n";
    springs << 130 + i << "," << 120 + i << "," << 110 + i << "\n";
    masses << 140 + i << "," << 110 + i << "\n";
    held << 110 + i << ",1,1\n" << 110 + i << ",3,3\n" << 120 + i << ",1,3\n";
  }
  deck << std::showpoint << std::setprecision(10)
       << "*NODE,NSET=ALL\n1,0,0,0\n2,0,1,0\n3,0,2,0\n4,0,-1,0\n*NODE\n"
       << others.str() << "*ELEMENT,TYPE=SPRINGA,ELSET=X\n"
       << springs.str() << "*ELEMENT,TYPE=MASS,ELSET=Y\n"
       << masses.str() << "*SPRING,ELSET=X\n\n1000000000.\n*MASS,ELSET=Y\n1.\n"
       << "*ELEMENT,TYPE=SPRINGA,ELSET=S\n1,1,2\n*ELEMENT,TYPE=SPRINGA,ELSET=G\n2,2,3\n"
       << "*ELEMENT,TYPE=MASS,ELSET=M\n3,2\n*ELEMENT,TYPE=DASHPOTA,ELSET=D\n4,1,2\n"
       << "*ELEMENT,TYPE=DASHPOTA,ELSET=E\n5,2,3\n*ELEMENT,TYPE=SPRINGA,ELSET=W\n6,4,1\n"
       << "*ELEMENT,TYPE=MASS,ELSET=F\n7,1\n*SPRING,ELSET=S\n\n"
       << d.part.real() << "\n*SPRING,ELSET=G\n\n"
       << d.ground.real() << "\n*SPRING,ELSET=W\n\n"
       << seismic << "\n*MASS,ELSET=M\n"
       << d.mass << "\n*MASS,ELSET=F\n"
       << seismic << "\n*DASHPOT,ELSET=D\n\n"
       << d.part.imag() / omega << "\n*DASHPOT,ELSET=E\n\n"
       << d.ground.imag() / omega << "\n*BOUNDARY\n"
       << held.str() << "3,1,3\n4,1,3\n1,1,1\n1,3,3\n2,1,1\n2,3,3\n";
  if (!d.foot_moves) deck << "1,2,2\n";
  deck << "*STEP\n*FREQUENCY,STORAGE=YES\n"
       << (d.foot_moves ? 2 : 1) << "\n*END STEP\n*STEP\n"
       << "*STEADY STATE DYNAMICS\n"
       << d.hertz << "," << d.hertz + 1 << ",2,1.\n*CLOAD\n";
  if (d.foot_moves)
    deck << "1,2," << seismic * (1 - omega * omega) << "\n";
  else
    deck << "2,2,1.\n";
  deck << "*NODE PRINT,NSET=ALL\nU\n*END STEP\n";
  return deck.str();
}

// Motion of the mass, m, per motion of the foot or per N.
Complex in_calculix(const OneDirection& d) {
  const TemporaryFolder folder("put_back");
  write_whole(folder.path / "system.inp", deck_in_one_direction(d));
  const std::string command = "cd '" + folder.path.string() + "' && ccx -i system >log 2>&1";
  if (std::system(command.c_str()) != 0) throw std::runtime_error("ccx is not there, or broke off");
  std::istringstream dat(read_whole(folder.path / "system.dat"));
  std::map<int, std::vector<double>> along; // of a node, real then imaginary, for every frequency
  bool printed = false;
  for (std::string line; std::getline(dat, line);) {
    printed = printed || line.find("displacements") != std::string::npos;
    std::istringstream fields(line);
    int node = 0;
    double x = 0, y = 0, z = 0;
    if (printed && fields >> node >> x >> y >> z) along[node].push_back(y);
  }
  if (along[2].size() < 2) throw std::runtime_error(read_whole(folder.path / "log"));
  const Complex mass(along[2][0], along[2][1]), foot(along[1][0], along[1][1]);
  return d.foot_moves ? mass / foot : mass;
}

StiffnessRequest at_frequency(double hertz) {
  StiffnessRequest r;
  r.hertz = Eigen::VectorXd::Constant(1, hertz);
  return r;
}

// Part and mass, its right end free in one direction alone and its left one moving in it. A lever
// without mass shows rotations as motion of its end.
struct TubeAndMass {
  Case data;
  int channel = 0;   // of the sensor
  double factor = 1; // its motion per motion of the end
};

TubeAndMass tube_and_mass(Case part, int direction, double mass) {
  constexpr double arm = 0.1, rigid = 1e10;
  TubeAndMass w{std::move(part)};
  BeamPart lever = std::get<BeamPart>(w.data.parts[0].body);
  lever.points = {{0, L, 0}, {arm, L, arm}};
  lever.elements = 1;
  lever.section.EA = lever.section.GA = 1e9;
  lever.section.EI = lever.section.GJ = 1e7;
  lever.section.mass_per_length = 1e-9;
  lever.section.rotary_inertia_per_length = lever.section.polar_inertia_per_length = 1e-12;
  w.data.parts.push_back({"lever", lever});
  Cap& end = w.data.caps[1];
  end.of = {"tube.end", "lever.start"};
  if (direction < 3)
    end.mass = mass;
  else
    end.inertia = {mass, mass, mass, 0, 0, 0};
  w.data.mount[1].kind = MountKind::springs;
  w.data.mount[1].stiffness = {rigid, rigid, rigid, rigid, rigid, rigid};
  w.data.mount[1].stiffness[std::size_t(direction)] = 0;
  w.data.sensors = {{.name = "end", .at = {arm, L, arm}}};
  // A turn about x, y, z moves the end of the lever along y, x, y.
  constexpr std::array channels{0, 1, 2, 1, 0, 1};
  constexpr std::array factors{1., 1., 1., -arm, arm, arm};
  w.channel = channels[std::size_t(direction)];
  w.factor = factors[std::size_t(direction)];
  return w;
}

Complex transmissibility_of(TubeAndMass w, int direction, double hertz) {
  w.data.analyses.damping.coupled = true;
  w.data.analyses.statics = false;
  w.data.analyses.error_bars = false;
  w.data.analyses.modes = Modes{.band = {0, 3000}};
  w.data.analyses.response = Response{.bases = {},
                                      .motions = {motion_of("left", direction)},
                                      .band = {hertz - 1, hertz + 1},
                                      .points = 3};
  const Results results = run_silently(w.data);
  const ResponseResult& r = results.responses.at(0);
  for (long i = 0; i < r.hertz.size(); ++i)
    if (std::abs(r.hertz[i] - hertz) < 1e-6) return r.acceleration(i, w.channel) / w.factor;
  throw std::runtime_error("the response has no such frequency");
}

// A damped tube whose left end moves, a mass or an inertia on its right one, each of the six
// directions for itself.
TEST(StiffnessPutBack, carries_a_mass_in_every_direction) {
  constexpr std::array names{"x", "y", "z", "rx", "ry", "rz"};
  constexpr std::array frequencies{12., 120., 12., 40., 60., 40.};
  Case data = tube(2);
  data.analyses.damping.loss_factors = {{.of = "tube", .value = 0.08}};
  for (int d = 0; d < 6; ++d) {
    OneDirection one{.hertz = frequencies[std::size_t(d)], .foot_moves = true};
    const Complex1212 Z = part_stiffness(data, at_frequency(one.hertz), [](const std::string&) {})
                              .states[0]
                              .over.at[0][0];
    const double omega = 2 * pi * one.hertz;
    one.part = transfer_stiffness(Z, d); // of bending below zero
    one.ground = driving_point_stiffness(Z, d, 1) - one.part;
    one.mass = 0.6 * (one.part + one.ground).real() / (omega * omega); // not far from resonance
    const Complex own = transmissibility_of(tube_and_mass(data, d, one.mass), d, one.hertz),
                  theirs = in_calculix(one);
    print_for_table(std::string("tube and mass in CalculiX, transmissibility along ") +
                        names[std::size_t(d)],
                    std::abs(own), std::abs(theirs), 0.01);
    EXPECT_LT(std::abs(own - theirs) / std::abs(theirs), 0.01) << own << " " << theirs;
  }
}

constexpr double slid_mass = 3, mount_spring = 5e3, mount_dashpot = 60; // kg, N/m, N s/m

// Two sliders in a row, behind them a mass on a damped mount that a force pushes.
LevelResponses pushed_sliders(int harmonics) {
  Case whole = sliding_chain();
  whole.caps[1].mass = slid_mass;
  whole.mount[1].kind = MountKind::springs;
  whole.mount[1].stiffness = {mount_spring, mount_spring, mount_spring, 0, 0, 0};
  whole.mount[1].damping.emplace().dashpot = {0, mount_dashpot, 0, 0, 0, 0};
  whole.sensors = {{.name = "end", .at = {0, 0.2, 0}}};
  whole.analyses.statics = false;
  whole.analyses.error_bars = false;
  whole.analyses.modes = Modes{.count = 3};
  Levels levels;
  levels.forces = {{.name = "push", .at = "chain.right", .direction = 1, .levels = {0.5, 4, 12}}};
  levels.band = {4, 40};
  levels.points = 400;
  levels.harmonics = harmonics;
  levels.referee = 0;
  whole.analyses.levels = levels;
  return run_silently(whole).level_responses.at(0);
}

// Motion of the mass, m/N, and what CalculiX makes of it with the sliders as a spring and a dashpot
// of that frequency and amplitude.
struct PutBack {
  double own = 0, theirs = 0;
  double third = 0;  // harmonic of the acceleration, over the first
  double spring = 0; // that is left of the stuck stiffness
};

PutBack put_back(const LevelCurve& curve, Eigen::Index k, int harmonics) {
  OneDirection one{.hertz = curve.hertz[k], .mass = slid_mass};
  const double omega = 2 * pi * one.hertz;
  PutBack p{.own = std::abs(curve.first(k, 1)) / (omega * omega)};
  StiffnessRequest request = at_frequency(one.hertz);
  request.ends = {"right", "left"}; // the end with the mass moves
  request.levels = {{.translation = p.own * curve.level}};
  request.harmonics = harmonics;
  const Complex1212 Z =
      part_stiffness(sliding_chain(), request, [](const std::string&) {}).states[0].over.at[1][0];
  one.part = transfer_stiffness(Z, 1);
  one.ground =
      driving_point_stiffness(Z, 1) - one.part + Complex(mount_spring, omega * mount_dashpot);
  p.spring = one.part.real() / 4e4;
  p.theirs = std::abs(in_calculix(one));
  for (std::size_t h = 0; h < curve.orders.size(); ++h)
    if (curve.orders[h] == 3) p.third = curve.higher[h](k, 1) / std::abs(curve.first(k, 1));
  return p;
}

// A spring and a dashpot know one harmonic. Balanced with that alone the whole is met at every
// amplitude; with five harmonics as long as the motion is nearly a sine.
TEST(StiffnessPutBack, of_friction_carries_a_mass_at_every_amplitude) {
  for (const int harmonics : {1, 5}) {
    double least = 1, most = 0;
    int sines = 0;
    for (const LevelCurve& curve : pushed_sliders(harmonics).curves) {
      Eigen::Index top = 0;
      curve.first.col(1).cwiseAbs().maxCoeff(&top);
      for (const double share : {0.8, 1., 1.1, 1.2}) {
        Eigen::Index k = 0;
        (curve.hertz.array() / (share * curve.hertz[top]) - 1).abs().minCoeff(&k);
        const PutBack p = put_back(curve, k, harmonics);
        least = std::min(least, p.spring);
        most = std::max(most, p.spring);
        std::ostringstream what;
        what << "sliders and mass in CalculiX, "
             << (harmonics == 1 ? "one harmonic" : "five harmonics") << ", mm by " << curve.level
             << " N at " << share << " of the peak";
        const bool sine = p.third < 0.05;
        sines += sine ? 1 : 0;
        if (!sine) {
          std::printf("  %s: %.5g, %.5g (%.1f %%), third harmonic of the acceleration %.1f %%\n",
                      what.str().c_str(), 1e3 * p.own * curve.level, 1e3 * p.theirs * curve.level,
                      100 * (p.own / p.theirs - 1), 100 * p.third);
          continue;
        }
        const double allowed = harmonics == 1 ? 1e-3 : 0.01;
        print_for_table(what.str(), 1e3 * p.own * curve.level, 1e3 * p.theirs * curve.level,
                        allowed);
        EXPECT_LT(std::abs(p.own / p.theirs - 1), allowed) << what.str();
      }
    }
    EXPECT_GE(sines, harmonics == 1 ? 12 : 7);
    EXPECT_GT(most, 0.95);  // from sticking
    EXPECT_LT(least, 0.35); // to slipping
  }
}

} // namespace
} // namespace plica::test
