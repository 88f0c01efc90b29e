#include "lab/identification/stabilisation.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace plica {
namespace {

double participation_match(const Pole& a, const Pole& b) {
  return std::norm(a.participation.dot(b.participation));
}

Stability against(const Pole& pole, const std::vector<Pole>& before,
                  const StabilityLimits& limits) {
  Stability best = Stability::fresh;
  for (const Pole& old : before) {
    Stability now = Stability::fresh;
    if (std::abs(pole.frequency() / old.frequency() - 1) < limits.frequency) {
      now = Stability::frequency;
      if (std::abs(pole.damping() / old.damping() - 1) < limits.damping) {
        now = Stability::damping;
        if (participation_match(pole, old) > limits.participation) now = Stability::all;
      }
    }
    best = std::max(best, now);
  }
  return best;
}

bool near(const Pole& a, const Pole& b, double share) {
  const double width =
      std::max(share * std::min(-a.lambda.real(), -b.lambda.real()), 2e-4 * std::abs(a.lambda));
  return std::abs(a.lambda - b.lambda) < width && participation_match(a, b) > 0.8;
}

double deviation(const std::vector<double>& values) {
  double mean = 0, square = 0;
  for (double v : values) mean += v / double(values.size());
  for (double v : values) square += (v - mean) * (v - mean);
  return values.size() < 2 ? 0 : std::sqrt(square / double(values.size() - 1));
}

StableGroup group_of(std::vector<const DiagramPole*> poles, int orders) {
  std::sort(poles.begin(), poles.end(), [](const DiagramPole* a, const DiagramPole* b) {
    return a->pole.damping() < b->pole.damping();
  });
  std::vector<double> frequencies, dampings;
  for (const DiagramPole* p : poles) {
    frequencies.push_back(p->pole.frequency());
    dampings.push_back(p->pole.damping());
  }
  std::vector<DiagramPole> members;
  for (const DiagramPole* p : poles) members.push_back(*p);
  return {.pole = poles[poles.size() / 2]->pole,
          .order = poles[poles.size() / 2]->order,
          .count = orders,
          .members = std::move(members),
          .scatter_frequency = deviation(frequencies),
          .scatter_damping = deviation(dampings)};
}

} // namespace

std::vector<DiagramPole> stabilisation(const std::vector<PolesOfOrder>& orders,
                                       const StabilityLimits& limits) {
  std::vector<DiagramPole> diagram;
  for (std::size_t n = 0; n < orders.size(); ++n)
    for (const Pole& pole : orders[n].poles)
      diagram.push_back(
          {.order = orders[n].order,
           .pole = pole,
           .stability = n == 0 ? Stability::fresh : against(pole, orders[n - 1].poles, limits)});
  return diagram;
}

std::vector<StableGroup> stable_groups(const std::vector<DiagramPole>& diagram, double width) {
  std::vector<const DiagramPole*> left;
  int highest = 0;
  for (const DiagramPole& p : diagram) {
    highest = std::max(highest, p.order);
    if (p.stability == Stability::all) left.push_back(&p);
  }
  std::vector<StableGroup> groups;
  while (!left.empty()) {
    // The pole with company in the most orders heads the next group.
    std::set<int> most;
    const DiagramPole* head = nullptr;
    for (const DiagramPole* p : left) {
      std::set<int> orders;
      for (const DiagramPole* q : left)
        if (near(p->pole, q->pole, width)) orders.insert(q->order);
      if (orders.size() > most.size()) {
        most = orders;
        head = p;
      }
    }
    const int count = static_cast<int>(most.size());
    if (count < 4) break;
    std::vector<const DiagramPole*> members, others;
    for (const DiagramPole* q : left)
      if (near(head->pole, q->pole, width))
        members.push_back(q);
      else
        others.push_back(q);
    if (3 * count >= highest - *most.begin() + 1) groups.push_back(group_of(members, count));
    left = std::move(others);
  }
  std::sort(groups.begin(), groups.end(), [](const StableGroup& a, const StableGroup& b) {
    return a.pole.frequency() < b.pole.frequency();
  });
  return groups;
}

} // namespace plica
