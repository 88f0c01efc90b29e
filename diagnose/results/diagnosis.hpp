// What a diagnosis says: where the gap between model and test lies, which effect causes it, how
// much of it goes when the effect is modelled, and what to measure next.
#pragma once

#include "diagnose/readings/reading.hpp"
#include "mesh/mesh.hpp"
#include "model/description/case_edit.hpp"

#include <Eigen/Core>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace plica {

// none: the nominal case explains the test. identified: one effect does. ambiguous: each of several
// effects does, and the data cannot tell. several: effects together do. mostly: effects that are
// far ahead close at least half of the gap. unknown: nothing of the library does.
enum class Verdict { none, identified, ambiguous, several, mostly, unknown };

struct EstimatedParameter {
  std::string name, unit;
  double value = 0;
  std::array<double, 2> interval{}; // 90 %
  double z = 0;                     // distance from the centre of its prior
};

struct NamedEffect {
  std::string name, place, way;
  double probability = 0; // of effect and place
  std::vector<EstimatedParameter> parameters;
  std::vector<std::string> other_places = {}; // where it explains as well (Standards::apart)
  double anywhere = 0;                        // probability of the effect, wherever it sits
  std::vector<int> nodes = {}; // of Diagnosis::mesh, where it sits; none: everywhere, or outside
  // m from the left end of a bellows to a place on it, and between which two it lies: half way to
  // the next ones that were looked at, of the other places too.
  struct Along {
    double value = 0;
    std::array<double, 2> interval{};
  };
  std::optional<Along> along = {};
  // m: how far from a spot on a surface or a deck it may sit, as no spot that was looked at lies
  // nearer to the cause; that it sits at one of the other places included.
  std::optional<double> within = {};
  // What a case says in its place (Hypothesis::in_case), at these values.
  std::function<CaseEdits(const Case& now)> in_case = {};
};

// How probable it is that an effect is part of the cause, and at which of its places, as far as the
// verdict claims it: over single effects, over sets that explain the test, or over all sets.
struct EffectInclusion {
  std::string effect;
  double probability = 0;                                  // wherever it sits
  std::vector<std::pair<std::string, double>> places = {}; // of effect and place, largest first
};

// What probabilities of effects are of.
struct Weighing {
  // One effect or none, were it all there is; sets that explain the test; all that were tried.
  enum class Over { singles, standing_sets, all_sets } over = Over::singles;
  bool limited = false; // to the share of the gap that what leads closes
};

// One hypothesis that was tried, or a set of them.
struct TriedHypothesis {
  std::vector<NamedEffect> effects; // none = the nominal case
  double log_evidence = 0;
  std::optional<double> sampled_log_evidence; // by Markov chains
  double log_bayes_factor = 0;                // over the nominal case
  double half_width = 0, double_width = 0;    // the same with priors half and twice as wide
  double chi2 = 0, chi2_of_means = 0; // of the fitted readings, of their means over the levels
  bool adequate = false;              // as good as an admissible specimen
  double share_of_healthy_worse = 0;  // that fit no better: a p-value
  std::string worst_block;            // where it fits least
  double worst_block_z = 0;
  double gap_after = 0; // RMS of e
  std::optional<double> held_out_after;
  bool absurd = false; // |z| of a parameter above 3
  bool fails_held_out = false;
  std::string rejected;                // why, in words; empty = not
  std::vector<std::string> aside = {}; // readings that do not follow what it changes
};

// A mass on a spring of its own, which is no effect of the library, but explains the test as well
// as what is told first, or far better.
struct Resonator {
  NamedEffect found; // "resonator", its mass, frequency and place
  std::string words; // "15 g on a spring of its own, which resonates at 805 Hz, at beam.point[3]"
  double gap_after = 0; // RMS of e
  bool is_ahead = false;
};
inline std::string resonator_clause(bool is_ahead, const std::string& words) {
  return std::string("; what is no effect here would do ") + (is_ahead ? "better" : "as well") +
         ": " + words;
}

// An effect that has no place in the case.
struct EffectNotTried {
  std::string name, needs; // needs: "a bellows"
};

// One block of readings against admissible specimens.
struct LocatedGap {
  std::string component; // by hypotheses at that place; else empty and
  std::string direction; // of base, with that of the response where it differs: "y", "x to z"
  std::string band;      // peak and its frequency
  std::optional<ReadingKind> kind = {}; // of a component none
  bool of_energy = false;               // of a component: what a measured shape leaves there
  std::optional<double> level;
  std::string state;
  double z = 0;             // signed: above zero, the test shows more than the model
  bool significant = false; // at 5 % after Holm's correction
};

// Change of a frequency or damping with level.
struct LevelTrend {
  std::string quantity;
  double slope = 0, sigma = 0; // d ln / d ln level
  double best = 0;             // the slope that the model has with what the gap is closed with
};

// A parameter estimated from parts of the readings alone.
struct ParameterDrift {
  std::string parameter, by;                                        // by level, direction, band
  std::vector<std::pair<std::string, std::array<double, 2>>> parts; // estimate and sigma
  double p = 1;                                                     // that they are equal
};

struct GapShrink {
  double before = 0, after = 0; // RMS of whitened differences; 1 = measurement and scatter
  double shrink() const { return before > 0 ? 1 - after / before : 0; }
  std::array<double, 2> interval{}; // of the shrink, 90 %
  int readings = 0;
  // Its interval lies above zero, by more than what a search leaves by rounding.
  bool is_sure() const { return interval[0] > 1e-3; }
};

