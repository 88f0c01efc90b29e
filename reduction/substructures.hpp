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

struct ReducedModel {
  Model model; // the frame with the superelements
  std::vector<int> number;
  std::vector<Instance> instances;
  int reductions = 0;  // done for them
  bool proved = false; // of every substructure
  std::string reason;

  // All DOFs of the whole, or the six of chosen nodes, from those of the reduced model; and forces
  // the other way.
  Eigen::MatrixXd field(const Eigen::MatrixXd& reduced) const;
  Eigen::MatrixXd field_at(const Eigen::MatrixXd& reduced, const std::vector<int>& nodes) const;
  Eigen::MatrixXd gather(const Eigen::MatrixXd& force) const;
};

// Nodes that keep a local break of the symmetry out of the superelements: of every ring that has
// left its circle (a dent) and the ring on either side, with the axis nodes tied to them. Taken
// among the interface nodes, the broken stretch stays as shells, and what is left of the part is
// symmetric.
std::vector<int> nodes_around_breaks(const Model& model);

// A superelement of superelements: the reduced model with these nodes of the whole as its boundary.
// Fields are those of the whole. Throws as craig_bampton().
Reduction craig_bampton(const std::shared_ptr<const ReducedModel>& model,
                        const std::vector<int>& boundary, double cutoff);

// How substructures are reduced. By symmetry where `symmetry` allows it and the substructure has
// it. Modes with the interface held up to `cutoff` (Hz), by symmetry those that the interface feels
// or `all_harmonics`.
struct ReductionRequest {
  double cutoff = 0;
  bool symmetry = true, all_harmonics = false;

  bool operator==(const ReductionRequest&) const = default;
};

// Reductions of earlier models, for substructures that come again without any change, at the same
// place. Keeps the last few; several threads may use one.
class ReductionMemory {
public:
  std::shared_ptr<const PartReduction> find(const Substructure& part,
                                            const ReductionRequest& request);
  void keep(std::shared_ptr<const Substructure> part, const ReductionRequest& request,
            std::shared_ptr<const PartReduction> reduction);

private:
  struct Entry {
    std::shared_ptr<const Substructure> part;
    ReductionRequest request;
    std::shared_ptr<const PartReduction> reduction;
  };
  std::deque<Entry> entries_; // the last used first
  std::mutex mutex_;
};

// Throws as cut() and craig_bampton(). `memory`: what it knows is not reduced again.
ReducedModel reduce_substructures(const Model& model, const std::vector<int>& interface_nodes,
                                  const ReductionRequest& request,
                                  ReductionMemory* memory = nullptr);

} // namespace plica
