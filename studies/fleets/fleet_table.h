/// The rows of a fleet and the files they are kept in.
#pragma once
#include "responses/summary.h"
#include "studies/fleets/run_end.h"
#include "studies/fleets/sweep.h"
#include <map>
#include <optional>

namespace rimpact::fleets {

/// Results of one run by column name; parameters are not among them.
using Row = std::map<std::string, Cell>;

/// Peaks, impacts, residual, energy, status and reason, and every number a model puts among the summary's
/// extras. A number that is not finite is left out and makes the status "failed".
Row row_of(const Summary &summary);
/// None: the cell is empty or a text.
std::optional<double> number_in(const Row &row, const std::string &column);
/// Whether a column of zeros and ones holds a one; false where the cell is empty.
bool is_true(const Row &row, const std::string &column);
Row row_without_result(RowStatus status, const std::string &reason);

class FleetTable {
public:
  FleetTable(const Sweep &sweep, std::map<std::string, std::string> meta);
  /// Takes over the rows of every table in the folder. Throws DataError when one is damaged.
  void read_folder(const std::string &folder);
  void set(std::size_t run, Row row) { rows_[run] = std::move(row); }
  bool has(std::size_t run) const { return rows_.count(run) > 0; }
  const Row &row(std::size_t run) const { return rows_.at(run); }
  /// Of the runs that `wanted` names and that are there.
  Table table(const std::vector<std::size_t> &wanted) const;
  /// The same as path.csv, which a later call goes on from.
  void keep(const std::string &path, const std::vector<std::size_t> &wanted) const;
  /// The same as path.csv and path.h5.
  void write(const std::string &path, const std::vector<std::size_t> &wanted) const;

private:
  void read(const std::string &path);
  const Sweep &sweep_;
  std::map<std::string, std::string> meta_;
  std::map<std::size_t, Row> rows_; ///< by run, from 0
};

} // namespace rimpact::fleets
