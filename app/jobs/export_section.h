/// `rimpact export BEARING --dxf`: the section of a bearing as it is drawn, for which no calibration is needed.
#pragma once
#include "app/jobs/export_scene.h"

namespace rimpact::app {

/// Of the bearing, scene or case folder options.folder into section.dxf. Throws InputError for what needs a calibration
/// too, and for a triple pendulum, which has no such section.
void export_section(const ExportOptions &options, const std::vector<std::string> &head, Console &console);

} // namespace rimpact::app
