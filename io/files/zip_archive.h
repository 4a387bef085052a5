/// Archives as data bases send them (zip): their members' names and bytes, by libzip.
#pragma once
#include <memory>
#include <string>
#include <vector>

struct zip;

namespace rimpact {

class ZipArchive {
public:
  /// Throws DataError for what is absent or no such archive.
  explicit ZipArchive(const std::string &path);

  /// Of members that are files, sorted, with "/" between folders.
  std::vector<std::string> names() const;
  bool has(const std::string &name) const;
  /// At most `most` bytes of a member. Throws DataError naming archive and member: it is not there, encrypted, packed
  /// in a way that libzip does not know, truncated or damaged (its CRC-32, of a member read whole), or larger than 1
  /// GB.
  std::string read(const std::string &name, std::size_t most = std::string::npos) const;

private:
  struct Close {
    void operator()(zip *archive) const;
  };
  std::string path_;
  std::unique_ptr<zip, Close> archive_;
};

/// Whether a file's first bytes are an archive's.
bool is_zip_archive(const std::string &path);

} // namespace rimpact
