/// The mapping file of a measured curve: its keys are in docs/reference/keys.md.
#pragma once
#include "calibration/data/impact_window.h"
#include "files/key_visitor.h"

namespace rimpact::calibration {

/// One stored signal's column: stored = (value - zero) factor si.
struct Column {
  std::string signal, header, unit;
  double factor = 1, zero = 0;
  double si = 1; ///< of the unit
};

struct Mapping {
  std::string scene, file;
  std::vector<std::string> overrides;
  int skip_lines = 0;
  double force_noise = 0;
  std::vector<Column> columns;
  std::optional<Uncertainty> uncertainty;
};
/// Walk over the keys of the file: its own, those of [columns.SIGNAL], those of [uncertainty].
void visit(KeyVisitor &v, Mapping &mapping);
void visit(KeyVisitor &v, Column &column);
void visit(KeyVisitor &v, Uncertainty &uncertainty);
/// Whether a run is named by a mapping file.
bool is_mapping(const std::string &path);
/// Throws InputError naming file, line and key; DataError when the file cannot be read.
Mapping read_mapping(const std::string &path);

} // namespace rimpact::calibration
