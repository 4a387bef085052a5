#include "responses/frame_limits.h"

#include <fmt/format.h>

namespace rimpact {

std::optional<std::string> doubt_of_frame(std::optional<double> ductility, std::optional<double> drift) {
  if (!is_beyond_frame(ductility, drift)) return std::nullopt;
  std::string reached;
  if (ductility) reached = fmt::format("a ductility of {:.3g} (doubted above {:g})", *ductility, most_ductility);
  if (drift)
    reached += fmt::format("{}a drift of {:.3g} m (above {:g} m)", ductility ? " and " : "", *drift, most_drift);
  return "the frame reaches " + reached +
         ", assumed bounds: its law loses no strength by cycles, so that it stands "
         "where a real one may have collapsed";
}

} // namespace rimpact
