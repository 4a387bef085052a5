// Where the rim is meshed: arcs about the places touched, joined where they meet, closed where they go round.
#include "meshes/stack_mesh.h"
#include "meshes/touched_places.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace rimpact::meshes {
namespace {

constexpr PlaceSizes sizes{0.02, 0.04, 1.0, 0.45};

/// Size of the grid's interval that starts at an angle.
double size_at(const std::vector<double> &lines, double angle) {
  const auto next = std::upper_bound(lines.begin(), lines.end(), angle + 1e-9);
  return *next - *(next - 1);
}

TEST(TouchedPlaces, AreCountedFromTheFirstAndMergedWhenTheSame) {
  const std::vector<double> expected{0, M_PI / 2, M_PI},
      found = from_the_first({-0.3, M_PI / 2 - 0.3, -0.3 - M_PI, -0.3 + 2 * M_PI});
  ASSERT_EQ(found.size(), 3u);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], 1e-12);
  EXPECT_EQ(folded({0, 1, 2 * M_PI - 1, 4}, 0), (std::vector<double>{0, 1, 2 * M_PI - 4}));
}

TEST(TouchedPlaces, OneThatWouldLeaveASliverBesideAnotherIsThatOne) {
  EXPECT_EQ(folded({0, 0.05, 1, 1.05, M_PI - 0.05}, 0.1), (std::vector<double>{0, 1, M_PI}));
  EXPECT_EQ(folded({0, 0.15, 1, 1.15, M_PI - 0.15}, 0.1), (std::vector<double>{0, 0.15, 1, 1.15, M_PI - 0.15}));
}

TEST(TouchedPlaces, AnchorsOfAGridNeverLieNearerThanHalfItsFineSize) {
  for (double next = 2 * sizes.fine; next < M_PI; next += 0.003) {
    const std::vector<double> lines = graded_lines(anchors_at({0, next}, sizes));
    for (std::size_t k = 0; k + 1 < lines.size(); ++k) EXPECT_GT(lines[k + 1] - lines[k], 0.45 * sizes.fine) << next;
  }
}

TEST(TouchedPlaces, ArcsApartStayApartAndOverlappingOnesAreOne) {
  const auto apart = rim_arcs({0, M_PI}, sizes, false);
  ASSERT_EQ(apart.size(), 2u);
  EXPECT_NEAR(apart[1].angles.front(), M_PI - 1, 1e-12);
  const auto joined = rim_arcs({0, 1.2, M_PI}, sizes, false); // 0 .. 1.2 .. pi are each less than 2 apart
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_NEAR(joined[0].angles.front(), -1, 1e-12);
  EXPECT_NEAR(joined[0].angles.back(), M_PI + 1, 1e-12);
  EXPECT_FALSE(joined[0].closed);
  for (const double place : {0.0, 1.2, M_PI}) EXPECT_LT(size_at(joined[0].angles, place), 0.021);
  EXPECT_GT(size_at(joined[0].angles, 0.5), 0.08);
}

TEST(TouchedPlaces, AnArcBeforeTheFirstPlaceIsJoinedToItAcrossTheTurn) {
  const auto arcs = rim_arcs({0, 2 * M_PI - 0.5}, sizes, false);
  ASSERT_EQ(arcs.size(), 1u);
  EXPECT_NEAR(arcs[0].angles.back() - arcs[0].angles.front(), 2.5, 1e-12);
}

TEST(TouchedPlaces, AHalfArcEndsAtTheSymmetry) {
  const auto arcs = rim_arcs({0, M_PI}, sizes, true);
  ASSERT_EQ(arcs.size(), 2u);
  EXPECT_EQ(arcs[0].angles.front(), 0);
  EXPECT_TRUE(arcs[0].from_symmetry && arcs[1].to_symmetry);
  EXPECT_FALSE(arcs[0].to_symmetry || arcs[1].from_symmetry);
}

TEST(TouchedPlaces, AllRoundTheRimIsAClosedRingOfOnePiece) {
  MeshOrder options{.level = 0, .half = false, .rim = true};
  options.directions = {0.3, 1.9, -1.0, 3.3};
  const HexMesh mesh = stack_mesh(scene::Bearing{}, options); // checks its groups and pieces
  double around = 0, lowest = INFINITY;                       // of the wall's lowest faces, seen from above
  for (const auto &face : mesh.faces)
    if (face.group == Surface::rim_wall)
      for (const unsigned node : face.corners) lowest = std::min(lowest, mesh.nodes[node][2]);
  for (const auto &face : mesh.faces) {
    if (face.group != Surface::rim_wall) continue;
    double low = INFINITY, high = -INFINITY, bottom = INFINITY;
    const double middle = std::atan2(mesh.nodes[face.corners[0]][1], mesh.nodes[face.corners[0]][0]);
    for (const unsigned node : face.corners) {
      const double angle = std::remainder(std::atan2(mesh.nodes[node][1], mesh.nodes[node][0]) - middle, 2 * M_PI);
      low = std::min(low, angle), high = std::max(high, angle), bottom = std::min(bottom, mesh.nodes[node][2]);
    }
    if (bottom < lowest + 1e-6) around += high - low;
  }
  EXPECT_NEAR(around, 2 * M_PI, 1e-6);
  EXPECT_GT(quality(mesh).min_scaled_jacobian, 0.1);
}

TEST(TouchedPlaces, EverySectorOfAWholeModelHasAFineSliderBeforeIt) {
  MeshOrder options{.level = 1, .half = false, .rim = true};
  options.directions = {0.3, 1.9};
  const HexMesh mesh = stack_mesh(scene::Bearing{}, options);
  for (const auto &[group, radius] : {std::pair{Surface::slider_side, 0.1125}, {Surface::rim_wall, 0.52}})
    for (const double direction : options.directions) {
      double smallest = INFINITY; // edge along the surface of the faces at the place
      for (const auto &face : mesh.faces) {
        if (face.group != group) continue;
        for (int k = 0; k < 4; ++k) {
          const auto &a = mesh.nodes[face.corners[k]], &b = mesh.nodes[face.corners[(k + 1) % 4]];
          const bool here =
              std::hypot(a[0] - radius * std::cos(direction), a[1] - radius * std::sin(direction)) < 0.012;
          if (here && std::abs(a[2] - b[2]) < 1e-9) smallest = std::min(smallest, std::hypot(a[0] - b[0], a[1] - b[1]));
        }
      }
      EXPECT_LT(smallest, 0.0125) << static_cast<int>(group) << ' ' << direction;
    }
}

} // namespace
} // namespace rimpact::meshes
