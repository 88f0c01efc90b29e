#include "diagnose/weigh/likely_values.hpp"

#include "words/sample_ranks.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Silverman's width of a kernel for points of so many coordinates, one of which spreads like this.
double kernel_width(const VectorXd& at, Index coordinates) {
  const double spread = std::sqrt((at.array() - at.mean()).square().mean());
  const std::vector<double> values(at.begin(), at.end());
  const double quartiles = (quantile(values, 0.75) - quantile(values, 0.25)) / 1.34;
  return 0.9 * std::min(spread, quartiles) *
         std::pow(double(at.size()), -1. / double(coordinates + 4));
}

// Places of draws, a column each, in widths of a kernel for each coordinate.
class Kernel {
public:
  Kernel(const MatrixXd& at, const std::vector<Index>& of) : at_(&at), width_(at.rows()) {
    for (Index i = 0; i < at.rows(); ++i)
      width_[i] = kernel_width(at.row(i)(of).transpose(), at.rows());
  }
  const VectorXd& width() const { return width_; }
  // Of every draw, squared.
  VectorXd distances_to(const VectorXd& place) const {
    return ((at_->colwise() - place).array().colwise() / width_.array())
        .matrix()
        .colwise()
        .squaredNorm();
  }
  VectorXd densest() const {
    Index best = 0;
    double most = -1;
    for (Index i = 0; i < at_->cols(); ++i) {
      const double density = (-0.5 * distances_to(at_->col(i)).array()).exp().sum();
      if (density > most) {
        most = density;
        best = i;
      }
    }
    return at_->col(best);
  }
  std::vector<Index> within(const VectorXd& place, double reach) const {
    const VectorXd away = distances_to(place);
    std::vector<Index> near;
    for (Index i = 0; i < away.size(); ++i)
      if (away[i] <= reach * reach) near.push_back(i);
    return near;
  }

private:
  const MatrixXd* at_;
  VectorXd width_;
};

} // namespace

VectorXd likely_values(const HypothesisFit& fit, std::size_t member) {
  const Hypothesis& h = *fit.together[member];
  const Index first = fit.first_of(member), count = Index(h.parameters.size());
  const VectorXd optimum = fit.values.segment(first, count);
  constexpr Index fewest = 20;
  if (h.along.empty() || fit.draws.cols() < fewest) return optimum;
  const auto drawn = [&](Index parameter) {
    return VectorXd(fit.draws.row(first + parameter).transpose().unaryExpr([&](double z) {
      return value_of(h.parameters[std::size_t(parameter)].prior, z);
    }));
  };
  MatrixXd at(Index(h.along.size()), fit.draws.cols());
  for (Index i = 0; i < at.rows(); ++i) at.row(i) = drawn(Index(h.along[std::size_t(i)]));
  std::vector<Index> all(std::size_t(at.cols()));
  std::iota(all.begin(), all.end(), Index(0));
  Kernel kernel(at, all);
  if (!(kernel.width().minCoeff() > 0)) return optimum;
  VectorXd place;
  constexpr int times = 5;
  constexpr double reach = 4; // widths of the kernel: two places lie farther apart
  for (int i = 0; i < times; ++i) {
    place = kernel.densest();
    const std::vector<Index> near = kernel.within(place, reach);
    if (Index(near.size()) < fewest) break;
    const Kernel narrower(at, near);
    const double least = narrower.width().minCoeff();
    if (!(least > 0 && narrower.width().prod() < kernel.width().prod())) break;
    kernel = narrower;
  }
  const std::vector<Index> near = kernel.within(place, 1);
  VectorXd likely = optimum;
  for (Index k = 0; k < count; ++k) {
    const VectorXd values = drawn(k)(near);
    likely[k] = median({values.begin(), values.end()});
  }
  for (std::size_t i = 0; i < h.along.size(); ++i) likely[Index(h.along[i])] = place[Index(i)];
  return likely;
}

} // namespace plica
