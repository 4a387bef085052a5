#include "fe_contact/drive/cached_preload.h"

#include "fe_contact/drive/run.h"
#include "fe_contact/drive/state_fields.h"
#include "fe_contact/solver/ranks.h"
#include "io/files/digest.h"
#include "io/files/error.h"
#include "responses/identity.h"
#include "responses/physics_version.h"
#include "scene/toml_writer.h"
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

struct SlideOut {
  SystemState &state;
  TopDrive &drive;
  double rest_height;
};

void visit(StateVisitor &v, SlideOut &slide) {
  fe::visit(v, slide.state);
  v.part("drive", [&] { fe::visit(v, slide.drive, slide.state.u.size()); });
  v.number("rest_height", slide.rest_height);
}

} // namespace

CachedPreload::CachedPreload(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options) {
  if (options.folder.empty()) return;
  key_ = key_of(scene, plan);
  const fs::path beside = fs::absolute(fs::path(options.folder) / "x").lexically_normal().parent_path().parent_path();
  path_ = (beside / "slid-out" / (sha256(key_).substr(0, 24) + ".h5")).string();
  writes_ = options.keeps_files();
}

bool CachedPreload::take(SystemState &state, TopDrive &drive, double &rest_height) const {
  bool whole = false;
  std::error_code none;
  if (!path_.empty() && fs::is_regular_file(path_, none)) {
    try {
      SystemState kept = state;
      TopDrive kept_drive;
      const Checkpoint file = read_checkpoint(path_);
      whole = file.text("key") == key_;
      if (whole) {
        StateReader reader(file);
        SlideOut slide{kept, kept_drive, 0};
        visit(reader, slide);
        state = kept;
        drive = kept_drive;
        rest_height = slide.rest_height;
      }
    } catch (const DataError &) {
      whole = false; // damaged, or of an older format: it is made anew
    }
  }
  return !ranks().any(!whole);
}

void CachedPreload::keep(SystemState &state, TopDrive &drive, double rest_height) const {
  if (!writes_ || path_.empty()) return;
  Checkpoint file;
  file.texts["key"] = key_;
  StateWriter writer(file);
  SlideOut slide{state, drive, rest_height};
  visit(writer, slide);
  std::error_code failed;
  fs::create_directories(fs::path(path_).parent_path(), failed);
  if (failed) throw IoError("cannot make the folder of " + path_ + ": " + failed.message());
  write_checkpoint(file, path_);
}

} // namespace rimpact::fe
