#include "expect_error.h"
#include "scene/surface.h"
#include <cmath>
#include <Eigen/LU>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

SurfaceSpec spec_of(SurfaceKind kind) {
  SurfaceSpec spec;
  spec.kind = kind;
  if (kind == SurfaceKind::polynomial) spec.coefficients = {1 / 4.5, 0.3, -0.2, 0.4, 0.5};
  if (kind == SurfaceKind::table)
    for (const double r : {0.0, 0.06, 0.1, 0.17, 0.28, 0.37, 0.44, 0.53, 0.6}) { // no cubic at all
      spec.table_radius.push_back(r);
      spec.table_height.push_back(r * r / 4.5 + 0.004 * (1 - std::cos(9 * r)));
    }
  return spec;
}
SurfaceSpec table_of(double (*height)(double), std::size_t n_rows, double end) {
  SurfaceSpec spec;
  spec.kind = SurfaceKind::table;
  for (std::size_t i = 0; i < n_rows; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(n_rows - 1);
    spec.table_radius.push_back(end * s * (0.6 + 0.4 * s)); // rows need not be equally far apart
    spec.table_height.push_back(height(spec.table_radius.back()));
  }
  return spec;
}

class Surfaces : public testing::TestWithParam<SurfaceKind> {
protected:
  std::unique_ptr<SlidingSurface> surface_ = make_surface(spec_of(GetParam()));
};
INSTANTIATE_TEST_SUITE_P(Kinds, Surfaces,
                         testing::Values(SurfaceKind::ellipse, SurfaceKind::sphere, SurfaceKind::cone,
                                         SurfaceKind::polynomial, SurfaceKind::table),
                         [](const auto &kind) { return word(kind.param); });

TEST_P(Surfaces, HeightFieldSolvesTheImplicitEquation) {
  for (const double r : {0.0, 0.1, 0.31, 0.5})
    for (const double angle : {0.0, 0.7, 2.5, 4.0}) {
      const double x = r * std::cos(angle), y = r * std::sin(angle);
      const double z = surface_->at(x, y).z;
      EXPECT_NEAR(surface_->F({x, y, z}), 0, 1e-14);
      EXPECT_LT(surface_->F({x, y, z + 1e-3}), 0) << "above the dish is inside";
      EXPECT_GT(surface_->F({x, y, z - 1e-3}), 0);
    }
}

TEST_P(Surfaces, DerivativesAgreeWithDifferences) {
  const Eigen::Vector3d p(0.23, -0.31, 0.04);
  constexpr double h = 1e-5;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(i);
    EXPECT_NEAR(surface_->gradient(p)[i], (surface_->F(p + step) - surface_->F(p - step)) / (2 * h), 1e-8);
    EXPECT_TRUE(surface_->hessian(p).col(i).isApprox(
        (surface_->gradient(p + step) - surface_->gradient(p - step)) / (2 * h), 1e-8));
  }
  const auto here = surface_->at(p.x(), p.y());
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector2d s = h * Eigen::Vector2d::Unit(i), q = p.head<2>();
    const auto up = surface_->at(q.x() + s.x(), q.y() + s.y()), down = surface_->at(q.x() - s.x(), q.y() - s.y());
    EXPECT_NEAR(here.gradient[i], (up.z - down.z) / (2 * h), 1e-9);
    EXPECT_TRUE(here.hessian.col(i).isApprox((up.gradient - down.gradient) / (2 * h), 1e-7));
  }
}

TEST_P(Surfaces, CurvatureAtTheVertexIsOneOverR0) {
  if (GetParam() == SurfaceKind::table) GTEST_SKIP() << "a table's vertex is what its rows say";
  const auto k = surface_->curvatures(0);
  EXPECT_NEAR(k.meridional, 1 / 2.25, 1e-14);
  EXPECT_NEAR(k.circumferential, 1 / 2.25, 1e-14);
}

/// Trace and determinant of the shape operator (I + g g^T)^-1 H / S from gradient and Hessian: independent of the
/// meridian's formulas.
TEST_P(Surfaces, CurvaturesAreThoseOfTheHeightField) {
  for (const double r : {0.0, 1e-9, 0.05, 0.21, 0.45}) {
    const double x = 0.6 * r, y = -0.8 * r;
    const auto p = surface_->at(x, y);
    const double S = std::sqrt(1 + p.gradient.squaredNorm());
    const Eigen::Matrix2d metric = Eigen::Matrix2d::Identity() + p.gradient * p.gradient.transpose();
    const Eigen::Matrix2d shape = metric.inverse() * p.hessian / S;
    const auto k = surface_->curvatures(r);
    EXPECT_NEAR(shape.trace(), k.meridional + k.circumferential, 1e-12) << r;
    EXPECT_NEAR(shape.determinant(), k.meridional * k.circumferential, 1e-12) << r;
  }
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
  const auto surface = make_surface(spec_of(SurfaceKind::sphere));
  for (const double r : {0.1, 0.3, 0.5}) {
    EXPECT_NEAR(surface->curvatures(r).meridional, 1 / 2.25, 1e-13);
    EXPECT_NEAR(surface->curvatures(r).circumferential, 1 / 2.25, 1e-13);
    EXPECT_NEAR(surface->at(r, 0).z, 2.25 - std::sqrt(2.25 * 2.25 - r * r), 1e-14);
  }
}

