/// The signals of one test from the tables of a mapping: rows chosen, units turned to SI, channels with a clock of
/// their own brought to the clock of `time`.
#pragma once
#include "calibration/data/mapping.h"

namespace rimpact::calibration {

struct Channels {
  Response response;              ///< the mapped signals, SI, at the instants of `time`
  std::string unit_of_force;      ///< as declared or found, of the rim's force
  std::vector<std::string> notes; ///< what the tables were read by
};

/// Channels with a clock of their own are taken at the instants of `time` along straight lines between their samples;
/// instants that one of them does not cover are left out. Throws InputError (a unit of another kind, or none) and
/// DataError (a column that is missing, time that runs back, cells that are no numbers), naming file, line or column.
Channels read_channels(const Mapping &mapping, const TestPart &part);

/// Names of the tests: [test.NAME] as the file lists them, else what test_column says, in order of appearance; none:
/// the file is one test.
std::vector<std::string> tests_of(const Mapping &mapping);

/// Values over strictly rising `times`, along straight lines, at `at`; within the first and the last of `times`.
std::vector<double> on_clock(const std::vector<double> &times, const std::vector<double> &values,
                             const std::vector<double> &at);

} // namespace rimpact::calibration
