// A model cut at interface nodes into substructures, each replaced by a superelement.
//
// Nodes that elements or couplings join without passing an interface node belong together, and so
// do all that hang between the same interface nodes: a bellows and the liner inside it. What lies
// on interface nodes alone (masses of caps, mounts, joints) stays as it is, and so does a stretch
// of wall that meets interface nodes of the wall alone.
#pragma once

#include "reduction/superelement.hpp"

#include <deque>
#include <memory>
#include <mutex>

namespace plica {

struct Substructure {
  Model model;               // with its own numbers
  std::vector<int> nodes;    // number in the whole, per own node; increasing
  std::vector<int> boundary; // own numbers of the interface nodes it meets
};

struct CutModel {
  std::vector<Substructure> parts;
  Model frame;             // interface nodes and what lies on them alone
  std::vector<int> number; // in the frame, per node of the whole; -1 = inside a part
};

// Throws std::invalid_argument naming a node of a part that meets no interface node.
CutModel cut(const Model& model, const std::vector<int>& interface_nodes);

// True when b is a moved along: the same elements, sections and couplings between nodes at the same
// distances. `rounding` is relative: meshing a bellows elsewhere on the axis moves its nodes by
// 1e-10 of their radius and turns its directors by 1e-7.
bool is_copy(const Substructure& a, const Substructure& b, double rounding = 1e-6);

struct PartReduction { // of one substructure; copies share one
  Reduction reduction;
  int sectors = 0;     // of its rotational symmetry; 0 = by the full mesh
  std::string because; // why by the full mesh
};

struct Instance {
  std::shared_ptr<const Substructure> part;
  std::shared_ptr<const PartReduction> reduced;
  std::vector<int> scalar_nodes; // of its modal coordinates in the frame
};

// Its coordinates among the DOFs of the reduced model: of its boundary nodes, then modal ones.
// `number`: as ReducedModel has it.
std::vector<int> rows_of(const Instance& instance, const std::vector<int>& number);

struct ReducedModel {
  Model model; // the frame with the superelements
  std::vector<int> number;
  std::vector<Instance> instances;
  int reductions = 0;  // done for them
  bool proved = false; // of every substructure
  std::string reason;

  // All DOFs of the whole, or the six of chosen nodes (increasing), from those of the reduced
  // model; and forces the other way.
  Eigen::MatrixXd field(const Eigen::MatrixXd& reduced) const;
  Eigen::MatrixXd field_at(const Eigen::MatrixXd& reduced, const std::vector<int>& nodes) const;
  Eigen::MatrixXd gather(const Eigen::MatrixXd& force) const;
  Eigen::MatrixXd gather_at(const Eigen::MatrixXd& force, const std::vector<int>& nodes) const;
};

// u' K_c u of the field of the whole, by component (rows) and column of the reduced model's DOFs: a
// superelement with one component has it in its own matrix.
Eigen::MatrixXd strain_energy(const ReducedModel& model, const Eigen::MatrixXd& reduced);

// Nodes that keep a local break of the symmetry out of the superelements: of every ring that has
// left its circle (a dent) and the ring on either side, with the axis nodes tied to them. Taken
// among the interface nodes, the broken stretch stays as shells, and what is left of the part is
// symmetric.
std::vector<int> nodes_around_breaks(const Model& model);

// A superelement of superelements: the reduced model with these nodes of the whole as its boundary.
// Fields are those of the whole. Throws as craig_bampton().
Reduction craig_bampton(const std::shared_ptr<const ReducedModel>& model,
                        const std::vector<int>& boundary, double cutoff);

// What reduce_part() is told, how the parts of one model are reduced. By symmetry where `symmetry`
// allows it and the substructure has it. Modes with the interface held up to `cutoff` (Hz), by
// symmetry those that the interface feels or `all_harmonics`.
struct PartReductionRequest {
  double cutoff = 0;
  bool symmetry = true, all_harmonics = false;

  bool operator==(const PartReductionRequest&) const = default;
};

// Reductions of earlier models, for substructures that come again without any change, at the same
// place. Keeps the last few; several threads may use one.
class ReductionMemory {
public:
  std::shared_ptr<const PartReduction> find(const Substructure& part,
                                            const PartReductionRequest& request);
  void keep(std::shared_ptr<const Substructure> part, const PartReductionRequest& request,
            std::shared_ptr<const PartReduction> reduction);

private:
  struct Entry {
    std::shared_ptr<const Substructure> part;
    PartReductionRequest request;
    std::shared_ptr<const PartReduction> reduction;
  };
  std::deque<Entry> entries_; // the last used first
  std::mutex mutex_;
};

// Reduces substructures of which none is a copy of another; the reductions stand in their order.
using PartReducer = std::function<std::vector<std::shared_ptr<const PartReduction>>(
    const std::vector<std::shared_ptr<const Substructure>>& parts,
    const PartReductionRequest& request)>;

// Of one. Throws as craig_bampton(). The part outlives it.
std::shared_ptr<const PartReduction> reduce_part(const Substructure& part,
                                                 const PartReductionRequest& request);

// One after the other in this process. `memory`, which outlives it: what it knows is not reduced
// again.
PartReducer reduce_here(ReductionMemory* memory = nullptr);

// Parts with those of them that are no copy of an earlier one.
struct DifferentParts {
  std::vector<std::shared_ptr<const Substructure>> parts, different;
  std::vector<std::size_t> place; // per part: among the different ones
};
DifferentParts different_parts(std::vector<Substructure> pieces);

// Throws as `reduce`.
ReducedModel reduce_substructures(CutModel pieces, const PartReductionRequest& request,
                                  const PartReducer& reduce = reduce_here());

} // namespace plica
