/// The forms that record files come in, one catalogue line each.
#pragma once
#include "records/sampled_signal.h"
#include <string>
#include <string_view>
#include <vector>

namespace rimpact {

/// What a header says besides numbers, as it writes it; empty: nothing.
struct RecordHead {
  std::string station;   ///< event and station: alike for the components of one recording, and no other's
  std::string direction; ///< see direction.h
};

/// One form of a file: whether a file is of it, and its reader, which gives m/s^2 and throws DataError naming file and
/// line. `ending` is the file's, in capitals with its dot.
struct RecordFormat {
  const char *name;
  bool (*is)(std::string_view text, const std::string &ending);
  SampledSignal (*parse)(const std::string &text, const std::string &path, double gravity); ///< of one channel
  RecordHead (*head)(std::string_view text) = nothing_said;                                 ///< the same; never throws
  std::vector<std::string_view> (*channels)(std::string_view text) = one_channel;           ///< at least one

  static RecordHead nothing_said(std::string_view) { return {}; }
  static std::vector<std::string_view> one_channel(std::string_view text) { return {text}; }
};

/// Tried in this order; the last one, AT2, takes what no other does.
const std::vector<RecordFormat> &record_formats();
/// Whether a file of a folder is a record, as its text's beginning and its ending say: AT2 files by their ending,
/// tables by their header, other forms by what they hold.
bool is_record_file(std::string_view beginning, const std::string &ending);

/// Whether a table's text, or its beginning, holds the header of a record (record_table.h).
bool has_record_header(const std::string &text, double gravity);
/// COSMOS V2 and CSMIP V2 (corrected accelerations): header blocks whose lengths their first lines tell, accelerations
/// in a unit that the line of counts names (cm/s^2, g, m/s^2). Numbers behind the values it promises are refused, and
/// so are CSMIP's raw accelerograms (V1) and spectra (V3). Velocity and displacement blocks behind it are not read.
SampledSignal parse_cosmos_v2(const std::string &text, const std::string &path, double gravity);
RecordHead head_of_cosmos(std::string_view text);
/// Parts that each begin with a head line "Corrected acceleration ...".
std::vector<std::string_view> channels_of_cosmos(std::string_view text);
/// GeoNet V1A and V2A: 16 lines of text, 10 of numbers, accelerations in mm/s^2 in columns of 8, as many and as large
/// as the header says; velocities and displacements behind them are not read.
SampledSignal parse_geonet(const std::string &text, const std::string &path, double gravity);
RecordHead head_of_geonet(std::string_view text);
std::vector<std::string_view> channels_of_geonet(std::string_view text);
bool opens_geonet(std::string_view line); ///< the first line of a component
/// ESM and ITACA ASCII: 64 lines KEY: VALUE, then one value a line in the unit of UNITS (cm/s^2 | m/s^2 | g), as many
/// as NDATA says and as large as PGA_CM/S^2 says (header_check.h).
SampledSignal parse_esm(const std::string &text, const std::string &path, double gravity);
RecordHead head_of_esm(std::string_view text);
/// K-NET and KiK-net ASCII: 17 lines, counts times the scale factor N(gal)/M less their mean; the sampling is in Hz.
/// Their number and peak are held against the header's.
SampledSignal parse_knet(const std::string &text, const std::string &path, double gravity);
/// Directions 1 to 3 of KiK-net are the borehole's, 4 to 6 the surface's: two stations.
RecordHead head_of_knet(std::string_view text);
/// PEER's second line: event, date, station, direction.
RecordHead head_of_at2(std::string_view text);
/// Records of PEER joined into one file, each with its four header lines.
std::vector<std::string_view> channels_of_at2(std::string_view text);

/// The names of keys that open a line, "KEY: VALUE" or fixed columns; the rest of the line, trimmed. Empty: no such
/// line among the first `n`.
std::string header_value(const std::vector<std::string_view> &lines, std::size_t n, std::string_view key);

/// Numbers from `first` on, several a line, until `expected` are there (0: to the end). Throws DataError naming line
/// and word that is none, or how many are missing. Columns of `width` characters that touch are told apart; 0: blanks
/// part. `next_line` gets the first line that was not read.
std::vector<double> read_values(const std::vector<std::string_view> &lines, std::size_t first, std::size_t expected,
                                std::size_t width, const std::string &path, std::size_t *next_line = nullptr);

/// Throws DataError where `line`, behind the values, holds nothing but numbers: the count or the data are wrong.
void refuse_numbers(const std::vector<std::string_view> &lines, std::size_t line, std::size_t npts,
                    const std::string &path);

/// The text from each line that opens a part to the next one; with fewer than two such lines all of it.
std::vector<std::string_view> parts_at(std::string_view text, bool (*opens)(std::string_view line));

} // namespace rimpact
