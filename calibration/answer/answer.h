/// What a calibration hands over: the law with its numbers, where it holds and how far off it is, what follows from it
/// at five speeds, a constant pair where one serves, and every doubt. `calibration.json` ("answer"), calibration.toml,
/// exports, the report's first page and what the terminal says are made from this one record.
///
/// The answer is a law, not a pair: a law of the rim's material (hunt-crossley, elastoplastic) belongs to the rim and
/// holds for any supported mass; one whose dashpot is 2 xi sqrt(k_i m) holds for the mass it was fitted at.
#pragma once
#include "calibration/answer/answer_error.h"
#include "calibration/answer/answer_foot.h"
#include "scene/stack_terms.h"
#include <set>

namespace rimpact::calibration {

/// Why the answer's law is this one.
enum class ChosenBy { ranking, user, only };
constexpr auto choices(ChosenBy) {
  return choices_of<ChosenBy>({{ChosenBy::ranking, "ranking", "it leaves least of the laws that hold"},
                               {ChosenBy::user, "user", "asked for"},
                               {ChosenBy::only, "only", "there is no other"}});
}
/// Of which runs an error is.
enum class ErrorFrom { left_out, fitted };
constexpr auto choices(ErrorFrom) {
  return choices_of<ErrorFrom>({{ErrorFrom::left_out, "left out"}, {ErrorFrom::fitted, "fitted"}});
}

/// Largest absolute relative errors of runs left out of the fit one at a time [-].
struct WorstErrors {
  double peak_force = 0, depth = 0, rebound = 0;
  bool inside_valid_range = true; ///< false: over all of them, for the law holds nowhere
};

struct AnswerLaw {
  FitResult result; ///< what was fitted
  ChosenBy chosen_by = ChosenBy::only;
  std::string remark;       ///< where the user's choice is not the best; else empty
  std::string held;         ///< exponents that were not fitted, and why; else empty
  bool of_the_mass = false; ///< holds for Answer::scene.load.mass only; else it belongs to the rim
  /// Approach speeds of the impacts fitted, those that the rim's foot bears [m/s].
  double fitted_from = 0, fitted_to = 0;
  std::string end;                            ///< sentence of a law that ends where the rim's foot goes; else empty
  std::optional<double> valid_from, valid_to; ///< neighbouring runs left out that are met within `tolerance` [m/s]
  double tolerance = 0.05;
  std::optional<WorstErrors> worst_left_out;
  std::optional<double> unexplained; ///< of the force, over the runs fitted [-]
  int n_runs = 0;
  std::vector<LawError> left_out, fitted; ///< by speed, grazing runs apart
  std::string sentence;
};

/// A weightless impact at one speed, by the answer's law in the reduced model at the supported mass.
struct AnswerRow {
  double speed = 0;                         ///< approach [m/s]
  double peak_force = 0, penetration = 0;   ///< [N], [m]
  double restitution = 0, contact_time = 0; ///< [-], [s]
  std::optional<double> k_i, e;             ///< of the pair_law's pair with this peak force and rebound [N/m], [-]
  std::optional<double> peak_force_error, rebound_error; ///< of the law, absolute relative; see errors_at()
  ErrorFrom error_from = ErrorFrom::fitted;
};

struct StrainRow {
  double speed;        ///< approach [m/s]
  double depth;        ///< deepest penetration [m]
  JudgedStrain strain; ///< of the rim's steel
};
/// A place of the steel over all runs.
struct PlaceStrain {
  SteelPlace place;
  double damage = 0, damage_speed = 0;             ///< largest mean damage by Johnson and Cook [-], of the run at [m/s]
  std::optional<double> locus_damage, locus_speed; ///< alike, by Bao and Wierzbicki; none: not known
  double strain = 0, strain_speed = 0;             ///< largest mean plastic strain [-], alike
  Passing crack, limit;                            ///< damage 1 by whichever passes it first, and the strain's limit
  std::string sentence;
};
struct AnswerStrain {
  double limit = 0;
  bool limit_is_assumption = true;
  std::vector<StrainRow> rows; ///< by speed
  JudgedStrain largest{0, std::nullopt};
  std::optional<double> largest_speed_below_limit; ///< of a run below which no run exceeds the limit [m/s]
  bool exceeded() const { return largest.largest > limit; }
  std::vector<PlaceStrain> places; ///< that are known
  std::string sentence;
  std::string crack_sentence;  ///< how near the rim's steel came to a crack; empty: not known
  std::string slider_sentence; ///< of the slider's edge, where it is crushed beyond the limit; else empty
};
struct AnswerMeshError {
  std::optional<double> peak_force, rebound;      ///< largest over the runs fitted [-]; empty: not known
  std::vector<ErrorAt> by_peak_force, by_rebound; ///< of the runs of which it is known
  std::optional<Finding> find;                    ///< where it is not known
  std::string sentence;                           ///< empty: no finite elements
};

/// Of pad and socket beside the law (scene/stack_terms.h).
struct AnswerStack {
  double elastic_slip; ///< [m]
  scene::SlipFrom slip_from;
  /// Rung rim has no pad: its law is the rim's alone, and the pad's spring stands beside it. A law fitted to runs that
  /// have a pad has taken up what the mass's bouncing on it does.
  bool on_pads_spring;
};

struct Answer {
  scene::Scene scene; ///< the fitted runs' bearing and load, with the law and every number it reads
  std::string rim_identity;
  std::set<RunSource> sources;    ///< of the runs fitted
  std::vector<std::string> rungs; ///< of the runs fitted: rim, rigid-dish, full, or "measured"
  std::vector<int> meshes;
  AnswerLaw law;
  std::vector<AnswerRow> table; ///< five speeds in equal ratios over the speeds fitted
  std::string pair_law = "no-tension";
  std::optional<PairRange> pair;
  std::string no_pair; ///< why there is none
  bool published_applies = false;
  std::optional<AnswerStrain> strain;
  std::optional<AnswerFoot> foot; ///< none: no run tells
  AnswerMeshError mesh_error;
  std::optional<SteelBand> steel_band; ///< static and fast; none: no twin was run
  std::vector<AnswerError> errors;     ///< all parts, by quantity and source
  std::optional<AnswerStack> stack;    ///< none: the runs are of the reduced model, whose scenes say what they have
  std::vector<std::string> doubts;     ///< sentences
  std::string validity;                ///< where it holds, in short sentences, for headers and exports
  std::string source() const;          ///< the sources' words, joined by "and"
};

/// The error of the law at a speed, from runs by speed: linear in the logarithm of the speed between the two enclosing
/// ones where both err to the same side, else the larger; of the nearest beyond them. `of` picks the error. Empty
/// without runs.
std::optional<double> errors_at(double speed, const std::vector<LawError> &errors, double LawError::*of);

/// Everything but `result` must be filled in `calibration`; `runs` are those fitted (and ranked) on.
Answer make_answer(const Calibration &calibration, const CalibrationOptions &options,
                   const std::vector<const StoredRun *> &runs);

} // namespace rimpact::calibration
