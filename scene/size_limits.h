/// Bounds on what a scene would store: settings that are each in their range may together ask for more than a machine
/// has.
#pragma once

namespace rimpact::scene {

struct Scene;

inline constexpr int instants_a_cycle = 2000; ///< of a slow path by the reduced models

/// Throws InputError where the samples between contacts alone would be more than some millions.
void check_sizes(const Scene &scene);

} // namespace rimpact::scene
