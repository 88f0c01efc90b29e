#include "changes.hpp"

#include "../files.hpp"
#include "structures.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/os.h>
#include <fstream>

namespace sealed {
namespace {

namespace fs = std::filesystem;
using Eigen::VectorXd;
using nlohmann::json;

constexpr double of_measurement = 0.001; // of a frequency
constexpr double of_shape = 0.03;        // of the largest component
constexpr double one_error = 1.645;      // the 90 % error of a size, in standard deviations

double log_between(Draws& draws, double low, double high) {
  return low * std::pow(high / low, draws.uniform());
}

// The largest amount below `most` at which f(amount) <= target; f grows.
template <typename Grows> double where(double target, double least, double most, const Grows& f) {
  double a = std::log(least), b = std::log(most);
  if (f(most) <= target) return most;
  for (int i = 0; i < 16; ++i) {
    const double c = (a + b) / 2;
    (f(std::exp(c)) < target ? a : b) = c;
  }
  return std::exp((a + b) / 2);
}

struct Day { // one mounting of a specimen
  std::string state;
  VectorXd frequencies, damping;
  std::vector<VectorXd> shapes = {}; // their largest component is one
};

class SpecimenMaker {
public:
  SpecimenMaker(const ChangedStructure& structure, const std::string& mechanism, bool changes,
                std::uint64_t seed, const std::string& id)
      : structure_(structure), draws_(seed, "change." + id), shape_draws_(seed, "shape." + id),
        changes_(changes) {
    mechanism_ = {.name = mechanism, .amount = 0, .seed = seed ^ fnv1a(id)};
    err();
    scatter_ = log_between(draws_, 0.003, 0.01);
    baselines_ = 1 + draws_.below(2);
    before_ = structure_.modes(mechanism_, {});
    after_ = before_;
    if (changes_) draw_change();
    measure();
  }

  json truth(const std::string& id) const {
    json effects = json::array(), positions = json::object();
    if (changes_)
      effects.push_back(
          {{"name", change_.name}, {"place", change_.place}, {"value", change_.value}});
    std::vector<double> point = changes_ ? structure_.point(change_.place) : std::vector<double>{0};
    const char* further[] = {"at", "across"};
    for (std::size_t i = 0; i < point.size(); ++i)
      if (const auto own = change_.value.find(further[i]); own != change_.value.end())
        point[i] += own->second;
    return {{"id", id},
            {"structure", structure_.name()},
            {"mechanism", mechanism_.name},
            {"model_error", error_},
            {"mounting", scatter_},
            {"baselines", baselines_},
            {"kind", changes_ ? "effect" : "none"},
            {"class", changes_ ? change_.name : "none"},
            {"strength", ""},
            {"effects", effects},
            {"position", point},
            {"ratio", ratio_},
            {"detectable", detectable_}};
  }

  void write(const fs::path& folder, const std::string& id) const {
    fs::create_directories(folder);
    auto out = fmt::output_file((folder / "measured.yaml").string());
    out.print("# Made by plica_sealed, not by the model of the case: another theory, and what the "
              "case leaves out.\nspecimen: {}\nsource: sealed suite of changes, specimen {}\n",
              structure_.name(), id);
    out.print("states:\n");
    for (const Day& day : days_)
      out.print("  - {{name: {}{}}}\n", day.state, day.state == "after" ? "" : ", baseline: true");
    if (const auto stations = structure_.stations(); !stations.empty()) {
      out.print("sensors:\n");
      for (const Station& s : stations)
        out.print("  - {{name: {}, at: [0, {:.6g}, 0]}}\n", s.name, s.along);
    }
    out.print("modes:\n");
    const auto labels = structure_.labels();
    for (const Day& day : days_)
      for (std::size_t k = 0; k < labels.size(); ++k) {
        const double f = day.frequencies[Eigen::Index(k)], z = day.damping[Eigen::Index(k)];
        out.print("  - {{frequency: {:.6g}, sigma: {:.3g}, damping: {:.4g}, sigma_damping: {:.2g}, "
                  "{}, state: {}{}}}\n",
                  f, of_measurement * f, z, 0.05 * z, labels[k], day.state, vector_of(day, k));
      }
  }

private:
  std::string vector_of(const Day& day, std::size_t mode) const {
    const auto channels = structure_.channels(mode);
    if (channels.empty()) return "";
    return fmt::format(", vector: {{channels: [{}], real: [{:.4f}]}}", fmt::join(channels, ", "),
                       fmt::join(day.shapes[mode], ", "));
  }

