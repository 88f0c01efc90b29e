// The full mesh of a case over ranks: what a Route answers, with every rank at work.
//
// All members are collective: every rank calls them, with what the first rank was asked. What the
// first rank alone needs (fields over all DOFs) comes out there and is empty elsewhere.
#pragma once

#include "engine/rows_of_ranks.hpp"
#include "engine/shift_invert_modes.hpp"
#include "run/routes/route.hpp"

namespace plica {

struct EngineLoads {
  std::vector<int> base; // as in Loads, on every rank
  Eigen::MatrixXd force; // all DOFs x loads, on the first rank
};

class DistributedModel {
public:
  // `log` hears what MUMPS did, on the first rank. Throws InputError on every rank for a clash of
  // constraints and for more ranks than there is work for.
  DistributedModel(const BuiltCase& built, const Ranks& ranks, MumpsSettings settings,
                   std::function<void(const std::string&)> log);

  int unknowns() const { return map_.size(); }
  double mass() const { return mass_; }
  std::optional<Matrix1212> end_stiffness(const std::array<int, 2>& caps);
  Eigen::MatrixXd follow(const std::array<int, 2>& caps, const Eigen::MatrixXd& motion);
  ModalSolution modes(const ModesRequest& request, const EngineLoads& loads,
                      const std::vector<int>& sensors);

private:
  // A stiffness with some DOFs of it held, and the factor of the rest.
  struct Held {
    DistributedMatrix whole, inner;
    std::vector<int> kept; // own rows of `whole` that are not held, from 0
    std::optional<MumpsFactor> factor;
  };
  void factor_base();
  void find_mass();
  std::vector<int> own_without(const std::vector<int>& held) const;
  Eigen::MatrixXd rows_of(const Eigen::MatrixXd& all) const;
  Held& without_mount(const std::vector<int>& boundary);
  Eigen::MatrixXd follow_boundary(Held& part, const std::vector<int>& boundary,
                                  const Eigen::MatrixXd& at_boundary);
  Eigen::MatrixXd loads_on_free(const EngineLoads& loads) const;
  Eigen::MatrixXd expand_free(const Eigen::MatrixXd& own_free) const;
  void report(const std::string& of, const MumpsReport& factor) const;

  const BuiltCase& built_;
  const Ranks& ranks_;
  MumpsSettings settings_;
  std::function<void(const std::string&)> log_;
  DofMap map_;
  RowShare share_;
  std::vector<int> held_;
  std::vector<int> free_; // own rows that nothing holds, from 0
  DistributedMatrix K_, M_free_, K_free_;
  Eigen::MatrixXd rigid_;      // own free rows: motions of a rigid body about the origin
  Eigen::MatrixXd base_force_; // own free rows: M r, held DOFs moving along
  double mass_ = 0;
  std::optional<ShiftedFactor> base_;
  std::vector<int> solved_; // boundary of `statics_`
  std::optional<Held> statics_;
};

} // namespace plica
