/// `rimpact motion FOLDER --select N --target ...` and `--strike ... --rotated DIR`: what is made of a folder's pairs.
#pragma once
#include "app/console/console.h"
#include "io/records/record_folder.h"
#include "io/records/record_selection.h"

namespace rimpact::app {

struct SelectionOptions {
  SelectionRules rules = {.count = 0}; ///< count 0: no selection is asked for
  std::string target, folder;          ///< folder: of the results
};

/// Selects, writes selection.csv, spectrum.csv, spectrum.png and sweep.toml into the folder, and says what it did.
void select_motions(const RecordFolder &folder, const SelectionOptions &options, Console &console);

/// A record as a table that every verb reads.
std::string acceleration_csv(const SampledSignal &record);

/// Writes STATION-FN.csv and STATION-FP.csv of every pair into `out`; a pair that cannot be turned is told.
void rotate_motions(const RecordFolder &folder, double strike, const std::string &out, Console &console);

} // namespace rimpact::app
