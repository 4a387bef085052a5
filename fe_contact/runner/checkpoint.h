/// Checkpoints: named arrays of doubles and texts in one HDF5 file, written atomically.
#pragma once
#include <map>
#include <string>
#include <vector>

namespace rimpact::fe {

struct Checkpoint {
  std::map<std::string, std::vector<double>> numbers;
  std::map<std::string, std::string> texts;
  double number(const std::string &name) const; ///< first value; throws DataError when absent
};
void write_checkpoint(const Checkpoint &checkpoint, const std::string &path); ///< throws IoError
Checkpoint read_checkpoint(const std::string &path);                          ///< throws DataError

} // namespace rimpact::fe
