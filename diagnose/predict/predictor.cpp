#include "diagnose/predict/predictor.hpp"

#include "diagnose/effects/on_table.hpp"
#include "diagnose/predict/built_in_state.hpp"
#include "solve/parallel.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

namespace plica {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// The model of a state whose case is changed; in its operating state, which may be of the change.
std::function<void(Model&)> built_with(const NominalState& state,
                                       std::vector<std::function<void(Case&)>> changes) {
  return [&data = state.data, changes = std::move(changes)](Model& model) {
    Case changed = data;
    for (const auto& change : changes) change(changed);
    model = model_in_state(changed, build_on_table(changed));
  };
}

// What a hypothesis does to the model of a state.
std::vector<ModelChange> changes_in(const NominalState& state, const Hypothesis& h) {
  std::vector<ModelChange> all = h.changes;
  for (ModelChange& change : all)
    if (change.apply) change.apply = around_state(std::move(change.apply));
  for (const auto& change : h.case_changes)
    all.push_back({built_with(state, {change}), h.large ? Follow::modes : Follow::nominal});
  return all;
}

// One change of each of two hypotheses, by their numbers: a case is changed before it is built, the
// model after.
ModelChange both_in(const NominalState& state, const Hypothesis& a, std::size_t i,
                    const Hypothesis& b, std::size_t j) {
  const auto of_case = [](const Hypothesis& h, std::size_t k) { return k >= h.changes.size(); };
  const auto case_change = [](const Hypothesis& h, std::size_t k) {
    return h.case_changes[k - h.changes.size()];
  };
  ModelChange both;
  for (const auto& [h, k] : {std::pair{&a, i}, {&b, j}})
    if (!of_case(*h, k))
      both.on_motion.insert(both.on_motion.end(), h->changes[k].on_motion.begin(),
                            h->changes[k].on_motion.end());
  if (of_case(a, i) && of_case(b, j)) {
    both.apply = built_with(state, {case_change(a, i), case_change(b, j)});
    return both;
  }
  const bool turned = of_case(b, j);
  const ModelChange first = changes_in(state, turned ? b : a)[turned ? j : i],
                    second = changes_in(state, turned ? a : b)[turned ? i : j];
  both.apply = [first, second](Model& model) {
    if (first.apply) first.apply(model);
    if (second.apply) second.apply(model);
  };
  return both;
}

bool is_costly(const Hypothesis& h) {
  return (h.large && !h.case_changes.empty()) ||
         std::any_of(h.changes.begin(), h.changes.end(),
                     [](const ModelChange& c) { return c.follow == Follow::modes; });
}

} // namespace

Identities identities_of(const std::vector<const Hypothesis*>& together) {
  Identities all;
  for (const Hypothesis* h : together) all.push_back(h->identity.number());
  return all;
}

std::optional<StateModels::Changes> StateModels::kept(std::size_t s, const Hypothesis& h) {
  const std::lock_guard lock(mutex_);
  const auto known = kept_.find({s, h.identity.number()});
  return known == kept_.end() ? std::nullopt : std::optional(known->second);
}

StateModels::Changes StateModels::prepared(std::size_t s, const Hypothesis& h) {
  if (auto known = kept(s, h)) return std::move(*known);
  const NominalState& state = nominal_.states[s];
  Changes made = state.model->prepare(changes_in(state, h));
  if (!is_costly(h)) return made;
  const std::lock_guard lock(mutex_);
  return kept_.try_emplace({s, h.identity.number()}, std::move(made)).first->second;
}

StateModels::Changes StateModels::changes(std::size_t s, const Together& together) {
  std::vector<Changes> parts(together.size());
  in_parallel(int(parts.size()),
              [&](int h) { parts[std::size_t(h)] = prepared(s, *together[std::size_t(h)]); });
  Changes behind;
  if (solves_anew_) {
    std::vector<int> first{0};
    for (const Changes& part : parts) first.push_back(first.back() + int(part.size()));
    for (std::size_t a = 0; a < parts.size(); ++a)
      for (std::size_t b = a + 1; b < parts.size(); ++b)
        for (PreparedChange& change :
             products(s, *together[a], parts[a], first[a], *together[b], parts[b], first[b]))
          behind.push_back(std::move(change));
  }
  parts.push_back(std::move(behind));
  Changes all;
  for (Changes& part : parts)
    for (PreparedChange& change : part) all.push_back(std::move(change));
  return all;
}

