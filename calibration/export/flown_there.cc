#include "calibration/export/flown_there.h"

#include <fmt/format.h>

namespace rimpact::calibration {

std::string FlownThere::sentence() const {
  return fmt::format("Flown in {} by rimpact's tests, files like this one, in Tcl and in Python: the springs of every "
                     "law, at five speeds "
                     "and a second time, within {:.2g} % of the self-check; the whole bearing of the built-in case "
                     "(windows, both pulses, a "
                     "load that varies, a motion in two directions) within {:.2g} % of the self-check, {:.2g} % of the "
                     "reduced model and "
                     "{:.2g} % of finite elements in touch speed and peak force. This very file was not flown there.",
                     program, 100 * springs, 100 * bearing, 100 * model, 100 * solids);
}

} // namespace rimpact::calibration
