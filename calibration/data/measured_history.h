/// Histories of a measured record, made ready to be compared with a model's.
#pragma once
#include "calibration/data/measured_record.h"

namespace rimpact::calibration {

/// Leaves in the response the rim's force of contacts only, freed of the cell's zero.
void keep_contacts_only(Response &response, const ContactRecord &record);

/// Velocities where none are measured: slopes that reach across no touch or release, and at these the speeds of the
/// flights. Differences of neighbouring samples would be noise.
void complete_velocities(StoredRun &run, const MeasuredRecord &record);

/// The same of a quasi-static path, which has no contacts: plain differences.
void differentiate_path(Response &response);

} // namespace rimpact::calibration
