#include "model/run_response.hpp"

#include "model/input_error.hpp"
#include "solve/frequency_grid.hpp"
#include "solve/frequency_response.hpp"

#include <numbers>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::array axis_names{"x", "y", "z", "rx", "ry", "rz"};

// Rows of the three displacements of each sensor in a field over all DOFs.
MatrixXd at_sensors(const BuiltCase& built, const MatrixXd& u) {
  MatrixXd rows(3 * built.sensors.size(), u.cols());
  for (std::size_t s = 0; s < built.sensors.size(); ++s)
    rows.middleRows(3 * Eigen::Index(s), 3) = u.middleRows(6 * built.sensors[s].node, 3);
  return rows;
}

// Channels that stay below a thousandth of the largest are rounding, or have no path.
void add_peaks(ResponseResult& response) {
  const double largest = response.transmissibility.cwiseAbs().maxCoeff();
  for (Eigen::Index c = 0; c < response.transmissibility.cols(); ++c) {
    if (response.transmissibility.col(c).cwiseAbs().maxCoeff() < 1e-3 * largest) continue;
    for (const Peak& p : find_peaks(response.hertz, response.transmissibility.col(c).cwiseAbs()))
      response.peaks.push_back({.channel = static_cast<int>(c),
                                .frequency = p.frequency,
                                .amplitude = p.height,
                                .damping = p.damping});
  }
}

} // namespace

ResponseLoads response_loads(const Response& asked, const BuiltCase& built, const System& system,
                             const std::vector<int>& free, const BaseFactor& factor) {
  if (factor.sigma != 0)
    throw InputError({{.file = "",
                       .line = 0,
                       .key = "analyses.response",
                       .wrong = "nothing holds the part, so the table cannot shake it",
                       .allowed = "a mount or supports that leave no rigid motion free"}});
  ResponseLoads loads{.base = base_motion(built.model, system, free, {0, 0, 0}),
                      .force = {},
                      .static_solutions = {}};
  loads.force = loads.base.force(Eigen::all, asked.bases);
  loads.static_solutions = factor.factor.solve(loads.force);
  return loads;
}

std::vector<ResponseResult> base_responses(const Response& asked, double damping,
                                           const BuiltCase& built, const System& system,
                                           const std::vector<int>& free, const SparseMatrix& K,
                                           const SparseMatrix& M, const ModeSet& set,
                                           const ResponseLoads& loads) {
  const ModalBasis basis = add_static_correction(K, M, set.lambda, set.Phi, loads.static_solutions);
  MatrixXd q = MatrixXd::Zero(system.map.size(), basis.Phi.cols());
  q(free, Eigen::all) = basis.Phi;
  const auto count = basis.lambda.size();
  const ModalModel modal{.lambda = basis.lambda,
                         .zeta = VectorXd::Constant(count, damping),
                         .eta = VectorXd::Zero(count),
                         .output = at_sensors(built, expand(system.map, q)),
                         .input = basis.Phi.transpose() * loads.force};
  const MatrixXd rigid = at_sensors(built, expand(system.map, loads.base.r));
  const VectorXd modes = set.lambda.unaryExpr(&frequency);
  const VectorXd hertz = frequency_grid(asked.band[0], asked.band[1], asked.points, modes,
                                        VectorXd::Constant(modes.size(), damping));
  const VectorXd omega = 2 * std::numbers::pi * hertz;
  std::vector<ResponseResult> responses;
  for (std::size_t k = 0; k < asked.bases.size(); ++k) {
    ResponseResult response{.base = axis_names[asked.bases[k]],
                            .hertz = hertz,
                            .channels = {},
                            .transmissibility = {},
                            .peaks = {}};
    for (const BuiltSensor& s : built.sensors)
      for (int axis : {0, 1, 2}) response.channels.push_back({s.name, axis_names[axis]});
    const Eigen::MatrixXcd relative = frequency_response(modal, static_cast<int>(k), omega);
    response.transmissibility = -(omega.cwiseAbs2().asDiagonal() * relative);
    response.transmissibility.rowwise() += rigid.col(asked.bases[k]).transpose();
    add_peaks(response);
    responses.push_back(std::move(response));
  }
  return responses;
}

} // namespace plica
