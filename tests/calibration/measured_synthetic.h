/// Records as a laboratory's instruments make them, with a known answer: the reduced model's own motion, sampled
/// evenly, every sample of travel and force with an independent normal error.
#pragma once
#include "calibration/data/series.h"
#include "reduced_models/simulate.h"
#include "synthetic.h"

namespace rimpact::calibration::testing {

struct Instruments {
  double rate = 1000;                   ///< [Hz]
  double displacement = 0;              ///< standard error of one sample [m]
  double force = 0;                     ///< share of the peak
  double before = 0.010, after = 0.020; ///< recorded before the first touch and after the last release [s]
};

/// The truth between its samples: force jumps at touch, so it is read within pulses only.
inline Response sampled(const scene::Scene &s, const Response &truth, const Instruments &with, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  const auto &t = truth.series("time");
  Summary summary;
  summarise_response(truth, summary);
  const double peak = summary.peak_impact_force.value_or(0), dt = 1 / with.rate;
  const double phase = dt * std::uniform_real_distribution<double>()(generator);
  const double first = summary.impacts.front().touch_time - with.before + phase,
               last = summary.impacts.back().release_time + with.after;
  Response r;
  for (int i = 0; first + i * dt <= last; ++i) {
    const double at = first + i * dt;
    r.append("time", i * dt);
    for (const char *axis : {"_x", "_y"}) {
      const auto &u = truth.series(std::string("displacement") + axis),
                 &v = truth.series(std::string("velocity") + axis);
      const double travel = at < t.front() ? u.front() + (at - t.front()) * v.front() : hermite_at(t, u, v, at);
      const bool x = axis[1] == 'x';
      r.append(std::string("displacement") + axis, x ? travel + with.displacement * normal(generator) : 0);
      r.append(std::string("impact") + axis,
               x ? pulse_at(t, truth.series("impact_x"), at) + with.force * peak * normal(generator) : 0);
    }
    r.append("force_x", r.series("impact_x").back()), r.append("force_y", 0);
    r.append("gap", s.bearing.lateral_capacity() - std::abs(r.series("displacement_x").back()));
  }
  return r;
}

/// A whole history keeps its clock (the ground motion's), a window begins `before` its touch.
inline StoredRun measured(const scene::Scene &s, const Instruments &with, unsigned seed, WindowOptions options = {}) {
  options.measured = true;
  auto truth = s;
  truth.reduced.output_step = 1e-3;
  const auto motion = reduced::simulate(truth).response;
  auto record = sampled(s, motion, with, seed);
  if (s.excitation.kind != scene::ExcitationKind::window) {
    Summary summary;
    summarise_response(motion, summary);
    std::mt19937 generator(seed); // the first draw of `sampled` is its phase
    const double phase = std::uniform_real_distribution<double>()(generator) / with.rate;
    for (double &t : record.series("time")) t += summary.impacts.front().touch_time - with.before + phase;
  }
  return make_run(fmt::format("{}-{}", s.name, seed), s, record, options);
}

} // namespace rimpact::calibration::testing
