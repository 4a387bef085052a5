#include "files/zip_archive.h"
#include "files/error.h"
#include "files/file.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <zlib.h>

namespace rimpact {
namespace {

constexpr std::string_view end_mark("PK\5\6", 4), entry_mark("PK\1\2", 4), member_mark("PK\3\4", 4);
constexpr std::size_t end_size = 22, entry_size = 46, member_size = 30, largest_comment = 65535;
constexpr std::size_t largest_member = 1'000'000'000;
constexpr unsigned stored = 0, deflated = 8, encrypted = 1;

/// A number of `n` bytes, the lowest first.
std::size_t number_at(const std::string &bytes, std::size_t at, std::size_t n) {
  std::size_t value = 0;
  for (std::size_t i = n; i-- > 0;) value = 256 * value + static_cast<unsigned char>(bytes[at + i]);
  return value;
}

bool stands_at(const std::string &bytes, std::size_t at, std::string_view mark) {
  return at <= bytes.size() && bytes.compare(at, mark.size(), mark) == 0;
}

/// Where the record that ends every archive begins.
std::size_t find_end(const std::string &bytes, const std::string &path) {
  const std::size_t first = bytes.size() > end_size + largest_comment ? bytes.size() - end_size - largest_comment : 0;
  for (std::size_t at = bytes.size() >= end_size ? bytes.size() - end_size + 1 : 0; at-- > first;)
    if (stands_at(bytes, at, end_mark)) return at;
  throw DataError(fmt::format("{}: is no zip archive, or a truncated one: the record at its end is missing", path));
}

std::string inflated(std::string packed, std::size_t size, const std::string &where) {
  std::string bytes(size, '\0');
  z_stream stream{};
  constexpr int raw = -MAX_WBITS; // no header of zlib around the data
  if (inflateInit2(&stream, raw) != Z_OK) throw DataError(where + ": cannot be unpacked");
  stream.next_in = reinterpret_cast<Bytef *>(packed.data());
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef *>(bytes.data());
  stream.avail_out = static_cast<uInt>(size);
  const int status = inflate(&stream, Z_SYNC_FLUSH);
  const std::size_t missing = stream.avail_out;
  inflateEnd(&stream);
  if ((status != Z_STREAM_END && status != Z_OK && status != Z_BUF_ERROR) || missing > 0)
    throw DataError(fmt::format("{}: is damaged: {} of {} bytes could be unpacked", where, size - missing, size));
  return bytes;
}

} // namespace

ZipArchive::ZipArchive(const std::string &path) : bytes_(read_file(path)), path_(path) {
  const std::size_t end = find_end(bytes_, path);
  const std::size_t n = number_at(bytes_, end + 10, 2);
  std::size_t at = number_at(bytes_, end + 16, 4);
  for (std::size_t i = 0; i < n; ++i) {
    if (!stands_at(bytes_, at, entry_mark) || at + entry_size > bytes_.size())
      throw DataError(fmt::format("{}: its list of members is damaged behind {} of {}", path, i, n));
    const auto field = [&](std::size_t offset, std::size_t length) { return number_at(bytes_, at + offset, length); };
    const std::size_t name_length = field(28, 2);
    Member member{.name = bytes_.substr(at + entry_size, name_length)};
    member.flags = static_cast<unsigned>(field(8, 2)), member.method = static_cast<unsigned>(field(10, 2));
    member.crc = field(16, 4), member.packed = field(20, 4), member.size = field(24, 4), member.offset = field(42, 4);
    at += entry_size + name_length + field(30, 2) + field(32, 2);
    if (!member.name.empty() && member.name.back() != '/') members_.push_back(std::move(member));
  }
}

std::vector<std::string> ZipArchive::names() const {
  std::vector<std::string> names;
  for (const auto &member : members_) names.push_back(member.name);
  std::sort(names.begin(), names.end());
  return names;
}

const ZipArchive::Member *ZipArchive::find(const std::string &name) const {
  const auto found = std::find_if(members_.begin(), members_.end(), [&](const auto &m) { return m.name == name; });
  return found == members_.end() ? nullptr : &*found;
}

bool ZipArchive::has(const std::string &name) const {
  return find(name) != nullptr;
}

std::string ZipArchive::read(const std::string &name, std::size_t most) const {
  const std::string where = path_ + "/" + name;
  const Member *member = find(name);
  if (member == nullptr) throw DataError(fmt::format("{}: the archive has no such member", where));
  if ((member->flags & encrypted) != 0) throw DataError(where + ": is encrypted; unpack the archive");
  if (member->method != stored && member->method != deflated)
    throw DataError(
        fmt::format("{}: is packed by method {}, only 0 and 8 are known; unpack the archive", where, member->method));
  if (member->size > largest_member) throw DataError(where + ": is larger than 1 GB");
  if (!stands_at(bytes_, member->offset, member_mark) || member->offset + member_size > bytes_.size())
    throw DataError(where + ": its beginning is not where the archive's list says");
  const std::size_t begin = member->offset + member_size + number_at(bytes_, member->offset + 26, 2) +
                            number_at(bytes_, member->offset + 28, 2);
  if (begin + member->packed > bytes_.size()) throw DataError(where + ": is truncated");
  std::string packed = bytes_.substr(begin, member->packed);
  const std::size_t size = std::min(member->size, most);
  if (member->method == stored) return packed.substr(0, size);
  std::string bytes = inflated(std::move(packed), size, where);
  if (size == member->size &&
      crc32(0, reinterpret_cast<const Bytef *>(bytes.data()), static_cast<uInt>(size)) != member->crc)
    throw DataError(where + ": is damaged: its check sum differs from the archive's");
  return bytes;
}

bool is_zip_archive(const std::string &path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return false;
  std::ifstream file(path, std::ios::binary);
  std::string start(member_mark.size(), '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  return start == member_mark;
}

} // namespace rimpact
