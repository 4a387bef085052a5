/// Checkpoints: named arrays of doubles and texts in one HDF5 file, written atomically. In front of the HDF5 part,
/// where HDF5 leaves room for others, stand 512 bytes with the format's number and the SHA-256 of all that follows: a
/// file with a changed bit is refused before anything of it is read. The reader states of every field how many values
/// are due and what they may be: a file of another build or hand is refused in one sentence too.
#pragma once
#include <map>
#include <string>
#include <vector>

namespace rimpact::fe {

/// What each value of a field may be.
struct Limits {
  double low = -1e30, high = 1e30;
  bool whole = false;                ///< a whole number
  bool infinite = false;             ///< it may be infinite too
  bool contains(double value) const; ///< NaN is nowhere
};
inline constexpr Limits count{0, 1e15, true};
inline constexpr Limits infinite_too{.infinite = true};

struct Checkpoint {
  std::map<std::string, std::vector<double>> numbers;
  std::map<std::string, std::string> texts;
  std::string path = {}; ///< of the file it was read from, for messages

  /// A field of `due` values within the limits; of any number of values. Throw DataError.
  const std::vector<double> &field(const std::string &name, std::size_t due, Limits limits = {}) const;
  const std::vector<double> &field(const std::string &name, Limits limits = {}) const;
  double number(const std::string &name, Limits limits = {}) const;
  const std::string &text(const std::string &name) const;
  /// Throws DataError: "PATH is damaged (what); run without --resume to start afresh".
  [[noreturn]] void damaged(const std::string &what) const;
};
void write_checkpoint(const Checkpoint &checkpoint, const std::string &path); ///< throws IoError
/// Throws DataError where the file is absent, damaged, or of another format.
Checkpoint read_checkpoint(const std::string &path);

} // namespace rimpact::fe
