// The rim mesh against closed forms: volumes, areas, nodes on exact surfaces, two bodies that touch but are not one.
#include "io/files/error.h"
#include "meshes/hex_order.h"
#include "meshes/rim_mesh.h"
#include "meshes/section.h"
#include "scene/bearing_catalogue.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Dense>
#include <filesystem>
#include <gtest/gtest.h>

namespace rimpact::meshes {
namespace {

/// Volume of the 27-node cells of one body, 3 x 3 x 3 Gauss points.
double volume(const HexMesh &mesh, Volume body) {
  const double g = std::sqrt(0.6), x[3] = {-g, 0, g}, w[3] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
  double total = 0;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    if (mesh.volumes[c] != body) continue;
    for (int q = 0; q < 27; ++q) {
      const int at[3] = {q % 3, q / 3 % 3, q / 9};
      double N[3][3], dN[3][3];
      for (int d = 0; d < 3; ++d) {
        const double s = x[at[d]];
        N[d][0] = s * (s - 1) / 2, N[d][1] = 1 - s * s, N[d][2] = s * (s + 1) / 2;
        dN[d][0] = s - 0.5, dN[d][1] = -2 * s, dN[d][2] = s + 0.5;
      }
      Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
      for (int a = 0; a < 27; ++a) {
        const auto &p = hex27[a];
        const Eigen::Vector3d node(mesh.nodes[mesh.cells[c][a]].data());
        J += node * Eigen::RowVector3d(dN[0][p[0]] * N[1][p[1]] * N[2][p[2]], N[0][p[0]] * dN[1][p[1]] * N[2][p[2]],
                                       N[0][p[0]] * N[1][p[1]] * dN[2][p[2]]);
      }
      total += w[at[0]] * w[at[1]] * w[at[2]] * J.determinant();
    }
  }
  return total;
}

/// Half slider: cylinder less the spherical cap of the socket less the rounding of the edge.
double exact_slider_half(const scene::Bearing &b) {
  const double R = b.slider.diameter / 2, H = b.slider.top - b.slider.bottom, c = b.slider.bottom,
               S = b.foot.cap_radius, e = b.slider.edge_radius;
  const double depth = S - c, cap = M_PI * depth * depth * (3 * S - depth) / 3;
  const double corner_area = e * e * (1 - M_PI / 4),
               arc_centroid = e - (4 * e / (3 * M_PI)); // of the quarter disc, from the corner
  const double quarter = M_PI * e * e / 4;
  const double corner_centroid =
      (e * e * (R - e / 2) - quarter * (R - arc_centroid)) / corner_area; // radius of the removed corner
  return 0.5 * (M_PI * R * R * H - cap - 2 * M_PI * corner_centroid * corner_area);
}

TEST(RimMesh, VolumesConvergeToClosedForms) {
  const scene::Bearing bearing;
  // Far cells span up to half a radian; a quadratic arc then misses 2e-4 of the volume, 1.5^4 times less a level.
  double last = 1, last_ring = 1;
  for (int level = 1; level <= 2; ++level) {
    const HexMesh mesh = rim_mesh(bearing, {.level = level});
    const double ring = 0.5 * 1.0 * (std::pow(0.56, 2) - std::pow(0.52, 2)) * 0.060; // half angle 1 rad
    const double ring_error = std::abs(volume(mesh, Volume::rim) - ring);
    EXPECT_LT(ring_error, 3e-4 * ring) << "level " << level;
    EXPECT_LT(ring_error, last_ring / 2.5);
    last_ring = ring_error;
    const double slider = volume(mesh, Volume::upper_slider), exact = exact_slider_half(bearing);
    EXPECT_NEAR(slider, exact, 1.5e-3 * exact) << "level " << level;
    EXPECT_LT(std::abs(slider - exact), last / 2.5);
    last = std::abs(slider - exact);
  }
}

TEST(RimMesh, NodesOfTheWallsLieOnTheCylinders) {
  const scene::Bearing bearing;
  const HexMesh mesh = rim_mesh(bearing, {});
  const double bottom = bearing.slider.bottom + scene::lift(bearing, 0.4), e = bearing.slider.edge_radius;
  int n_wall = 0, n_side = 0;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const auto &face : mesh.faces) {
      for (int f = 0; f < 6; ++f) {
        std::array<unsigned, 4> corners;
        for (int k = 0; k < 4; ++k) corners[k] = mesh.cells[c][hex_faces[f][k]];
        if (corners != face.corners) continue;
        for (int a = 0; a < 27; ++a) { // nodes of this face: one coordinate fixed
          const int axis = f / 2;
          if (hex27[a][axis] != (f % 2) * 2) continue;
          const auto &x = mesh.nodes[mesh.cells[c][a]];
          if (face.group == Surface::rim_wall) {
            EXPECT_NEAR(std::hypot(x[0], x[1]), 0.52, 1e-9);
            ++n_wall;
          }
          if (face.group == Surface::slider_side) {
            const double r = std::hypot(x[0] - 0.4, x[1]), z = x[2] - bottom;
            if (z >= e)
              EXPECT_NEAR(r, 0.12, 1e-9);
            else
              EXPECT_NEAR(std::hypot(r - (0.12 - e), z - e), e, 1e-9);
            ++n_side;
          }
        }
      }
    }
  EXPECT_GT(n_wall, 100);
  EXPECT_GT(n_side, 100);
}

