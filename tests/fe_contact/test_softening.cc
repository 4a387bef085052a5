// Steel that its own plastic work heats: a bar against its closed form, the tangent by differences, the work, and no
// change where it is not asked for.
#include "one_point.h"
#include "steels.h"

namespace rimpact::fe {
namespace {

using test::expect_consistent_tangent, test::PulledBar, test::random_gradient;

scene::Material heated(scene::Material steel) {
  steel.heat.model = scene::Softening::adiabatic;
  steel.heat.melting = 150; // ten times as soft as steel is
  return steel;
}

/// Largest relative difference of a perfectly plastic bar from sigma_0 exp(-beta sigma_0 alpha / (rho c dT_m)).
double error_of_bar(int steps) {
  scene::Material steel = heated(test::bilinear());
  steel.tangent_modulus = 0;
  const HenckyJ2 law = HenckyJ2::from(steel);
  PulledBar bar{law};
  const double sigma_0 = *steel.yield, by_strain = 0.9 * sigma_0 / (7850.0 * 460 * 150);
  double largest = 0;
  for (int n = 1; n <= steps; ++n) {
    const double stress = bar.pull(0.2 * n / steps, 1e-4);
    if (bar.state.alpha > 0)
      largest = std::max(largest, std::abs(stress / (sigma_0 * std::exp(-by_strain * bar.state.alpha)) - 1));
  }
  EXPECT_GT(bar.state.alpha, 0.19);
  EXPECT_GT(by_strain * bar.state.alpha, 0.1); // a fall to be seen
  return largest;
}

TEST(Softening, ABarFollowsTheClosedForm) {
  const double coarse = error_of_bar(200), fine = error_of_bar(800);
  EXPECT_LT(fine, 5e-4);
  EXPECT_NEAR(coarse / fine, 4, 0.5); // first order
}

TEST(Softening, TheRiseIsThatOfTheWork) {
  const SofteningLaw law{{.model = scene::Softening::adiabatic}, 7850};
  EXPECT_NEAR(law.rise(7850 * 460 / 0.9), 1, 1e-12);
  EXPECT_NEAR(law.factor(7850 * 460 / 0.9 * 150), 0.9, 1e-12);
  EXPECT_EQ(law.factor(0), 1);
  EXPECT_EQ(law.factor(1e15), 0.01);
  EXPECT_EQ(SofteningLaw{}.factor(1e9), 1);
}

TEST(Softening, TangentAgreesWithDifferences) {
  for (const auto model : {scene::RateModel::none, scene::RateModel::cowper_symonds})
    for (const bool kinematic : {false, true})
      for (const auto &[name, steel] : test::steels()) {
        scene::Material material = heated(steel);
        material.rate.model = model;
        if (kinematic) material.hardening.chaboche.values = {{40e9, 400}};
        const HenckyJ2 law = HenckyJ2::from(material);
        std::mt19937 generator(7);
        for (int sample = 0; sample < 5; ++sample) {
          SCOPED_TRACE(name);
          const J2State history = law.step(J2State{}, random_gradient(generator, 0.05), 1e-4).state;
          ASSERT_LT(law.softening(history), 0.999);
          expect_consistent_tangent(law, history, random_gradient(generator, 0.05), 1e-4);
        }
      }
}

TEST(Softening, WorkOfABarIsStoredAndSpent) {
  for (const auto model : {scene::RateModel::none, scene::RateModel::cowper_symonds}) {
    scene::Material steel = heated(test::voce());
    steel.rate.model = model;
    const HenckyJ2 law = HenckyJ2::from(steel);
    PulledBar bar{law};
    double work = 0, before = 0;
    for (int n = 1; n <= 2000; ++n) {
      const double stress = bar.pull(0.2 * n / 2000, 1e-5);
      work += 0.5 * (stress + before) * 0.2 / 2000;
      before = stress;
    }
    EXPECT_NEAR(bar.energy + law.plastic_work(bar.state), work, 1e-3 * work);
    EXPECT_LT(bar.state.viscous_work / work, model == scene::RateModel::none ? -0.02 : 1);
  }
}

TEST(Softening, SteelThatDoesNotMeltIsAsEver) {
  scene::Material steel = heated(test::bilinear());
  steel.heat.melting = 1e12;
  std::mt19937 generator(13);
  for (int sample = 0; sample < 10; ++sample) {
    const Matrix3 F = random_gradient(generator, 0.03);
    const auto ever = HenckyJ2::from(test::bilinear()).step(J2State{}, F),
               cold = HenckyJ2::from(steel).step(J2State{}, F);
    EXPECT_LT((cold.response.stress - ever.response.stress).norm(), 1e-9 * ever.response.stress.norm());
    EXPECT_LT((cold.response.tangent - ever.response.tangent).norm(), 1e-9 * ever.response.tangent.norm());
  }
}

} // namespace
} // namespace rimpact::fe
