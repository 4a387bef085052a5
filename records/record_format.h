/// The forms that record files come in, one catalogue line each.
#pragma once
#include "records/sampled_signal.h"
#include <string>
#include <string_view>
#include <vector>

namespace rimpact {

/// One form of a file: whether a file is of it, and its reader, which gives m/s^2 and throws DataError naming file and
/// line. `ending` is the file's, in capitals with its dot.
struct RecordFormat {
  const char *name;
  bool (*is)(std::string_view text, const std::string &ending);
  SampledSignal (*parse)(const std::string &text, const std::string &path, double gravity);
};

/// Tried in this order; the last one, AT2, takes what no other does.
const std::vector<RecordFormat> &record_formats();

/// COSMOS V2 (corrected accelerations): header blocks whose lengths their first lines tell, accelerations in a unit
/// that the line of counts names (cm/s^2, g, m/s^2). One channel a file; velocity and displacement blocks behind it are
/// not read.
SampledSignal parse_cosmos_v2(const std::string &text, const std::string &path, double gravity);
/// ESM and ITACA ASCII: 64 lines KEY: VALUE, then one value a line in the unit of UNITS (cm/s^2 | m/s^2 | g).
SampledSignal parse_esm(const std::string &text, const std::string &path, double gravity);
/// K-NET and KiK-net ASCII: 17 lines, counts times the scale factor N(gal)/M less their mean; the sampling is in Hz.
SampledSignal parse_knet(const std::string &text, const std::string &path, double gravity);

/// The names of keys that open a line, "KEY: VALUE" or fixed columns; the rest of the line, trimmed. Empty: no such
/// line among the first `n`.
std::string header_value(const std::vector<std::string_view> &lines, std::size_t n, std::string_view key);

/// Numbers from `first` on, several a line, until `expected` are there (0: to the end). Throws DataError naming line
/// and word that is none, or how many are missing. Columns of `width` characters that touch are told apart; 0: blanks
/// part.
std::vector<double> read_values(const std::vector<std::string_view> &lines, std::size_t first, std::size_t expected,
                                std::size_t width, const std::string &path);

} // namespace rimpact
