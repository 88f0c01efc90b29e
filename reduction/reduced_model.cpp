#include "reduction/craig_bampton.hpp"
#include "reduction/substructures.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace plica {

using Eigen::Index;
using Eigen::MatrixXd;

std::vector<int> rows_of(const Instance& instance, const std::vector<int>& number) {
  std::vector<int> rows;
  for (int node : instance.part->boundary)
    for (int d = 0; d < 6; ++d) rows.push_back(6 * number[instance.part->nodes[node]] + d);
  const int modal = instance.reduced->reduction.element.modal();
  for (int k = 0; k < modal; ++k) rows.push_back(6 * instance.scalar_nodes[k / 6] + k % 6);
  return rows;
}

namespace {

// Those of some nodes of the whole that lie inside an instance.
struct Inside {
  std::vector<int> own;        // numbers in the part
  std::vector<std::size_t> at; // places in the list
};

Inside inside(const Instance& instance, const std::vector<int>& number,
              const std::vector<int>& nodes) {
  Inside found;
  const std::vector<int>& known = instance.part->nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto place = std::lower_bound(known.begin(), known.end(), nodes[i]);
    if (number[nodes[i]] >= 0 || place == known.end() || *place != nodes[i]) continue;
    found.own.push_back(static_cast<int>(place - known.begin()));
    found.at.push_back(i);
  }
  return found;
}

} // namespace

std::shared_ptr<const PartReduction> reduce_part(const Substructure& part,
                                                 const PartReductionRequest& asked) {
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

PartReducer reduce_here(ReductionMemory* memory) {
  return [memory](const std::vector<std::shared_ptr<const Substructure>>& parts,
                  const PartReductionRequest& request) {
    std::vector<std::shared_ptr<const PartReduction>> reductions;
    for (const std::shared_ptr<const Substructure>& part : parts) {
      std::shared_ptr<const PartReduction> known = memory ? memory->find(*part, request) : nullptr;
      if (!known) {
        known = reduce_part(*part, request);
        if (memory) memory->keep(part, request, known);
      }
      reductions.push_back(std::move(known));
    }
    return reductions;
  };
}

DifferentParts different_parts(std::vector<Substructure> pieces) {
  DifferentParts all;
  for (Substructure& piece : pieces) {
    const auto part = std::make_shared<const Substructure>(std::move(piece));
    const auto same = std::find_if(all.different.begin(), all.different.end(),
                                   [&](const auto& other) { return is_copy(*other, *part); });
    all.place.push_back(std::size_t(same - all.different.begin()));
    if (same == all.different.end()) all.different.push_back(part);
    all.parts.push_back(part);
  }
  return all;
}

ReducedModel reduce_substructures(CutModel pieces, const PartReductionRequest& request,
                                  const PartReducer& reduce) {
  ReducedModel reduced{.model = std::move(pieces.frame),
                       .number = std::move(pieces.number),
                       .instances = {},
                       .reductions = 0,
                       .proved = true,
                       .reason = ""};
  const DifferentParts parts = different_parts(std::move(pieces.parts));
  const auto reductions = reduce(parts.different, request);
  reduced.reductions = static_cast<int>(parts.different.size());
  for (std::size_t i = 0; i < parts.parts.size(); ++i) {
    Instance instance{
        .part = parts.parts[i], .reduced = reductions[parts.place[i]], .scalar_nodes = {}};
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
    const Inside chosen = inside(instance, number, nodes);
    if (chosen.own.empty()) continue;
    const MatrixXd rows =
        instance.reduced->reduction.field_at(q(rows_of(instance, number), Eigen::all), chosen.own);
    for (std::size_t i = 0; i < chosen.at.size(); ++i)
      u.middleRows<6>(6 * Index(chosen.at[i])) = rows.middleRows<6>(6 * Index(i));
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
  std::vector<int> all(number.size());
  std::iota(all.begin(), all.end(), 0);
  return gather_at(force, all);
}

MatrixXd ReducedModel::gather_at(const MatrixXd& force, const std::vector<int>& nodes) const {
  std::vector<int> loaded;
  std::vector<Index> at; // rows of their forces
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (const Index row = 6 * Index(i); !force.middleRows<6>(row).isZero(0)) {
      loaded.push_back(nodes[i]);
      at.push_back(row);
    }
  MatrixXd q = MatrixXd::Zero(dof_count(model), force.cols());
  for (std::size_t i = 0; i < loaded.size(); ++i)
    if (const int frame_node = number[loaded[i]]; frame_node >= 0)
      q.middleRows<6>(6 * Index(frame_node)) = force.middleRows<6>(at[i]);
  for (const Instance& instance : instances) {
    const Inside chosen = inside(instance, number, loaded);
    if (chosen.own.empty()) continue;
    const Reduction& r = instance.reduced->reduction;
    const Index size = r.element.K.rows();
    const MatrixXd shapes = r.field_at(MatrixXd::Identity(size, size), chosen.own);
    MatrixXd own(shapes.rows(), force.cols());
    for (std::size_t i = 0; i < chosen.own.size(); ++i)
      own.middleRows<6>(6 * Index(i)) = force.middleRows<6>(at[chosen.at[i]]);
    q(rows_of(instance, number), Eigen::all) += shapes.transpose() * own;
  }
  return q;
}

} // namespace plica
