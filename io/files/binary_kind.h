/// Files that are no text where a table of text is wanted.
#pragma once
#include <string>
#include <string_view>

namespace rimpact {

/// What the bytes are, in words ("an Excel workbook"), and what makes a table of them; empty: they may be text. UTF-16
/// is text.
std::string binary_kind(std::string_view bytes);

/// Throws DataError naming the file, its kind and what to do.
void refuse_binary(std::string_view bytes, const std::string &path);

} // namespace rimpact
