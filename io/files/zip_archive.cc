#include "io/files/zip_archive.h"
#include "io/files/error.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <zip.h>

namespace rimpact {
namespace {

constexpr zip_uint64_t largest_member = 1'000'000'000;

struct CloseFile {
  void operator()(zip_file_t *file) const { zip_fclose(file); }
};

} // namespace

void ZipArchive::Close::operator()(zip *archive) const {
  zip_discard(archive);
}

ZipArchive::ZipArchive(const std::string &path) : path_(path) {
  int code = 0;
  archive_.reset(zip_open(path.c_str(), ZIP_RDONLY, &code));
  if (archive_) return;
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  const std::string why = zip_error_strerror(&error);
  zip_error_fini(&error);
  throw DataError(fmt::format("{}: is no zip archive, or a truncated one: {}", path, why));
}

std::vector<std::string> ZipArchive::names() const {
  std::vector<std::string> names;
  for (zip_int64_t i = 0; i < zip_get_num_entries(archive_.get(), 0); ++i) {
    const char *name = zip_get_name(archive_.get(), static_cast<zip_uint64_t>(i), 0);
    if (name != nullptr && *name != '\0' && !std::string_view(name).ends_with('/')) names.emplace_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool ZipArchive::has(const std::string &name) const {
  return zip_name_locate(archive_.get(), name.c_str(), 0) >= 0;
}

std::string ZipArchive::read(const std::string &name, std::size_t most) const {
  const std::string where = path_ + "/" + name;
  if (!has(name)) throw DataError(fmt::format("{}: the archive has no such member", where));
  zip_stat_t about;
  if (zip_stat(archive_.get(), name.c_str(), 0, &about) != 0 || (about.valid & ZIP_STAT_SIZE) == 0)
    throw DataError(fmt::format("{}: is damaged: {}", where, zip_strerror(archive_.get())));
  if (about.encryption_method != ZIP_EM_NONE) throw DataError(where + ": is encrypted; unpack the archive");
  if (about.size > largest_member) throw DataError(where + ": is larger than 1 GB");
  const std::unique_ptr<zip_file_t, CloseFile> file(zip_fopen(archive_.get(), name.c_str(), 0));
  if (!file)
    throw DataError(fmt::format("{}: cannot be unpacked here: {} (method {})", where, zip_strerror(archive_.get()),
                                about.comp_method));
  std::string bytes(std::min<std::size_t>(about.size, most), '\0');
  std::size_t n = 0;
  zip_int64_t more = 1;
  while (n < bytes.size() && (more = zip_fread(file.get(), bytes.data() + n, bytes.size() - n)) > 0)
    n += static_cast<std::size_t>(more);
  char behind = 0;
  if (n == about.size) more = zip_fread(file.get(), &behind, 1); // the check sum is looked at behind the last byte
  if (more < 0 || n < bytes.size())
    throw DataError(fmt::format("{}: is damaged: {} of {} bytes could be unpacked ({})", where, n, bytes.size(),
                                zip_file_strerror(file.get())));
  return bytes;
}

bool is_zip_archive(const std::string &path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return false;
  std::ifstream file(path, std::ios::binary);
  std::string start(4, '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  return start == "PK\3\4";
}

} // namespace rimpact
