#include "studies/fleets/implausible_runs.h"
#include "io/files/json_text.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::fleets {

const std::vector<std::string> &bounded_quantities() {
  static const std::vector<std::string> names{
      "peak_displacement_m", "peak_lateral_force_N", "peak_impact_force_N", "residual_displacement_m",
      "ductility",           "peak_drift_m",         "peak_storey_shear_N", "peak_floor_acceleration_m_s2"};
  return names;
}

PlausibleBounds read_plausible(const TomlFile &file) {
  PlausibleBounds bounds;
  TomlReader reader(file, "plausible");
  for (const auto &quantity : bounded_quantities()) {
    double most = 0;
    reader.number({quantity.c_str()}, most, si, {0, 1e12, true});
    if (most > 0) bounds[quantity] = most;
  }
  reader.finish();
  return bounds;
}

void ImplausibleRuns::add(const CellReader &run) {
  for (const auto &[quantity, most] : bounds_)
    if (const auto value = run(quantity.c_str())) {
      Beyond &found = found_[quantity];
      found.n += *value > most;
      found.largest = std::max(found.largest.value_or(*value), *value);
    }
}

bool ImplausibleRuns::bound_the_frame() const {
  return bounds_.contains("ductility") || bounds_.contains("peak_drift_m");
}

nlohmann::ordered_json ImplausibleRuns::json() const {
  auto all = nlohmann::ordered_json::object();
  for (const auto &[quantity, most] : bounds_) {
    const auto found = found_.find(quantity);
    const Beyond beyond = found == found_.end() ? Beyond{} : found->second;
    all[quantity] = {
        {"bound", most}, {"n_runs_beyond", beyond.n}, {"largest", or_null<nlohmann::ordered_json>(beyond.largest)}};
  }
  return all;
}

std::vector<std::string> ImplausibleRuns::doubts() const {
  std::vector<std::string> sentences;
  for (const auto &[quantity, found] : found_)
    if (found.n > 0)
      sentences.push_back(fmt::format("{} runs have a {} beyond {:g}, the bound of [plausible], up to {:.3g}: such a "
                                      "run may be a collapse that the model does not have",
                                      found.n, quantity, bounds_.at(quantity), *found.largest));
  return sentences;
}

} // namespace rimpact::fleets