TEST(RimMesh, BodiesTouchButAreNotWelded) {
  for (const bool half : {true, false}) {
    const HexMesh mesh = rim_mesh({}, {.half = half});
    EXPECT_EQ(quality(mesh).n_components, 2);
    EXPECT_GT(quality(mesh).min_scaled_jacobian, 0.1);
  }
  const HexMesh half = rim_mesh({}, {}), whole = rim_mesh({}, {.half = false});
  for (const Volume body : {Volume::plate, Volume::rim, Volume::upper_slider})
    EXPECT_NEAR(volume(whole, body), 2 * volume(half, body), 1e-12);
  EXPECT_TRUE(
      std::none_of(whole.faces.begin(), whole.faces.end(), [](const auto &f) { return f.group == Surface::symmetry; }));
}

TEST(RimMesh, LevelsRefineByAboutThreeAndAHalf) {
  const double n[3] = {double(rim_mesh({}, {.level = 1}).cells.size()), double(rim_mesh({}, {.level = 2}).cells.size()),
                       double(rim_mesh({}, {.level = 3}).cells.size())};
  for (int k = 0; k < 2; ++k) {
    EXPECT_GT(n[k + 1] / n[k], 2.2);
    EXPECT_LT(n[k + 1] / n[k], 4.5);
  }
}

TEST(RimMesh, OtherDimensions) {
  for (const double thickness : {0.010, 0.100}) {
    scene::Bearing bearing;
    bearing.rim.thickness = thickness;
    const double outer = 0.52 + thickness, ring = 0.5 * (outer * outer - 0.52 * 0.52) * 0.060;
    EXPECT_NEAR(volume(rim_mesh(bearing, {}), Volume::rim), ring, 3e-4 * ring);
  }
  for (const double angle : {0.5, 1.4}) EXPECT_NO_THROW(rim_mesh({}, {.sector_half_angle = angle}));
  scene::Bearing with_ledge;
  with_ledge.rim.ledge = 0.010;
  EXPECT_EQ(quality(rim_mesh(with_ledge, {})).n_components, 2);
}

/// The plate's cut follows a smaller dish: its cells are sound, and it keeps the built-in bearing's.
TEST(RimMesh, SmallerDishes) {
  EXPECT_EQ(plate_cut_radius(scene::Bearing{}), 0.44);
  for (const double edge : {0.15, 0.25, 0.35, 0.42, 0.45, 0.50}) {
    scene::Bearing bearing;
    const double size = edge / 0.52;
    bearing.surface.kind = scene::SurfaceKind::sphere;
    bearing.surface.R0 = bearing.surface.a = 2.25 * std::sqrt(size);
    bearing.surface.planar_radius = edge;
    bearing.slider.diameter *= size;
    bearing.foot.cap_radius =
        std::min(bearing.foot.cap_radius, 0.9 * std::hypot(bearing.slider.bottom, bearing.slider.diameter / 2));
    for (const int level : {0, 1}) {
      const MeshQuality q = quality(rim_mesh(bearing, {.level = level}));
      EXPECT_GT(q.min_scaled_jacobian, 0.05) << edge << ' ' << level;
      EXPECT_EQ(q.n_components, 2) << edge << ' ' << level;
    }
  }
}

