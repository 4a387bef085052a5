/// One process at a time in a results folder. The lock is the kernel's (flock), so that it is gone with its holder,
/// however that ends; the file says who holds it. It works on local disks and between the clients of NFS version 4;
/// where a file system knows no locks, there is none.
#pragma once
#include <string>

namespace rimpact {

class FolderLock {
public:
  /// Creates the folder where it is missing. `part` tells the shards of one folder apart ("2-of-3"), which run side by
  /// side. Throws IoError: what holds the folder, or why it cannot be made.
  explicit FolderLock(const std::string &folder, const std::string &part = "");
  ~FolderLock(); ///< an empty folder that it made goes with it
  FolderLock(FolderLock &&other) noexcept;
  FolderLock &operator=(FolderLock &&) = delete;

private:
  std::string path_, made_; ///< made_: the folder, where this lock made it
  int descriptor_ = -1;
};

} // namespace rimpact
