/// Recordings of a folder whose spectra fit a target's, and their scale factors.
#pragma once
#include "io/records/record_folder.h"
#include "io/records/target_spectrum.h"
#include <vector>

namespace rimpact {

struct SelectionRules {
  std::size_t count = 7;       ///< recordings, one a station
  double period = 1;           ///< T of the structure [s]
  double from = 0.2, to = 1.5; ///< of T: where spectra are compared
  double largest_scale = 5;    ///< factors beyond it, or below its inverse, are not taken
  double least_share = 0.9;    ///< of the target that the mean must nowhere be below
};

/// One recording: two horizontal components under one factor.
struct SelectedRecording {
  std::string station, x, y; ///< y empty: a component alone
  double factor = 1;
  double misfit = 0;                 ///< standard deviation of ln(target / spectrum) over the range, once scaled
  std::vector<double> spectrum = {}; ///< S_a [g] at RecordSelection::periods, scaled
};

struct RecordSelection {
  std::vector<double> periods, target, mean; ///< [s], [g], [g]; even in the logarithm
  std::vector<SelectedRecording> recordings; ///< by misfit
  double common = 1;                         ///< factor that all of them have besides their own
  std::size_t n_candidates = 0;
  std::vector<std::string> doubts = {};
};

/// Each pair of a folder (where it has none, each component) by its spectrum: of the largest direction, max of
/// |(u_x, u_y)|, or of the geometric mean of both, as the target is meant. Its factor makes the mean of
/// ln(target / spectrum) zero over the range; the `count` of least misfit are taken. Then all are scaled by one factor,
/// >= 1, so that their mean is nowhere below `least_share` of the target (ASCE/SEI 7-22, 16.2.3.2; EN 1998-1,
/// 3.2.3.1.2). Throws InputError where fewer than `count` are at hand.
RecordSelection select_records(const RecordFolder &folder, const TargetSpectrum &target, const SelectionRules &rules);

} // namespace rimpact
