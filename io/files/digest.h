/// SHA-256: names a text or a file by its contents (`sha256sum FILE` gives the same).
#pragma once
#include <string>
#include <string_view>

namespace rimpact {

/// 64 hexadecimal digits.
std::string sha256(std::string_view bytes);
/// Of a file's contents. Throws DataError as read_file does.
std::string sha256_of_file(const std::string &path);

} // namespace rimpact
