/// A run's folder.
#pragma once
#include "responses/summary.h"

namespace rimpact {

/// Writes a whole run folder: scene.toml, response.h5, response.csv, summary.json. Creates it. Throws IoError.
void write_run_folder(const std::string &folder, const scene::Scene &scene, Response response, const Summary &summary);

} // namespace rimpact
