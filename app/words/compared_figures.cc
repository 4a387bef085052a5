#include "app/words/compared_figures.h"

#include <cmath>
#include <fmt/format.h>

namespace rimpact::app {

const std::vector<ComparedFigure> &compared_figures() {
  using calibration::Comparison;
  constexpr double percent = 100, milliseconds = 1e3;
  static const std::vector<ComparedFigure> all{
      {"peak", "peak impact force", "of the hardest impact", &Comparison::peak_force_error, percent, "%"},
      {"displacement", "peak displacement", "horizontal", &Comparison::peak_displacement_error, percent, "%"},
      {"approach", "approach speed", "of the hardest impact, at its touch", &Comparison::approach_speed_error, percent,
       "%"},
      {"rebound", "rebound speed", "of the hardest impact, at its release", &Comparison::rebound_error, percent, "%"},
      {"restitution", "restitution", "rebound over approach speed, of the hardest impact",
       &Comparison::restitution_error, percent, "%"},
      {"time_ms", "first touch", "later than A's", &Comparison::touch_time_difference, milliseconds, "ms"},
      {"rms_displacement", "displacement, rms", "difference over L_c, from first touch to 0.5 s after release",
       &Comparison::nrmse_displacement, percent, "% of L_c"},
      {"rms_force", "impact force, rms", "difference over A's peak, the same span", &Comparison::nrmse_force, percent,
       "% of peak"},
      {"rms_lateral", "lateral force, rms", "difference over A's peak, the same span", &Comparison::nrmse_lateral_force,
       percent, "% of peak"},
  };
  return all;
}

std::optional<double> value_of(const ComparedFigure &figure, const calibration::Comparison &metrics) {
  const auto &value = metrics.*figure.value;
  if (!value) return {};
  return figure.factor * *value;
}

std::string in_words(const ComparedFigure &figure, std::optional<double> value) {
  if (!value) return "-";
  constexpr double hundredths = 100;
  return fmt::format("{:+.2f} {}", std::round(hundredths * *value) / hundredths + 0.0, figure.unit);
}

nlohmann::json figures_json(const calibration::Comparison &metrics) {
  auto rows = nlohmann::json::array();
  for (const auto &figure : compared_figures()) {
    const auto value = value_of(figure, metrics);
    rows.push_back({{"name", figure.name},
                    {"title", figure.title},
                    {"unit", figure.unit},
                    {"value", value ? nlohmann::json(*value) : nlohmann::json()}});
  }
  return rows;
}

} // namespace rimpact::app
