#include "scene/size_limits.h"

#include "io/files/error.h"
#include "scene/scene.h"
#include <fmt/format.h>

namespace rimpact::scene {

void check_sizes(const Scene &scene) {
  constexpr double most = 4e6; // instants, some 25 numbers each: 0.8 GB
  const auto &e = scene.excitation;
  if (!e.is_dynamic() && instants_a_cycle * e.rounds() > most)
    throw InputError(fmt::format("excitation: {:g} cycles would store {:.2g} instants; at most {:g} cycles are kept",
                                 e.rounds(), instants_a_cycle * e.rounds(), most / instants_a_cycle));
  const double instants = e.is_dynamic() ? e.duration / scene.reduced.output_step : 0;
  if (instants > most)
    throw InputError(fmt::format("reduced.output_step_ms {:g} would store {:.2g} instants over excitation.duration_s "
                                 "{:g}; at most {:.2g} are kept: {:g} or more",
                                 1e3 * scene.reduced.output_step, instants, e.duration, most, 1e3 * e.duration / most));
}

} // namespace rimpact::scene
