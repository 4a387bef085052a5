#include "scene/size_limits.h"

#include "files/error.h"
#include "scene/scene.h"
#include <fmt/format.h>

namespace rimpact::scene {

void check_sizes(const Scene &scene) {
  constexpr double most = 4e6; // instants, some 25 numbers each: 0.8 GB
  const double instants = scene.excitation.is_dynamic() ? scene.excitation.duration / scene.reduced.output_step : 0;
  if (instants > most)
    throw InputError(fmt::format("reduced.output_step_ms {:g} would store {:.2g} instants over excitation.duration_s "
                                 "{:g}; at most {:.2g} are kept: {:g} or more",
                                 1e3 * scene.reduced.output_step, instants, scene.excitation.duration, most,
                                 1e3 * scene.excitation.duration / most));
}

} // namespace rimpact::scene
