#include "app/jobs/export_building.h"
#include "buildings/assembly.h"
#include "buildings/bearing_doubts.h"
#include "buildings/frame_source.h"
#include "calibration/export/comment.h"
#include "calibration/export/opensees.h"
#include "io/files/file.h"
#include "scene/rim_identity.h"
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

namespace fs = std::filesystem;
using buildings::Frame;
using calibration::ExportedRim;

constexpr const char *limits =
    "What OpenSees carries of a building's bearings: friction and restoring force follow each bearing's own normal "
    "force, for its slider rides on an ellipsoid; what that leaves of another dish is for the weight at rest. The "
    "rim's push unloads the dish. A rim is round but forgets its dents (elastoplastic), or stands along x only (the "
    "other laws). "
    "No pulse was flown on these bearings; rimpact export of the calibration flies them on one.";

/// The law of the scene, under the weight of one bearing.
ExportedRim rim_of(const scene::Scene &scene, const scene::Bearing &bearing, double reaction) {
  ExportedRim rim;
  rim.settings = scene.reduced;
  rim.vertical = reaction, rim.gravity = scene.load.gravity;
  rim.mass = rim.fitted_mass = reaction / scene.load.gravity;
  rim.lateral_capacity = bearing.lateral_capacity() + scene.reduced.capacity_offset;
  const double scale = scene.reduced.fitted_speed_scale(rim.mass);
  rim.from = scale * scene.reduced.fitted_from.value_or(0.1), rim.to = scale * scene.reduced.fitted_to.value_or(1.0);
  rim.tuned_to = rim.to;
  rim.bearing = bearing.name, rim.rim_identity = scene::rim_identity(bearing);
  rim.statement = {fmt::format("Bearing {} under {:.6g} N, rim law {} as in scene.toml.", bearing.name, reaction,
                               scene.reduced.impact_law->name)};
  return rim;
}

struct Placed {
  int node; ///< from 1
  Eigen::Vector3d at;
};
constexpr int plate_offset = 100000, anchor_offset = 200000, tag_offset = 100000;
constexpr int nodes_each = 10; ///< of a bearing's own nodes, the anchor first

std::string place_tcl(const std::vector<Placed> &list, const std::string &head) {
  std::string text = head + "set here [file dirname [info script]]\n";
  for (const auto &[node, at] : list)
    text += fmt::format("node {0} {1:.10g} {2:.10g} {3:.10g}\nfix {0} 1 1 1 1 1 1\nsource [file join $here "
                        "bearing_{4}.tcl]\nrimpact_bearing {5} {0} {4} {6}\n",
                        plate_offset + node, at[0], at[1], at[2], node, tag_offset + 100 * node,
                        anchor_offset + nodes_each * node);
  return text;
}

std::string place_python(const std::vector<Placed> &list, const std::string &head) {
  std::string text = head;
  for (const auto &placed : list) text += fmt::format("import bearing_{}\n", placed.node);
  text += "\n\ndef place(ops):\n    \"\"\"Plates' nodes, held, and every bearing. `ops` is openseespy.opensees; the "
          "building's nodes stand already.\"\"\"\n";
  for (const auto &[node, at] : list)
    text += fmt::format("    ops.node({0}, {1:.10g}, {2:.10g}, {3:.10g})\n    ops.fix({0}, 1, 1, 1, 1, 1, 1)\n    "
                        "bearing_{4}.rimpact_bearing(ops, {5}, {0}, {4}, {6})\n",
                        plate_offset + node, at[0], at[1], at[2], node, tag_offset + 100 * node,
                        anchor_offset + nodes_each * node);
  return text;
}

} // namespace

bool is_building_folder(const std::string &folder) {
  std::error_code none;
  const fs::path in(folder);
  return fs::exists(in / "nodes.csv", none) && fs::exists(in / "elements.csv", none) &&
         fs::exists(in / "scene.toml", none);
}

void export_building_bearings(const std::string &folder, const std::string &out, const std::vector<std::string> &header,
                              Console &console) {
  const auto scene = scene::load_scene((fs::path(folder) / "scene.toml").string());
  if (!(scene.reduced.k_i > 0))
    throw InputError(folder + ": reduced.k_i_kN_per_m is 0: the bearings have no rim to export");
  const Frame frame = buildings::load_frame(folder);
  const auto bearings = buildings::bearings_of(frame, scene);
  const auto reactions = buildings::static_reactions(buildings::assemble(frame), scene.load.gravity);
  const auto doubts = buildings::doubts_of_elements(bearings, {reactions.begin(), reactions.end()});
  for (const auto &doubt : doubts) console.warn(doubt);
  std::error_code failure;
  fs::create_directories(out, failure);
  if (failure) throw IoError(fmt::format("{}: {}", out, failure.message()));
  std::vector<Placed> placed;
  auto table = nlohmann::json{{"files", nlohmann::json::array()}, {"limits", limits}};
  table["doubts"] = doubts;
  std::string written;
  const auto write = [&](const std::string &name, const std::string &text) {
    const std::string path = (fs::path(out) / name).string();
    write_atomically(text, path);
    written += path + "\n", table["files"].push_back(path);
  };
  for (std::size_t i = 0, b = 0; i < frame.nodes.size(); ++i) {
    if (!frame.nodes[i].supported) continue;
    scene::Scene own = scene;
    if (bearings[b].rigid_bodies())
      throw InputError(fmt::format(
          "{}: the bearing under node {} is of rigid bodies (\"{}\"): only dishes are exported; {}", folder, i + 1,
          word(bearings[b].reduced.model),
          bearings[b].triple() ? "OpenSees' TripleFrictionPendulum has a triple pendulum's stages without its "
                                 "rims' law (docs/guide/triple-pendulum.md)"
                               : "no element of OpenSees is one"));
    own.bearing = bearings[b].bearing, own.load.vertical = reactions[b];
    ExportedRim rim = rim_of(own, own.bearing, reactions[b]);
    for (const auto &doubt : doubts) rim.statement.push_back("DOUBT: " + doubt);
    const auto springs = calibration::opensees_rim(rim);
    const auto dish = calibration::dish_of(own, rim.lateral_capacity);
    const int node = static_cast<int>(i) + 1;
    write(fmt::format("bearing_{}.tcl", node), calibration::opensees_tcl(rim, springs, dish, header));
    write(fmt::format("bearing_{}.py", node), calibration::opensees_python(rim, springs, dish, header));
    placed.push_back({node, frame.nodes[i].at});
    ++b;
  }
  auto lines = header;
  lines.push_back(
      fmt::format("The building's nodes have the numbers of nodes.csv; plates are nodes {} + N, a bearing's "
                  "own nodes from {} + {} N, elements and materials from {} + 100 N.",
                  plate_offset, anchor_offset, nodes_each, tag_offset));
  lines.push_back(limits);
  write("bearings.tcl", place_tcl(placed, calibration::comment_lines("#", lines)));
  write("bearings.py", place_python(placed, calibration::comment_lines("#", lines)));
  console.message(limits);
  console.data(console.json ? table.dump(2) + "\n" : written);
}

} // namespace rimpact::app
