// The stack's mesh: volumes, tied and touching parts, nodes on the exact sphere of cap and socket.
#include "meshes/stack_mesh.h"

#include "scene/bearing_catalogue.h"
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace rimpact::meshes {
namespace {

std::set<unsigned> nodes_of(const HexMesh &mesh, Volume volume) {
  std::set<unsigned> result;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    if (mesh.volumes[c] == volume) result.insert(mesh.cells[c].begin(), mesh.cells[c].end());
  return result;
}

TEST(StackMesh, PadAndFootShareTheSeatAndNothingElse) {
  const HexMesh mesh = stack_mesh(scene::Bearing{}, {});
  const auto pad = nodes_of(mesh, Volume::pad), foot = nodes_of(mesh, Volume::foot);
  int shared = 0;
  for (const unsigned node : pad) {
    const auto &x = mesh.nodes[node];
    const bool on_the_seat = std::abs(x[2] - 0.040) < 1e-9;
    EXPECT_EQ(foot.count(node) > 0, on_the_seat) << x[0] << ' ' << x[1] << ' ' << x[2];
    shared += on_the_seat;
  }
  EXPECT_GT(shared, 50);
}

TEST(StackMesh, AFrictionalPadStandsInARecessWithNodesOfItsOwn) {
  for (const double clearance : {0.0, 3e-4}) {
    scene::Bearing bearing;
    bearing.contact.pad_foot = scene::PadFoot::frictional;
    bearing.contact.pad_clearance = clearance;
    const HexMesh mesh = stack_mesh(bearing, {});
    EXPECT_EQ(quality(mesh).n_components, 3);
    EXPECT_GT(quality(mesh).min_scaled_jacobian, 0.1);
    const auto pad = nodes_of(mesh, Volume::pad), foot = nodes_of(mesh, Volume::foot);
    for (const unsigned node : pad) EXPECT_EQ(foot.count(node), 0u);
    std::map<Surface, int> faces;
    for (const auto &face : mesh.faces) {
      ++faces[face.group];
      const bool seat = face.group == Surface::pad_top || face.group == Surface::foot_seat,
                 wall = face.group == Surface::pad_side || face.group == Surface::foot_recess;
      for (const unsigned node : face.corners) {
        const auto &x = mesh.nodes[node];
        if (seat) {
          EXPECT_NEAR(x[2], bearing.pad.thickness, 1e-12);
        }
        if (!wall) continue;
        const double gap = face.group == Surface::foot_recess ? clearance : 0.0;
        EXPECT_NEAR(std::hypot(x[0], x[1]), bearing.pad.outer_radius + gap, 1e-12);
        if (face.group == Surface::foot_recess) {
          EXPECT_GE(x[2], bearing.foot.bottom - 1e-12);
        }
      }
    }
    EXPECT_GT(faces[Surface::foot_seat], faces[Surface::pad_top]); // the pad's hole is roofed too
    EXPECT_GT(faces[Surface::pad_side], 10);
    EXPECT_GT(faces[Surface::foot_recess], 5);
  }
}

TEST(StackMesh, CapAndSocketLieOnOneSphere) {
  for (const int level : {1, 2}) {
    MeshOrder options;
    options.level = level;
    const HexMesh mesh = stack_mesh(scene::Bearing{}, options);
    int cap = 0, socket = 0;
    for (const auto &face : mesh.faces) {
      if (face.group != Surface::foot_cap && face.group != Surface::socket) continue;
      for (const unsigned node : face.corners) {
        const auto &x = mesh.nodes[node];
        EXPECT_NEAR(std::hypot(x[0], x[1], x[2]), 0.090, 1e-9);
      }
      ++(face.group == Surface::foot_cap ? cap : socket);
    }
    EXPECT_GT(cap, 20);
    EXPECT_GT(socket, 12);
  }
}

TEST(StackMesh, CellsAreSoundAtEveryLevelWholeAndHalfWithAndWithoutRim) {
  for (const bool half : {true, false})
    for (const bool rim : {false, true})
      for (const int level : {1, 2, 3}) {
        if (level == 3 && !half) continue;
        MeshOrder options;
        options.level = level;
        options.half = half;
        options.rim = rim;
        options.directions = {half ? M_PI : 0.3};
        if (rim) options.directions.push_back(options.directions[0] + M_PI);
        const HexMesh mesh = stack_mesh(scene::Bearing{}, options);
        const MeshQuality q = quality(mesh);
        EXPECT_GT(q.min_scaled_jacobian, 0.1) << level << half << rim;
        EXPECT_LT(q.worst_aspect, 100) << level << half << rim;
      }
}

double shortest_edge(const HexMesh &mesh, Surface group) {
  double shortest = INFINITY;
  for (const auto &face : mesh.faces)
    for (int k = 0; k < 4 && face.group == group; ++k) {
      const auto &a = mesh.nodes[face.corners[k]], &b = mesh.nodes[face.corners[(k + 1) % 4]];
      shortest = std::min(shortest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
  return shortest;
}

/// A sliver at the socket carries a point's whole force and flows: twice the time, and a plastic strain that is
/// the mesh's own.
TEST(StackMesh, CellsAreSoundWhereverTheSecondPlaceIs) {
  for (const int level : {0, 1})
    for (const double degrees : {6, 9, 12, 24, 30, 60, 90, 105, 120, 147, 156, 165, 174, 177, 182, 200, 290}) {
      MeshOrder options{.level = level, .half = false, .rim = true};
      options.directions = {0.3, 0.3 + degrees * M_PI / 180};
      const HexMesh mesh = stack_mesh(scene::Bearing{}, options);
      EXPECT_GT(quality(mesh).min_scaled_jacobian, 0.13) << level << ' ' << degrees;
      EXPECT_GT(shortest_edge(mesh, Surface::socket), level == 0 ? 0.0018 : 0.0008) << level << ' ' << degrees;
    }
}

TEST(StackMesh, TheWholePlateCarriesTheExactDishFromItsMiddleToItsEdge) {
  for (const bool both : {false, true}) {
    MeshOrder options;
    options.rim = options.whole_plate = true;
    if (both) options.directions = {0, M_PI};
    const scene::Bearing bearing;
    const HexMesh mesh = stack_mesh(bearing, options);
    const MeshQuality q = quality(mesh);
    EXPECT_EQ(q.n_components, 3);
    EXPECT_GT(q.min_scaled_jacobian, 0.05); // slender cells of the core, where nothing happens
    const auto surface = scene::make_surface(bearing.surface);
    double area = 0, nearest = 1, farthest = 0, to_minus_x = 0;
    for (const auto &face : mesh.faces) {
      if (face.group == Surface::rim_wall)
        for (const unsigned node : face.corners) to_minus_x = std::min(to_minus_x, mesh.nodes[node][0]);
      if (face.group != Surface::dish) continue;
      double plan = 0;
      for (int k = 0; k < 4; ++k) {
        const auto &a = mesh.nodes[face.corners[k]], &b = mesh.nodes[face.corners[(k + 1) % 4]];
        const double r = std::hypot(a[0], a[1]);
        EXPECT_NEAR(a[2], surface->at(r, 0).z, 1e-9);
        nearest = std::min(nearest, r);
        farthest = std::max(farthest, r);
        plan += 0.5 * (a[0] * b[1] - a[1] * b[0]);
      }
      area += std::abs(plan);
    }
    EXPECT_NEAR(area, 0.5 * M_PI * 0.52 * 0.52, 0.01 * 0.42); // chords for arcs
    EXPECT_LT(nearest, 0.03);
    EXPECT_NEAR(farthest, 0.52, 1e-9);
    EXPECT_NEAR(to_minus_x, both ? -0.52 : 0.0, 1e-6);
    EXPECT_LT(q.n_nodes, both ? 22000u : 15000u);
  }
}

/// Rung rigid-dish between two dishes: half the slider, whose middle plane has its image in x = 0, and its face whole.
TEST(StackMesh, ASliderBetweenTwoDishesIsItsOwnImage) {
  const scene::Bearing bearing = scene::builtin_bearing("dcfp-155");
  for (const std::vector<double> &directions : {std::vector<double>{0}, {0, M_PI}, {0, 1.2}})
    for (const int level : {0, 1}) {
      const bool half = directions.size() < 2 || directions[1] == M_PI;
      const HexMesh mesh = stack_mesh(bearing, {.level = level, .half = half, .rim = true, .directions = directions});
      EXPECT_GT(quality(mesh).min_scaled_jacobian, 0.05);
      std::set<std::array<long, 2>> places;
      double reach = 0;
      for (const auto &face : mesh.faces)
        for (const unsigned node : face.corners) {
          const auto &x = mesh.nodes[node];
          if (face.group == Surface::top) places.insert({std::lround(x[0] * 1e8), std::lround(x[1] * 1e8)});
          if (face.group != Surface::pad_face) continue;
          reach = std::max(reach, std::hypot(x[0], x[1]));
          EXPECT_NEAR(std::hypot(x[0], x[1], x[2] - bearing.surface.R0), bearing.surface.R0, 1e-12);
        }
      const double R = bearing.surface.R0, edge = bearing.slider.edge_radius;
      EXPECT_NEAR(reach, (bearing.slider.diameter / 2 - edge) * R / (R - edge), 1e-9) << "where the rounding begins";
      for (const auto &[x, y] : places) EXPECT_TRUE(places.count({-x, half ? y : -y})) << x << ' ' << y;
    }
}

} // namespace
} // namespace rimpact::meshes
