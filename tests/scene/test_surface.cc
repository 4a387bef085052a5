#include "expect_error.h"
#include "scene/surface.h"
#include <cmath>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

SurfaceSpec spec_of(const std::string &kind) {
  SurfaceSpec spec;
  spec.kind = kind;
  return spec;
}

class Surfaces : public testing::TestWithParam<const char *> {
protected:
  std::unique_ptr<SlidingSurface> surface = make_surface(spec_of(GetParam()));
};
INSTANTIATE_TEST_SUITE_P(Kinds, Surfaces, testing::Values("ellipse", "sphere"));

TEST_P(Surfaces, HeightFieldSolvesTheImplicitEquation) {
  for (const double r : {0.0, 0.1, 0.31, 0.5})
    for (const double angle : {0.0, 0.7, 2.5, 4.0}) {
      const double x = r * std::cos(angle), y = r * std::sin(angle);
      const double z = surface->at(x, y).z;
      EXPECT_NEAR(surface->F({x, y, z}), 0, 1e-14);
      EXPECT_LT(surface->F({x, y, z + 1e-3}), 0) << "above the dish is inside";
      EXPECT_GT(surface->F({x, y, z - 1e-3}), 0);
    }
}

TEST_P(Surfaces, DerivativesAgreeWithDifferences) {
  const Eigen::Vector3d p(0.23, -0.31, 0.04);
  constexpr double h = 1e-5;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(i);
    EXPECT_NEAR(surface->gradient(p)[i], (surface->F(p + step) - surface->F(p - step)) / (2 * h), 1e-8);
    EXPECT_TRUE(surface->hessian(p).col(i).isApprox(
        (surface->gradient(p + step) - surface->gradient(p - step)) / (2 * h), 1e-8));
  }
  const auto here = surface->at(p.x(), p.y());
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector2d s = h * Eigen::Vector2d::Unit(i), q = p.head<2>();
    const auto up = surface->at(q.x() + s.x(), q.y() + s.y()),
               down = surface->at(q.x() - s.x(), q.y() - s.y());
    EXPECT_NEAR(here.gradient[i], (up.z - down.z) / (2 * h), 1e-9);
    EXPECT_TRUE(here.hessian.col(i).isApprox((up.gradient - down.gradient) / (2 * h), 1e-7));
  }
}

TEST_P(Surfaces, CurvatureAtTheVertexIsOneOverR0) {
  const auto k = surface->curvatures(0);
  EXPECT_NEAR(k.meridional, 1 / 2.25, 1e-14);
  EXPECT_NEAR(k.circumferential, 1 / 2.25, 1e-14);
}

TEST(Ellipse, LiftAndCurvatureOfTheThesis) {
  const auto surface = make_surface(SurfaceSpec{});
  EXPECT_NEAR(surface->at(0.39, 0).z, 0.03929, 5e-6);
  EXPECT_NEAR(surface->at(0.40, 0).gradient.x(), 0.253, 5e-4);
  EXPECT_NEAR(surface->at(0, 0.52).z, 0.08700, 5e-5);
  // Meridional radius of curvature of an ellipse: (a^4 z'^2-free form) (a^2 sin^2 t + b^2 cos^2 t)^(3/2) / (a
  // b).
  const double a = 0.5625, b = 0.140625, r = 0.37, sine = r / a, cosine = std::sqrt(1 - sine * sine);
  const double radius = std::pow(a * a * cosine * cosine + b * b * sine * sine, 1.5) / (a * b);
  EXPECT_NEAR(surface->curvatures(r).meridional, 1 / radius, 1e-12);
  EXPECT_DOUBLE_EQ(surface->limit_radius(), a);
}

TEST(Sphere, CurvatureIsTheSameEverywhere) {
  const auto surface = make_surface(spec_of("sphere"));
  for (const double r : {0.1, 0.3, 0.5}) {
    EXPECT_NEAR(surface->curvatures(r).meridional, 1 / 2.25, 1e-13);
    EXPECT_NEAR(surface->curvatures(r).circumferential, 1 / 2.25, 1e-13);
    EXPECT_NEAR(surface->at(r, 0).z, 2.25 - std::sqrt(2.25 * 2.25 - r * r), 1e-14);
  }
}

TEST(Surface, RefusesUnknownKindsAndPointsOutside) {
  expect_error<InputError>([] { make_surface(spec_of("elipse")); },
                           {"elipse", "did you mean \"ellipse\"", "sphere"});
  const auto surface = make_surface(SurfaceSpec{});
  EXPECT_THROW(surface->at(0.5625, 0), std::domain_error);
  EXPECT_THROW(surface->at(0.4, 0.4), std::domain_error);
}

} // namespace
