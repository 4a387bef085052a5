/// The ground motions of a study: for each level of intensity the record files and their scale.
#pragma once
#include "studies/risk/study.h"

namespace rimpact::risk {

struct Motion {
  std::string file;      ///< absolute
  std::string record;    ///< what is drawn together in the bootstrap: RSN and number, or the station
  double scale = 1;      ///< of the acceleration
  double over_level = 1; ///< scale x S_a / level
  std::size_t line = 0;  ///< of the table, 0: none
};

struct MotionLevel {
  double intensity_g = 0, return_period_years = 0;
  int n_listed = 0; ///< rows of the table, or records of the folders
  std::vector<Motion> motions = {};
};

struct Motions {
  std::vector<MotionLevel> levels;  ///< growing, those without a record left out
  std::vector<std::string> missing; ///< sentences: rows without a record, and why
  std::vector<std::string> doubts;  ///< sentences: levels without records, factors that miss their level
};

/// Scaled by its printed factor a component meets its level within this, or within the factor's last of two digits.
inline constexpr double level_tolerance = 0.02, factor_rounding = 0.005;

/// Reads the table and the records. `folders`: besides the study's. With ComponentRule::nearest a row takes that of its
/// record's horizontal components which meets the level best; where a level lists a record twice the rows are its two
/// components. A record of which one component is at hand counts only where that one meets the level.
/// Throws DataError, naming file and line: a factor that is not > 0, a component twice at one level, a level that the
/// hazard or the file cannot give, a damaged record. Throws InputError where no level has a record.
Motions motions_of(const Study &study, const std::vector<std::string> &folders);

} // namespace rimpact::risk
