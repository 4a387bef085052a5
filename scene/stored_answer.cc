#include "scene/stored_answer.h"

#include "laws/impact/catalogue.h"
#include <fmt/format.h>

namespace rimpact::scene {

const std::map<std::string, ElementNumber> &element_numbers() {
  static const auto numbers = [] {
    std::map<std::string, ElementNumber> all{{"capacity_offset", {"mm", "capacity_offset_mm"}}};
    for (const auto &p : laws::law_parameters()) all[p.name] = {p.unit, p.key};
    return all;
  }();
  return numbers;
}

namespace {

struct NumberWithUnit {
  double value = 0;
  std::string unit = {};
};
template <class V> void visit(V &v, NumberWithUnit &number) {
  v.needed("value", number.value), v.needed("unit", number.unit);
}

} // namespace

template <class V> void visit(V &v, StoredGain &gain) {
  v("factor", gain.factor), v("standard_error", gain.standard_error), v("stated_error", gain.stated_error);
}

template <class V> void visit_places(V &v, StoredElement &element) {
  v("lateral_capacity_m", element.lateral_capacity), v("reference_speed_m_per_s", element.reference_speed);
}
/// Parameters stand in one object with what else there is of numbers.
void visit(const JsonReader &v, StoredElement &element) {
  visit_places(v, element);
  for (const auto &[name, entry] : v.object().items()) {
    const auto known = element_numbers().find(name);
    const bool is_known = known != element_numbers().end();
    if (!is_known && !entry.is_object()) continue; // lateral_capacity_m and the like
    if (!is_known) v.fail(v.path_of(name), "is no parameter that this version knows");
    NumberWithUnit number;
    v.needed(name.c_str(), number);
    if (const std::string &unit = known->second.unit; number.unit != unit)
      v.fail(v.path_of(name) + ".unit", fmt::format("is \"{}\", not \"{}\"", number.unit, unit));
    element.numbers[name] = number.value;
  }
}
void visit(JsonWriter &v, StoredElement &element) {
  visit_places(v, element);
  if (!element.reference_speed) v.object.erase("reference_speed_m_per_s");
  for (const auto &[name, value] : element.numbers)
    v(name.c_str(), NumberWithUnit{.value = value, .unit = element_numbers().at(name).unit});
}

template <class V> void visit(V &v, StoredWorst &worst) {
  v("peak_force", worst.peak_force), v("penetration", worst.penetration), v("rebound", worst.rebound);
  v("inside_valid_range", worst.inside_valid_range);
}

template <class V> void visit(V &v, StoredLaw &law) {
  v.needed("name", law.name), v("chosen_by", law.chosen_by), v.or_null("remark", law.remark);
  v.or_null("held", law.held), v("gain", law.gain), v("belongs_to", law.belongs_to);
  v("parameters", law.parameters), v.needed("element", law.element);
  v("fitted_from_m_s", law.fitted_from), v("fitted_to_m_s", law.fitted_to);
  v("valid_from_m_s", law.valid_from), v("valid_to_m_s", law.valid_to), v("tolerance", law.tolerance);
  v("worst_left_out", law.worst_left_out), v("force_unexplained", law.force_unexplained);
  v("n_runs", law.n_runs), v("converged", law.converged), v("sentence", law.sentence);
}

template <class V> void visit(V &v, StoredPair &pair) {
  v("law", pair.law), v.needed("k_i_kN_per_m", pair.k_i), v.needed("e", pair.e), v("c_i_kN_s_per_m", pair.c_i);
  v.needed("mass_kg", pair.mass), v.needed("from_m_s", pair.from), v.needed("to_m_s", pair.to);
  v("tolerance", pair.tolerance), v("worst_peak_force_error", pair.worst_peak_force);
  v("worst_rebound_error", pair.worst_rebound), v("parameters", pair.parameters), v("sentence", pair.sentence);
}

template <class V> void visit(V &v, StoredFoot &foot) {
  v("connection", foot.connection), v("in_words", foot.in_words), v("joint", foot.joint);
  v("goes_at_force_kN", foot.goes_at_force, kilo), v("goes_at_m_s", foot.goes_at);
  v("borne_to_m_s", foot.borne_to), v("sentence", foot.sentence), v.or_null("doubt", foot.doubt);
}

template <class V> void visit(V &v, StoredStrainRow &row) {
  v("speed_m_s", row.speed), v("penetration_mm", row.depth, milli), v("strain", row.strain);
  v.or_null("place", row.place);
}
template <class V> void visit(V &v, StoredStrain &strain) {
  v("rows", strain.rows), v("sentence", strain.sentence);
}

template <class V> void visit(V &v, StoredStack &stack) {
  v("finite_pad", stack.finite_pad), v("socket_friction", stack.socket_friction);
  v("normal_force", stack.normal_force), v("friction", stack.friction);
  v("elastic_slip_mm", stack.elastic_slip, milli), v("elastic_slip_from", stack.slip_from);
}

template <class V> void visit(V &v, StoredBand &band) {
  v.or_null("calibration", band.calibration), v("sentences", band.sentences);
}

template <class V> void visit(V &v, StoredMeshError &error) {
  v("peak_force", error.peak_force), v.or_null("sentence", error.sentence);
}

template <class V> void visit(V &v, StoredAssumption &assumption) {
  v("key", assumption.key), v("value", assumption.value);
}

template <class V> void visit(V &v, FittedPlates &plates) {
  v("radius_m", plates.radius), v("slider_height_mm", plates.slider_height, milli);
  v("slider_diameter_mm", plates.slider_diameter, milli), v("rim_height_mm", plates.rim_height, milli);
  v("lateral_capacity_m", plates.capacity);
}

template <class V> void visit(V &v, StoredAnswer &a) {
  v("bearing", a.bearing), v("rim_identity", a.rim_identity), v("source", a.source);
  v.one_or_list("rung", a.rungs), v.one_or_list("mesh", a.meshes);
  v("mass_kg", a.mass), v("vertical_kN", a.vertical, kilo), v("gravity_m_per_s2", a.gravity);
  v.needed("law", a.law), v("rims_in_series", a.rims_in_series), v("plates", a.plates);
  v("pair", a.pair), v.or_null("no_pair", a.no_pair), v("strain", a.strain), v("rim_foot", a.foot);
  v("mesh_error", a.mesh_error), v("stack", a.stack);
  v.or_null("steel_rate", a.steel_rate), v("steel_band", a.steel_band);
  v("error_sentences", a.error_sentences), v("finding_sentences", a.finding_sentences);
  v("assumptions", a.assumptions), v("doubts", a.doubts), v("validity", a.validity);
}

nlohmann::json to_json(const StoredParameters &parameters) {
  return json_of(parameters);
}

nlohmann::json to_json(const StoredGain &gain) {
  return json_of(gain);
}

nlohmann::json to_json(const StoredElement &element) {
  return json_of(element);
}

nlohmann::json to_json(const StoredAnswer &answer) {
  return json_of(answer);
}

StoredAnswer read_answer(const nlohmann::json &answer, const std::string &file, const std::string &path) {
  StoredAnswer read;
  const JsonReader reader(answer, file, path);
  visit(reader, read);
  return read;
}

} // namespace rimpact::scene
