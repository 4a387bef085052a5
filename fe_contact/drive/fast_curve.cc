#include "fe_contact/drive/fast_curve.h"

#include "fe_contact/laws/strain_rate.h"
#include "io/files/error.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::fe {
namespace {

/// Between rows by straight lines; both columns rise from 0.
double strain_at(const reduced::CurveStrain &rows, double depth) {
  const auto above = std::upper_bound(rows.penetration.begin(), rows.penetration.end(), depth);
  if (above == rows.penetration.end()) return rows.strain.back();
  const auto i = static_cast<std::size_t>(above - rows.penetration.begin());
  const double d = i > 0 ? rows.penetration[i - 1] : 0, strain = i > 0 ? rows.strain[i - 1] : 0;
  return strain + (rows.strain[i] - strain) * (depth - d) / (*above - d);
}

void scale(std::vector<double> &values, double factor) {
  for (double &value : values) value *= factor;
}

void scale(laws::CurvePath &path, double factor) {
  scale(path.loading.penetration, factor), scale(path.loading.force, factor);
  for (auto &back : path.unloading) scale(back.penetration, factor), scale(back.force, factor);
}

} // namespace

void require_rate(const scene::Bearing &bearing) {
  if (!bearing.rim_steel().knows_rate())
    throw InputError("a curve at speed needs bearing.material.steel.rate, or the rim's: the rim's steel knows no rate");
}

FastCurve fast_curve(const reduced::RimCurveFile &slow, const scene::Bearing &bearing, double mass, double speed) {
  require_rate(bearing);
  if (slow.strain.strain.empty()) throw InputError("a curve at speed needs the rim's strain, which this curve has not");
  const laws::RimCurve held(slow.held);
  const double energy = 0.5 * mass * speed * speed, most = held.work(held.range());
  if (energy > most)
    throw InputError(
        fmt::format("{:g} kg at {:g} m/s bring {:.0f} J; the curve stops {:.0f} J", mass, speed, energy, most));
  const double depth = held.depth_of(energy);
  FastCurve fast{.file = slow};
  fast.rate = speed * strain_at(slow.strain, depth) / depth;
  fast.factor = 1 + RateLaw{bearing.rim_steel().rate}.overstress(fast.rate);
  scale(fast.file.held, fast.factor), scale(fast.file.dish, fast.factor);
  scale(fast.file.strain.penetration, fast.factor), scale(fast.file.strain.strain, fast.factor);
  scale(fast.file.foot.penetration, fast.factor), scale(fast.file.foot.use, fast.factor);
  return fast;
}

} // namespace rimpact::fe
