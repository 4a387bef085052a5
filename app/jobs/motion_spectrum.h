/// `rimpact motion ... --spectrum DIR`: response spectra of records.
#pragma once
#include "app/console/console.h"
#include "app/words/motion_table.h"

namespace rimpact::app {

/// FOLDER/spectrum.csv, a row for each record and each of 61 periods from 0.05 to 10 s, even in the logarithm: S_a with
/// 5 % damping, RotD50 and RotD100 of its pair (empty where there is none), and that of `target` (target_spectrum.h;
/// empty: none); and FOLDER/spectrum.png. Throws InputError for a target that is not understood, IoError.
void write_spectra(const std::vector<MotionRow> &rows, const std::string &target, const std::string &folder,
                   Console &console);

} // namespace rimpact::app
