#include "calibration/data/measured_doubts.h"
#include "calibration/data/channel_lag.h"
#include "calibration/data/functionals.h"
#include "calibration/data/sample_noise.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {

/// Impulse against the change of momentum of an isolated impact: says what no noise shows, a gain or a mass that is
/// wrong.
void doubt_impulse(StoredRun &run, const MeasuredRecord &record, const MeasuredImpact &impact) {
  const auto &x = run.scene.excitation;
  const auto &w = impact.window;
  const Contact &contact = record.contacts()[impact.index];
  if (!run.is_window() || x.with_weight || x.with_friction || x.with_ground || w.measurement->rebound.weights.empty())
    return;
  const auto &m = *w.measurement;
  const double change = run.scene.load.mass * (w.impact.approach_speed + w.impact.rebound_speed),
               ratio = contact.impulse / change;
  const double speeds = std::sqrt(m.start_factor.row(1).squaredNorm() +
                                  std::pow(m.sigma_displacement, 2) * record.inflation() * variance_gain(m.rebound));
  const double error = std::hypot(contact.impulse_error / change, ratio * run.scene.load.mass * speeds / change);
  if (std::abs(ratio - 1) > 0.02 && std::abs(ratio - 1) > 4 * error)
    run.doubts.push_back(fmt::format(
        "at {:.4f} s the force's impulse is {:.3f} +- {:.3f} times the change of momentum: the cell's gain or "
        "the mass ({:g} kg) is off, or something else than the rim slows it; [uncertainty] gain states it",
        contact.touch_time, ratio, error, run.scene.load.mass));
}

/// The first touch of a rim without a dent is at L_c, to the record's noise and its sampling. The law's stiffness
/// follows from the depth: 0.4 mm, less than a drawing's tolerance, make a rim that gives way by 2 mm a third too soft.
void doubt_place(StoredRun &run, const MeasuredRecord &record, const MeasuredImpact &impact) {
  constexpr double felt = 0.25e-3; // [m]
  const Contact &contact = record.contacts()[impact.index];
  const ShotStart &start = impact.start;
  const double L_c = run.scene.bearing.lateral_capacity(), off = start.touch - L_c;
  const double unsure = noise_reach * start.touch_noise + start.touch_late;
  if (std::abs(off) <= felt + unsure) return;
  run.doubts.push_back(fmt::format(
      "at {:.4f} s the rim first bears force at {:.2f} mm of travel, {:.2f} mm {} the bearing's L_c of {:.2f} mm, "
      "which a stiffness feels: is the displacement's zero right? (--fit ...,capacity_offset looks for the rim)",
      contact.touch_time, 1e3 * start.touch, 1e3 * std::abs(off), off > 0 ? "beyond" : "before", 1e3 * L_c));
}

/// From touch to half the peak force [s]: where a lag shifts the force most.
double rise_of(const MeasuredRecord &record, const std::vector<double> &times, const Contact &contact) {
  const auto &force = record.force().smooth;
  const double half = 0.5 * *std::max_element(force.begin() + contact.first, force.begin() + contact.last + 1);
  std::size_t i = contact.first;
  while (i < contact.last && force[i] < half) ++i;
  return std::max(0.0, times[i] - contact.touch_time);
}

/// A force that comes late looks like a rim that begins late: the law fitted to it is too soft.
void doubt_clocks(StoredRun &run, const MeasuredRecord &record, const WindowOptions &options,
                  const MeasuredImpact &impact) {
  constexpr double share = 0.05; // of the force's rise, which a stiffness hardly feels
  const Contact &contact = record.contacts()[impact.index];
  const auto found = channel_lag(run, record, impact.index, impact.window.direction);
  if (impact.window.grazing || !found) return;
  const double unsure = found->unsure + 2 * options.stated_clock_error;
  if (std::abs(found->lag) <= share * rise_of(record, run.response.series("time"), contact) + unsure) return;
  run.doubts.push_back(fmt::format(
      "at {:.4f} s the force comes {:.2g} ms {} the motion that it causes (+- {:.2g} ms): do the channels have one "
      "clock and one filter, and does the cell read its peak? A stiffness feels a tenth of a millisecond; shift the "
      "column, or state it by [uncertainty] time_ms",
      contact.touch_time, 1e3 * std::abs(found->lag), found->lag > 0 ? "after" : "before", 1e3 * unsure));
}

/// A cell that does not come back to its reading takes what is left for the rim's force.
void doubt_drift(StoredRun &run, const MeasuredRecord &record) {
  constexpr double felt = 0.02; // of the peak, beyond what filters and hum leave of a mean
  const ContactRecord &force = record.force();
  const double error = noise_of_differences(force.push) * std::sqrt(4.0 / std::max(1, force.n_quiet));
  if (std::abs(force.left_over) <= felt * force.peak + noise_reach * error) return;
  run.doubts.push_back(fmt::format("after the last release the force reads {:.3g} kN more than before the first touch, "
                                   "{:.1f} % of the peak: does the cell drift, or does something else press?",
                                   force.left_over / 1e3, 100 * force.left_over / force.peak));
}

/// A force that stands at one value, its largest, for a tenth of the contact.
void doubt_cell(StoredRun &run, const MeasuredRecord &record, const MeasuredImpact &impact) {
  const Contact &contact = record.contacts()[impact.index];
  const auto &push = record.force().push;
  const double most = *std::max_element(push.begin() + contact.first, push.begin() + contact.last + 1);
  std::size_t flat = 0, longest = 0;
  for (std::size_t i = contact.first; i <= contact.last; ++i) {
    flat = push[i] > most * (1 - 1e-6) ? flat + 1 : 0;
    longest = std::max(longest, flat);
  }
  // of a smooth peak that long is told by one step of its digits
  const double step = step_of_digits(run.response.series("impact_x")),
               told = 2 / M_PI * std::acos(1 - std::min(1.0, step / most));
  const double share = static_cast<double>(longest) / static_cast<double>(contact.last - contact.first + 1);
  if (longest < 4 || share < std::max(0.1, 2 * told)) return;
  run.doubts.push_back(fmt::format("at {:.4f} s the force stands at {:.0f} kN, its largest, for {} samples: does the "
                                   "cell saturate?",
                                   contact.touch_time, most / 1e3, longest));
}

} // namespace

void doubt(StoredRun &run, const MeasuredRecord &record, const WindowOptions &options, const MeasuredImpact &impact) {
  doubt_impulse(run, record, impact);
  if (impact.index == 0) doubt_place(run, record, impact), doubt_drift(run, record);
  doubt_clocks(run, record, options, impact);
  doubt_cell(run, record, impact);
}

} // namespace rimpact::calibration
