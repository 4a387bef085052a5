#include "calibration/export/dish.h"
#include "scene/assumptions.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {

double Dish::slope_at(double r) const {
  std::size_t i = 1;
  while (i + 1 < travel.size() && r > travel[i]) ++i;
  return slope[i - 1] + (slope[i] - slope[i - 1]) * (r - travel[i - 1]) / (travel[i] - travel[i - 1]);
}

Dish dish_of(const scene::Scene &scene, double capacity) {
  const auto surface = scene::make_surface(scene.bearing.surface);
  const auto slope = [&](double r) { return surface->at(r, 0).gradient.x(); };
  const double R = 1 / surface->curvatures(0).meridional;
  const auto error = [&](double r) { return r / R / slope(r) - 1; };
  const double last = std::min(1.15 * capacity, 0.5 * (capacity + std::min(surface->limit_radius(), 2 * capacity)));
  Dish dish{.sphere = scene.bearing.surface.kind == scene::SurfaceKind::sphere,
            .radius = R,
            .travel = {},
            .slope = {},
            .error_half = error(capacity / 2),
            .error_full = error(capacity),
            .diagonal_error = 0,
            .mu_slow = scene.reduced.mu_slow,
            .mu_fast = scene.reduced.mu_fast,
            .rate = scene.reduced.rate,
            .elastic_slip = scene.reduced.elastic_slip,
            .vertical_stiffness = scene.bearing.ertalyte.E * scene.bearing.pad_area() / scene.bearing.pad.thickness};
  if (const auto &pad = scene.bearing.pad; scene::has_default_pad(scene.bearing))
    dish.assumed_pad = fmt::format(" That pad, {:g} x {:g} mm, is the built-in bearing's: this bearing gives none, an "
                                   "assumption.",
                                   2e3 * pad.outer_radius, 1e3 * pad.thickness);
  dish.travel = {0, 0.002 * last, 0.006 * last, 0.02 * last}; // finer at the centre, where a truss of 1 mm turns
  constexpr int n = 24;
  for (int i = 1; i <= n; ++i) dish.travel.push_back(last * i / n);
  for (const double r : dish.travel) dish.slope.push_back(r > 0 ? slope(r) : 0);
  const double on_axis = slope(capacity / std::sqrt(2.0));
  dish.diagonal_error = std::sqrt(2.0) * on_axis / slope(capacity) - 1;
  return dish;
}

std::vector<std::string> Dish::lines(double vertical) const {
  std::vector<std::string> all;
  if (sphere)
    all.push_back(fmt::format("Dish: sphere of {:.6g} m. Its element restores N r / R, with N the force it carries: "
                              "{:+.2f} % at half the way to the rim, {:+.2f} % at the rim against W h'(r).",
                              radius, 100 * error_half, 100 * error_full));
  else
    all.push_back(fmt::format("Dish: no sphere. Its restoring force is the table W h'(r) for the dead load W = {:.6g} "
                              "kN: it does not follow a changing normal force (overturning, vertical motion). "
                              "A sphere of the vertex radius {:.4g} m would be off by {:+.1f} % at half the way to the "
                              "rim and {:+.1f} % at the rim.",
                              vertical / 1e3, radius, 100 * error_half, 100 * error_full));
  all.push_back(fmt::format("Friction: {}, built up over {:.3g} mm, on the normal force of the element. Vertical "
                            "stiffness: the pad's E A / t.{}",
                            mu_slow == mu_fast
                                ? fmt::format("Coulomb, {:g}", mu_fast)
                                : fmt::format("{:g} slow, {:g} fast, rate {:g} s/m", mu_slow, mu_fast, rate),
                            1e3 * elastic_slip, assumed_pad));
  return all;
}

} // namespace rimpact::calibration