  void err() {
    error_ = log_between(draws_, 0.01, 0.04);
    const VectorXd right = structure_.frequencies({}, {});
    const auto deviation = [&](double amount) {
      Mechanism m = mechanism_;
      m.amount = amount;
      const VectorXd off = (structure_.frequencies(m, {}).array() / right.array()).log();
      return std::sqrt(off.squaredNorm() / double(off.size()));
    };
    mechanism_.amount = where(error_, 1e-6, 10, deviation);
    error_ = deviation(mechanism_.amount);
  }

  double sigma() const { // of the difference of two states
    return std::sqrt((scatter_ * scatter_ + of_measurement * of_measurement) *
                     (1 + 1. / baselines_));
  }

  void draw_change() {
    for (;;) {
      const Change open = structure_.draw_change(draws_);
      const double wanted = log_between(draws_, 0.3, 10);
      const auto changed = [&](double size) {
        Effect e = open.effect;
        e.value[open.size] = open.value(size);
        return e;
      };
      const auto seen = [&](double size) {
        const VectorXd moved = (structure_.frequencies(mechanism_, changed(size)).array() /
                                before_.frequencies.array())
                                   .log();
        return moved.norm() / sigma() / one_error;
      };
      const double size = where(wanted, open.smallest, open.largest, seen);
      ratio_ = seen(size);
      change_ = changed(size);
      if (ratio_ >= 0.3) break;
    }
    after_ = structure_.modes(mechanism_, change_);
  }

  void measure() {
    VectorXd zeta(before_.frequencies.size());
    for (double& z : zeta) z = structure_.damping() * std::exp(0.3 * draws_.normal());
    const auto day = [&](const std::string& state, const FoundModes& found) {
      Day d{.state = state, .frequencies = found.frequencies, .damping = zeta};
      for (double& v : d.frequencies)
        v *= 1 + scatter_ * draws_.normal() + of_measurement * draws_.normal();
      for (double& z : d.damping) z *= std::exp(0.12 * draws_.normal());
      for (const VectorXd& shape : found.shapes) {
        d.shapes.emplace_back(shape / shape.cwiseAbs().maxCoeff());
        for (double& v : d.shapes.back()) v += of_shape * shape_draws_.normal();
      }
      days_.push_back(d);
    };
    day("as_delivered", before_);
    if (baselines_ > 1) day("mounted_anew", before_);
    day("after", after_);
    VectorXd mean = VectorXd::Zero(before_.frequencies.size());
    for (int b = 0; b < baselines_; ++b)
      mean.array() += days_[std::size_t(b)].frequencies.array().log() / baselines_;
    const VectorXd change = (after_.frequencies.array() / before_.frequencies.array()).log(),
                   seen = days_.back().frequencies.array().log() - mean.array();
    detectable_ = changes_ && (seen.squaredNorm() - (seen - change).squaredNorm()) / 2 >
                                  std::log(10.) * sigma() * sigma();
  }

  const ChangedStructure& structure_;
  Draws draws_, shape_draws_;
  bool changes_, detectable_ = false;
  Mechanism mechanism_;
  double error_ = 0, scatter_ = 0, ratio_ = 0;
  int baselines_ = 1;
  FoundModes before_, after_;
  Effect change_;
  std::vector<Day> days_;
};

} // namespace

std::string make_changes(const ChangesPlan& plan, const fs::path& data, const fs::path& truth) {
  fs::create_directories(data);
  fs::create_directories(truth);
  struct Planned {
    const ChangedStructure* structure;
    std::string mechanism;
    bool changes;
  };
  const auto structures = changed_structures();
  std::vector<Planned> all;
  for (const auto& structure : structures) {
    fs::copy_file(fs::path(PLICA_SOURCE_DIR) / "tests/sealed/changes" /
                      (structure->name() + ".yaml"),
                  data / (structure->name() + ".yaml"), fs::copy_options::overwrite_existing);
    for (const std::string& mechanism : mechanisms)
      if (chooses_thresholds(mechanism) == plan.thresholds)
        for (int k = 0; k < plan.rounds; ++k)
          all.push_back({structure.get(), mechanism, (k * 6) % 16 >= 6});
  }
  Draws draws(plan.seed, "order of changes");
  for (std::size_t i = all.size(); i > 1; --i)
    std::swap(all[i - 1], all[std::size_t(draws.below(int(i)))]);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string id = fmt::format("{:03}", i + 1);
    const SpecimenMaker maker(*all[i].structure, all[i].mechanism, all[i].changes, plan.seed, id);
    maker.write(data / id, id);
    std::ofstream(truth / (id + ".json")) << maker.truth(id).dump(1) << '\n';
  }
  return fingerprint(truth);
}

} // namespace sealed
