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
  DirectionKind kind; ///< of a record that belongs there
};

DirectionKind kind_of(const std::string &file) {
  if (is_builtin_record(file)) return DirectionKind::unknown;
  try {
    return records_of_file(file).front().direction.kind;
  } catch (const DataError &) {
    return DirectionKind::unknown; // reading it for the run says why
  }
}

} // namespace

void doubt_records(const Scene &scene, std::vector<std::string> &found) {
  const Excitation &e = scene.excitation;
  if (e.kind != ExcitationKind::record) return;
  const std::array axes{Axis{"excitation.x", e.x_file, e.x, DirectionKind::horizontal},
                        Axis{"excitation.y", e.y_file, e.y, DirectionKind::horizontal},
                        Axis{"excitation.z", e.z_file, e.z, DirectionKind::vertical}};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (axes[i].file.empty()) continue;
    if (const auto kind = kind_of(axes[i].file); kind != DirectionKind::unknown && kind != axes[i].kind)
      found.push_back(
          fmt::format("{} = {} is a {} record by its header or name", axes[i].key, axes[i].file, word(kind)));
    if (!is_builtin_record(axes[i].file) && !axes[i].signal.values.empty())
      for (const auto &doubt : record_doubts(axes[i].signal, scene.load.gravity))
        found.push_back(fmt::format("{}: {}: {}", axes[i].key, axes[i].file, doubt));
    for (std::size_t k = 0; k < i; ++k)
      if (axes[k].file == axes[i].file)
        found.push_back(fmt::format("{} and {} are the same component, {}", axes[k].key, axes[i].key, axes[i].file));
  }
}

} // namespace rimpact::scene
