/// Contacts in a measured record, whose force is never exactly zero: found against the noise the record itself shows.
///
/// p is the radial push of the rim, inwards > 0, freed of the cell's zero; pbar its mean over m neighbouring samples (m
/// odd, 1 to 15, a fifteenth of the samples that bear half the peak), so that the noise of pbar is s = sigma
/// sqrt(min(1, tau / m)), where tau says how the errors of neighbouring samples hang together (data/sample_noise.h). A
/// contact holds at least three samples in succession beyond the threshold max(5 s, share of the peak); it reaches on
/// both sides to where |pbar| falls below 5 s, and ends where the slider is clearly inside its touch. Neighbours closer
/// than 0.35 of the earlier one's length are one contact: a force that changes its sign passes through zero. A contact
/// whose impulse is within 5 standard errors of none is none. Samples are not altered: thresholds find contacts and
/// nothing else.
#pragma once
#include "responses/response.h"
#include <string>
#include <vector>

namespace rimpact::calibration {

struct Contact {
  std::size_t first, last;         ///< samples
  double touch_time, release_time; ///< [s]: within the step by which the force jumps; else followed back, and on,
                                   ///< through what the threshold hides
  bool jumps;                      ///< the force sets in with a step that no noise makes
  double impulse, impulse_error;   ///< [N s], its standard error by the noise of the force
};

struct ContactRecord {
  std::vector<Contact> contacts;
  std::vector<double> push;   ///< p [N], all samples
  std::vector<double> smooth; ///< pbar [N]
  double sigma = 0; ///< noise of one sample of p [N]: root mean square in quiet, at least that of its digits; 0 for a
                    ///< record without noise
  double inflation = 1; ///< tau: variance of an average of many quiet samples over that of independent ones, >= 1
  double left_over = 0; ///< reading in quiet after the last contact less that before the first [N]; 0: too few samples
  double zero_x = 0, zero_y = 0; ///< the cell's reading in quiet [N], taken off where it is beyond 4 standard errors
  double threshold = 0;          ///< [N]
  double peak = 0;               ///< largest |pbar| [N]
  int n_quiet = 0;               ///< samples that sigma stands on; 0: differences of neighbours
  std::vector<std::string> notes;
};

/// `share` of the peak, 0..0.5: below it nothing counts as a contact, whatever the noise. Needs time, displacement_x|y,
/// impact_x|y.
ContactRecord find_contacts(const Response &response, double share);

} // namespace rimpact::calibration
