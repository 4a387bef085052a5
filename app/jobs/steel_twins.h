/// The twins of the main job's windows, with the other steel: the band between both, and the twins' own law.
#pragma once
#include "app/console/console.h"
#include "app/jobs/main_jobs.h"
#include "calibration/answer/steel_band.h"

namespace rimpact::app {

/// Whether a run is no twin, in the jobs' order.
std::vector<Job> without_twins(const std::vector<Job> &jobs);
/// From the summaries of the windows and their twins that ended well; none: no pair of them did.
std::optional<calibration::SteelBand> steel_band(const MainTarget &target, const std::vector<Job> &jobs);
/// Fits the answer's law to the twins into DIR/calibration/FOLDER, which the band names; it names none, and the console
/// is told why, where no law could be fitted.
void fit_twins(const std::vector<Job> &jobs, const std::string &law, const std::string &calibration,
               calibration::SteelBand &band, Console &console);

} // namespace rimpact::app
