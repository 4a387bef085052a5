/// Texts in other character sets than UTF-8, by the C library's iconv.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace rimpact {

/// The first byte that is no UTF-8; none: all of it is.
std::optional<std::size_t> not_utf8(std::string_view bytes);

/// `bytes` of the character set `name` (as iconv knows it: windows-1254, shift_jis, ...) in UTF-8; none: some byte is
/// no character of it. Throws InputError, opening with `place`, for a set that this system does not know.
std::optional<std::string> utf8_from(std::string_view bytes, const std::string &name, const std::string &place);

} // namespace rimpact
