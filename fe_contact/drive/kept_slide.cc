#include "fe_contact/drive/kept_slide.h"

#include "fe_contact/drive/record_checkpoint.h"
#include "fe_contact/drive/system_checkpoint.h"
#include "fe_contact/solver/ranks.h"
#include "files/digest.h"
#include "files/error.h"
#include "responses/identity.h"
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::fe {
namespace {

namespace fs = std::filesystem;

/// Whether a key of the resolved scene shapes the slide out.
bool shapes(const std::string &key) {
  if (key == "bearing.name") return false;
  for (const char *part : {"bearing.", "model.own_mesh."})
    if (key.starts_with(part)) return true;
  for (const char *whole : {"load.vertical_kN", "model.rung", "model.mesh", "model.penalty_scale", "model.symmetry",
                            "excitation.direction_deg", "excitation.with"})
    if (key == whole) return true;
  return false;
}

/// Everything that shapes it, a line each.
std::string key_of(const scene::Scene &scene, const planning::Plan &plan) {
  std::string key;
  for (const auto &[name, value] : resolved_keys(scene::to_toml(scene)))
    if (shapes(name)) key += name + " = " + value + "\n";
  for (const auto &[file, hash] : identity_of(scene).inputs) key += "file " + hash + "\n";
  key += fmt::format("half {} sector {} program {}\n", plan.half, plan.sector_half_angle, physics_version());
  return key;
}

} // namespace

KeptSlide::KeptSlide(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options) {
  if (options.folder.empty()) return;
  key_ = key_of(scene, plan);
  const fs::path beside = fs::absolute(fs::path(options.folder) / "x").lexically_normal().parent_path().parent_path();
  path_ = (beside / "slid-out" / (sha256(key_).substr(0, 24) + ".h5")).string();
  writes_ = options.keeps_files();
}

bool KeptSlide::take(const BearingSystem &system, SystemState &state, TopDrive &drive, double &rest_height) const {
  bool whole = false;
  std::error_code none;
  if (!path_.empty() && fs::is_regular_file(path_, none)) {
    try {
      SystemState kept = state;
      const Checkpoint file = read_checkpoint(path_);
      whole = file.text("key") == key_;
      if (whole) {
        get(file, kept);
        const auto &way = file.field("way", 3);
        const double height = file.number("rest_height");
        drive.last_change = vector(file.field("drive_change", std::size_t(system.equations().n)));
        drive.last_way = vector(way);
        state = kept;
        rest_height = height;
      }
    } catch (const DataError &) {
      whole = false; // damaged, or of an older format: it is made anew
    }
  }
  return !ranks().any(!whole);
}

void KeptSlide::keep(const SystemState &state, const TopDrive &drive, double rest_height) const {
  if (!writes_ || path_.empty()) return;
  Checkpoint file;
  file.texts["key"] = key_;
  put(file, state);
  file.numbers["drive_change"] = list(drive.last_change);
  file.numbers["way"] = list(drive.last_way);
  file.numbers["rest_height"] = {rest_height};
  std::error_code failed;
  fs::create_directories(fs::path(path_).parent_path(), failed);
  if (failed) throw IoError("cannot make the folder of " + path_ + ": " + failed.message());
  write_checkpoint(file, path_);
}

} // namespace rimpact::fe
