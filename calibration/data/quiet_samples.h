/// What a record's force channel says where the rim is not touched: its zero, its noise, what a drift leaves.
#pragma once
#include "calibration/data/contact_detector.h"

namespace rimpact::calibration {

inline constexpr std::size_t few_quiet = 8; ///< samples below which quiet says nothing

double mean_of(const std::vector<double> &values, std::size_t n); ///< of the first n; 0 of none

/// Samples that surely come before the first contact: up to a fifth of the largest force, less a fifth of them.
std::size_t quiet_beginning(const std::vector<double> &x, const std::vector<double> &y);

/// Noise before any contact is known, into `record`: by neighbours, or, of errors that a filter has made alike or that
/// hum, by what the beginning scatters about a straight line. In a record that begins at its touch that line is the
/// force's own rise.
void first_noise(ContactRecord &record, std::size_t beginning);

/// Noise, zero and what is left over, taken anew from the samples outside the record's contacts. `x`, `y`: the force
/// channels [N]. Leaves the record as it was where fewer than few_quiet are quiet.
void measure_quiet(ContactRecord &record, const std::vector<double> &x, const std::vector<double> &y);

} // namespace rimpact::calibration
