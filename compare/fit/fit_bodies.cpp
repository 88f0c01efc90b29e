#include "compare/fit/fit_bodies.hpp"

#include "model/description/case_path.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

// The inertias of a case, as pointers into it.
std::vector<Sextuple*> inertias_of(Case& data) {
  std::vector<Sextuple*> all;
  for (Cap& cap : data.caps) all.push_back(&cap.inertia);
  for (Part& part : data.parts)
    if (auto* mass = std::get_if<PointMass>(&part.body)) all.push_back(&mass->inertia);
  return all;
}

constexpr double inside = 1 - 1e-9; // of a limit, so that rounding does not pass it

} // namespace

FitBodies::FitBodies(const Case& data, const FitRequest& request) {
  Case copy = data;
  for (Sextuple* inertia : inertias_of(copy)) {
    Body body{.inertia = *inertia, .parameter = {}};
    body.parameter.fill(-1);
    for (std::size_t p = 0; p < request.parameters.size(); ++p)
      for (const std::string& path : request.parameters[p].paths)
        for (std::size_t i = 0; i < inertia->size(); ++i)
          if (number_at(copy, path) == &(*inertia)[i]) body.parameter[i] = int(p);
    if (std::any_of(body.parameter.begin(), body.parameter.end(), [](int p) { return p >= 0; }))
      bodies_.push_back(body);
  }
}

void FitBodies::settle(Eigen::VectorXd& values) const {
  for (const Body& body : bodies_) {
    const auto& parameter = body.parameter;
    const auto is_free = [&](std::size_t i) { return parameter[i] >= 0; };
    const auto J = [&](std::size_t i) {
      return is_free(i) ? values[parameter[i]] : body.inertia[i];
    };
    const auto set = [&](std::size_t i, double value) { values[parameter[i]] = value; };
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      if (J(i) <= J(j) + J(k)) continue;
      if (is_free(i) && parameter[i] != parameter[j] && parameter[i] != parameter[k])
        set(i, inside * (J(j) + J(k)));
      else if (is_free(j) && parameter[j] == parameter[k])
        set(j, J(i) / (2 * inside));
      else if (is_free(j))
        set(j, J(i) / inside - J(k));
      else if (is_free(k))
        set(k, J(i) / inside - J(j));
    }
    for (const auto& [product, about] :
         {std::pair<std::size_t, std::size_t>{3, 2}, {4, 0}, {5, 1}}) {
      const double most = inside * J(about) / 2;
      if (is_free(product) && std::abs(J(product)) > most)
        set(product, std::copysign(std::max(0., most), J(product)));
    }
  }
}

} // namespace plica