TEST(Cone, HasItsSlopeFarFromTheRoundedVertex) {
  SurfaceSpec spec = spec_of(SurfaceKind::cone);
  spec.slope = 0.12, spec.R0 = 0.05; // rounded over 6 mm
  const auto cone = make_surface(spec);
  EXPECT_NEAR(cone->at(0.4, 0).gradient.x(), 0.12, 0.12 * 2e-4);
  EXPECT_NEAR(cone->at(0.4, 0).z - cone->at(0.3, 0).z, 0.012, 1e-5);
  EXPECT_NEAR(cone->at(0.4, 0).z, 0.12 * (0.4 - 0.006), 1e-5);
  EXPECT_NEAR(cone->curvatures(0).meridional, 1 / 0.05, 1e-10);
}

TEST(Polynomial, IsTheSumOfItsPowers) {
  const auto surface = make_surface(spec_of(SurfaceKind::polynomial));
  const double r = 0.37;
  EXPECT_NEAR(surface->at(0, r).z,
              r * r / 4.5 + 0.3 * std::pow(r, 3) - 0.2 * std::pow(r, 4) + 0.4 * std::pow(r, 5) + 0.5 * std::pow(r, 6),
              1e-15);
}

TEST(Table, ReproducesCubicsExactly) {
  const auto surface = make_surface(table_of([](double r) { return r * r * (0.3 - 0.2 * r); }, 5, 0.6));
  for (const double r : {0.0, 0.013, 0.2, 0.411, 0.599}) {
    EXPECT_NEAR(surface->at(r, 0).z, r * r * (0.3 - 0.2 * r), 1e-15);
    EXPECT_NEAR(surface->at(r, 0).gradient.x(), 0.6 * r - 0.6 * r * r, 1e-14);
    EXPECT_NEAR(surface->at(r, 0).hessian(0, 0), 0.6 - 1.2 * r, 1e-12);
  }
}

TEST(Table, ConvergesToTheEllipseItSamples) {
  const auto exact = make_surface(SurfaceSpec{});
  const auto height = [](double r) { return 0.140625 * (1 - std::sqrt(1 - r * r / (0.5625 * 0.5625))); };
  double error[2] = {0, 0}, bend[2] = {0, 0};
  for (int level : {0, 1}) {
    const auto table = make_surface(table_of(height, level ? 81 : 41, 0.53));
    for (double r = 0.001; r < 0.45; r += 0.01) {
      error[level] = std::max(error[level], std::abs(table->at(r, 0).z - exact->at(r, 0).z));
      bend[level] = std::max(bend[level], std::abs(table->curvatures(r).meridional - exact->curvatures(r).meridional));
    }
  }
  EXPECT_LT(error[1], 1e-8);
  EXPECT_GT(error[0] / error[1], 12) << "fourth order";
  EXPECT_LT(bend[1], 2e-3);
  EXPECT_GT(bend[0] / bend[1], 3) << "second order";
}

TEST(Table, RefusesRowsThatMakeNoTable) {
  const auto refuse = [](void (*change)(SurfaceSpec &), std::initializer_list<const char *> words) {
    SurfaceSpec spec = spec_of(SurfaceKind::table);
    change(spec);
    expect_error<InputError>([&] { make_surface(spec); }, words);
  };
  refuse([](SurfaceSpec &s) { s.table_radius.resize(3); }, {"surface.radius_mm", "3 radii", "at least 4"});
  refuse([](SurfaceSpec &s) { s.table_height.pop_back(); }, {"surface.height_mm", "8 heights", "9 radii"});
  refuse([](SurfaceSpec &s) { s.table_radius[0] = 0.01; }, {"surface.radius_mm", "10 mm", "vertex"});
  refuse([](SurfaceSpec &s) { s.table_height[0] = 0.002; }, {"2 mm", "must be 0"});
  refuse([](SurfaceSpec &s) { s.table_radius[3] = 0.1; }, {"row 4", "100 mm", "row 3"});
}

TEST(Surface, RefusesPointsOutside) {
  EXPECT_THROW(make_surface(spec_of(SurfaceKind::table))->at(0.6, 0), std::domain_error);
  const auto surface = make_surface(SurfaceSpec{});
  EXPECT_THROW(surface->at(0.5625, 0), std::domain_error);
  EXPECT_THROW(surface->at(0.4, 0.4), std::domain_error);
}

} // namespace
