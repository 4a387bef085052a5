// Writes an indentation as a CalculiX deck: our own mesh (27-node cells reduced to ccx's), material, supports
// and path; a finely meshed cap, all its nodes given the sphere's travel, stands for the rigid sphere (the
// same as a *RIGID BODY in translation, with fewer equations). Units: mm, N, MPa. The quarter is written:
// reactions in the .dat file are a quarter of the sphere's.
#include "../../benchmarks/peers/rim_calculix/ccx_deck.h"
#include "problem.h"
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fstream>
#include <iostream>

namespace rimpact::verification {
namespace {

using meshes::Surface;

struct Settings {
  std::string problem, file, element = "C3D20R", contact = "SURFACE TO SURFACE";
  int cells = 0, cap_cells = 8;
  double longest = 1; ///< longest increment, as a share of the step
};

std::string material(const Problem &p) {
  std::string text = fmt::format("*MATERIAL, NAME=BLOCK\n*ELASTIC\n{}, {}\n", 1e-6 * p.material.E, p.material.nu);
  if (p.material.yield) { // Cauchy stress over logarithmic plastic strain, linear far beyond what is reached
    const double yield = 1e-6 * *p.material.yield, hardening = 1e-6 * hardening_modulus(p.material);
    text += fmt::format("*PLASTIC\n{:.9g}, 0.\n{:.9g}, 2.\n", yield, yield + 2 * hardening);
  }
  return text + "*SOLID SECTION, ELSET=rim, MATERIAL=BLOCK\n*MATERIAL, NAME=CAP\n*ELASTIC\n200000., 0.3\n"
                "*SOLID SECTION, ELSET=upper_slider, MATERIAL=CAP\n";
}

/// Node sets of the supports, free of overlaps: a node's component is held by one card only.
std::string sets(const Problem &p, const meshes::HexMesh &mesh, const DeckMesh &deck) {
  const double edge = 1e-9 * p.side();
  std::set<unsigned> bottom, x_plane, y_plane, cap;
  for (const unsigned n : deck.nodes_of(meshes::Volume::upper_slider)) cap.insert(n);
  for (const unsigned n : deck.nodes_of(meshes::Volume::rim)) {
    const auto &x = mesh.nodes[n];
    if (x[2] < edge - p.side()) {
      bottom.insert(n);
      continue;
    }
    if (x[0] < edge) x_plane.insert(n);
    if (x[1] < edge) y_plane.insert(n);
  }
  return node_set("BOTTOM", bottom) + node_set("X_PLANE", x_plane) + node_set("Y_PLANE", y_plane) +
         node_set("CAP", cap);
}

std::string contact(const Problem &p, const Settings &settings) {
  return fmt::format("*SURFACE INTERACTION, NAME=SPHERE\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{:g}\n"
                     "*FRICTION\n{:g}, {:g}\n*CONTACT PAIR, INTERACTION=SPHERE, TYPE={}\nslider_side, rim_wall\n",
                     1e-9 * p.ccx_stiffness, p.mu, 1e-10 * p.ccx_stiffness, settings.contact);
}

void write(const Settings &settings) {
  const Problem p = problem(settings.problem);
  meshes::HexMesh mesh = block(p, settings.cells);
  add_cap(mesh, p, settings.cap_cells);
  const bool quadratic = settings.element.starts_with("C3D20");
  const DeckMesh deck(mesh, quadratic ? 20 : 8);
  std::ofstream file(settings.file);
  file << "*HEADING\nindentation " << p.name << ", " << settings.cells << " cells a direction; mm, N, MPa\n"
       << deck.nodes_and_elements(settings.element, {{meshes::Volume::upper_slider, quadratic ? "C3D20R" : "C3D8"}})
       << sets(p, mesh, deck) << deck.surface(Surface::slider_side) << deck.surface(Surface::rim_wall) << material(p)
       << contact(p, settings) << "*BOUNDARY\nBOTTOM, 1, 3\nX_PLANE, 1, 1\nY_PLANE, 2, 2\n"
       << fmt::format("*STEP, NLGEOM, INC=2000\n*STATIC\n0.1, 1., 1e-6, {:g}\n", settings.longest)
       << fmt::format("*BOUNDARY\nCAP, 1, 2\nCAP, 3, 3, {:.12g}\n", -1e3 * p.depth)
       << "*NODE PRINT, NSET=CAP, TOTALS=ONLY\nRF\n*END STEP\n";
  if (!file.flush()) throw std::runtime_error("cannot write " + settings.file);
}

} // namespace
} // namespace rimpact::verification

int main(int argc, char **argv) {
  rimpact::verification::Settings settings;
  CLI::App app("Writes an indentation as a CalculiX deck");
  app.add_option("problem", settings.problem, "elastic or steel")->required();
  app.add_option("cells", settings.cells, "cells a direction")->required()->check(CLI::Range(2, 100));
  app.add_option("deck", settings.file, "the .inp file")->required();
  app.add_option("--element", settings.element)->check(CLI::IsMember({"C3D20R", "C3D20", "C3D8", "C3D8I"}));
  app.add_option("--contact", settings.contact)->check(CLI::IsMember({"SURFACE TO SURFACE", "NODE TO SURFACE"}));
  app.add_option("--cap-cells", settings.cap_cells, "a direction of the cap")->check(CLI::Range(2, 400));
  app.add_option("--longest", settings.longest, "longest increment, of the step's 1")->check(CLI::Range(1e-4, 1.0));
  CLI11_PARSE(app, argc, argv);
  try {
    rimpact::verification::write(settings);
  } catch (const std::exception &error) {
    std::cerr << "error: " << error.what() << "\n";
    return 2;
  }
  return 0;
}
