#include "scene/record_doubts.h"
#include "io/files/error.h"
#include "io/records/near_fault_pulse.h"
#include "io/records/record.h"
#include "io/records/record_doubts.h"
#include "io/records/record_folder.h"
#include <array>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

struct Axis {
  const char *key;
  const std::string &file;
  const SampledSignal &signal;
  DirectionKind kind;       ///< of a record that belongs there
  FolderRecord record = {}; ///< what is known of the file's
};

/// Direction and station; unknown where there is no file, or it cannot be read: reading it for the run says why.
FolderRecord record_of(const std::string &file) {
  if (file.empty() || is_builtin_record(file)) return {};
  try {
    return records_of_file(file).front();
  } catch (const DataError &) {
    return {};
  }
}

/// What is said of two axes' records.
std::string doubt_of_two(const Axis &a, const Axis &b) {
  if (a.file == b.file) return fmt::format("{} and {} are the same component, {}", a.key, b.key, a.file);
  const FolderRecord &first = a.record, &second = b.record;
  const bool known = first.direction.kind != DirectionKind::unknown && second.direction.kind != DirectionKind::unknown;
  if (!known || first.station.empty() || second.station.empty() || first.station == second.station) return {};
  return fmt::format("{} and {} are of two stations, {} and {}", a.key, b.key, first.station, second.station);
}

} // namespace

void doubt_records(const Scene &scene, std::vector<std::string> &found) {
  const Excitation &e = scene.excitation;
  if (e.kind != ExcitationKind::record) return;
  std::array axes{Axis{"excitation.x", e.x_file, e.x, DirectionKind::horizontal},
                  Axis{"excitation.y", e.y_file, e.y, DirectionKind::horizontal},
                  Axis{"excitation.z", e.z_file, e.z, DirectionKind::vertical}};
  for (Axis &axis : axes) axis.record = record_of(axis.file);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (axes[i].file.empty()) continue;
    if (const auto kind = axes[i].record.direction.kind; kind != DirectionKind::unknown && kind != axes[i].kind)
      found.push_back(
          fmt::format("{} = {} is a {} record by its header or name", axes[i].key, axes[i].file, word(kind)));
    if (!is_builtin_record(axes[i].file) && !axes[i].signal.values.empty())
      for (const auto &doubt : record_doubts(axes[i].signal, scene.load.gravity))
        found.push_back(fmt::format("{}: {}: {}", axes[i].key, axes[i].file, doubt));
    for (std::size_t k = 0; k < i; ++k)
      if (const std::string doubt = axes[k].file.empty() ? "" : doubt_of_two(axes[k], axes[i]); !doubt.empty())
        found.push_back(doubt);
  }
}

} // namespace rimpact::scene
