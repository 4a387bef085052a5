#include "calibration/answer/calibration_text.h"

#include "calibration/answer/answer.h"
#include "calibration/fit/parameter.h"
#include "calibration/laws/percent.h"
#include "laws/impact/catalogue.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::calibration {

double damping_coefficient(const scene::Scene &scene) {
  return laws::damping_coefficient(scene.reduced.k_i, scene.reduced.restitution, scene.load.mass);
}

namespace {

std::string describe(const LawRanking &ranking) {
  if (ranking.rows.empty()) return {};
  std::string text = fmt::format("{:<16} force left   fitted: peak  rebound   left out: peak  rebound\n", "impact law");
  for (const auto &row : ranking.rows)
    text += fmt::format("  {:<14} {:>10} {:>14} {:>8} {:>16} {:>9}\n", row.result.law, percent_of(row.unexplained),
                        percent_of(row.largest_peak_error), percent_of(row.largest_rebound_error),
                        percent_of(row.left_out_peak_error), percent_of(row.left_out_rebound_error));
  if (std::none_of(ranking.rows.begin(), ranking.rows.end(), [](const auto &row) { return row.left_out_peak_error; }))
    text += "Left out: not known, for too few runs hit the rim hard enough to leave one out.\n";
  return text + ranking.sentence + "\n";
}

/// The fit of the law that was asked for, its pair or numbers beside what they miss.
std::string other_fit(const Calibration &c) {
  const auto percent = [](const std::optional<double> &v) {
    return v ? fmt::format("{:+8.1f} %", 100 * *v) : "         -";
  };
  std::string text = fmt::format("law {} fitted to {}, at {:.6g} kg ({} impacts, {} starts)\n", c.result.law,
                                 word(c.fitted_on), c.scene.load.mass, c.result.n_impacts, c.result.n_starts);
  for (const auto &name : c.result.names) {
    const auto &e = c.result.parameters.at(name);
    text += fmt::format("  {:<13} {:>12.5g} {:<6} +- {:<10.3g} 95 %: {:.5g} .. {:.5g}{}\n", name, e.value,
                        parameter(name).unit, e.standard_error, e.interval_low, e.interval_high,
                        e.identifiable ? "" : "  NOT IDENTIFIABLE: " + e.reason);
  }
  const auto section = [&](const std::string &title, const std::map<std::string, RunCheck> &checks) {
    if (checks.empty()) return;
    text += fmt::format("{:<44} peak force  displacement  rebound\n", title);
    for (const auto &[folder, check] : checks)
      text += fmt::format("  {:<42} {}  {}  {}\n", folder, percent(check.history.peak_force_error),
                          percent(check.history.peak_displacement_error), percent(check.history.rebound_error));
  };
  section("runs fitted, by this fit, from rest", c.fit);
  section("runs predicted, by this fit, from rest", c.prediction);
  if (c.windows) text += c.windows->sentence + "\n";
  for (const auto &law : c.speed_laws)
    text += fmt::format("of each window alone: {} = {:.3g}{} (v / 1 m/s)^{:.3f} from {:.2g} to {:.2g} m/s, within {}\n",
                        law.name, law.coefficient, unit_behind(law.unit), law.exponent, law.from, law.to,
                        percent_up(law.largest_error));
  return text;
}

} // namespace

std::string describe(const Calibration &c) {
  std::string text = c.answer ? describe(*c.answer) + "\n" : "";
  text += describe(c.laws);
  for (const auto &r : c.grazing)
    text +=
        fmt::format("{}: first touch at scale {}; at {:g} the peak impact force is {:.4g} kN ({:.4g} .. {:.4g} kN)\n",
                    r.scene, r.critical_scale ? fmt::format("{:.5f}", *r.critical_scale) : "-", r.scale,
                    r.peak_force.nominal / 1e3, r.peak_force.low / 1e3, r.peak_force.high / 1e3);
  for (const auto &note : c.notes) text += "note: " + note + "\n";
  if (c.answer && c.answer->law.result.law != c.result.law)
    text += "\nNot the answer, which stands above, but another fit, for comparison:\n";
  return text + other_fit(c);
}

} // namespace rimpact::calibration
