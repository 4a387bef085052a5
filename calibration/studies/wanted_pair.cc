#include "calibration/studies/wanted_pair.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <set>

namespace rimpact::calibration {

namespace {

constexpr double smallest_fall = 0.01; ///< of e over the speeds: less is no dependence to solve for the speed

using Value = std::function<double(const RimAtPair &)>;

double speed(const RimAtPair &rim) {
  return rim.inputs.back();
}
double stiffness(const RimAtPair &rim) {
  return rim.k_i;
}

/// Smallest and largest value over the rims that are taken.
Bounds bounds_of(const std::vector<RimAtPair> &rims, bool met_only, const Value &of) {
  Bounds result{HUGE_VAL, -HUGE_VAL};
  for (const auto &rim : rims)
    if (rim.met || !met_only) result = {std::min(result.lower, of(rim)), std::max(result.upper, of(rim))};
  return result;
}

std::string span(const std::vector<RimAtPair> &rims, bool met_only, const Value &of) {
  const Bounds bounds = bounds_of(rims, met_only, of);
  return fmt::format("{:.3g} to {:.3g}", bounds.lower, bounds.upper);
}

std::ptrdiff_t n_met(const PairRegion &region) {
  return std::count_if(region.rims.begin(), region.rims.end(), [](const auto &rim) { return rim.met; });
}

std::string sentence_of(const PairRegion &region) {
  std::string text = fmt::format("e = {:g} is returned by {} of {} rims within the speeds computed", region.wanted.e,
                                 region.rims.size(), region.n_rims);
  if (region.rims.empty()) return text + ".";
  text += fmt::format(", at {} m/s (each known to {:.0f} %), with {} kN/m there. ", span(region.rims, false, speed),
                      100 * region.speed_error, span(region.rims, false, stiffness));
  text += fmt::format("k_i = {:g} kN/m within the surrogate's {:.0f} % as well: {} rims", region.wanted.k_i,
                      100 * region.k_i_error, n_met(region));
  if (n_met(region) == 0) return text + ".";
  text += fmt::format(", at {} m/s", span(region.rims, true, speed));
  for (std::size_t j = 0; j + 1 < geometry_axes().size(); ++j)
    text += fmt::format(", {} {} {}", geometry_axes()[j].name,
                        span(region.rims, true, [j](const RimAtPair &rim) { return rim.inputs[j]; }),
                        geometry_axes()[j].unit);
  return text + ".";
}

} // namespace

void WantedPair::validate() const {
  if (!(k_i > 0)) throw InputError(fmt::format("--pair: k_i {:g} must be > 0 kN/m", k_i));
  if (!(e > 0 && e < 1)) throw InputError(fmt::format("--pair: e {:g} must be > 0 and < 1", e));
}

std::optional<PairRegion> pair_region(const GeometryStudy &study, const WantedPair &wanted) {
  wanted.validate();
  const auto &k_i = study.surrogates.at("k_i"), &e = study.surrogates.at("e");
  if (!k_i || !e) return {};
  const std::size_t v = e->exponents.size() - 1;
  const double fall = std::pow(e->low[v] / e->high[v], e->exponents[v]) - 1; // of e over the speeds computed
  if (!(fall > std::max(smallest_fall, e->left_out_rms))) return {};
  PairRegion region{.wanted = wanted,
                    .speed_error = e->left_out_rms / std::abs(e->exponents[v]),
                    .k_i_error = k_i->left_out_rms,
                    .n_rims = 0,
                    .rims = {},
                    .sentence = {}};
  std::set<std::vector<double>> seen; // the bearing's own rim stands in the study at several speeds
  for (const auto &row : study.rows) {
    if (!seen.insert({row.inputs.begin(), row.inputs.end() - 1}).second) continue;
    ++region.n_rims;
    RimAtPair rim{.name = row.name, .inputs = row.inputs, .k_i = 0, .met = false};
    rim.inputs[v] *= std::pow(wanted.e / e->at(row.inputs), 1 / e->exponents[v]); // a product of powers, solved for v
    if (!e->covers(rim.inputs)) continue;
    rim.k_i = k_i->at(rim.inputs);
    rim.met = std::abs(rim.k_i / wanted.k_i - 1) <= region.k_i_error;
    region.rims.push_back(rim);
  }
  region.sentence = sentence_of(region);
  return region;
}

nlohmann::json to_json(const PairRegion &region) {
  nlohmann::json rims = nlohmann::json::array();
  for (const auto &rim : region.rims) {
    nlohmann::json entry = {{"name", rim.name}, {"k_i", rim.k_i}, {"met", rim.met}};
    for (std::size_t j = 0; j < rim.inputs.size(); ++j) entry[geometry_axes()[j].name] = rim.inputs[j];
    rims.push_back(entry);
  }
  nlohmann::json result = {{"wanted", {{"k_i", region.wanted.k_i}, {"e", region.wanted.e}}},
                           {"speed_error_rms", region.speed_error},
                           {"k_i_error_rms", region.k_i_error},
                           {"n_rims", region.n_rims},
                           {"n_return_e", region.rims.size()},
                           {"n_met", n_met(region)},
                           {"rims", rims},
                           {"sentence", region.sentence}};
  if (region.rims.empty()) return result;
  const Bounds speeds = bounds_of(region.rims, false, speed), k_i = bounds_of(region.rims, false, stiffness);
  result["speed_m_s"] = {speeds.lower, speeds.upper}, result["k_i_kN_per_m"] = {k_i.lower, k_i.upper};
  return result;
}

} // namespace rimpact::calibration