StateModels::Changes StateModels::products(std::size_t s, const Hypothesis& a, const Changes& of_a,
                                           int a_first, const Hypothesis& b, const Changes& of_b,
                                           int b_first) {
  const std::tuple key{s, a.identity.number(), b.identity.number()};
  std::optional<Changes> found;
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = products_.find(key); known != products_.end()) found = known->second;
  }
  if (!found) {
    const NominalState& state = nominal_.states[s];
    std::vector<std::optional<PreparedChange>> each(of_a.size() * of_b.size());
    in_parallel(int(each.size()), [&](int k) {
      const auto i = std::size_t(k) / of_b.size(), j = std::size_t(k) % of_b.size();
      if (of_a[i].term || of_b[j].term) return; // they add up
      each[std::size_t(k)] = state.model->product(both_in(state, a, i, b, j), of_a[i], of_b[j]);
      if (each[std::size_t(k)]) each[std::size_t(k)]->product_of = {int(i), int(j)};
    });
    found.emplace();
    for (std::optional<PreparedChange>& change : each)
      if (change) found->push_back(std::move(*change));
    const std::lock_guard lock(mutex_);
    products_.try_emplace(key, *found);
  }
  for (PreparedChange& change : *found) {
    (*change.product_of)[0] += a_first;
    (*change.product_of)[1] += b_first;
  }
  return std::move(*found);
}

void StateModels::solve_anew() {
  forget_sets();
  solves_anew_ = true;
}

void StateModels::forget_sets() {
  const std::lock_guard lock(mutex_);
  std::erase_if(known_, [](const auto& known) { return known.first.second.size() > 1; });
}

void StateModels::make(std::size_t s, const Together& together, const Changes& changes,
                       StateModel& own) {
  const NominalState& state = nominal_.states[s];
  std::vector<int> held = state.built.held_nodes;
  for (const Hypothesis* h : together)
    for (int node : h->released) std::erase(held, node);
  own.nominal = &state;
  own.whole = with_losses(state, changes, own.losses);
  const std::vector<int>& boundary = state.model->boundary();
  for (int i = 0; i < int(own.whole.K.rows()); ++i)
    if (i >= own.whole.boundary ||
        std::find(held.begin(), held.end(), boundary[std::size_t(i / 6)]) == held.end())
      own.coordinates.push_back(i);
  own.free = FreeAffineModel(own.whole, own.coordinates, state.zeta);
}

StateModels::Lazy& StateModels::lazy(std::size_t state, const Together& together) {
  const std::lock_guard lock(mutex_);
  return known_[{state, identities_of(together)}];
}

const StateModel& StateModels::of(std::size_t state, const Together& together) {
  Lazy& own = lazy(state, together);
  std::call_once(own.once, [&] { make(state, together, changes(state, together), own.model); });
  return own.model;
}

void StateModels::reduce(std::size_t s, const Together& each) {
  const NominalState& state = nominal_.states[s];
  std::vector<ModelChange> all;
  std::vector<std::size_t> count;
  for (const Hypothesis* h : each) {
    const std::vector<ModelChange> own =
        is_costly(*h) ? std::vector<ModelChange>() : changes_in(state, *h);
    all.insert(all.end(), own.begin(), own.end());
    count.push_back(own.size());
  }
  Changes made = state.model->prepare(all);
  auto next = std::make_move_iterator(made.begin());
  for (std::size_t i = 0; i < each.size(); ++i) {
    const Hypothesis* h = each[i];
    const Changes own =
        is_costly(*h) ? prepared(s, *h) : Changes(next, next + std::ptrdiff_t(count[i]));
    next += std::ptrdiff_t(count[i]);
    Lazy& model = lazy(s, {h});
    std::call_once(model.once, [&] { make(s, {h}, own, model.model); });
  }
}

