#include "calibration/laws/windows_table.h"
#include "calibration/fit/shooting.h"
#include "calibration/laws/law_words.h"
#include "calibration/laws/percent.h"
#include "io/files/error.h"
#include "laws/impact/catalogue.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {

WindowRow make_row(const StoredRun &run, const FitResult &pair, const FitOptions &options, double tolerance) {
  const ImpactWindow &w = run.impacts.front();
  const double m = run.scene.load.mass, v = w.impact.approach_speed, e = w.impact.restitution();
  WindowRow row{};
  row.folder = run.folder;
  row.speed = v;
  row.peak_force = w.impact.peak_force;
  row.contact_time = w.impact.release_time - w.impact.touch_time;
  row.peak_penetration = w.impact.peak_penetration;
  row.rebound_speed = w.impact.rebound_speed;
  row.restitution = e;
  row.own = fit({&run}, options);
  if (e > 0 && e <= 1) {
    const double xi = laws::damping_ratio(e), speed_ratio = row.peak_force / (v * laws::kelvin_voigt_peak(e));
    row.k_from_peak = speed_ratio * speed_ratio / m;
    const double frequency = M_PI / row.contact_time;
    row.k_from_contact_time = m * frequency * frequency / (1 - xi * xi);
  }
  const auto scene = with_fitted(run.scene, pair);
  const Shot shot = shoot(scene, w);
  row.normalised_force = row.peak_force / (v * std::sqrt(scene.reduced.k_i * m));
  row.pair_force_error = shot.peak / w.peak - 1;
  row.pair_rebound_error = (shot.rebound_speed - w.impact.rebound_speed) / v;
  row.pair_holds = std::abs(row.pair_force_error) <= tolerance;
  return row;
}

void find_range(WindowsTable &table) {
  std::size_t longest = 0;
  for (std::size_t first = 0; first < table.rows.size(); ++first) {
    std::size_t n = 0;
    while (first + n < table.rows.size() && table.rows[first + n].pair_holds) ++n;
    if (n <= longest) continue;
    longest = n;
    table.valid_from = table.rows[first].speed;
    table.valid_to = table.rows[first + n - 1].speed;
  }
}

std::string misses(const WindowRow &row) {
  return fmt::format("at {:.3g} m/s it {} the peak force by {}", row.speed,
                     row.pair_force_error > 0 ? "overstates" : "understates",
                     percent_up(std::abs(row.pair_force_error)));
}

/// Of the law that was fitted, by its own type; bounds are those measured in the windows.
std::string sentence(const WindowsTable &table, const scene::Scene &scene) {
  std::string name = law_in_words(scene);
  name.front() = 'T';
  const auto &first = table.rows.front(), &last = table.rows.back();
  if (!table.valid_from) {
    const auto best = std::min_element(table.rows.begin(), table.rows.end(), [](const auto &a, const auto &b) {
      return std::abs(a.pair_force_error) < std::abs(b.pair_force_error);
    });
    return fmt::format(
        "{} meets the peak force within {:.0f} % at none of the speeds from {:.3g} to {:.3g} m/s; it comes "
        "closest at {:.3g} m/s ({:+.0f} %).",
        name, 100 * table.tolerance, first.speed, last.speed, best->speed, 100 * best->pair_force_error);
  }
  double peak = 0, rebound = 0;
  for (const auto &row : table.rows)
    if (row.speed >= *table.valid_from && row.speed <= *table.valid_to)
      peak = std::max(peak, std::abs(row.pair_force_error)),
      rebound = std::max(rebound, std::abs(row.pair_rebound_error));
  const auto where = *table.valid_from == *table.valid_to
                         ? fmt::format("at {:.3g} m/s only", *table.valid_from)
                         : fmt::format("for impacts at {:.3g} to {:.3g} m/s", *table.valid_from, *table.valid_to);
  std::string text = fmt::format(
      "{} meets the peak force of the windows within {} {}, its rebound there off by up to {} of the approach speed",
      name, percent_up(peak), where, percent_up(rebound));
  if (*table.valid_from > first.speed) text += "; " + misses(first);
  if (*table.valid_to < last.speed) text += "; " + misses(last);
  return text + ".";
}

} // namespace

WindowsTable windows_table(const std::vector<const StoredRun *> &windows, const FitResult &pair,
                           const FitOptions &options, double tolerance) {
  WindowsTable table;
  table.tolerance = tolerance;
  FitOptions own = options; // each window by itself knows only the impact element
  std::erase_if(own.parameters, [](const std::string &name) { return parameter(name).seen_in_flight; });
  own.start.clear();
  std::erase_if(own.bounds, [](const auto &entry) { return parameter(entry.first).seen_in_flight; });
  own.n_starts = std::clamp(options.n_starts, 1, 3);
  if (own.parameters.empty()) own.parameters = {"k_i", "e"};
  for (const StoredRun *run : windows) {
    if (run->impacts.empty()) throw DataError(run->folder + ": the window holds no impact to fit");
    table.rows.push_back(make_row(*run, pair, own, tolerance));
  }
  std::sort(table.rows.begin(), table.rows.end(), [](const auto &a, const auto &b) { return a.speed < b.speed; });
  if (table.rows.empty()) return table;
  find_range(table);
  table.sentence = sentence(table, with_fitted(windows.front()->scene, pair));
  return table;
}

} // namespace rimpact::calibration
