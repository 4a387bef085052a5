/// The response of a model: named series with units, written as HDF5 (/response, /meta) and CSV. SI units.
#pragma once
#include "responses/signals.h"
#include <map>
#include <string>
#include <vector>

namespace rimpact {

class Response {
public:
  /// Adds a value to the series `name` (must be in known_signals()).
  void append(const std::string &name, double value);
  std::vector<double> &series(const std::string &name);
  const std::vector<double> &series(const std::string &name) const; ///< throws DataError when absent
  bool has(const std::string &name) const { return series_.count(name) > 0; }
  std::size_t size() const; ///< number of instants (length of "time")
  const std::map<std::string, std::vector<double>> &all() const { return series_; }

  /// Text kept in /meta: "version", "scene" (TOML), "git", "summary" ...
  std::map<std::string, std::string> meta;

  /// Throws std::logic_error when the lengths differ or a value is not finite: never a NaN in an output.
  void check() const;

private:
  std::map<std::string, std::vector<double>> series_;
};

/// Reads a run folder, a .h5 or a .csv. Throws DataError with the reason.
Response read_response(const std::string &path);

} // namespace rimpact
