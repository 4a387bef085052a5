/// What a geometry study says.
#pragma once
#include "calibration/studies/geometry_study.h"

namespace rimpact::calibration {

GeometryStudy geometry_study(std::vector<GeometryRow> rows, const scene::Scene &window, const GeometryOptions &options);
nlohmann::json to_json(const GeometryStudy &study);
std::string to_csv(const GeometryStudy &study);
std::string describe(const GeometryStudy &study);

} // namespace rimpact::calibration