// What the gap is made of: the squared differences of the fitted readings from the nominal case
// over their covariance before any effect, G = r' W r / n.
//
// An effect's share is its Shapley value: what G falls by when it comes in, over all orders in
// which effects can come, without a refit, over draws of their joint posterior. What is left is
// split by expectation: a part C_k of the covariance leaves trace(W C_k) / n, all of them 1
// together (less where less is left); the rest is unexplained. Shares sum to 1; one that makes
// others worse is negative.
enum class Remainder { measurement, mounting, model, unexplained };
constexpr const char* word_of(Remainder left) {
  constexpr std::array words{"measurement", "mounting", "model", "unexplained"};
  return words.at(static_cast<std::size_t>(left));
}
struct LedgerRow {
  std::vector<NamedEffect> effects = {}; // that cannot be told apart; none: what is left
  std::optional<Remainder> left = {};    // of a row without effects
  double share = 0;
  std::array<double, 2> interval{}; // 90 %
  std::string told_apart_by = {};   // what to measure to tell its effects apart; empty: not known
};
struct Ledger {
  double gap = 0; // G
  int readings = 0;
  std::vector<LedgerRow> rows;
  std::vector<std::pair<std::string, double>> left_in; // readings with their shares of the gap left
  double explained = 0;                                // share of all effects together
  std::array<double, 2> explained_interval{};
};

// One reading beside the models.
struct ComparedReading {
  ReadingKind kind = ReadingKind::frequency;
  std::string name, unit;
  double measured = 0, nominal = 0, best = 0;
  std::optional<double> second;
  double sigma = 0; // of all uncertainties, relative
  bool held_out = false;
};

// Baselines beside the model, and what they say of its error.
struct BaselineFound {
  std::vector<ComparedReading> readings; // `best` is the nominal case: no effect acts there
  std::vector<std::string> words;
};

inline constexpr double hardly_told_apart = 0.8; // cosine of two signatures, and above

struct Mimic {
  std::string a, b; // effects
  double cosine = 0;
};

struct SmallestDetectable {
  std::string name, place, way, parameter, unit;
  double at = 0;               // value of the parameter, of the size to be expected,
  double noncentrality = 0;    // for which this is the non-centrality
  std::optional<double> value; // smallest; none: beyond its prior's reach, or another place of the
                               // effect shows more
};

struct ProposedMeasurement {
  std::string what;
  double cost = 1;       // 1: an hour at the rig
  double change = 0;     // expected, of the shares of the ledger: root of their squares
  std::string about;     // the effect whose share it settles most, or "what is unexplained"
  double separation = 0; // expected, of what is to be told apart; 25 = beyond doubt
  std::string separates; // which from which
  std::vector<std::string> resolves; // effects that it tells from all others that are open
};

// A factor on all shells and beams, or on the damping of all modes.
enum class FreeFactor { modulus, density, damping };

// One that would close the gap and is not the cause.
struct Compensator {
  FreeFactor on = FreeFactor::modulus;
  std::string name;
  double factor = 1; // on its nominal value
  double prior_sigmas = 0;
  double gap_after = 0;
  std::optional<double> held_out_after;
  std::string contradicted_by;
};

// A response measured and as models have it.
struct OverlaidResponse {
  std::string name;
  Eigen::VectorXd hertz;
  Eigen::VectorXcd measured, nominal, best, second; // accelerations; second may be empty
};

struct Diagnosis {
  std::string case_name, headline; // one line with odds
  Verdict verdict = Verdict::none;
  std::vector<NamedEffect> effects; // named, or the ambiguous set by probability
  std::vector<LocatedGap> where;
  std::vector<LevelTrend> trends;
  std::vector<ParameterDrift> drifts;
  std::vector<TriedHypothesis> tried; // best of each effect, then sets; by evidence
  // Of these what the gap is closed with, in gap, readings and pictures: the effects named, the
  // first of an ambiguous set, else what comes nearest. None: the nominal case.
  std::optional<std::size_t> best;
  std::optional<Resonator> resonator; // none: nothing is known of one
  std::vector<EffectNotTried> not_tried;
  std::vector<std::pair<std::string, double>> probabilities; // of effects and "none"
  Weighing weighing;                                         // of these
  std::vector<EffectInclusion> inclusion;                    // these by place, without "none"
  Ledger ledger;
  GapShrink gap;
  std::optional<GapShrink> held_out;
  std::string held_out_how; // "frf[6], frf[7]", "the highest level", "each reading in turn"
  std::vector<ComparedReading> readings;
  BaselineFound baseline; // empty: the test has none
  std::vector<Compensator> compensators;
  std::vector<Mimic> mimics; // of effects that look alike by 0.8 and more
  std::vector<std::string> effect_names;
  Eigen::MatrixXd likeness; // effects x effects: largest cosine of their signatures
  std::vector<SmallestDetectable> detectable;
  std::vector<ProposedMeasurement> next;
  std::vector<std::string> advice; // what tells look-alikes apart beyond what is computed
  std::vector<OverlaidResponse> overlays;
  // Draws of the best and second hypothesis, values of their parameters.
  std::vector<std::pair<std::string, Eigen::MatrixXd>> posteriors;
  std::vector<std::string> assumptions, warnings;
  Mesh mesh; // of the nominal case, and its lines: for pictures
  std::vector<std::array<int, 2>> lines;
  double basis_error = 0; // of a frequency of the best hypothesis by its reduction, relative
  int hypotheses = 0, evaluations = 0;
  double seconds = 0;
};

} // namespace plica
