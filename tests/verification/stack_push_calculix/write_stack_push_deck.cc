// Writes a push of the whole bearing (rung full) as a CalculiX deck: same mesh (27-node cells reduced to ccx's 20),
// materials, contacts with friction, weight. The stack is placed `before` short of the rim, tilted as the dish is, set
// down, loaded, and slid on into the rim. Units: mm, N, MPa; half model, so that forces in the .dat file are half.
#include "../../benchmarks/peers/rim_calculix/ccx_deck.h"
#include "fe_contact/drive/run.h"
#include "fe_contact/planning/plan.h"
#include "io/files/error.h"
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
using meshes::Volume;

struct Settings {
  std::string file;
  double before = 0.020;      ///< of the way out, before the walls meet [m]
  double first_sinking = 0.4; ///< of the pad's lowest node into the dish, before the load takes over [mm]; ccx gives
                              ///< way to it in its first step
  double longest = 0.025;     ///< longest increment, as a share of the slide
  std::vector<std::string> overrides;
};

/// The stack set down where the slide begins: pad and foot tilted about the socket's centre as the dish is there.
void place(meshes::HexMesh &mesh, const scene::Bearing &bearing, double x0, double sinking) {
  const auto surface = scene::make_surface(bearing.surface);
  const double tilt = std::atan(surface->at(x0, 0).gradient[0]), c = std::cos(tilt), s = std::sin(tilt);
  std::vector<char> of_stack(mesh.nodes.size(), 0), of_foot(mesh.nodes.size(), 0);
  for (std::size_t k = 0; k < mesh.cells.size(); ++k)
    for (const unsigned n : mesh.cells[k]) {
      of_foot[n] |= mesh.volumes[k] == Volume::pad || mesh.volumes[k] == Volume::foot;
      of_stack[n] |= of_foot[n] || mesh.volumes[k] == Volume::upper_slider;
    }
  constexpr double pressed = 1e-8; // into the socket [m]: contact from the start, at 1 MPa
  double rise = -1e9;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    auto &x = mesh.nodes[n];
    if (of_foot[n]) x = {c * x[0] - s * x[2], x[1], s * x[0] + c * x[2] + pressed};
    if (of_stack[n]) x[0] += x0;
  }
  for (const auto &face : mesh.faces)
    if (face.group == Surface::pad_face)
      for (const unsigned n : face.corners)
        rise = std::max(rise, surface->at(mesh.nodes[n][0], mesh.nodes[n][1]).z - mesh.nodes[n][2]);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    if (of_stack[n]) mesh.nodes[n][2] += rise - 1e-3 * sinking;
}

/// The top face stays level: the heights of its nodes are that of the first.
std::string level(const std::set<unsigned> &top) {
  std::string text;
  for (const unsigned n : top)
    if (n != *top.begin()) text += fmt::format("*EQUATION\n2\n{}, 3, 1., {}, 3, -1.\n", n + 1, *top.begin() + 1);
  return text;
}

/// Soft springs that keep the foot from tumbling while ccx seeks its seat [N/mm]; the contacts' own forces hold none of
/// theirs.
std::string springs(const meshes::HexMesh &mesh, const std::set<unsigned> &foot, std::size_t first_element) {
  std::string text;
  const auto by = [&](int i) {
    return [&mesh, i](unsigned a, unsigned b) { return mesh.nodes[a][i] < mesh.nodes[b][i]; };
  };
  const auto [left, right] = std::minmax_element(foot.begin(), foot.end(), by(0));
  const auto [low, high] = std::minmax_element(foot.begin(), foot.end(), by(2));
  for (const int component : {1, 3}) {
    text += fmt::format("*ELEMENT, TYPE=SPRING1, ELSET=HOLD{}\n", component);
    for (const unsigned n : {*left, *right, *low, *high}) text += fmt::format("{}, {}\n", first_element++, n + 1);
    text += fmt::format("*SPRING, ELSET=HOLD{0}\n{0}\n100.\n", component);
  }
  return text;
}

std::string step(double first, double longest, const std::string &boundary) {
  std::string text =
      fmt::format("*STEP, NLGEOM, INC=4000\n*STATIC\n{:g}, 1., 1e-7, {:g}\n{}", first, longest, boundary);
  text += "*NODE PRINT, NSET=TOP, TOTALS=ONLY\nRF\n*NODE PRINT, NSET=TOP_ONE\nU\n";
  for (const char *pair : {"SLAVE=pad_face, MASTER=dish", "SLAVE=slider_side, MASTER=rim_wall"})
    text += fmt::format("*CONTACT PRINT, {}\nCF\n", pair);
  return text + "*END STEP\n";
}

