/// Ground-motion records: PEER AT2 files, CSV files and built-in ones. Accelerations are returned in m/s^2.
#pragma once
#include "io/records/record_units.h"
#include "io/records/sampled_signal.h"
#include <string>
#include <vector>

namespace rimpact {

/// Standard gravity [m/s^2], for records read outside a scene; a scene uses its own load.gravity_m_per_s2.
inline constexpr double standard_gravity = 9.80665;

/// No ground moves faster than this, in units of gravity: a larger value is a slip of units or of the file.
inline constexpr double largest_acceleration = 100;

/// Longest step of a record whose header states it [s]: a longer one is a slip of units.
inline constexpr double longest_step = 1;

/// What is in a record (verb `motion`). Velocity and displacement by exact integration of the piecewise linear
/// acceleration from rest, without baseline correction. Arias = pi/(2g) int a^2 dt (trapezoidal); D5-95 between its 5
/// and 95 %.
struct RecordInfo {
  std::size_t npts;
  double dt;       ///< [s]
  double pga_g;    ///< largest |a| [g]
  double pgv, pgd; ///< [m/s], [m]
  double arias;    ///< [m/s]
  double duration; ///< significant duration D5-95 [s]
};

/// Reads `path` ("builtin:NAME": a built-in record; any form of record_format.h, told by the file; "FILE#3": its third
/// channel; "FILE.zip/NAME": of an archive, record_file.h). A file of several channels is refused without one. A unit
/// that records.csv beside it states takes the place of its header's.
/// Throws DataError naming file and line: missing file, velocity or displacement, fewer values than NPTS, dt <= 0,
/// values that are not finite or beyond largest_acceleration.
SampledSignal read_record(const std::string &path, double gravity = standard_gravity);
/// The same from a file's text.
SampledSignal parse_record(const std::string &text, const std::string &path, const ReadAs &as);
RecordInfo inspect(const SampledSignal &record, double gravity = standard_gravity);

/// Throws DataError, naming `where`, for an acceleration [m/s^2] beyond largest_acceleration.
void require_plausible(double acceleration, double gravity, const std::string &where);

/// The two forms from text; `path` is for messages only.
/// AT2: 4 header lines as PEER writes them (old and new), NPTS and DT in any spelling met in practice.
SampledSignal parse_at2(const std::string &text, const std::string &path, const ReadAs &as);
/// CSV, uniformly sampled, starting at any instant >= 0, which it keeps; columns by record_table.h, any of comma,
/// semicolon and tab between cells, decimal commas, UTF-8, UTF-16 or Latin-1, remarks above the header, text below the
/// rows. Refused: two columns of one quantity without a direction each, more or fewer cells than columns, instants
/// before 0.
SampledSignal parse_record_csv(const std::string &text, const std::string &path, const ReadAs &as);

} // namespace rimpact
