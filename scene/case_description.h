/// What a scene is, in four lines: bearing, load, motion and impact element, with where its numbers come from.
#pragma once
#include "scene/scene.h"
#include <nlohmann/json.hpp>

namespace rimpact::scene {

/// "bearing: ...\nload: ...\nmotion: ...\nimpact element: ...\n"; a load that is not read is left out. A line more has
/// a triple pendulum whose inner rims have their own element.
std::string describe_case(const Scene &scene, bool load_is_read = true);
/// "load: W = ... kN, m = ... kg (W = ... m g)\n", and that it is an assumption where nobody gave it.
std::string load_sentence(const Scene &scene);
/// "rim 60 mm high, 40 mm thick": the one order in which a rim's dimensions are said.
std::string rim_in_words(const Bearing &bearing);
/// "rim's foot: ...\n": what holds the rim on its plate; of a rim in one piece with it, that the solids assume so.
std::string foot_sentence(const Bearing &bearing);
/// The joint at the foot of the scene's rims, in the words of its strength: of rigid bodies, whose plates have no rim
/// of the bearing's, the calibration's. Empty: one piece with the plate, or not known.
std::string joint_at_foot(const Scene &scene);
/// The impact element alone: its law, numbers and where they come from.
std::string element_line(const Scene &scene);
/// That of a triple pendulum's inner rims; empty: they have the same one.
std::string inner_element_line(const Scene &scene);
/// The same as `load`, `motion` and `impact_element` (law, every number of it, source, fitted_from_m_per_s,
/// fitted_to_m_per_s, fitted_mass_kg, foot_force_kN, fitted_rim: null where not known).
nlohmann::json case_json(const Scene &scene);

} // namespace rimpact::scene