TEST(RimMesh, InvertedCellsAndMissingGroupsAreRefused) {
  HexMesh mesh = rim_mesh({}, {});
  HexMesh bad = mesh;
  std::swap(bad.nodes[bad.cells[0][0]], bad.nodes[bad.cells[0][6]]);
  EXPECT_THROW(check(bad, 2, rim_groups), DataError);
  EXPECT_THROW(check(mesh, 1, rim_groups), DataError);
  mesh.faces.clear();
  EXPECT_THROW(check(mesh, 2, rim_groups), DataError);
}

TEST(GradedLines, HitTheAnchorsAndFollowTheSizes) {
  const auto lines = graded_lines({{0, 1}, {10, 1}, {40, 6}});
  EXPECT_EQ(lines.front(), 0);
  EXPECT_EQ(lines.back(), 40);
  EXPECT_TRUE(std::find(lines.begin(), lines.end(), 10.0) != lines.end());
  EXPECT_TRUE(std::is_sorted(lines.begin(), lines.end()));
  EXPECT_NEAR(lines[1], 1, 1e-12);
  EXPECT_GT(lines.back() - lines[lines.size() - 2], 4);
}

/// What the tilt about the dish's centre makes of a node, undone: from the dish's centre, out and down.
Eigen::Vector3d upright(const std::array<double, 3> &node, const scene::Bearing &b) {
  const double theta = scene::tilt(b, b.lateral_capacity()), x = node[0], down = b.surface.R0 - node[2];
  return {x * std::cos(theta) - down * std::sin(theta), node[1], x * std::sin(theta) + down * std::cos(theta)};
}

TEST(RimMesh, ASliderBetweenTwoDishesStandsTiltedAtTheWall) {
  const scene::Bearing b = scene::builtin_bearing("dcfp-155");
  const double R = b.surface.R0, radius = b.slider.diameter / 2;
  for (int level = 0; level <= 2; ++level) {
    MeshOrder order;
    order.level = level;
    const HexMesh mesh = rim_mesh(b, order);
    EXPECT_EQ(quality(mesh).n_components, 2);
    EXPECT_GT(quality(mesh).min_scaled_jacobian, 0.1) << level;
    double farthest = 0;
    for (const BoundaryFace &face : mesh.faces)
      for (const unsigned corner : face.corners) {
        const Eigen::Vector3d at = upright(mesh.nodes[corner], b);
        if (face.group == Surface::pad_face) EXPECT_NEAR(at.norm(), R, 1e-9);
        if (face.group == Surface::top) EXPECT_NEAR(at.z(), R - b.slider.height / 2, 1e-9);
        if (face.group != Surface::slider_side) continue;
        EXPECT_LT(std::hypot(at.x(), at.y()), radius + 1e-9);
        farthest = std::max(farthest, std::hypot(mesh.nodes[corner][0], mesh.nodes[corner][1]));
      }
    // Nodes of the rounding stand beside the very point of touch.
    EXPECT_LT(farthest, b.wall_radius() + 1e-9);
    EXPECT_GT(farthest, b.wall_radius() - 0.5 * b.slider.edge_radius * std::pow(scene::tilt(b, 0.3), 2));
  }
}

TEST(RimMesh, ASliderBetweenTwoDishesHasItsVolume) {
  const scene::Bearing b = scene::builtin_bearing("dcfp-155");
  MeshOrder order;
  order.level = 2, order.half = false;
  // The lower half of the slider; the rounding takes about (1 - pi / 4) e^2 of the edge's length.
  const double edge = (1 - M_PI / 4) * std::pow(b.slider.edge_radius, 2) * M_PI * b.slider.diameter;
  const double half = scene::slider_mass(b) / b.steel.density / 2 - edge;
  EXPECT_NEAR(volume(rim_mesh(b, order), Volume::upper_slider) / half, 1, 1e-3);
}

} // namespace
} // namespace rimpact::meshes
