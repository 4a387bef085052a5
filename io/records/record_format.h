/// The forms that record files come in, one catalogue line each.
#pragma once
#include "io/records/record_units.h"
#include "io/records/sampled_signal.h"
#include <string>
#include <string_view>
#include <vector>

namespace rimpact {

/// What a header says besides numbers, as it writes it; empty: nothing.
struct RecordHead {
  std::string station;         ///< event and station: alike for the components of one recording, and no other's
  std::string direction;       ///< see direction.h
  std::string instrument = {}; ///< of several of one file: its components are a station of their own
};

/// One of the components that a file holds: a part of its text, or a column of all of it.
struct Channel {
  std::string_view text;
  std::size_t column = 0; ///< of a table's accelerations, from 0; else 0
};

/// One form of a file: whether a file is of it, and its reader, which gives m/s^2 and throws DataError naming file and
/// line. `ending` is the file's, in capitals with its dot.
struct RecordFormat {
  const char *name;
  bool (*is)(std::string_view text, const std::string &ending);
  SampledSignal (*parse)(const std::string &text, const std::string &path, const ReadAs &as); ///< of one channel
  RecordHead (*head)(const Channel &channel) = nothing_said;             ///< the same; never throws
  std::vector<Channel> (*channels)(std::string_view text) = one_channel; ///< at least one; never throws

  static RecordHead nothing_said(const Channel &) { return {}; }
  static std::vector<Channel> one_channel(std::string_view text) { return {{text}}; }
};

/// Tried in this order; the last one, AT2, takes what no other does.
const std::vector<RecordFormat> &record_formats();
/// Whether a file of a folder is a record, as its text's beginning and its ending say: AT2 files by their ending,
/// tables by their header, other forms by what they hold.
bool is_record_file(std::string_view beginning, const std::string &ending);

/// Whether a table's text, or its beginning, holds the header of a record (record_table.h).
bool has_record_header(const std::string &text, double gravity);
/// The accelerations of a table that has several, each named by its direction.
std::vector<Channel> channels_of_csv(std::string_view text);
RecordHead head_of_csv(const Channel &channel);
/// JMA (Japan Meteorological Agency): CSV with SITE CODE, SAMPLING RATE, UNIT and INITIAL TIME above columns of NS, EW
/// and UD; their mean, the instrument's offset, is taken off.
SampledSignal parse_jma(const std::string &text, const std::string &path, const ReadAs &as);
RecordHead head_of_jma(const Channel &channel);
std::vector<Channel> channels_of_jma(std::string_view text);
/// SMC (USGS): 11 lines of text, 48 integers, 50 reals, remarks, then as many accelerations in cm/s^2 as the 17th
/// integer says, at the samples per second of the 2nd real. Velocity, displacement and spectra are refused.
SampledSignal parse_smc(const std::string &text, const std::string &path, const ReadAs &as);
RecordHead head_of_smc(const Channel &channel);
/// CSMIP V1 (uncorrected accelerograms): pairs of time and acceleration in columns of 7, or accelerations at even
/// instants under a line of counts as in V2. Instants at unequal steps are refused.
SampledSignal parse_csmip_raw(const std::string &text, const std::string &path, const ReadAs &as);
/// COSMOS V2 and CSMIP V2 (corrected accelerations): header blocks whose lengths their first lines tell, accelerations
/// in a unit that the line of counts names (cm/s^2, g, m/s^2). Numbers behind the values it promises are refused, a
/// peak that the header tells is held against them (header_check.h), and spectra (V3) are refused. Velocity and
/// displacement blocks behind it are not read.
SampledSignal parse_cosmos_v2(const std::string &text, const std::string &path, const ReadAs &as);
RecordHead head_of_cosmos(const Channel &channel);
/// Parts that each begin with a head line "Corrected acceleration ...".
std::vector<Channel> channels_of_cosmos(std::string_view text);
/// GeoNet V1A and V2A: 16 lines of text, 10 of numbers, accelerations in mm/s^2 in columns of 8, as many and as large
/// as the header says; velocities and displacements behind them are not read.
SampledSignal parse_geonet(const std::string &text, const std::string &path, const ReadAs &as);
RecordHead head_of_geonet(const Channel &channel);
std::vector<Channel> channels_of_geonet(std::string_view text);
bool opens_geonet(std::string_view line); ///< the first line of a component
/// ESM and ITACA ASCII: 64 lines KEY: VALUE, then one value a line in the unit of UNITS (cm/s^2 | m/s^2 | g), as many
/// as NDATA says and as large as PGA_CM/S^2 says (header_check.h).
SampledSignal parse_esm(const std::string &text, const std::string &path, const ReadAs &as);
RecordHead head_of_esm(const Channel &channel);
/// K-NET and KiK-net ASCII: 17 lines, counts times the scale factor N(gal)/M less their mean; the sampling is in Hz.
/// Their number and peak are held against the header's.
SampledSignal parse_knet(const std::string &text, const std::string &path, const ReadAs &as);
/// Directions 1 to 3 of KiK-net are the borehole's, 4 to 6 the surface's: two stations.
RecordHead head_of_knet(const Channel &channel);
/// PEER's second line: event, date, station, direction.
RecordHead head_of_at2(const Channel &channel);
/// Records of PEER joined into one file, each with its four header lines.
std::vector<Channel> channels_of_at2(std::string_view text);

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
std::vector<Channel> parts_at(std::string_view text, bool (*opens)(std::string_view line));

} // namespace rimpact
