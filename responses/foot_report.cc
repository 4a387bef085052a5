#include "responses/foot_report.h"

#include "io/files/error.h"
#include "io/files/json_text.h"
#include "responses/crossing.h"
#include <algorithm>
#include <cmath>

namespace rimpact {

namespace {

std::optional<double> force_where_it_goes(const Response &r) {
  const auto &x = r.series("impact_x"), &y = r.series("impact_y");
  const auto gone = first_crossing(r.series("rim_foot_use"), 1);
  if (!gone) return {};
  std::vector<double> force(x.size());
  std::ranges::transform(x, y, force.begin(), [](double fx, double fy) { return std::hypot(fx, fy); });
  return gone->of(force);
}

} // namespace

std::optional<FootReport> foot_report(const Response &r, const scene::Bearing &bearing) {
  if (r.size() == 0 || !r.has("rim_foot_weld_force")) return {};
  const bool joint = bearing.rim.connection.kind != scene::ConnectionKind::monolithic && r.has("rim_foot_use");
  const auto &measure = r.series(joint ? "rim_foot_use" : "rim_foot_weld_force");
  const auto k = static_cast<std::size_t>(std::max_element(measure.begin(), measure.end()) - measure.begin());
  const auto at = [&](const char *name) { return r.series(name)[k]; };
  FootReport report{.time = at("time"), .worst = {}, .weld = at("rim_foot_weld_force"), .use = {}, .goes_at_force = {}};
  report.worst.normal = at("rim_foot_normal_per_length"), report.worst.shear = at("rim_foot_shear_per_length");
  report.worst.moment = at("rim_foot_moment_per_length");
  report.needed_throat = report.weld / weld_strength(bearing.rim.connection);
  if (joint) report.use = measure[k], report.goes_at_force = force_where_it_goes(r);
  report.normal = at("rim_foot_normal"), report.shear = at("rim_foot_shear"), report.moment = at("rim_foot_moment");
  return report;
}

nlohmann::ordered_json to_json(const FootReport &f, const scene::RimConnection &connection) {
  return {{"connection", word(connection.kind)},
          {"in_words", in_words(connection)},
          {"use", or_null<nlohmann::ordered_json>(f.use)},
          {"exceeded", f.use ? nlohmann::ordered_json(f.exceeded()) : nlohmann::ordered_json(nullptr)},
          {"goes_at_force_N", or_null<nlohmann::ordered_json>(f.goes_at_force)},
          {"time_s", f.time},
          {"normal_N_per_m", f.worst.normal},
          {"shear_N_per_m", f.worst.shear},
          {"moment_N", f.worst.moment},
          {"weld_N_per_m", f.weld},
          {"needed_throat_mm", 1e3 * f.needed_throat},
          {"total_normal_N", f.normal},
          {"total_shear_N", f.shear},
          {"total_moment_Nm", f.moment}};
}

std::optional<FootReport> foot_report_in(const nlohmann::json &summary, const std::string &origin) {
  if (!summary.contains("rim_foot") || summary["rim_foot"].is_null()) return {};
  try {
    const auto &f = summary["rim_foot"];
    const auto number = [&](const char *key) { return f.at(key).get<double>(); };
    FootReport report;
    report.time = number("time_s"), report.weld = number("weld_N_per_m");
    report.worst = {number("normal_N_per_m"), number("shear_N_per_m"), 0, number("moment_N")};
    report.needed_throat = 1e-3 * number("needed_throat_mm");
    if (!f.value("use", nlohmann::json()).is_null()) report.use = number("use");
    if (report.exceeded() && !f.contains("goes_at_force_N"))
      throw DataError(origin + ": the run is of an earlier version, which did not keep the force at which the joint at "
                               "the rim's foot goes (goes_at_force_N): run it again");
    if (report.exceeded()) report.goes_at_force = number("goes_at_force_N");
    report.normal = number("total_normal_N"), report.shear = number("total_shear_N");
    report.moment = number("total_moment_Nm");
    return report;
  } catch (const nlohmann::json::exception &) {
    throw DataError(origin + ": \"rim_foot\" is not what went through a rim's foot");
  }
}

} // namespace rimpact
