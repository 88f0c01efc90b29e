#include "engine/shared_direct.hpp"

#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Frequencies of the rank: every n-th of n ranks.
std::vector<double> share_of(const std::vector<double>& hertz, int rank, int ranks) {
  std::vector<double> own;
  for (auto k = std::size_t(rank); k < hertz.size(); k += std::size_t(ranks))
    own.push_back(hertz[k]);
  return own;
}

// Real parts above imaginary ones, one answer below the other.
MatrixXd packed(const std::vector<MatrixXcd>& answers, Index rows, Index columns) {
  MatrixXd all(2 * rows * Index(answers.size()), columns);
  for (std::size_t k = 0; k < answers.size(); ++k)
    all.middleRows(2 * rows * Index(k), 2 * rows) << answers[k].real(), answers[k].imag();
  return all;
}

// Collective. The answers of all ranks, on the first, in the order of `hertz`.
std::vector<MatrixXcd> solve_share(const DirectProblem& problem, const std::vector<double>& hertz,
                                   const Ranks& ranks) {
  std::vector<MatrixXcd> own;
  std::string trouble;
  try {
    const std::vector<double> share = share_of(hertz, ranks.rank(), ranks.size());
    if (!share.empty()) own = solve_directly(problem, share);
  } catch (const std::exception& error) {
    trouble = error.what();
  }
  for (const std::string& text : ranks.everyones(trouble))
    if (!text.empty()) throw std::runtime_error(text);
  const auto rows = Index(problem.excited.list.size());
  const auto columns = 3 * Index(problem.built.sensors.size());
  const MatrixXd all = ranks.gather_rows(packed(own, rows, columns));
  std::vector<MatrixXcd> answers;
  if (!ranks.first()) return answers;
  answers.resize(hertz.size());
  Index at = 0;
  for (int rank = 0; rank < ranks.size(); ++rank)
    for (auto k = std::size_t(rank); k < hertz.size(); k += std::size_t(ranks.size())) {
      answers[k].resize(rows, columns);
      answers[k].real() = all.middleRows(at, rows);
      answers[k].imag() = all.middleRows(at + rows, rows);
      at += 2 * rows;
    }
  return answers;
}

} // namespace

DirectSolver direct_over_ranks(const Ranks& ranks) {
  return [&ranks](const DirectProblem& problem, const std::vector<double>& hertz) {
    tell(ranks, Order::direct);
    const ModalSolution& s = problem.modes.solution;
    ranks.broadcast(MatrixXd(Eigen::Map<const VectorXd>(hertz.data(), Index(hertz.size()))));
    MatrixXd damping(s.lambda.size(), 3);
    damping << s.lambda, problem.modes.zeta, problem.modes.eta;
    ranks.broadcast(damping);
    ranks.broadcast(s.u);
    return solve_share(problem, hertz, ranks);
  };
}

void answer_direct(const Case& data, const BuiltCase& built, const Ranks& ranks) {
  const MatrixXd hertz = ranks.broadcast(MatrixXd()), damping = ranks.broadcast(MatrixXd());
  ModalSolution solution;
  solution.lambda = damping.col(0);
  solution.u = ranks.broadcast(MatrixXd());
  const DampedModes modes{solution, damping.col(1), damping.col(2)};
  const Excitations excited = excitations(*data.analyses.response, built);
  try {
    solve_share({built, data.analyses.damping, modes, excited},
                {hertz.data(), hertz.data() + hertz.size()}, ranks);
  } catch (const std::runtime_error&) { // the first says it
  }
}

} // namespace plica
