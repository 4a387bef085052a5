#include "reduced_models/bearings/rim_curve_file.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/hdf5_memory.h"
#include "io/files/table.h"
#include "io/files/table_csv.h"
#include "responses/crossing.h"
#include "scene/rim_identity.h"
#include <fmt/format.h>
#include <map>
#include <mutex>

namespace rimpact::reduced {
namespace {

using namespace hdf5;

Handle new_group(hid_t place, const char *name) {
  return {H5Gcreate2(place, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "group"};
}
/// Of this file only: a link could lead into another one.
Handle open_group(hid_t place, const char *name) {
  H5L_info_t link;
  check(H5Lget_info(place, name, &link, H5P_DEFAULT), "a group is missing");
  if (link.type != H5L_TYPE_HARD) throw std::runtime_error(fmt::format("its group {} is a link", name));
  return {H5Gopen2(place, name, H5P_DEFAULT), H5Gclose, "a group cannot be opened"};
}

void write_column(hid_t group, const char *name, const std::vector<double> &values, const char *units) {
  write_numbers(group, name, values);
  const Handle set(H5Dopen2(group, name, H5P_DEFAULT), H5Dclose, "dataset");
  write_string(set, "units", units, true);
}

void write_path(hid_t file, const char *name, const laws::CurvePath &path) {
  const Handle group = new_group(file, name), loading = new_group(group, "loading"),
               unloading = new_group(group, "unloading");
  write_column(loading, "penetration", path.loading.penetration, "m");
  write_column(loading, "force", path.loading.force, "N");
  std::vector<double> branch, penetration, force;
  for (std::size_t k = 0; k < path.unloading.size(); ++k) {
    const laws::CurveSamples &back = path.unloading[k];
    branch.insert(branch.end(), back.force.size(), static_cast<double>(k + 1));
    penetration.insert(penetration.end(), back.penetration.begin(), back.penetration.end());
    force.insert(force.end(), back.force.begin(), back.force.end());
  }
  write_column(unloading, "branch", branch, "1");
  write_column(unloading, "penetration", penetration, "m");
  write_column(unloading, "force", force, "N");
}

laws::CurvePath read_path(hid_t file, const char *name) {
  const Handle group = open_group(file, name), loading = open_group(group, "loading"),
               unloading = open_group(group, "unloading");
  laws::CurvePath path{{read_numbers(loading, "penetration"), read_numbers(loading, "force")}, {}};
  const auto branch = read_numbers(unloading, "branch"), penetration = read_numbers(unloading, "penetration"),
             force = read_numbers(unloading, "force");
  if (branch.size() != penetration.size() || branch.size() != force.size())
    throw std::runtime_error("its columns of unloading differ in length");
  for (std::size_t i = 0; i < branch.size(); ++i) {
    if (i == 0 || branch[i] != branch[i - 1]) path.unloading.emplace_back();
    path.unloading.back().penetration.push_back(penetration[i]);
    path.unloading.back().force.push_back(force[i]);
  }
  laws::RimCurve check(path); // what it holds makes a curve
  return path;
}

/// A column over the penetration along `held`, in a group of its own.
struct AlongHeld {
  const char *group, *column, *words;
};
constexpr AlongHeld strain_columns{"steel", "strain", "steel"}, foot_columns{"rim_foot", "use", "the rim's foot"};

void write_along(hid_t file, const AlongHeld &what, const std::vector<double> &penetration,
                 const std::vector<double> &values) {
  const Handle held = open_group(file, "held"), group = new_group(held, what.group);
  write_column(group, "penetration", penetration, "m");
  write_column(group, what.column, values, "1");
}

/// Penetrations and values; empty where the file has none.
template <class Columns> Columns read_along(hid_t file, const AlongHeld &what) {
  const Handle held = open_group(file, "held");
  if (H5Lexists(held, what.group, H5P_DEFAULT) <= 0) return {};
  const Handle group = open_group(held, what.group);
  const auto penetration = read_numbers(group, "penetration"), values = read_numbers(group, what.column);
  if (penetration.size() != values.size())
    throw std::runtime_error(fmt::format("its columns of {} differ in length", what.words));
  return {penetration, values};
}

constexpr const char *unknown = "unknown";

double number_of(const std::map<std::string, std::string> &meta, const char *name) {
  const auto entry = meta.find(name);
  if (entry == meta.end()) throw std::runtime_error(fmt::format("/meta/{} is missing", name));
  return std::stod(entry->second);
}

void add_rows(Table &table, const char *path, double branch, const laws::CurveSamples &samples) {
  for (std::size_t i = 0; i < samples.force.size(); ++i)
    table.rows.push_back({std::string(path), branch, samples.penetration[i], samples.force[i]});
}

} // namespace

void write_rim_curve(const RimCurveFile &curve, const std::string &path) {
  write_atomically(file_in_memory([&](hid_t file) {
                     if (!curve.dish.unloading.empty()) write_path(file, "dish", curve.dish);
                     write_path(file, "held", curve.held);
                     if (!curve.strain.strain.empty())
                       write_along(file, strain_columns, curve.strain.penetration, curve.strain.strain);
                     if (!curve.foot.use.empty())
                       write_along(file, foot_columns, curve.foot.penetration, curve.foot.use);
                     write_meta(file,
                                {{"kind", "rim curve"},
                                 {"bearing", curve.bearing},
                                 {"rim_identity", curve.rim_identity},
                                 {"rim_values", curve.rim_values},
                                 {"joint", curve.joint},
                                 {"mesh", curve.mesh},
                                 {"made_by", curve.made_by},
                                 {"mesh_force_error",
                                  curve.errors.mesh_force ? fmt::format("{}", *curve.errors.mesh_force) : unknown},
                                 {"left_out_rebound_error", fmt::format("{}", curve.errors.left_out_rebound)}});
                   }),
                   path);
}

void write_rim_curve_csv(const RimCurveFile &curve, const std::string &path) {
  Table table{{"path", "branch", "penetration_m", "force_N"}, {}, {}};
  for (const auto &[name, way] : {std::pair{"dish", &curve.dish}, std::pair{"held", &curve.held}}) {
    add_rows(table, name, 0, way->loading);
    for (std::size_t k = 0; k < way->unloading.size(); ++k)
      add_rows(table, name, static_cast<double>(k + 1), way->unloading[k]);
  }
  write_csv(table, path);
}

RimCurveFile read_rim_curve(const std::string &path) {
  const std::string bytes = read_file(path);
  RimCurveFile curve;
  try {
    with_image(bytes, [&](hid_t file) {
      const auto meta = read_meta(file);
      const auto text = [&](const char *name) { return meta.count(name) ? meta.at(name) : std::string(); };
      if (text("kind") != "rim curve") throw std::runtime_error("no rim curve of `rimpact curve`");
      if (H5Lexists(file, "dish", H5P_DEFAULT) > 0) curve.dish = read_path(file, "dish");
      curve.held = read_path(file, "held");
      curve.strain = read_along<CurveStrain>(file, strain_columns);
      curve.foot = read_along<CurveFoot>(file, foot_columns);
      curve.joint = text("joint"), curve.bearing = text("bearing"), curve.rim_identity = text("rim_identity"),
      curve.rim_values = text("rim_values"), curve.mesh = text("mesh"), curve.made_by = text("made_by");
      if (text("mesh_force_error") != unknown) curve.errors.mesh_force = number_of(meta, "mesh_force_error");
      curve.errors.left_out_rebound = number_of(meta, "left_out_rebound_error");
    });
  } catch (const std::exception &error) {
    throw DataError(fmt::format("{}: is not a rim curve: {}", path, error.what()));
  }
  return curve;
}

namespace {

struct KnownCurve {
  RimCurveFile file;
  std::shared_ptr<const laws::RimCurve> dish, held;
};

/// Read once a process: runs of a fleet share it.
const KnownCurve &known_curve(const std::string &path) {
  static std::mutex lock;
  static std::map<std::string, KnownCurve> known;
  const std::lock_guard guard(lock);
  auto entry = known.find(path);
  if (entry != known.end()) return entry->second;
  RimCurveFile file = read_rim_curve(path);
  const auto curve_of = [](const laws::CurvePath &way) {
    return way.unloading.empty() ? nullptr : std::make_shared<laws::RimCurve>(way);
  };
  auto dish = curve_of(file.dish), held = curve_of(file.held);
  return known.emplace(path, KnownCurve{std::move(file), std::move(dish), std::move(held)}).first->second;
}

} // namespace

std::shared_ptr<const laws::RimCurve> rim_curve_of(const scene::Scene &scene) {
  const std::string &path = scene.reduced.impact_curve;
  const auto &[file, dish, held] = known_curve(path);
  if (const std::string own = scene::rim_identity(scene.bearing); file.rim_identity != own)
    throw InputError(fmt::format(
        "reduced.impact_curve {}: the curve is of the rim of {} ({}), this bearing's is {}: {}; "
        "make its own by `rimpact curve BEARING`",
        path, file.bearing, file.rim_identity, own,
        file.rim_values.empty()
            ? "dish, slider, rim, plate and steel shape it"
            : "there and here " + scene::rim_differences(file.rim_values, scene::rim_values(scene.bearing))));
  const bool is_held = scene.excitation.kind == scene::ExcitationKind::window && !scene.excitation.with_weight;
  if (!is_held && !dish)
    throw InputError(
        fmt::format("reduced.impact_curve {}: it holds the path with the height held alone (`rimpact curve "
                    "--held`), which serves windows without weight; push both for this scene",
                    path));
  return is_held ? held : dish;
}

CurveJoint joint_of_curve(const scene::Scene &scene) {
  const KnownCurve &known = known_curve(scene.reduced.impact_curve);
  const auto &[depth, use] = known.file.foot;
  CurveJoint joint{known.file.joint, {}};
  if (const auto gone = first_crossing(use, 1)) joint.gone_at = known.held->loading(gone->of(depth)).force;
  return joint;
}

std::vector<std::string> doubts_of_curve(const scene::Scene &scene) {
  constexpr double coarse_mesh = 0.03, coarse_unloadings = 0.10;
  if (scene.reduced.impact_curve.empty() || !scene.reduced.impact_law->pushed) return {};
  const std::string &path = scene.reduced.impact_curve;
  const RimCurveFile &file = known_curve(path).file;
  const CurveErrors &errors = file.errors;
  std::vector<std::string> doubts;
  if (!errors.mesh_force)
    doubts.push_back(fmt::format("{}: nothing says how far the mesh of this rim curve is off ({}); push it on mesh 1",
                                 path, file.mesh));
  else if (*errors.mesh_force > coarse_mesh)
    doubts.push_back(fmt::format("{}: the mesh of this rim curve is off by some {:.1f} % of the force; push it on a "
                                 "finer one",
                                 path, 100 * *errors.mesh_force));
  if (errors.left_out_rebound > coarse_unloadings)
    doubts.push_back(fmt::format("{}: between its unloadings this rim curve is off by up to {:.0f} % of the rebound; "
                                 "push it with more of them (rimpact curve --unloadings N)",
                                 path, 100 * errors.left_out_rebound));
  return doubts;
}

} // namespace rimpact::reduced
