/// What `rimpact main` is asked about: a bearing under its load.
#pragma once
#include "app/jobs/given_case.h"

namespace rimpact::app {

/// A bearing under its load, for runs of the verb's own motions: the scene's bearing, load, [model] and [reduced].
struct MainTarget : GivenCase {
  std::vector<std::string> remarks; ///< what of the scene is not run
};

/// Of what given_case() takes. The rung is `rim` unless the file or an override asks for another. Throws InputError for
/// a motion or a name given by --set, for a bearing of rigid bodies and a building.
MainTarget main_target(const std::string &where, const std::vector<std::string> &overrides);
/// Whether the key says what an element was fitted to: reference runs carry none of it.
bool is_of_a_fit(const std::string &key);
/// Why verbs that run finite elements do not read [bounds].
extern const char *const bounds_are_reduced;
/// Throws InputError for a bearing of rigid bodies or a building.
void require_bearing_under_rigid_mass(const scene::Scene &scene, const std::string &verb);
/// Throws InputError for a slider whose halves slide on one another: a law of a rim does not know them.
void require_slider_of_one_piece(const scene::Scene &scene, const std::string &verb);
/// The rung is `rim` unless the file or an override asks for another.
void take_rung(GivenCase &given, const std::vector<std::string> &overrides);

} // namespace rimpact::app
