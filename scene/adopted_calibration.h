/// A calibration's element in the place of a scene's own.
#pragma once
#include "io/files/toml_reader.h"
#include "scene/bearing.h"
#include "scene/impact_element.h"
#include "scene/stack_terms.h"

namespace rimpact::scene {

/// Where the file has reduced.calibration, puts the folder's law, numbers, range, mass and rim in the place of
/// reduced.*, for the reader to find. `folder`: the calibration is sought beside it. A key typed with --set stays and
/// is remarked upon. An element's key in the file itself is an InputError, or, where the calibration was given on the
/// command line, is replaced with a remark. Throws DataError for a calibration that cannot be read.
/// The terms of pad and socket that the calibration carries come with it (adopt_stack_terms).
TakenTerms adopt_calibration(TomlFile &file, const std::string &folder, const Bearing &bearing,
                             std::vector<std::string> &remarks);
/// The same of isolator.inner.rims.calibration, one rim's law and what it is known for. Throws InputError where the
/// model is no triple pendulum, or the file says that its inner rims have no law of their own.
void adopt_inner_calibration(TomlFile &file, const std::string &folder, std::vector<std::string> &remarks);
/// Throws InputError where inner rims are to have their own law, and no stiffness is given: after adoption.
void require_inner_element(const TomlFile &file);

/// Law and numbers of a section typed with --set; to be asked before its calibration is adopted.
std::vector<std::string> typed_element_keys(const TomlFile &file, const std::string &section);
/// After reading: whether they changed a calibrated element, which then has no origin, range, mass or rim any more.
bool is_changed_by_hand(const std::vector<std::string> &typed, const ImpactElement &element,
                        std::vector<std::string> &remarks);

} // namespace rimpact::scene
