/// Text from outside (calibration.json, names of bearings, folders, commands) as comments of Tcl, Python, s2k, e2k
/// and CSV files: whatever it holds, it stays a comment.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace rimpact::calibration {

/// Printable ASCII without what any of these languages reads: control characters become blanks; quotes of every kind
/// become ', a backslash /; brackets, braces, $ and ; become what is plain; every other character is one `?`.
std::string plain_text(std::string_view text);
/// `text` made plain, broken at blanks to lines of about 118 characters, each begun with `mark` and ended by a newline.
std::string comment_line(std::string_view mark, std::string_view text);
std::string comment_lines(std::string_view mark, const std::vector<std::string> &texts);

} // namespace rimpact::calibration
