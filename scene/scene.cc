#include "scene/scene.h"
#include "scene/error.h"
#include "scene/keys.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

void check_friction(const ReducedSettings &r) {
  if (r.mu_slow > r.mu_fast)
    throw InputError(fmt::format("reduced.mu_slow {} exceeds reduced.mu_fast {}", r.mu_slow, r.mu_fast));
  if (r.mu_slow != r.mu_fast && !(r.rate > 0))
    throw InputError(fmt::format("reduced.rate_s_per_m {} must be > 0 when reduced.mu_slow {} differs from "
                                 "reduced.mu_fast {}",
                                 r.rate, r.mu_slow, r.mu_fast));
}

void check_excitation(const Excitation &e, double lateral_capacity) {
  if (e.kind == ExcitationKind::record && e.x.values.empty() && e.y.values.empty() && e.z.values.empty())
    throw InputError("excitation.x needs a file: a record has x, y or z");
  if (e.kind == ExcitationKind::window && !(e.impact_speed() > 0))
    throw InputError(fmt::format("excitation.scale {} leaves a window no approach speed", e.scale));
  if (e.kind == ExcitationKind::push && !(e.scale > 0))
    throw InputError(fmt::format("excitation.scale {} must be > 0 for a push", e.scale));
  if (e.kind == ExcitationKind::free && !(e.start_displacement().norm() <= lateral_capacity))
    throw InputError(fmt::format("excitation.displacement_m starts at {} m, beyond the rim at L_c = {} m",
                                 e.start_displacement().norm(), lateral_capacity));
}

/// A prescribed path the sliding surface cannot follow is refused here, not by the surface in mid-run.
void check_path(const Scene &scene) {
  const auto &e = scene.excitation;
  const double limit = make_surface(scene.bearing.surface)->limit_radius();
  const auto refuse = [&](const char *key, double value, double reach) {
    if (reach < limit) return;
    throw InputError(
        fmt::format("excitation.{} {} takes the slider to {:.6g} m, past the sliding surface's end at {} m",
                    key, value, reach, limit));
  };
  const double reach = std::abs(e.scale) * e.amplitude;
  if (e.kind == ExcitationKind::cyclic) refuse("amplitude_m", e.amplitude, reach);
  if (e.kind == ExcitationKind::figure_eight) refuse("amplitude_m", e.amplitude, 1.25 * reach);
  if (e.kind == ExcitationKind::push)
    refuse("travel_mm", e.travel * 1e3, scene.bearing.lateral_capacity() + e.scale * e.travel);
}

} // namespace

void Scene::validate() const {
  bearing.validate();
  check_ranges(*this);
  check_friction(reduced);
  check_excitation(excitation, bearing.lateral_capacity());
  check_path(*this);
}

} // namespace rimpact::scene