void StateModels::keep(std::size_t s, const Together& each) {
  in_parallel(int(each.size()), [&](int i) {
    const Hypothesis& h = *each[std::size_t(i)];
    if (kept(s, h)) return;
    Changes made = prepared(s, h);
    const std::lock_guard lock(mutex_);
    kept_.try_emplace({s, h.identity.number()}, std::move(made));
  });
}

std::vector<std::size_t> StateModels::fitted_states(const TestReadings& test) const {
  std::vector<std::size_t> found;
  for (std::size_t s = 0; s < nominal_.states.size(); ++s)
    if (std::any_of(test.readings.begin(), test.readings.end(), [&](const Reading& r) {
          return !r.held_out && r.state == nominal_.states[s].name;
        }))
      found.push_back(s);
  return found;
}

Predictor::Predictor(const Nominal& nominal, const TestReadings& test,
                     const std::vector<const Hypothesis*>& together,
                     std::shared_ptr<StateModels> models)
    : nominal_(nominal), test_(test), together_(together),
      models_(models ? std::move(models) : std::make_shared<StateModels>(nominal)) {
  for (std::size_t h = 0; h < together.size(); ++h) {
    const Hypothesis& own = *together[h];
    if (own.softening) {
      softening_ = int(h);
      group_ = {.change = changes_, .stiffness = own.group_stiffness, .present = own.group_present};
    }
    changes_ += int(own.changes.size() + own.case_changes.size());
    parameters_ += int(own.parameters.size());
  }
  for (const Reading& r : test.readings)
    for (std::size_t s = 0; s < nominal.states.size(); ++s)
      if (nominal.states[s].name == r.state) state_of_reading_.push_back(s);
  for (const NominalState& state : nominal.states) {
    int last = int(state.built.sensors.size()) - 1;
    for (const Reading& r : test.readings) last = std::max(last, state.number_of(r.sensor));
    for (const TestRun& run : test.runs) last = std::max(last, state.number_of(run.sensor));
    seen_.push_back(last + 1);
  }
}

StateAnswers Predictor::answers_of(std::size_t state, const Acting& acting) const {
  return StateAnswers(model(state), test_, acting, seen_[state]);
}

double Predictor::basis_error(const VectorXd& values) const {
  constexpr int modes = 6;
  const NominalState& state = nominal_.states.front();
  return state.model
      ->frequency_errors(models_->changes(0, together_), acting(values, 0).all,
                         model(0).coordinates, modes)
      .maxCoeff();
}

VectorXd Predictor::values_of(const VectorXd& z) const {
  VectorXd values(z.size());
  Index i = 0;
  for (const Hypothesis* h : together_)
    for (const EffectParameter& p : h->parameters) {
      values[i] = plica::value_of(p.prior, z[i]);
      ++i;
    }
  return values;
}

Acting Predictor::acting(const VectorXd& values, std::size_t state) const {
  std::vector<double> all, rig;
  Acting acting;
  Index first = 0;
  for (std::size_t i = 0; i < together_.size(); ++i) {
    const Hypothesis& h = *together_[i];
    VectorXd own = values.segment(first, Index(h.parameters.size()));
    first += own.size();
    if (h.values_in) own = h.values_in(own, nominal_.states[state].name);
    if (h.coefficients)
      for (double x : h.coefficients(own)) {
        all.push_back(x);
        rig.push_back(h.at_rig ? x : 0);
      }
    if (h.setup) h.setup(acting.setup, own);
    if (int(i) == softening_) {
      acting.group = group_;
      acting.softening = h.softening(own);
    }
  }
  acting.all = Eigen::Map<VectorXd>(all.data(), Index(all.size()));
  acting.rig = Eigen::Map<VectorXd>(rig.data(), Index(rig.size()));
  return acting;
}

std::optional<VectorXd> Predictor::operator()(const VectorXd& values, Which which) const {
  auto found = answers(values, Slip::as_is, which, Across::left_out);
  return found ? std::optional(std::move(found->log)) : std::nullopt;
}

std::optional<Answered> Predictor::answered(const VectorXd& values, Which which) const {
  return answers(values, Slip::as_is, which, Across::asked);
}

