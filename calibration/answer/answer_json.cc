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

/// One value as itself, several as a list, none as null.
template <class T> json one_or_list(const std::vector<T> &values) {
  return values.empty() ? json(nullptr) : values.size() == 1 ? json(values.front()) : json(values);
}

json law_json(const AnswerLaw &law, const scene::Scene &scene) {
  json worst = nullptr;
  if (law.worst_left_out)
    worst = {{"peak_force", number(law.worst_left_out->peak_force)},
             {"penetration", number(law.worst_left_out->depth)},
             {"rebound", number(law.worst_left_out->rebound)},
             {"inside_valid_range", law.worst_left_out->inside_valid_range}};
  return {{"name", law.result.law},
          {"chosen_by", word(law.chosen_by)},
          {"remark", text_or_null(law.remark)},
          {"held", text_or_null(law.held)},
          {"gain", gain_json(law.result.gain)},
          {"belongs_to", law.of_the_mass ? "mass" : "rim"},
          {"parameters", parameters_json(law.result)},
          {"element", element_json(scene)},
          {"fitted_from_m_s", number(law.fitted_from)},
          {"fitted_to_m_s", number(law.fitted_to)},
          {"valid_from_m_s", number(law.valid_from)},
          {"valid_to_m_s", number(law.valid_to)},
          {"tolerance", law.tolerance},
          {"worst_left_out", worst},
          {"force_unexplained", number(law.unexplained)},
          {"n_runs", law.n_runs},
          {"converged", law.result.converged},
          {"sentence", law.sentence}};
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

json pair_json(const PairRange &pair) {
  const double k = pair.result.parameters.at("k_i").value, e = pair.result.parameters.at("e").value;
  scene::Scene scene;
  scene.reduced.k_i = 1e3 * k, scene.reduced.restitution = e, scene.load.mass = pair.mass;
  return {{"law", pair.law},
          {"k_i_kN_per_m", number(k)},
          {"e", number(e)},
          {"c_i_kN_s_per_m", number(damping_coefficient(scene) / 1e3)},
          {"mass_kg", pair.mass},
          {"from_m_s", pair.from},
          {"to_m_s", pair.to},
          {"tolerance", pair.tolerance},
          {"worst_peak_force_error", number(pair.worst_peak_force)},
          {"worst_rebound_error", number(pair.worst_rebound)},
          {"parameters", parameters_json(pair.result)},
          {"sentence", pair.sentence}};
}

/// Of pad and socket, by key of [reduced]: scene/stack_terms.h.
json stack_json(const AnswerStack &stack) {
  const auto normal = stack.on_pads_spring ? scene::NormalForce::pad : scene::NormalForce::inertia;
  return {{"finite_pad", true},
          {"socket_friction", true},
          {"normal_force", word(normal)},
          {"friction", word(scene::Friction::park_wen)},
          {"elastic_slip_mm", 1e3 * stack.elastic_slip},
          {"elastic_slip_from", word(stack.slip_from)}};
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
          {"rows", rows},
          {"calibration", text_or_null(band.calibration)},
          {"sentences", sentences(band)}};
}

/// Of the solids that the law is fitted to.
json steel_rate_json(const Answer &a) {
  if (a.sources.count(RunSource::finite_elements) == 0) return nullptr;
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
                    {"strain", at.strain},
                    {"strain_at_m_s", at.strain_speed},
                    {"crack", passing_json(at.crack)},
                    {"limit", passing_json(at.limit)},
                    {"sentence", at.sentence}});
  return list;
}

json strain_json(const AnswerStrain &s) {
  json rows = json::array();
  for (const auto &row : s.rows)
    rows.push_back({{"speed_m_s", row.speed},
                    {"penetration_mm", 1e3 * row.depth},
                    {"strain", row.strain.largest},
                    {"place", place_or_null(row.strain.place)}});
  return {{"limit", s.limit},
          {"limit_is_assumption", s.limit_is_assumption},
          {"rows", rows},
          {"largest", s.largest.largest},
          {"place", place_or_null(s.largest.place)},
          {"exceeded", s.exceeded()},
          {"largest_speed_below_limit_m_s", number(s.largest_speed_below_limit)},
          {"places", places_json(s.places)},
          {"sentence", s.sentence},
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

json foot_json(const AnswerFoot &foot) {
  return {{"connection", word(foot.connection.kind)},
          {"in_words", in_words(foot.connection)},
          {"joint", strength_in_words(foot.connection)},
          {"goes_at_force_kN", foot.goes_at_force ? json(*foot.goes_at_force / 1e3) : json(nullptr)},
          {"goes_at_m_s", number(foot.goes_at())},
          {"borne_to_m_s", number(foot.borne_to())},
          {"rows", foot_rows_json(foot.runs)},
          {"gone", passing_json(foot.runs.gone)},
          {"twins", foot_rows_json(foot.twins)},
          {"twins_gone", passing_json(foot.twins.gone)},
          {"sentence", foot.sentence},
          {"doubt", text_or_null(foot.doubt)}};
}

} // namespace

json to_json(const Answer &a) {
  json table = json::array(), assumed = json::array();
  for (const auto &row : a.table) table.push_back(row_json(row));
  for (const auto &assumption : scene::assumptions(a.scene.bearing))
    assumed.push_back({{"key", assumption.key}, {"value", assumption.value}});
  return {{"bearing", a.scene.bearing.name},
          {"rim_identity", a.rim_identity},
          {"rung", one_or_list(a.rungs)},
          {"mesh", one_or_list(a.meshes)},
          {"mass_kg", a.scene.load.mass},
          {"vertical_kN", a.scene.load.vertical / 1e3},
          {"gravity_m_per_s2", a.scene.load.gravity},
          {"source", a.source()},
          {"law", law_json(a.law, a.scene)},
          {"table", table},
          {"rims_in_series", a.scene.bearing.dishes()},
          {"pair_law", a.pair_law},
          {"pair", a.pair ? pair_json(*a.pair) : json(nullptr)},
          {"no_pair", text_or_null(a.no_pair)},
          {"published_applies", a.published_applies},
          {"strain", a.strain ? strain_json(*a.strain) : json(nullptr)},
          {"rim_foot", a.foot ? foot_json(*a.foot) : json(nullptr)},
          {"mesh_error",
           {{"peak_force", number(a.mesh_error.peak_force)}, {"sentence", text_or_null(a.mesh_error.sentence)}}},
          {"stack", a.stack ? stack_json(*a.stack) : json(nullptr)},
          {"steel_rate", steel_rate_json(a)},
          {"steel_band", a.steel_band ? band_json(*a.steel_band) : json(nullptr)},
          {"errors", errors_json(a.errors)},
          {"error_sentences", sentences(a.errors)},
          {"finding_sentences", finding_sentences(a.errors)},
          {"assumptions", assumed},
          {"doubts", a.doubts},
          {"validity", a.validity}};
}

} // namespace rimpact::calibration
