#include "reduction/craig_bampton.hpp"
#include "reduction/substructures.hpp"

#include <algorithm>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

std::shared_ptr<const PartReduction> reduce(const Substructure& part,
                                            const ReductionRequest& asked) {
  auto reduced = std::make_shared<PartReduction>();
  if (asked.symmetry) {
    auto view = cyclic_model(part.model);
    if (const auto* cyclic = std::get_if<CyclicModel>(&view)) {
      reduced->sectors = cyclic->around();
      reduced->reduction = craig_bampton(*cyclic, part.boundary, asked.cutoff, asked.all_harmonics);
      return reduced;
    }
    reduced->because = std::get<std::string>(view);
  } else {
    reduced->because = "as the case asks";
  }
  reduced->reduction = craig_bampton(part.model, part.boundary, asked.cutoff);
  return reduced;
}

// Coordinates of an instance: DOFs of its boundary nodes, then its modal ones.
std::vector<int> rows_of(const Instance& instance, const std::vector<int>& number) {
  std::vector<int> rows;
  for (int node : instance.part->boundary)
    for (int d = 0; d < 6; ++d) rows.push_back(6 * number[instance.part->nodes[node]] + d);
  const int modal = instance.reduced->reduction.element.modal();
  for (int k = 0; k < modal; ++k) rows.push_back(6 * instance.scalar_nodes[k / 6] + k % 6);
  return rows;
}

} // namespace

ReducedModel reduce_substructures(const Model& model, const std::vector<int>& interface_nodes,
                                  const ReductionRequest& request, ReductionMemory* memory) {
  CutModel pieces = cut(model, interface_nodes);
  ReducedModel reduced{.model = std::move(pieces.frame),
                       .number = std::move(pieces.number),
                       .instances = {},
                       .reductions = 0,
                       .proved = true,
                       .reason = ""};
  for (Substructure& piece : pieces.parts) {
    Instance instance{.part = std::make_shared<const Substructure>(std::move(piece)),
                      .reduced = nullptr,
                      .scalar_nodes = {}};
    for (const Instance& other : reduced.instances)
      if (!instance.reduced && is_copy(*other.part, *instance.part))
        instance.reduced = other.reduced;
    if (!instance.reduced) {
      if (memory) instance.reduced = memory->find(*instance.part, request);
      if (!instance.reduced) {
        instance.reduced = reduce(*instance.part, request);
        if (memory) memory->keep(instance.part, request, instance.reduced);
      }
      ++reduced.reductions;
    }
    const Reduction& r = instance.reduced->reduction;
    if (!r.proved) {
      reduced.proved = false;
      reduced.reason = r.reason;
    }
    std::vector<int> nodes;
    for (int node : instance.part->boundary)
      nodes.push_back(reduced.number[instance.part->nodes[node]]);
    instance.scalar_nodes = add_superelement(reduced.model, r.element, nodes, 0);
    reduced.instances.push_back(std::move(instance));
  }
  return reduced;
}

MatrixXd ReducedModel::field(const MatrixXd& q) const {
  MatrixXd u(6 * Index(number.size()), q.cols());
  for (std::size_t node = 0; node < number.size(); ++node)
    if (number[node] >= 0)
      u.middleRows<6>(6 * Index(node)) = q.middleRows<6>(6 * Index(number[node]));
  for (const Instance& instance : instances) {
    const MatrixXd own =
        instance.reduced->reduction.field(q(rows_of(instance, number), Eigen::all));
    const std::vector<int>& nodes = instance.part->nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (number[nodes[i]] < 0)
        u.middleRows<6>(6 * Index(nodes[i])) = own.middleRows<6>(6 * Index(i));
  }
  return u;
}

MatrixXd ReducedModel::field_at(const MatrixXd& q, const std::vector<int>& nodes) const {
  MatrixXd u(6 * Index(nodes.size()), q.cols());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (number[nodes[i]] >= 0)
      u.middleRows<6>(6 * Index(i)) = q.middleRows<6>(6 * Index(number[nodes[i]]));
  for (const Instance& instance : instances) {
    std::vector<int> own;        // numbers in the part
    std::vector<std::size_t> to; // places in the list
    const std::vector<int>& known = instance.part->nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto found = std::lower_bound(known.begin(), known.end(), nodes[i]);
      if (number[nodes[i]] >= 0 || found == known.end() || *found != nodes[i]) continue;
      own.push_back(static_cast<int>(found - known.begin()));
      to.push_back(i);
    }
    if (own.empty()) continue;
    const MatrixXd rows =
        instance.reduced->reduction.field_at(q(rows_of(instance, number), Eigen::all), own);
    for (std::size_t i = 0; i < to.size(); ++i)
      u.middleRows<6>(6 * Index(to[i])) = rows.middleRows<6>(6 * Index(i));
  }
  return u;
}

Reduction craig_bampton(const std::shared_ptr<const ReducedModel>& model,
                        const std::vector<int>& boundary, double cutoff) {
  std::vector<int> own;
  for (int node : boundary) {
    if (model->number[node] < 0)
      throw std::invalid_argument("boundary node " + std::to_string(node + 1) +
                                  " lies inside a superelement");
    own.push_back(model->number[node]);
  }
  Reduction r = craig_bampton(model->model, own, cutoff);
  if (r.proved && !model->proved) {
    r.proved = false;
    r.reason = model->reason;
  }
  r.field_at = [model, inner = r.field](const MatrixXd& c, const std::vector<int>& nodes) {
    return model->field_at(inner(c), nodes);
  };
  r.field = [model, inner = r.field](const MatrixXd& c) { return model->field(inner(c)); };
  return r;
}

MatrixXd ReducedModel::gather(const MatrixXd& force) const {
  MatrixXd q = MatrixXd::Zero(dof_count(model), force.cols());
  for (std::size_t node = 0; node < number.size(); ++node)
    if (number[node] >= 0)
      q.middleRows<6>(6 * Index(number[node])) = force.middleRows<6>(6 * Index(node));
  for (const Instance& instance : instances) {
    const std::vector<int>& nodes = instance.part->nodes;
    std::vector<int> loaded;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (number[nodes[i]] < 0 && !force.middleRows<6>(6 * Index(nodes[i])).isZero(0))
        loaded.push_back(static_cast<int>(i));
    if (loaded.empty()) continue;
    const Reduction& r = instance.reduced->reduction;
    const Index size = r.element.K.rows();
    const MatrixXd shapes = r.field_at(MatrixXd::Identity(size, size), loaded);
    MatrixXd own(shapes.rows(), force.cols());
    for (std::size_t i = 0; i < loaded.size(); ++i)
      own.middleRows<6>(6 * Index(i)) = force.middleRows<6>(6 * Index(nodes[loaded[i]]));
    q(rows_of(instance, number), Eigen::all) += shapes.transpose() * own;
  }
  return q;
}

} // namespace plica
