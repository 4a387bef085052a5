/// Whole files, read and written. Errors name the file and the reason.
#pragma once
#include <string>
#include <string_view>

namespace rimpact {

/// Throws DataError when the file is absent, a folder, a pipe or device, unreadable or larger than 1 GB.
std::string read_file(const std::string &path);
/// The same of a file that the command line names: what cannot be read is its fault, so it throws InputError.
std::string read_named_file(const std::string &path);
/// Writes beside `path`, flushes to the disk and renames, so that a full disk or a killed run leaves an earlier
/// file as it was. Throws IoError.
void write_atomically(std::string_view bytes, const std::string &path);
/// With those above it; nothing where it is there. Throws IoError naming it and the reason.
void make_folder(const std::string &path);

} // namespace rimpact
