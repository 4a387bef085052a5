#include "reduced_models/motion/integrator_check.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::reduced {
namespace {

double relative(double value, double reference) {
  return reference != 0 ? std::abs(value / reference - 1) : std::abs(value);
}

} // namespace

nlohmann::json integrator_check(const Summary &cvode, const Summary &own) {
  nlohmann::json check{
      {"name", "cvode"},
      {"n_steps_own", own.n_steps},
      {"n_impacts_own", own.impacts.size()},
      {"peak_displacement_difference_m", std::abs(cvode.peak_displacement - own.peak_displacement)},
      {"residual_displacement_difference_m", std::abs(cvode.residual_displacement - own.residual_displacement)},
      {"peak_lateral_force_difference", relative(cvode.peak_lateral_force, own.peak_lateral_force)}};
  if (cvode.impacts.size() != own.impacts.size() || own.impacts.empty()) return check;
  double touch = 0, force = 0;
  for (std::size_t i = 0; i < own.impacts.size(); ++i) {
    touch = std::max(touch, std::abs(cvode.impacts[i].touch_time - own.impacts[i].touch_time));
    force = std::max(force, relative(cvode.impacts[i].peak_force, own.impacts[i].peak_force));
  }
  check["touch_time_difference_s"] = touch, check["impact_force_difference"] = force;
  return check;
}

std::string integrator_in_words(const nlohmann::json &check) {
  const auto value = [&](const char *name) { return check.at(name).get<double>(); };
  std::string text =
      fmt::format("CVODE differs from the own steps ({}): travel by {:.2g} m, end by {:.2g} m, lateral force "
                  "by {:.2g} of it",
                  check.at("n_steps_own").get<long>(), value("peak_displacement_difference_m"),
                  value("residual_displacement_difference_m"), value("peak_lateral_force_difference"));
  const auto impacts = check.at("n_impacts_own").get<std::size_t>();
  if (check.contains("touch_time_difference_s"))
    text += fmt::format(", touches by {:.2g} s, impact forces by {:.2g} of them", value("touch_time_difference_s"),
                        value("impact_force_difference"));
  else if (impacts > 0)
    text += fmt::format("; the own steps have {} impact(s)", impacts);
  return text;
}

} // namespace rimpact::reduced
