#include "app/verbs/catalogue.h"

#include "app/verbs/fe_verb_texts.h"

namespace rimpact::app {
namespace {

// Shown in --help here; main_light.cc hands them over before it parses.
constexpr Verb run_shown{text_of_run}, mesh_shown{text_of_mesh}, curve_shown{text_of_curve};

constexpr const Verb *verbs[] = {&main_verb,    &new_verb,       &check_verb,       &motion_verb,     &design_verb,
                                 &reduced_verb, &building_verb,  &reliability_verb, &run_shown,       &mesh_shown,
                                 &curve_shown,  &calibrate_verb, &compare_verb,     &geometry_verb,   &design_page_verb,
                                 &study_verb,   &report_verb,    &export_verb,      &references_verb, &thesis_verb,
                                 &list_verb,    &help_verb,      &completion_verb,  &version_verb};

} // namespace

std::span<const Verb *const> light_verbs() {
  return verbs;
}

} // namespace rimpact::app
