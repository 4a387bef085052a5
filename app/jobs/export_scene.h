/// The bearing that an export writes beside its rim: found, checked against the calibration, loaded as the files are.
#pragma once
#include "app/console/console.h"
#include "calibration/export/dish.h"
#include "calibration/export/exported_rim.h"

namespace rimpact::app {

struct ExportOptions {
  std::string folder, out, law, scene;
  std::optional<double> mass, load; ///< [kg], [kN]
  bool opensees = false, sap2000 = false, etabs = false, csv = false, dxf = false;
  /// Whether what only a calibration has is asked for, beside files for OpenSees.
  bool asks_a_calibration() const { return sap2000 || etabs || csv || !law.empty() || mass || load || !scene.empty(); }
  bool anyway = false; ///< the whole bearing also where its self-check refuses it
};

struct ExportScene {
  scene::Scene scene;
  calibration::Dish dish;
};
/// None: it is not known. Of this rim by its identity; it carries the load of `rim`, with the calibration's terms of
/// pad and socket. What these do is said in the rim's statement, and the speed its springs are tuned to is set.
std::optional<ExportScene> export_scene(const ExportOptions &options, const scene::StoredCalibration &calibration,
                                        calibration::ExportedRim &rim, Console &console);

} // namespace rimpact::app
