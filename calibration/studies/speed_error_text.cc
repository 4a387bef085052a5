// Table, CSV and JSON of a study.
#include "calibration/studies/speed_error_text.h"

#include <fmt/format.h>

namespace rimpact::calibration {
namespace {

std::string percent(const std::optional<double> &value) {
  return value ? fmt::format("{:+.2f}", 100 * *value) : "-";
}
nlohmann::json number(const std::optional<double> &value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}
const char *quantity(const SpeedError &study) {
  return study.touches ? "peak force" : "peak displacement";
}

} // namespace

nlohmann::json to_json(const SpeedError &study) {
  nlohmann::json rows = nlohmann::json::array();
  for (const auto &row : study.rows) {
    nlohmann::json item = to_json(row.errors);
    item.update({{"name", row.run.name},
                 {"rung", word(row.run.rung)},
                 {"element", row.run.element},
                 {"mesh", row.run.mesh},
                 {"step_s", row.run.step},
                 {"wall_time_s", row.run.seconds},
                 {"processor_time_s", number(row.run.processor)},
                 {"peak_memory_bytes", row.run.memory},
                 {"n_dofs", row.run.n_dofs},
                 {"imbalance_relative", row.run.imbalance},
                 {"peak_impact_force_N", number(row.run.peak_force)},
                 {"dissipated_J", row.run.dissipated},
                 {"dissipated_error", number(row.dissipated_error)},
                 {"error", row.error},
                 {"reference", row.reference},
                 {"on_frontier", row.on_frontier}});
    rows.push_back(item);
  }
  return {{"rows", rows},
          {"observed_order", number(study.order)},
          {"extrapolated_peak_force_N", number(study.extrapolated)},
          {"wanted_error", study.wanted},
          {"error_of", study.touches ? "peak_impact_force" : "peak_displacement"},
          {"recommended", study.recommended.empty() ? nlohmann::json() : nlohmann::json(study.recommended)}};
}

std::string to_csv(const SpeedError &study) {
  std::string text = "name,rung,mesh,step_s,wall_time_s,peak_memory_bytes,n_dofs,peak_impact_force_N,error,"
                     "peak_displacement_error,rebound_error,dissipated_error,nrmse_force,nrmse_displacement,reference,"
                     "on_frontier,processor_time_s\n";
  const auto cell = [](const std::optional<double> &value) { return value ? fmt::format("{:.8g}", *value) : ""; };
  for (const auto &row : study.rows)
    text += fmt::format("{},{},{},{:g},{:.6g},{:.0f},{},{},{:.8g},{},{},{},{},{},{:d},{:d},{}\n", row.run.name,
                        word(row.run.rung), row.run.mesh, row.run.step, row.run.seconds, row.run.memory, row.run.n_dofs,
                        cell(row.run.peak_force), row.error, cell(row.errors.peak_displacement_error),
                        cell(row.errors.rebound_error), cell(row.dissipated_error), cell(row.errors.nrmse_force),
                        cell(row.errors.nrmse_displacement), row.reference, row.on_frontier, cell(row.run.processor));
  return text;
}

std::string describe(const SpeedError &study) {
  std::string text =
      fmt::format("{:22s} {:>9s} {:>9s} {:>6s} {:>7s} {:>9s} {:>8s} {:>8s} {:>8s} {:>8s} {:>8s}\n", "run", "cpu s",
                  "seconds", "GB", "dofs", "force kN", "force %", "displ. %", "rebound%", "dissip.%", "F rms %");
  for (const auto &row : study.rows) {
    const double truth = row.run.peak_force.value_or(0);
    const auto &errors = row.errors;
    text += fmt::format("{:22s} {:>9s} {:9.3f} {:6.2f} {:7d} {:9.1f} {:>8s} {:>8s} {:>8s} {:>8s} {:>8s} {}\n",
                        row.run.name, row.run.processor ? fmt::format("{:.3f}", *row.run.processor) : "-",
                        row.run.seconds, 1e-9 * row.run.memory, row.run.n_dofs, 1e-3 * truth,
                        row.run.peak_force ? fmt::format("{:.2f}", 100 * row.error) : "-",
                        percent(errors.peak_displacement_error), percent(errors.rebound_error),
                        percent(row.dissipated_error), percent(errors.nrmse_force),
                        row.reference     ? "reference"
                        : row.on_frontier ? "frontier"
                                          : "");
  }
  for (const auto &row : study.rows)
    if (!row.run.element.empty()) text += fmt::format("{}: {}\n", row.run.name, row.run.element);
  if (study.extrapolated)
    text += fmt::format("peak force extrapolated over the reference's three meshes: {:.1f} kN, observed order {:.2f}; "
                        "its errors are against that\n",
                        1e-3 * *study.extrapolated, *study.order);
  if (!study.touches) text += "the reference does not touch the rim: errors are of the peak displacement\n";
  text += study.recommended.empty() ? fmt::format("no setting has an error of {:.2g} % or less\n", 100 * study.wanted)
                                    : fmt::format("cheapest with an error of the {} of {:.2g} % or less: {}\n",
                                                  quantity(study), 100 * study.wanted, study.recommended);
  return text;
}

} // namespace rimpact::calibration
