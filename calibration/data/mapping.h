/// The mapping file of measured curves: its keys are in docs/reference/keys.md.
#pragma once
#include "calibration/data/impact_window.h"
#include "io/files/key_visitor.h"

namespace rimpact::calibration {

/// One stored signal's column: stored = (value - zero) factor si.
struct Column {
  std::string signal, header, unit;
  double factor = 1, zero = 0;
  /// Of a channel with a clock of its own: the column of its instants, in the unit of columns.time, and the table it
  /// stands in where that is another one. Empty: the clock and the table of `time`.
  std::string time_column, file;
  double lag = 0;            ///< by which its clock or filter is behind that of `time` [s]; taken off
  bool estimate_lag = false; ///< found by momentum in place of `lag` (force_clock.h)
  const std::string &table(const struct Mapping &mapping) const; ///< the file it stands in, as the mapping names it
  bool own_clock() const { return !time_column.empty() || lag != 0; }
};

/// Which rows of a table are the test.
struct TestPart {
  std::string name;                         ///< empty: the file is one test
  std::optional<double> from_time, to_time; ///< by the table's clock, once it is in seconds [s]
  int block = 0;                            ///< of the parts that begin with the names of the columns, from 1; 0: all
  std::vector<std::string> overrides;       ///< of the scene
};

struct Mapping {
  std::string path, scene, file;
  std::string encoding;    ///< empty: UTF-8 or UTF-16, or what is found
  std::string test_column; ///< names the test of each row; empty: none
  int skip_lines = 0;
  double force_noise = 0;
  std::vector<Column> columns;
  TestPart whole;              ///< what holds for every test
  std::vector<TestPart> tests; ///< in the file's order
  std::optional<Uncertainty> uncertainty;
  const Column *column_of(const std::string &signal) const; ///< null: it has none
};
/// Walk over the keys of the file: its own, those of [columns.SIGNAL], of [test.NAME], of [uncertainty].
void visit(KeyVisitor &v, Mapping &mapping);
void visit(KeyVisitor &v, Column &column);
void visit(KeyVisitor &v, TestPart &part);
void visit(KeyVisitor &v, Uncertainty &uncertainty);
/// Throws InputError naming file, line and key; DataError when the file cannot be read.
Mapping read_mapping(const std::string &path);

} // namespace rimpact::calibration
