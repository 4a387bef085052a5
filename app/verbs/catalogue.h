/// The verbs, in the order of --help.
#pragma once
#include "app/console/verb.h"
#include <span>

namespace rimpact::app {

extern const Verb main_verb, new_verb, check_verb, motion_verb, design_verb, reduced_verb, building_verb,
    reliability_verb, calibrate_verb, compare_verb, geometry_verb, design_page_verb, study_verb, report_verb,
    export_verb, references_verb, thesis_verb, list_verb, help_verb, completion_verb, version_verb;
extern const Verb run_verb, mesh_verb, curve_verb; ///< of the finite-element program

std::span<const Verb *const> light_verbs(); ///< of the light program, which shows the others' names

} // namespace rimpact::app
