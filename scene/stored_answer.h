/// What a calibration hands over, as calibration.json keeps it in `answer` (docs/interface.md): the one description of
/// its keys, by which `rimpact calibrate` writes it and scenes, limits and exports read it. What only the report reads
/// (the table over speed, parts of errors, rows of places and of the foot) is written beside it by calibration/answer.
///
/// SI, but for a law's numbers: these are in the unit of their key of [reduced] (laws::law_parameters(): kN/m, kN, -).
#pragma once
#include "io/files/json_fields.h"
#include "scene/fitted_plates.h"
#include "scene/stack_terms.h"

namespace rimpact::scene {

/// Whether a law holds for any mass or for the one it was fitted at.
enum class BelongsTo { rim, mass };
constexpr auto choices(BelongsTo) {
  return choices_of<BelongsTo>({{BelongsTo::rim, "rim"}, {BelongsTo::mass, "mass"}});
}

/// A number that was fitted, with what the data say of it.
struct StoredParameter {
  std::optional<double> value = {}; ///< none: the fit has no finite one
  std::string unit = {};
  std::optional<double> standard_error = {}, stated_error = {}; ///< in the unit
  std::array<std::optional<double>, 2> interval_95 = {};
  bool identifiable = true, at_bound = false;
  std::string verdict = {}, reason = {};
  bool operator==(const StoredParameter &) const = default;
};
template <class V> void visit(V &v, StoredParameter &p) {
  v("value", p.value), v("unit", p.unit), v("standard_error", p.standard_error), v("interval_95", p.interval_95);
  v("identifiable", p.identifiable), v("verdict", p.verdict), v("stated_error", p.stated_error);
  v("at_bound", p.at_bound), v.or_null("reason", p.reason);
}
using StoredParameters = std::map<std::string, StoredParameter>;

/// Of a force channel.
struct StoredGain {
  std::optional<double> factor = {}, standard_error = {}, stated_error = {}; ///< [-]
  bool operator==(const StoredGain &) const = default;
};

/// Every number that the law reads, fitted or not, and where the rim begins.
struct StoredElement {
  std::optional<double> lateral_capacity = {}; ///< travel at which the rim begins [m]
  std::optional<double> reference_speed = {};  ///< [m/s]
  std::map<std::string, double> numbers = {};  ///< by the parameter's name, in its unit
  bool operator==(const StoredElement &) const = default;
};

/// What calibrations call a number of the element: its unit, and its key of [reduced].
struct ElementNumber {
  std::string unit, key;
};
/// By name.
const std::map<std::string, ElementNumber> &element_numbers();

/// Largest errors on runs left out, absolute relative [-].
struct StoredWorst {
  std::optional<double> peak_force = {}, penetration = {}, rebound = {};
  bool inside_valid_range = false;
  bool operator==(const StoredWorst &) const = default;
};

struct StoredLaw {
  std::string name = {}, chosen_by = {}, remark = {}, held = {}, sentence = {};
  std::optional<StoredGain> gain = {};
  BelongsTo belongs_to = BelongsTo::rim;
  StoredParameters parameters = {}; ///< what was fitted
  StoredElement element = {};
  /// Approach speeds fitted, and those at which runs left out are met within `tolerance` [m/s].
  std::optional<double> fitted_from = {}, fitted_to = {}, valid_from = {}, valid_to = {};
  std::optional<double> tolerance = {};
  std::optional<StoredWorst> worst_left_out = {};
  std::optional<double> force_unexplained = {}; ///< [-]
  int n_runs = 0;
  bool converged = true;
  bool operator==(const StoredLaw &) const = default;
};

/// A constant pair, for one mass and the speeds named.
struct StoredPair {
  std::string law = {};
  double k_i = 0;                 ///< [kN/m]
  double e = 0;                   ///< [-]
  std::optional<double> c_i = {}; ///< of the dashpot at `mass` [kN s/m]
  double mass = 0;                ///< [kg]
  double from = 0, to = 0;        ///< [m/s]
  std::optional<double> tolerance = {}, worst_peak_force = {}, worst_rebound = {}; ///< [-]
  StoredParameters parameters = {};
  std::string sentence = {};
  bool operator==(const StoredPair &) const = default;
};

/// Whether the rim's foot bears the impacts.
struct StoredFoot {
  std::string connection = {}, in_words = {}; ///< its word; and with its sizes
  std::string joint = {};                     ///< what it is joined by; empty: one piece with the plate
  std::optional<double> goes_at_force = {};   ///< of the rim [N]; none: the foot bears all
  std::optional<double> goes_at = {};         ///< slowest run beyond [m/s]
  std::optional<double> borne_to = {};        ///< fastest run that it bears [m/s]
  std::string sentence = {}, doubt = {};
  bool operator==(const StoredFoot &) const = default;
};

/// The rim's steel over the runs.
struct StoredStrainRow {
  std::optional<double> speed = {}, depth = {}, strain = {}; ///< approach [m/s], penetration [m], largest [-]
  std::string place = {};
  bool operator==(const StoredStrainRow &) const = default;
};
struct StoredStrain {
  std::vector<StoredStrainRow> rows = {};
  std::string sentence = {};
  bool operator==(const StoredStrain &) const = default;
};

/// Of pad and socket beside the law (stack_terms.h); none: the file does not say.
struct StoredStack {
  std::optional<bool> finite_pad = {}, socket_friction = {};
  std::optional<NormalForce> normal_force = {};
  std::optional<Friction> friction = {};
  std::optional<double> elastic_slip = {}; ///< [m]
  SlipFrom slip_from = SlipFrom::bearing;
  bool operator==(const StoredStack &) const = default;
};

/// Static steel beside steel at speed.
struct StoredBand {
  std::string calibration = {}; ///< folder of the other steel's law, beside this one's; empty: none was fitted
  std::vector<std::string> sentences = {};
  bool operator==(const StoredBand &) const = default;
};

struct StoredMeshError {
  std::optional<double> peak_force = {}; ///< largest over the runs fitted [-]
  std::string sentence = {};
  bool operator==(const StoredMeshError &) const = default;
};

struct StoredAssumption {
  std::string key = {}, value = {};
  bool operator==(const StoredAssumption &) const = default;
};

struct StoredAnswer {
  std::string bearing = {}, rim_identity = {}, source = {};
  std::vector<std::string> rungs = {};
  std::vector<int> meshes = {};
  std::optional<double> mass = {}, vertical = {}, gravity = {}; ///< of the runs fitted [kg], [N], [m/s^2]
  StoredLaw law = {};
  int rims_in_series = 1;                  ///< that it is the law of
  std::optional<FittedPlates> plates = {}; ///< of a bearing with two dishes
  std::optional<StoredPair> pair = {};
  std::string no_pair = {}; ///< why there is none
  std::optional<StoredStrain> strain = {};
  std::optional<StoredFoot> foot = {}; ///< none: no run tells
  StoredMeshError mesh_error = {};
  std::optional<StoredStack> stack = {};
  std::string steel_rate = {}; ///< of the runs' steel, in words; empty: not of finite elements
  std::optional<StoredBand> steel_band = {};
  std::vector<std::string> error_sentences = {}, finding_sentences = {}, doubts = {};
  std::vector<StoredAssumption> assumptions = {};
  std::string validity = {};
  bool operator==(const StoredAnswer &) const = default;
};

nlohmann::json to_json(const StoredParameters &parameters);
nlohmann::json to_json(const StoredGain &gain);
nlohmann::json to_json(const StoredElement &element);
nlohmann::json to_json(const StoredAnswer &answer);

/// Of the object at `path` of `file`. Throws DataError naming both and the key: what stands there is of another kind, a
/// law has no name or no element, or a parameter is one this version does not know, or in another unit.
StoredAnswer read_answer(const nlohmann::json &answer, const std::string &file, const std::string &path = "answer");

} // namespace rimpact::scene
