/// The rim's law and its numbers from a calibration folder, in the place of a scene's own.
#pragma once
#include "io/files/toml_reader.h"
#include "scene/bearing.h"
#include "scene/keys.h"
#include "scene/stack_terms.h"

namespace rimpact::scene {

/// Keys of [reduced] that make the rim's element.
const std::vector<std::string> &element_keys();

/// Where the file has reduced.calibration, puts the folder's law, numbers, range, mass and rim in the place of
/// reduced.*, for the reader to find: those of calibration.json's `answer`, or of calibration.toml where there is none.
/// `folder`: the folder is sought beside it. A key typed with --set stays and is remarked upon. An element's key in the
/// file itself is an InputError, or, where the calibration was given on the command line, is replaced with a remark.
/// Throws DataError for a calibration that cannot be read.
/// The terms of pad and socket that the calibration carries come with it (adopt_stack_terms).
TakenTerms adopt_calibration(TomlFile &file, const std::string &folder, const Bearing &bearing,
                             std::vector<std::string> &remarks);

/// Law and numbers typed with --set; to be asked before adopt_calibration.
std::vector<std::string> typed_element_keys(const TomlFile &file);
/// After reading: an element that was changed by hand has no origin, range, mass or rim any more.
void forget_origin(const std::vector<std::string> &typed, ReducedSettings &reduced, std::vector<std::string> &remarks);

} // namespace rimpact::scene
