#include "calibration/answer/answer_json.h"
#include "calibration/answer/calibration_json.h"
#include "calibration/answer/calibration_text.h"
#include "calibration/answer/laws_json.h"

namespace rimpact::calibration {

using nlohmann::json;

namespace {

json text_or_null(const std::string &text) {
  return text.empty() ? json(nullptr) : json(text);
}

scene::StoredLaw stored_law(const AnswerLaw &law, const scene::Scene &scene) {
  std::optional<scene::StoredWorst> worst;
  if (law.worst_left_out)
    worst = {.peak_force = law.worst_left_out->peak_force,
             .penetration = law.worst_left_out->depth,
             .rebound = law.worst_left_out->rebound,
             .inside_valid_range = law.worst_left_out->inside_valid_range};
  return {.name = law.result.law,
          .chosen_by = word(law.chosen_by),
          .remark = law.remark,
          .held = law.held,
          .sentence = law.sentence,
          .gain = stored_gain(law.result.gain),
          .belongs_to = law.of_the_mass ? scene::BelongsTo::mass : scene::BelongsTo::rim,
          .parameters = stored_parameters(law.result),
          .element = stored_element(scene),
          .fitted_from = law.fitted_from,
          .fitted_to = law.fitted_to,
          .valid_from = law.valid_from,
          .valid_to = law.valid_to,
          .tolerance = law.tolerance,
          .worst_left_out = worst,
          .force_unexplained = law.unexplained,
          .n_runs = law.n_runs,
          .converged = law.result.converged};
}

json row_json(const AnswerRow &row) {
  return {{"speed_m_s", row.speed},
          {"peak_force_kN", row.peak_force / 1e3},
          {"restitution", number(row.restitution)},
          {"penetration_mm", row.penetration * 1e3},
          {"contact_time_ms", row.contact_time * 1e3},
          {"k_i_kN_per_m", row.k_i ? number(*row.k_i / 1e3) : json(nullptr)},
          {"e", number(row.e)},
          {"peak_force_error", number(row.peak_force_error)},
          {"rebound_error", number(row.rebound_error)},
          {"error_from", word(row.error_from)},
          {"inside_fit", true}};
}

scene::StoredPair stored_pair(const PairRange &pair) {
  const double k = pair.result.parameters.at("k_i").value, e = pair.result.parameters.at("e").value;
  scene::Scene scene;
  scene.reduced.k_i = 1e3 * k, scene.reduced.restitution = e, scene.load.mass = pair.mass;
  return {.law = pair.law,
          .k_i = k,
          .e = e,
          .c_i = damping_coefficient(scene) / 1e3,
          .mass = pair.mass,
          .from = pair.from,
          .to = pair.to,
          .tolerance = pair.tolerance,
          .worst_peak_force = pair.worst_peak_force,
          .worst_rebound = pair.worst_rebound,
          .parameters = stored_parameters(pair.result),
          .sentence = pair.sentence};
}

scene::StoredStack stored_stack(const AnswerStack &stack) {
  return {.finite_pad = true,
          .socket_friction = true,
          .normal_force = stack.on_pads_spring ? scene::NormalForce::pad : scene::NormalForce::inertia,
          .friction = scene::Friction::park_wen,
          .elastic_slip = stack.elastic_slip,
          .slip_from = stack.slip_from};
}

/// Of an impact in the band: static or fast.
json impact_json(const Impact &impact) {
  return {{"peak_force_kN", impact.peak_force / 1e3},
          {"penetration_mm", 1e3 * impact.peak_penetration},
          {"restitution", number(impact.restitution())}};
}

json band_json(const SteelBand &band) {
  json rows = json::array();
  for (const SteelTwin &twin : band.twins)
    rows.push_back(
        {{"speed_m_s", twin.speed}, {"static", impact_json(twin.static_steel)}, {"fast", impact_json(twin.fast)}});
  return {{"rate", in_words(band.rate)},
          {"rate_is_assumption", band.assumed},
          {"law_is_of", band.runs_are_static ? "static" : "fast"},
          {"rows", rows}};
}

/// Of the solids that the law is fitted to.
std::string steel_rate(const Answer &a) {
  if (a.sources.count(RunSource::finite_elements) == 0) return {};
  const scene::Material &steel = a.scene.bearing.rim_steel();
  return steel.knows_rate() ? in_words(steel.rate) : word(scene::RateModel::none);
}

json by_json(const std::vector<ErrorAt> &by) {
  json rows = json::array();
  for (const ErrorAt &at : by)
    rows.push_back({{"load", at.load},
                    {"speed_m_s", at.speed},
                    {"penetration_mm", at.depth ? json(1e3 * *at.depth) : json(nullptr)},
                    {"value", number(at.value)}});
  return rows;
}

json find_json(const std::optional<Finding> &find) {
  if (!find) return nullptr;
  return {{"command", find->command}, {"minutes", find->minutes > 0 ? json(find->minutes) : json(nullptr)}};
}

json errors_json(const std::vector<AnswerError> &errors) {
  json list = json::array();
  for (const AnswerError &error : errors)
    list.push_back({{"quantity", word(error.quantity)},
                    {"source", word(error.source)},
                    {"value", number(error.value)},
                    {"how", word(error.how)},
                    {"from", text_or_null(error.from)},
                    {"by", by_json(error.by)},
                    {"find", find_json(error.find)}});
  return list;
}

json place_or_null(const std::optional<SteelPlace> &place) {
  return place ? json(word(*place)) : json(nullptr);
}

json passing_json(const Passing &p) {
  return {{"below_m_s", number(p.below)}, {"beyond_m_s", number(p.beyond)}, {"expected_m_s", number(p.expected)}};
}

json places_json(const std::vector<PlaceStrain> &places) {
  json list = json::array();
  for (const PlaceStrain &at : places)
    list.push_back({{"place", word(at.place)},
                    {"damage", at.damage},
                    {"damage_at_m_s", at.damage_speed},
                    {"damage_bao_wierzbicki", number(at.locus_damage)},
                    {"damage_bao_wierzbicki_at_m_s", number(at.locus_speed)},
                    {"strain", at.strain},
                    {"strain_at_m_s", at.strain_speed},
                    {"crack", passing_json(at.crack)},
                    {"limit", passing_json(at.limit)},
                    {"sentence", at.sentence}});
  return list;
}

scene::StoredStrain stored_strain(const AnswerStrain &s) {
  scene::StoredStrain stored{.rows = {}, .sentence = s.sentence};
  for (const auto &row : s.rows)
    stored.rows.push_back({.speed = row.speed,
                           .depth = row.depth,
                           .strain = row.strain.largest,
                           .place = row.strain.place ? word(*row.strain.place) : ""});
  return stored;
}

/// What stands beside it.
json strain_json(const AnswerStrain &s) {
  return {{"limit", s.limit},
          {"limit_is_assumption", s.limit_is_assumption},
          {"largest", s.largest.largest},
          {"place", place_or_null(s.largest.place)},
          {"exceeded", s.exceeded()},
          {"largest_speed_below_limit_m_s", number(s.largest_speed_below_limit)},
          {"places", places_json(s.places)},
          {"crack_sentence", text_or_null(s.crack_sentence)},
          {"slider_sentence", text_or_null(s.slider_sentence)}};
}

json foot_rows_json(const FootOfRuns &runs) {
  json rows = json::array();
  for (const auto &row : runs.rows)
    rows.push_back({{"speed_m_s", row.speed},
                    {"use", number(row.foot.use)},
                    {"normal_N_per_m", row.foot.worst.normal},
                    {"shear_N_per_m", row.foot.worst.shear},
                    {"moment_N", row.foot.worst.moment},
                    {"needed_throat_mm", 1e3 * row.foot.needed_throat}});
  return rows;
}

scene::StoredFoot stored_foot(const AnswerFoot &foot) {
  return {.connection = word(foot.connection.kind),
          .in_words = in_words(foot.connection),
          .joint = strength_in_words(foot.connection),
          .goes_at_force = foot.goes_at_force,
          .goes_at = foot.goes_at(),
          .borne_to = foot.borne_to(),
          .sentence = foot.sentence,
          .doubt = foot.doubt};
}

/// What stands beside it.
json foot_json(const AnswerFoot &foot) {
  return {{"rows", foot_rows_json(foot.runs)},
          {"gone", passing_json(foot.runs.gone)},
          {"twins", foot_rows_json(foot.twins)},
          {"twins_gone", passing_json(foot.twins.gone)}};
}

std::vector<scene::StoredAssumption> stored_assumptions(const scene::Bearing &bearing) {
  std::vector<scene::StoredAssumption> list;
  for (const auto &assumption : scene::assumptions(bearing)) list.push_back({assumption.key, assumption.value});
  return list;
}

} // namespace

scene::StoredAnswer stored(const Answer &a) {
  scene::StoredAnswer kept{.bearing = a.scene.bearing.name,
                           .rim_identity = a.rim_identity,
                           .source = a.source(),
                           .rungs = a.rungs,
                           .meshes = a.meshes,
                           .mass = a.scene.load.mass,
                           .vertical = a.scene.load.vertical,
                           .gravity = a.scene.load.gravity,
                           .law = stored_law(a.law, a.scene),
                           .rims_in_series = a.scene.bearing.dishes(),
                           .no_pair = a.no_pair,
                           .mesh_error = {a.mesh_error.peak_force, a.mesh_error.sentence},
                           .steel_rate = steel_rate(a),
                           .error_sentences = sentences(a.errors),
                           .finding_sentences = finding_sentences(a.errors),
                           .doubts = a.doubts,
                           .assumptions = stored_assumptions(a.scene.bearing),
                           .validity = a.validity};
  if (a.scene.bearing.double_concave()) kept.plates = scene::plates_of(a.scene.bearing);
  if (a.pair) kept.pair = stored_pair(*a.pair);
  if (a.strain) kept.strain = stored_strain(*a.strain);
  if (a.foot) kept.foot = stored_foot(*a.foot);
  if (a.stack) kept.stack = stored_stack(*a.stack);
  if (a.steel_band) kept.steel_band = {a.steel_band->calibration, sentences(*a.steel_band)};
  return kept;
}

json to_json(const Answer &a) {
  json table = json::array(), all = scene::to_json(stored(a));
  for (const auto &row : a.table) table.push_back(row_json(row));
  all.update({{"table", table},
              {"pair_law", a.pair_law},
              {"published_applies", a.published_applies},
              {"errors", errors_json(a.errors)}});
  if (a.strain) all["strain"].update(strain_json(*a.strain));
  if (a.foot) all["rim_foot"].update(foot_json(*a.foot));
  if (a.steel_band) all["steel_band"].update(band_json(*a.steel_band));
  return all;
}

} // namespace rimpact::calibration