void write(const Settings &settings) {
  scene::Scene scene = scene::load_scene("rim-push", settings.overrides);
  scene.model.rung = scene::Rung::full;
  const planning::Plan plan = planning::make_plan(scene);
  if (!plan.half) throw InputError("the deck is that of rung full's symmetric half");
  meshes::HexMesh mesh = fe::mesh_of(scene, plan);
  place(mesh, scene.bearing, scene.bearing.lateral_capacity() - settings.before, settings.first_sinking);
  const DeckMesh deck(mesh, 20);
  const std::set<unsigned> top = deck.nodes_of(Surface::top);
  std::set<unsigned> fixed = deck.nodes_of(Surface::fixed), symmetry = deck.nodes_of(Surface::symmetry);
  for (const unsigned n : deck.nodes_of(Surface::sector_end)) fixed.insert(n);
  for (const auto &held : {fixed, top})
    for (const unsigned n : held) symmetry.erase(n);
  const double end = 1e3 * (settings.before + scene.excitation.travel * scene.excitation.scale);
  const auto &b = scene.bearing;
  const std::string weight =
      fmt::format("*CLOAD, AMPLITUDE=AT_ONCE\n{}, 3, {:g}\n", *top.begin() + 1, -scene.load.vertical / 2);
  const std::string held = "*BOUNDARY, OP=NEW\nFIXED, 1, 3\nSYMMETRY, 2, 2\nTOP, 2, 2\n";

  std::ofstream file(settings.file);
  file << "*HEADING\npush of the whole bearing " << b.name << ", mesh " << scene.model.mesh
       << ", half model; mm, N, MPa\n"
       << deck.nodes_and_elements("C3D20R") << springs(mesh, deck.nodes_of(Volume::foot), mesh.cells.size() + 1)
       << node_set("FIXED", fixed) << node_set("TOP", top) << node_set("TOP_ONE", {*top.begin()})
       << node_set("SYMMETRY", symmetry);
  for (const Surface group :
       {Surface::pad_face, Surface::dish, Surface::foot_cap, Surface::socket, Surface::slider_side, Surface::rim_wall})
    file << deck.surface(group);
  file << material("STEEL", b.steel) << material("ERTALYTE", b.ertalyte);
  for (const Volume volume : {Volume::plate, Volume::rim, Volume::foot, Volume::upper_slider, Volume::pad})
    if (!deck.nodes_of(volume).empty())
      file << "*SOLID SECTION, ELSET=" << to_string(volume)
           << ", MATERIAL=" << (volume == Volume::pad ? "ERTALYTE\n" : "STEEL\n");
  // Penalties that leave some micrometres of penetration at the pressures each pair carries.
  file << contact("SLIDING", "pad_face", "dish", 5e3, b.contact.steel_ertalyte)
       << contact("JOINT", "foot_cap", "socket", 1e5, b.contact.steel_steel)
       << contact("WALLS", "slider_side", "rim_wall", 1e7, b.contact.rim) << level(top)
       << "*AMPLITUDE, NAME=AT_ONCE\n0., 1., 1., 1.\n"
       << step(0.1, 0.25, held + "TOP, 1, 1\nTOP_ONE, 3, 3\n") << step(0.1, 0.5, held + "TOP, 1, 1\n" + weight)
       << step(0.001, settings.longest, held + fmt::format("TOP, 1, 1, {:g}\n", 1e3 * settings.before - 0.02) + weight)
       << step(0.002, settings.longest,
               held + fmt::format("TOP, 1, 1, {:g}\n", end) + weight); // the walls meet at once
  if (!file.flush()) throw Error(ExitCode::io, "cannot write " + settings.file);
}

} // namespace
} // namespace rimpact::verification

int main(int argc, char **argv) {
  rimpact::verification::Settings settings;
  CLI::App app("Writes a push of the whole bearing as a CalculiX deck");
  app.add_option("deck", settings.file, "the .inp file")->required();
  app.add_option("--before", settings.before, "way before the walls meet, m")->check(CLI::PositiveNumber);
  app.add_option("--sinking", settings.first_sinking, "first sinking of the pad into the dish, mm")
      ->check(CLI::PositiveNumber);
  app.add_option("--longest", settings.longest, "longest increment, of the slide")->check(CLI::Range(1e-4, 1.0));
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
