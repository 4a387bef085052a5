/// Archives as data bases send them (zip): their members' names and bytes.
#pragma once
#include <string>
#include <vector>

namespace rimpact {

/// PKWARE's APPNOTE 6.3: members that are stored or deflated, without encryption and without the large-file extension.
class ZipArchive {
public:
  /// Throws DataError, as read_file, and for what is no such archive.
  explicit ZipArchive(const std::string &path);

  /// Of members that are files, sorted, with "/" between folders.
  std::vector<std::string> names() const;
  bool has(const std::string &name) const;
  /// At most `most` bytes of a member. Throws DataError naming archive and member: it is not there, encrypted, packed
  /// by another method, truncated or damaged (its CRC-32), or larger than 1 GB.
  std::string read(const std::string &name, std::size_t most = std::string::npos) const;

private:
  struct Member {
    std::string name;
    unsigned method = 0, flags = 0;
    unsigned long crc = 0;
    std::size_t packed = 0, size = 0, offset = 0;
  };
  const Member *find(const std::string &name) const;
  std::string bytes_, path_;
  std::vector<Member> members_;
};

/// Whether a file's first bytes are an archive's.
bool is_zip_archive(const std::string &path);

} // namespace rimpact
