#include "diagnose/account/next_measurement.hpp"

#include "solve/parallel.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double open = 0.03;      // probability from which a rival is to be told apart
constexpr double worth_it = 0.005; // change of the ledger

std::string short_name(const RivalSet& r) {
  std::string name = r.together.empty() ? "nothing" : "";
  for (const Hypothesis* h : r.together) name += (name.empty() ? "" : " and ") + h->effect;
  return name;
}

// Draws of all rivals together: rows are shares, of each effect at its place, and last what is
// unexplained; and readings.
class Draws {
public:
  Draws(const Nominal& nominal, const OfferedReadings& menu, const std::vector<RivalSet>& rivals,
        const std::shared_ptr<StateModels>& models)
      : menu_(menu), readings_(Index(menu.readings.readings.size())) {
    for (const RivalSet& r : rivals)
      for (const Hypothesis* h : r.together) row_of(*h);
    struct Draw {
      const RivalSet* of;
      Index column;
    };
    std::vector<Draw> all;
    for (const RivalSet& r : rivals)
      for (Index k = 0; k < r.draws.shares.cols(); ++k) all.push_back({&r, k});
    const auto count = Index(all.size());
    shares_ = MatrixXd::Zero(Index(names_.size()) + 1, count);
    y_ = MatrixXd::Constant(readings_, count, NAN);
    weight_ = VectorXd::Zero(count);
    std::vector<std::unique_ptr<Predictor>> predictors;
    for (const RivalSet& r : rivals)
      predictors.push_back(std::make_unique<Predictor>(nominal, menu.readings, r.together, models));
    in_parallel(int(count), [&](int i) {
      const RivalSet& r = *all[std::size_t(i)].of;
      const Predictor& predict = *predictors[std::size_t(&r - rivals.data())];
      const Index column = all[std::size_t(i)].column;
      const auto y = predict(predict.values_of(r.draws.z.col(column)));
      if (!y) return;
      y_.col(i) = *y;
      weight_[i] = r.probability / double(r.draws.shares.cols());
      const auto own = r.draws.shares.col(column);
      for (std::size_t h = 0; h < r.together.size(); ++h)
        shares_(Index(known(*r.together[h])), i) += own[Index(h)];
      shares_(shares_.rows() - 1, i) = own[own.size() - 1];
    });
    if (weight_.sum() > 0) weight_ /= weight_.sum();
    shares_.colwise() -= VectorXd(shares_ * weight_);
  }

  // Expected change of the ledger by an offer, and what its share it settles most.
  std::pair<double, std::string> change(std::size_t offer) const {
    std::vector<Index> rows;
    for (Index k = menu_.first[offer]; k < menu_.first[offer + 1]; ++k)
      if (y_.row(k).array().isFinite().all()) rows.push_back(k);
    if (rows.empty()) return {};
    MatrixXd y = y_(rows, Eigen::all);
    y.colwise() -= VectorXd(y * weight_);
    const MatrixXd weighed = y * weight_.asDiagonal();
    MatrixXd spread = weighed * y.transpose();
    for (std::size_t k = 0; k < rows.size(); ++k)
      spread(Index(k), Index(k)) +=
          std::pow(usual_sigma(menu_.readings.readings[std::size_t(rows[k])].kind), 2);
    const MatrixXd with_shares = weighed * shares_.transpose();
    const VectorXd moved =
        (with_shares.array() * spread.llt().solve(with_shares).array()).colwise().sum();
    Index most = 0;
    moved.maxCoeff(&most);
    return {std::sqrt(std::max(0., moved.sum())),
            most < Index(names_.size()) ? names_[std::size_t(most)] : "what is unexplained"};
  }

private:
  static std::string name(const Hypothesis& h) { return h.effect + " at " + h.place; }
  void row_of(const Hypothesis& h) {
    if (std::find(names_.begin(), names_.end(), name(h)) == names_.end()) names_.push_back(name(h));
  }
  std::size_t known(const Hypothesis& h) const {
    return std::size_t(std::find(names_.begin(), names_.end(), name(h)) - names_.begin());
  }

  const OfferedReadings& menu_;
  Index readings_;
  std::vector<std::string> names_;
  MatrixXd shares_, y_; // about their means; as they are
  VectorXd weight_;
};

// Of rivals at their optima: what an offer tells apart.
class Separation {
public:
  Separation(const Nominal& nominal, const OfferedReadings& menu,
             const std::vector<RivalSet>& rivals, const std::shared_ptr<StateModels>& models)
      : menu_(menu), rivals_(rivals), y_(rivals.size()) {
    in_parallel(int(rivals.size()), [&](int i) {
      const RivalSet& r = rivals[std::size_t(i)];
      y_[std::size_t(i)] = Predictor(nominal, menu.readings, r.together, models)(r.values);
    });
    for (std::size_t i = 0; i < rivals.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) pairs_ += rivals[i].probability * rivals[j].probability;
  }

  void fill(ProposedMeasurement& p, std::size_t offer) const {
    double most = 0;
    for (std::size_t i = 0; i < rivals_.size(); ++i) {
      double nearest = 1e300;
      for (std::size_t j = 0; j < rivals_.size(); ++j) {
        if (i == j) continue;
        const double T = apart(offer, i, j);
        if (rivals_[j].probability > open) nearest = std::min(nearest, T);
        if (j > i) continue;
        const double gain =
            rivals_[i].probability * rivals_[j].probability * std::min(T, beyond_doubt);
        p.separation += gain / std::max(pairs_, 1e-12);
        if (gain > most) {
          most = gain;
          p.separates = short_name(rivals_[j]) + " from " + short_name(rivals_[i]);
        }
      }
      if (nearest > well_apart && nearest < 1e299 && !rivals_[i].together.empty())
        p.resolves.push_back(short_name(rivals_[i]));
    }
  }

private:
  // How far apart two rivals put what is offered, in squared standard deviations.
  double apart(std::size_t offer, std::size_t i, std::size_t j) const {
    return y_[i] && y_[j] ? menu_.apart(offer, *y_[i], *y_[j]) : 0;
  }

  const OfferedReadings& menu_;
  const std::vector<RivalSet>& rivals_;
  std::vector<std::optional<VectorXd>> y_;
  double pairs_ = 0;
};

} // namespace

std::vector<ProposedMeasurement> next_measurements(const Nominal& nominal,
                                                   const OfferedReadings& menu,
                                                   const std::vector<RivalSet>& rivals,
                                                   const std::shared_ptr<StateModels>& models) {
  if (menu.readings.readings.empty()) return {};
  const Draws draws(nominal, menu, rivals, models);
  const Separation separation(nominal, menu, rivals, models);
  std::vector<ProposedMeasurement> proposals;
  for (std::size_t o = 0; o < menu.offers.size(); ++o) {
    ProposedMeasurement p{.what = menu.offers[o].what,
                          .cost = menu.offers[o].cost,
                          .about = "",
                          .separates = "",
                          .resolves = {}};
    std::tie(p.change, p.about) = draws.change(o);
    if (p.change < worth_it) continue;
    separation.fill(p, o);
    proposals.push_back(std::move(p));
  }
  std::stable_sort(proposals.begin(), proposals.end(), [](const auto& a, const auto& b) {
    return a.change / a.cost > b.change / b.cost;
  });
  constexpr std::size_t most = 8;
  if (proposals.size() > most) proposals.resize(most);
  return proposals;
}

} // namespace plica
