/// What is common to the readers of tables as laboratories, data bases and spreadsheets write them: UTF-16, quoted
/// cells, `sep=;`, a decimal comma.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rimpact {

/// The text in UTF-8: UTF-16 with its byte-order mark is converted, anything else returned as it is. Throws DataError
/// for a half or broken character; `path` is for messages only.
std::string utf8_text(const std::string &bytes, const std::string &path);

/// What a line `sep=;` before the header says; none: it is no such line.
std::optional<char> stated_separator(std::string_view line);
/// Of a header line: semicolon, else tab, else comma; those inside quotes do not count.
char separator_of(std::string_view header);
/// The cells of a line without blanks around them and without their quotes; `""` inside quotes is one.
std::vector<std::string> cells_of(std::string_view line, char separator);

/// Numbers with a point or with a comma, one of both in a file.
class DecimalReader {
public:
  /// The cell's number; none: it is no finite number. Throws DataError, opening with `place`, for a point in a file of
  /// decimal commas and the reverse: one of them would stand for thousands.
  std::optional<double> number(const std::string &cell, const std::string &place);
  bool comma() const { return comma_; } ///< a decimal comma was met

private:
  bool comma_ = false, point_ = false;
};

} // namespace rimpact
