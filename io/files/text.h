/// Small text helpers of the readers: trimming, numbers, nearest names.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rimpact {

std::string_view trim(std::string_view text);
std::string upper(std::string_view text);
/// Splits at every `separator`, keeping empty parts.
std::vector<std::string_view> split(std::string_view text, char separator);
/// Lines without their ends; LF, CRLF and CR are accepted, a UTF-8 byte-order mark is dropped.
std::vector<std::string_view> lines_of(std::string_view text);

/// The whole of `text` as a number (blanks around allowed); nullopt otherwise. May return inf or NaN.
std::optional<double> to_number(std::string_view text);

/// "2000,5" with the point that TOML wants, "2000.5"; nullopt for what is not digits, one comma and digits.
std::optional<std::string> decimal_point_for(std::string_view text);
/// What a sentence on a refused number ends with where it has a comma: "; decimals follow a point: 2000.5", or, where
/// three digits stand behind it, both readings. Empty: no such number.
std::string hint_at_comma(std::string_view text);

/// Levenshtein distance.
std::size_t edit_distance(std::string_view a, std::string_view b);
/// The closest of `known` when close enough to be a slip of the pen.
std::optional<std::string> nearest(std::string_view name, const std::vector<std::string> &known);
/// Known names that hold `name`, or begin as it does: "mu" is in "mu_fast".
std::vector<std::string> words_near(std::string_view name, const std::vector<std::string> &known);
/// `"spher" is not known; did you mean "sphere"? (known: ellipse, sphere)`
std::string unknown_word(std::string_view name, const std::vector<std::string> &known);

} // namespace rimpact
