#include "calibration/answer/answer_table.h"
#include "calibration/laws/no_tension_pair.h"
#include "calibration/laws/percent.h"
#include "responses/open_impact.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {

constexpr int n_speeds = 5;
constexpr double widest_e = 0.10;      // an interval of e beyond it says little of the rebound
constexpr double widest_k_ratio = 1.5; // of its interval's ends: the peak force goes with the root

/// One impact alone: weightless, without friction, the building or other models.
scene::Scene one_impact(const scene::Scene &answer, double speed) {
  scene::Scene scene = answer;
  scene.excitation = {};
  scene.excitation.kind = scene::ExcitationKind::window;
  scene.excitation.speed = speed;
  scene.superstructure = {};
  scene.reduced.model = scene::ModelKind::physical;
  return scene;
}

AnswerRow row_of(const scene::Scene &answer, const AnswerLaw &law, double speed) {
  AnswerRow row;
  row.speed = speed;
  scene::Scene scene = one_impact(answer, speed);
  scene.excitation.duration = 0.25;
  for (int n = 0; n < 6; ++n, scene.excitation.duration *= 4) { // until a soft rim has let go
    const auto impacts = reduced::simulate(scene).summary.impacts;
    if (impacts.empty()) continue;
    const auto &i = impacts.front();
    row.peak_force = i.peak_force, row.penetration = i.peak_penetration;
    row.restitution = i.restitution(),
    row.contact_time = (is_open(i) ? scene.excitation.duration : i.release_time) - i.touch_time;
    if (!is_open(i) && i.release_time < 0.9 * scene.excitation.duration) break;
  }
  if (const auto pair = no_tension_pair(row.peak_force, row.restitution, speed, answer.load.mass))
    row.k_i = pair->k_i, row.e = pair->e;
  const auto &errors = law.left_out.empty() ? law.fitted : law.left_out;
  row.error_from = law.left_out.empty() ? ErrorFrom::fitted : ErrorFrom::left_out;
  row.peak_force_error = errors_at(speed, errors, &LawError::peak_force);
  row.rebound_error = errors_at(speed, errors, &LawError::rebound);
  return row;
}

} // namespace

std::optional<double> errors_at(double speed, const std::vector<LawError> &errors, double LawError::*of) {
  if (errors.empty()) return {};
  const auto above =
      std::lower_bound(errors.begin(), errors.end(), speed, [](const LawError &e, double v) { return e.speed < v; });
  if (above == errors.begin()) return known(std::abs(errors.front().*of));
  if (above == errors.end()) return known(std::abs(errors.back().*of));
  const LawError &low = *(above - 1), &high = *above;
  const double a = low.*of, b = high.*of;
  if (a * b <= 0 || !(high.speed > low.speed)) return known(larger_of(std::abs(a), std::abs(b)));
  const double share = std::log(speed / low.speed) / std::log(high.speed / low.speed);
  return known(std::abs((1 - share) * a + share * b));
}

std::vector<AnswerRow> answer_table(const scene::Scene &scene, const AnswerLaw &law) {
  std::vector<AnswerRow> rows;
  if (!(law.fitted_from > 0)) return rows;
  const double ratio = law.fitted_to / law.fitted_from;
  const int n = ratio > 1.001 ? n_speeds : 1;
  for (int i = 0; i < n; ++i)
    rows.push_back(
        row_of(scene, law, n == 1 ? law.fitted_from : law.fitted_from * std::pow(ratio, i / double(n_speeds - 1))));
  return rows;
}

void answer_pair(const Calibration &c, Answer &answer) {
  const std::string instead =
      answer.law.of_the_mass
          ? ""
          : fmt::format(". The law {} serves instead; the table gives k_i and e for each speed", answer.law.result.law);
  const std::string none = answer.law.of_the_mass ? "No other constant pair is given" : "No constant pair is given";
  if (!c.pair_range) {
    answer.no_pair =
        c.laws.rows.empty()
            ? none + ": it was not searched for (--laws none)"
            : fmt::format("{}: none of law {} meets peak force and rebound within 20 % over three neighbouring speeds",
                          none, answer.pair_law);
    answer.no_pair += instead + ".";
    return;
  }
  const auto &p = c.pair_range->result.parameters;
  const Estimate &k = p.at("k_i"), &e = p.at("e");
  const std::string here =
      fmt::format("{}: of the best one, from {:.3g} to {:.3g} m/s,", none, c.pair_range->from, c.pair_range->to);
  if (!e.identifiable || e.interval_high - e.interval_low > widest_e)
    answer.no_pair =
        fmt::format("{} e is known from {:.2g} to {:.2g} only{}.", here, e.interval_low, e.interval_high, instead);
  else if (!k.identifiable || k.interval_high > widest_k_ratio * k.interval_low)
    answer.no_pair = fmt::format("{} k_i is known from {:.3g} to {:.3g} kN/m only{}.", here, k.interval_low,
                                 k.interval_high, instead);
  else
    answer.pair = c.pair_range;
}

} // namespace rimpact::calibration
