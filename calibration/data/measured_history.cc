#include "calibration/data/measured_history.h"
#include "calibration/data/functionals.h"
#include "calibration/data/series.h"
#include <algorithm>
#include <limits>

namespace rimpact::calibration {

void keep_contacts_only(Response &r, const ContactRecord &record) {
  std::vector<bool> pressed(r.size(), false);
  for (const auto &c : record.contacts) std::fill(pressed.begin() + c.first, pressed.begin() + c.last + 1, true);
  auto &x = r.series("impact_x"), &y = r.series("impact_y");
  for (std::size_t i = 0; i < r.size(); ++i) {
    x[i] = pressed[i] ? x[i] - record.zero_x : 0, y[i] = pressed[i] ? y[i] - record.zero_y : 0;
    if (pressed[i] && x[i] == 0 && y[i] == 0)
      x[i] = std::numeric_limits<double>::min(); // a sample that happens to read nothing is no release
  }
}

void complete_velocities(StoredRun &run, const MeasuredRecord &record) {
  Response &r = run.response;
  const auto &times = r.series("time");
  for (const char *axis : {"_x", "_y"}) {
    if (r.has(std::string("velocity") + axis)) continue;
    std::vector<double> rates(r.size(), 0.0);
    const auto &u = r.series(std::string("displacement") + axis);
    std::size_t next = 0;
    for (std::size_t i = 0; i < record.contacts().size(); ++i) {
      const Contact &c = record.contacts()[i];
      if (c.first > next) smooth_rates(times, u, next, c.first - 1, rates);
      smooth_rates(times, u, c.first, c.last, rates);
      const Span before = record.flights(i).before, after = record.flights(i).after;
      const auto component = [&](const Span &flight, std::size_t at) {
        return record.state(flight, times[at]).v[axis[1] == 'x' ? 0 : 1];
      };
      if (before.size() >= shortest_flight) rates[c.first] = component(before, before.last);
      if (after.size() >= shortest_flight) rates[c.last] = component(after, after.first);
      next = c.last + 1;
    }
    if (next < r.size()) smooth_rates(times, u, next, r.size() - 1, rates);
    r.series(std::string("velocity") + axis) = rates;
  }
}

void differentiate_path(Response &r) {
  for (const char *axis : {"_x", "_y"})
    if (!r.has(std::string("velocity") + axis))
      r.series(std::string("velocity") + axis) =
          differentiate(r.series("time"), r.series(std::string("displacement") + axis));
}

} // namespace rimpact::calibration