VectorXd Predictor::law_error(const VectorXd& values, const VectorXd& y, Which which) const {
  if (softening_ < 0) return VectorXd();
  const auto stuck = answers(values, Slip::stuck, which, Across::left_out);
  if (!stuck) return VectorXd();
  VectorXd change = (y - stuck->log).cwiseAbs();
  change = change.array().isFinite().select(change, 0);
  // What shows along other axes hangs on how directions slip together, which no single law says.
  constexpr double as_along = 3;
  std::map<int, double> along;
  const auto& readings = test_.readings;
  for (std::size_t i = 0; i < readings.size(); ++i)
    if (readings[i].kind == ReadingKind::amplitude)
      along[readings[i].run] = std::max(along[readings[i].run], change[Index(i)]);
  for (std::size_t i = 0; i < readings.size(); ++i)
    if (readings[i].kind == ReadingKind::cross)
      change[Index(i)] = std::max(change[Index(i)], as_along * along[readings[i].run]);
  return together_[std::size_t(softening_)]->law_error * change;
}

std::optional<Answered> Predictor::answers(const VectorXd& values, Slip slip, Which which,
                                           Across across) const {
  std::vector<std::optional<Acting>> acts(seen_.size());
  std::vector<std::optional<StateAnswers>> answers(seen_.size());
  const auto n = Index(test_.readings.size());
  Answered found{.log = VectorXd::Constant(n, std::numeric_limits<double>::quiet_NaN()),
                 .across = Eigen::MatrixX2d::Zero(n, 2)};
  for (Index i = 0; i < n; ++i) {
    const Reading& reading = test_.readings[std::size_t(i)];
    if (which == Which::fitted && reading.held_out) continue;
    const std::size_t s = state_of_reading_[std::size_t(i)];
    if (!answers[s]) {
      acts[s] = acting(values, s);
      if (slip == Slip::stuck) acts[s]->group.reset();
      answers[s].emplace(answers_of(s, *acts[s]));
    }
    const std::optional<double> answer = answers[s]->answer(reading);
    if (!answers[s]->is_stable()) return std::nullopt;
    if (!answer) continue;
    found.log[i] = *answer;
    if (across == Across::asked && reading.kind == ReadingKind::cross && std::isfinite(*answer))
      found.across.row(i) = answers[s]->scatter_across(reading).transpose();
  }
  return found;
}

std::optional<AffineModes> Predictor::modes(const VectorXd& values) const {
  return model(0).free.modes(acting(values, 0).all);
}

std::vector<int> Predictor::nominal_modes(const VectorXd& values) const {
  std::vector<std::optional<Acting>> own(seen_.size());
  std::vector<int> modes;
  std::vector<std::optional<StateAnswers>> answers(seen_.size());
  for (std::size_t i = 0; i < test_.readings.size(); ++i) {
    const std::size_t s = state_of_reading_[i];
    if (!answers[s]) answers[s].emplace(answers_of(s, own[s].emplace(acting(values, s))));
    modes.push_back(answers[s]->nominal_mode(test_.readings[i]));
  }
  return modes;
}

std::optional<Eigen::VectorXcd> Predictor::response(const VectorXd& values, const TestRun& run,
                                                    const VectorXd& hertz) const {
  std::size_t s = 0;
  while (s + 1 < seen_.size() && nominal_.states[s].name != run.state) ++s;
  const Acting own = acting(values, s);
  return answers_of(s, own).response(run, hertz);
}

void PredictorStore::solve_anew() {
  models_->solve_anew();
  forget_sets();
}

void PredictorStore::forget_sets() {
  models_->forget_sets();
  const std::lock_guard lock(mutex_);
  std::erase_if(known_, [](const auto& known) { return known.first.size() > 1; });
}

const Predictor& PredictorStore::of(const std::vector<const Hypothesis*>& together) {
  const Identities identities = identities_of(together);
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = known_.find(identities); known != known_.end()) return *known->second;
  }
  auto made = std::make_unique<Predictor>(nominal_, test_, together, models_);
  const std::lock_guard lock(mutex_);
  return *known_.try_emplace(identities, std::move(made)).first->second;
}

} // namespace plica
