#include "measure.hpp"

#include "campaign.hpp"

#include <fmt/format.h>
#include <fmt/os.h>
#include <numbers>

namespace sealed {
namespace {

namespace fs = std::filesystem;

constexpr const char* axes = "xyz";

void write_table(const fs::path& file, const Bench& bench, const VectorXd& lines,
                 const MatrixXcd& response) {
  auto out = fmt::output_file(file.string());
  out.print("frequency [Hz]");
  for (const Probe& p : bench.probes)
    for (int a = 0; a < 3; ++a) out.print(",{0} {1} real,{0} {1} imaginary", p.name, axes[a]);
  out.print("\n");
  for (Eigen::Index l = 0; l < lines.size(); ++l) {
    out.print("{}", lines[l]);
    for (Eigen::Index c = 0; c < response.cols(); ++c)
      out.print(",{:.5g},{:.5g}", response(l, c).real(), response(l, c).imag());
    out.print("\n");
  }
}

void add_noise(MatrixXcd& response, Draws& draws) {
  for (auto& value : response.reshaped()) {
    const double sigma = std::max(0.015 * std::abs(value), 0.01) / std::numbers::sqrt2;
    value += std::complex<double>(sigma * draws.normal(), sigma * draws.normal());
  }
}

constexpr const char* header =
    "# Made by plica_sealed (tests/sealed), not by the model of the case: other, finer matrices "
    "with\n"
    "# healthy scatter of material, masses, joints and damping; joints that slip are integrated "
    "in\n"
    "# time; sensors sit a little off; every assembly shifts a little; noise as the sigmas say.\n";

using Builder = std::function<Bench(const State&)>;

// Force over displacement of the right end, moved along one axis, the left one held. Joints that
// slip give way: their stiffness is the secant at the stroke.
double rig_stiffness(const Bench& bench, int axis, double stroke) {
  const auto n = bench.body.K.rows();
  std::vector<int> inner;
  for (int i = 6; i < n; ++i)
    if (i < 12 || i >= rigid_unknowns) inner.push_back(i);
  VectorXd u = VectorXd::Zero(n);
  MatrixXd K = bench.body.K;
  for (int pass = 0; pass < 20; ++pass) {
    u[12 + axis] = stroke;
    const MatrixXd inside = K(inner, inner);
    u(inner) = -inside.ldlt().solve(K(inner, 12 + axis) * stroke);
    K = bench.body.K;
    for (const NonlinearSpring& spring : bench.test.nonlinear) {
      if (spring.law != Law::bouc_wen) continue; // the others touch the table only
      const VectorXd row = spring.row.head(n);
      const double x = std::abs(row.dot(u));
      if (x > spring.slip) K -= spring.stiffness * (1 - spring.slip / x) * row * row.transpose();
    }
  }
  return K.row(12 + axis).dot(u) / stroke;
}

std::string static_tests(const Bench& bench, Draws& draws) {
  std::string text = "static:\n";
  for (const auto& [name, axis] : {std::pair{"axial", 1}, std::pair{"transverse_x", 0}}) {
    const double value = rig_stiffness(bench, axis, 50e-6) * (1 + 0.015 * draws.normal());
    text += fmt::format("  - {{direction: {}, value: {:.5g}, sigma: {:.4g}, stroke: 0.05 mm}}\n",
                        name, value, 0.015 * value);
  }
  return text;
}

// Modes of the cantilever in every state, the first two of each direction.
std::string mode_list(const Campaign& c, const Builder& build, const std::string& name,
                      std::uint64_t seed, Draws& draws) {
  std::string text = "modes:\n";
  std::vector<std::string> states{""};
  for (const auto& [state, set] : c.states) states.push_back(state);
  for (const std::string& state : states) {
    const Bench bench = build(state.empty() ? State{} : c.states.at(state));
    const Assembly a = assemble_anew(bench, Draws(seed, name + ".assembly." + state));
    std::map<char, int> order;
    for (Eigen::Index i = 0;
         i < a.modes.w.size() && (order['x'] < c.orders || order['z'] < c.orders); ++i) {
      const VectorXcd shape =
          (bench.probes[0].rows * a.modes.phi.col(i)).cast<std::complex<double>>();
      const double across = shape.cwiseAbs()(Eigen::Vector2i(0, 2)).maxCoeff();
      if (c.only_across && across < std::max(1e-3, std::abs(shape[1]))) continue;
      const char axis = std::abs(shape[0]) > std::abs(shape[2]) ? 'x' : 'z';
      if (++order[axis] > c.orders) continue;
      const double f = a.modes.w[i] / (2 * std::numbers::pi) * (1 + 0.001 * draws.normal());
      const double zeta = a.zeta[i] * (1 + 0.05 * draws.normal());
      text += fmt::format("  - {{frequency: {:.5g}, sigma: {:.3g}, damping: {:.4g}, sigma_damping: "
                          "{:.2g}, shape: transverse, direction: {}, order: {}{}}}\n",
                          f, 0.001 * f, zeta, 0.05 * zeta, axis, order[axis],
                          state.empty() ? "" : ", state: " + state);
    }
  }
  return text;
}

std::string last_state_held_out(const Campaign& c) {
  const int each = 2 * c.orders, first = each * int(c.states.size());
  std::string text = "hold_out: [";
  for (int i = first; i < first + each; ++i)
    text += fmt::format("{}\"modes[{}]\"", i == first ? "" : ", ", i);
  return text + "]\n";
}

std::string response_list(const Campaign& c, const Builder& build, const std::string& name,
                          std::uint64_t seed, const fs::path& folder, const Bench& nominal,
                          Draws& draws) {
  std::string text = "frf:\n", held = "hold_out: [";
  int index = 0;
  for (const Run& run : c.runs) {
    Bench bench = run.state.empty() ? nominal : build(c.states.at(run.state));
    for (std::size_t j = 0; j < bench.test.nonlinear.size(); ++j) { // scaled once, on the plain one
      bench.test.nonlinear[j].slip = nominal.test.nonlinear[j].slip;
      bench.test.nonlinear[j].stiffness = nominal.test.nonlinear[j].stiffness;
    }
    const char axis = axes[run.base];
    const Assembly a =
        assemble_anew(bench, Draws(seed, fmt::format("{}.assembly.{}.{}", name, run.state, axis)));
    MatrixXcd response = nonlinear_response(bench, a, run.base, run.level, c.lines);
    add_noise(response, draws);
    const std::string file =
        fmt::format("{}_{}{}.csv", axis, run.level, run.state.empty() ? "" : "_" + run.state);
    write_table(folder / file, bench, c.lines, response);
    text += fmt::format("  - {{file: {}, base: {}, level: {}, sigma: {{relative: 1.5 %, floor: "
                        "0.01}}{}}}\n",
                        file, axis, run.level, run.state.empty() ? "" : ", state: " + run.state);
    if (run.held_out) held += fmt::format("{}\"frf[{}]\"", held.back() == '[' ? "" : ", ", index);
    ++index;
  }
  return text + held + "]\n";
}

} // namespace

std::map<std::string, double> measure(const Specimen& s, const ReducedWall* wall,
                                      std::uint64_t seed, const fs::path& data) {
  const fs::path folder = data / s.id;
  fs::create_directories(folder);
  const Campaign campaign = campaign_of(s);
  const std::string name = "specimen." + s.id;
  const Builder build = [&](const State& state) {
    const Draws healthy(seed, name + ".healthy");
    return wall ? bellows_bench(s, *wall, state, healthy) : beam_bench(s, state, healthy);
  };
  Draws noise(seed, name + ".noise");
  std::map<std::string, double> found;
  Bench bench = build({});
  std::vector<int> bases;
  for (const Run& run : campaign.runs) bases.push_back(run.base);
  if (const double slip = scale_nonlinear(bench, bases, campaign.lines); slip > 0)
    found["slip_force"] = slip;
  const double weighed = bench.body.weighed * (1 + 0.002 * noise.normal());
  std::string text =
      fmt::format("{}specimen: {}\nsource: sealed suite, specimen {}\n", header, case_of(s), s.id);
  text += sensors_of(s) + states_of(campaign);
  text += fmt::format("mass: {{value: {:.6g}, sigma: {:.3g}}} # with its sensors\n", weighed,
                      0.002 * weighed);
  if (wall) text += static_tests(bench, noise);
  if (campaign.runs.empty())
    text += mode_list(campaign, build, name, seed, noise) + last_state_held_out(campaign);
  else
    text += response_list(campaign, build, name, seed, folder, bench, noise);
  fmt::output_file((folder / "measured.yaml").string()).print("{}", text);
  return found;
}

} // namespace sealed
