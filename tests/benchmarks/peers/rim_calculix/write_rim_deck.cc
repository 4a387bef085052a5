// Writes the scene `rim-push`, or `impact-window` as it comes (no weight, no friction), as a CalculiX deck: same mesh
// (27-node cells reduced to ccx's), material, mass and boundary conditions as fe_contact/drive/path_run.cc and
// rungs/rim.cc. Units: mm, N, MPa, t, s. The half model is written: forces in the .dat file are half of the bearing's.
#include "ccx_deck.h"
#include "fe_contact/drive/order.h"
#include "fe_contact/drive/path_course.h"
#include "fe_contact/engine/solid.h"
#include "fe_contact/planning/plan.h"
#include "io/files/error.h"
#include "meshes/rim_mesh.h"
#include "reduced_models/bearings/physical_model.h"
#include "scene/scene.h"
#include <algorithm>
#include <CLI/CLI.hpp>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <iostream>

namespace rimpact::verification {
namespace {

using meshes::Surface;

struct Settings {
  std::string file, scene = "rim-push", element = "C3D20R";
  double contact_stiffness = 1e7; ///< [MPa/mm]: 50 E over a millimetre
  double withdrawal = 1.5;        ///< travel of unloading [mm]
  double longest = 0.0625;        ///< longest increment of a push, as a share of a step
  double longest_ms = 0.5;        ///< longest increment of a window
  std::vector<std::string> overrides;
};

/// Groups as node sets, free of overlaps: a node is held by one card only.
std::string sets_and_surfaces(const DeckMesh &deck, const meshes::HexMesh &mesh, const meshes::MeshOrder &options,
                              double cut_radius) {
  const std::set<unsigned> fixed = deck.nodes_of(Surface::fixed), top = deck.nodes_of(Surface::top);
  auto symmetry = deck.nodes_of(Surface::symmetry);
  std::set<unsigned> inner, end, cuts;
  for (const unsigned n : deck.nodes_of(Surface::sector_end)) {
    if (fixed.count(n)) continue;
    const auto &x = mesh.nodes[n];
    cuts.insert(n);
    if (std::hypot(x[0], x[1]) < cut_radius + 1e-9) inner.insert(n);
    if (std::abs(std::atan2(x[1], x[0]) - options.sector_half_angle) < 1e-9 || symmetry.count(n)) end.insert(n);
  }
  for (const auto &others : std::initializer_list<std::set<unsigned>>{fixed, top, cuts})
    for (const unsigned n : others) symmetry.erase(n);
  return node_set("FIXED", fixed) + node_set("TOP", top) + node_set("TOP_ONE", {*top.begin()}) +
         node_set("SYMMETRY", symmetry) + node_set("CUTS", cuts) + node_set("CUT_INNER", inner) +
         node_set("CUT_END", end) + deck.surface(Surface::slider_side) + deck.surface(Surface::rim_wall) +
         deck.surface(Surface::dish);
}

/// The top face's path over total time: pressed in during [0, 1], withdrawn during [1, 2].
std::string path(const scene::Scene &scene, const Settings &settings) {
  const reduced::PhysicalModel model(scene);
  const fe::RimFrame frame =
      fe::RimFrame::of(scene.bearing, 0, model.height(scene.bearing.lateral_capacity(), 0).z, false);
  const double deepest = scene.excitation.travel * scene.excitation.scale, back = 1e-3 * settings.withdrawal;
  std::string x = "*AMPLITUDE, NAME=ALONG, TIME=TOTAL TIME\n", z = "*AMPLITUDE, NAME=UP, TIME=TOTAL TIME\n";
  constexpr int points = 128; // the height follows a curve, the cards a polygon
  for (int n = 0; n <= points; ++n) {
    const double time = 2.0 * n / points;
    const double travel = time <= 1 ? deepest * time : deepest - back * (time - 1);
    const fe::TopTarget top = fe::beyond_touch(frame, &model, travel);
    x += fmt::format("{:.12g}, {:.12g}\n", time, 1e3 * top.plane.x());
    z += fmt::format("{:.12g}, {:.12g}\n", time, 1e3 * *top.height);
  }
  return x + z;
}

std::string push_step(const Settings &settings, const char *boundary) {
  return fmt::format("*STEP, NLGEOM, INC=2000\n*STATIC\n0.01, 1., 1e-7, {:g}\n{}", settings.longest, boundary) +
         "*NODE PRINT, NSET=TOP, TOTALS=ONLY\nRF\n*NODE PRINT, NSET=TOP_ONE\nU\n*END STEP\n";
}

std::string push(const scene::Scene &scene, const Settings &settings) {
  return path(scene, settings) + "*BOUNDARY\nTOP, 2, 2\n" +
         push_step(settings, "*BOUNDARY, AMPLITUDE=ALONG\nTOP, 1, 1, 1.\n*BOUNDARY, AMPLITUDE=UP\nTOP, 3, 3, 1.\n") +
         push_step(settings, "");
}

/// What the slider's top carries, as a mass that its nodes follow along x [t]: the bearing's but for what the slider
/// has itself.
double mass_on_top(const scene::Scene &scene, const meshes::HexMesh &mesh) {
  const fe::Discretisation space(mesh, 2);
  return 1e-3 * (scene.load.mass / 2 - fe::Solid(space, scene.bearing).mass_of(meshes::Volume::upper_slider));
}

/// The slider thrown at the wall it touches; its top moves along x as one, its height held.
std::string window(const scene::Scene &scene, const Settings &settings, const meshes::HexMesh &mesh,
                   const DeckMesh &deck) {
  const auto top = deck.nodes_of(Surface::top);
  const unsigned leader = *top.begin() + 1;
  std::string text = fmt::format("*ELEMENT, TYPE=MASS, ELSET=WEIGHT\n{}, {}\n*MASS, ELSET=WEIGHT\n{:.9g}\n",
                                 mesh.cells.size() + 1, leader, mass_on_top(scene, mesh));
  for (const unsigned node : top)
    if (node + 1 != leader) text += fmt::format("*EQUATION\n2\n{}, 1, 1., {}, 1, -1.\n", node + 1, leader);
  text += node_set("SLIDER", deck.nodes_of(meshes::Volume::upper_slider));
  text += fmt::format("*BOUNDARY\nTOP, 2, 3\n*INITIAL CONDITIONS, TYPE=VELOCITY\nSLIDER, 1, {:g}\n",
                      1e3 * scene.excitation.speed);
  return text +
         fmt::format("*STEP, NLGEOM, INC=20000\n*DYNAMIC, ALPHA=-0.3\n2e-5, {:g}, 1e-9, {:g}\n",
                     scene.excitation.duration, 1e-3 * settings.longest_ms) +
         "*NODE PRINT, NSET=TOP_ONE\nU, V\n*CONTACT PRINT, SLAVE=slider_side, MASTER=rim_wall\nCF\n*END STEP\n";
}

void write(const Settings &settings) {
  const scene::Scene scene = scene::load_scene(settings.scene, settings.overrides);
  planning::Plan plan = planning::make_plan(scene);
  const auto options = fe::mesh_order(scene, plan);
  if (!options.half) throw InputError("the deck is that of a symmetric half; leave model.symmetry at auto");
  const meshes::HexMesh mesh = meshes::rim_mesh(scene.bearing, options);
  const DeckMesh deck(mesh, settings.element.starts_with("C3D20") ? 20 : 8);
  const fe::RimFrame frame = fe::RimFrame::of(scene.bearing, 0, 0, settings.scene != "rim-push");

  std::ofstream file(settings.file);
  file << "*HEADING\n"
       << settings.scene << " of " << scene.bearing.name << ", mesh " << options.level
       << ", half model; mm, N, MPa, t, s\n"
       << fmt::format("** FRAME {:.12g} {:.12g} {:.12g}\n", frame.rate_ratio(), frame.reach, frame.turn)
       << deck.nodes_and_elements(settings.element)
       << sets_and_surfaces(deck, mesh, options, meshes::plate_cut_radius(scene.bearing))
       << material("STEEL", scene.bearing.steel) << fmt::format("*DENSITY\n{:g}\n", 1e-12 * scene.bearing.steel.density)
       << contact("WALLS", "slider_side", "rim_wall", settings.contact_stiffness, 0);
  if (scene.bearing.double_concave())
    file << contact("EDGE", "slider_side", "dish", settings.contact_stiffness, scene.bearing.contact.steel_ertalyte);
  for (const auto volume : {"plate", "rim", "upper_slider"})
    file << "*SOLID SECTION, ELSET=" << volume << ", MATERIAL=STEEL\n";
  file << "*TRANSFORM, NSET=CUTS, TYPE=C\n0., 0., 0., 0., 0., 1.\n" // 1 radial, 2 circumferential
       << "*BOUNDARY\nFIXED, 1, 3\nSYMMETRY, 2, 2\nCUT_INNER, 1, 1\nCUT_END, 2, 2\n"
       << (settings.scene == "rim-push" ? push(scene, settings) : window(scene, settings, mesh, deck));
  if (!file.flush()) throw Error(ExitCode::io, "cannot write " + settings.file);
}

} // namespace
} // namespace rimpact::verification

