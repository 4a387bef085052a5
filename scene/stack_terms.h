/// What pad and socket add to the physical model of a bearing: the pad's finite size and its spring below the mass, the
/// socket's friction, and the travel over which the pad, in shear, builds up the friction of its face. A calibration
/// carries them, because the bearing it was made for has them; the impact element is fitted beside them.
#pragma once
#include "io/files/choice.h"
#include "io/files/toml_reader.h"
#include "scene/scene.h"

namespace rimpact::scene {

/// Keys of [reduced] that switch them on.
const std::vector<std::string> &stack_keys();

/// Travel over which the pad builds up the friction mu N of its face: mu N t / (G A) [m], 0.14 mm by default. A slider
/// that turns round keeps its old friction for some milliseconds; on a pulse that is 5 to 20 % of the touch speed.
/// 0 between two dishes, where there is no pad.
double pad_elastic_slip(const Bearing &bearing, double normal_force, double mu);

/// Whence a calibration has its elastic slip.
enum class SlipFrom { bearing, fit };
constexpr auto choices(SlipFrom) {
  return choices_of<SlipFrom>({{SlipFrom::bearing, "bearing", "the bearing's own, under its load"},
                               {SlipFrom::fit, "fit", "fitted, or held in the fit"}});
}

/// Of the pad pressed between mass and dish, E A / t [N/m]: free to bulge, as a layer that shares its face with the
/// dish. Of a slider between two dishes, which has no pad: of its steel from face to face.
double pad_stiffness(const Bearing &bearing);

/// Retardation of the pad [s], 0 where it loses nothing: its dashpot is theta times its spring, so that a mass which
/// swings on it at omega = sqrt(k / m), 18 Hz by default, meets its loss factor eta = theta omega, a damping ratio of
/// eta / 2. As any dashpot's, the loss grows with the frequency.
double pad_retardation(const Scene &scene);

/// As a calibration writes them.
struct StackTerms {
  std::map<std::string, std::string> values; ///< by key of [reduced], in TOML
  SlipFrom slip_from = SlipFrom::bearing;
};

/// Of a file that names a calibration. What is typed with --set stays; what
/// the file has stays beside a calibration that the file names, and is replaced, with a remark, by one that is typed.
struct TakenTerms {
  std::vector<std::string> keys; ///< now in the file
  bool bearings_slip = false;    ///< among them is the slip that the bearing itself has
};
TakenTerms adopt_stack_terms(TomlFile &file, const StackTerms &terms, bool calibration_is_typed,
                             std::vector<std::string> &remarks);
/// After reading: terms that were taken are left out, with a remark, where the bearing's pad and foot do not fit it.
void leave_out_what_does_not_fit(Scene &scene);
/// After the load is known: an elastic slip that was taken becomes that of this bearing under this load.
void resolve_elastic_slip(Scene &scene);

} // namespace rimpact::scene