int main(int argc, char **argv) {
  rimpact::verification::Settings settings;
  CLI::App app("Writes rim-push or impact-window as a CalculiX deck");
  app.add_option("deck", settings.file, "the .inp file")->required();
  app.add_option("--scene", settings.scene)->check(CLI::IsMember({"rim-push", "impact-window"}));
  app.add_option("--element", settings.element)->check(CLI::IsMember({"C3D20R", "C3D20", "C3D8", "C3D8I"}));
  app.add_option("--contact-stiffness", settings.contact_stiffness, "MPa/mm")->check(CLI::PositiveNumber);
  app.add_option("--withdrawal", settings.withdrawal, "travel of unloading, mm")->check(CLI::PositiveNumber);
  app.add_option("--longest", settings.longest, "longest increment of a push, of a step's 1")
      ->check(CLI::Range(1e-4, 1.0));
  app.add_option("--longest-ms", settings.longest_ms, "longest increment of a window")->check(CLI::PositiveNumber);
  app.add_option("--set", settings.overrides, "KEY=VALUE of the scene")->allow_extra_args(false);
  CLI11_PARSE(app, argc, argv);
  try {
    rimpact::verification::write(settings);
  } catch (const rimpact::Error &error) {
    std::cerr << error.what() << "\n";
    return int(error.code());
  }
  return 0;
}
