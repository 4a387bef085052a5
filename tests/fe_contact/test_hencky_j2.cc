// The J2 law at one point: closed form, consistency of the tangent, objectivity, exact memory (VERIFICATION
// 10).
#include "fe_contact/laws/hencky_j2.h"
#include "fe_contact/laws/small_logarithm.h"

#include "one_point.h"
#include "steels.h"
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace rimpact::fe {
namespace {

using test::expect_consistent_tangent, test::PulledBar, test::random_gradient;

const scene::Material steel{200e9, 0.30, 7850.0, 360e6, 1450e6};

HenckyJ2 with_rate(scene::RateModel model) {
  scene::Material material = steel;
  material.rate.model = model;
  return HenckyJ2::from(material);
}
constexpr scene::RateModel rate_models[] = {scene::RateModel::cowper_symonds, scene::RateModel::johnson_cook};

TEST(HenckyJ2, UniaxialTensionFollowsTheBilinearCurve) {
  const HenckyJ2 law = HenckyJ2::from(steel);
  PulledBar bar{law};
  for (int n = 1; n <= 50; ++n) {
    const double axial = 0.02 * n / 50, stress = bar.pull(axial);
    // Closed form: elastic to the yield stress, then the tangent modulus.
    const double yield_strain = *steel.yield / steel.E;
    const double expected = axial < yield_strain ? steel.E * axial : *steel.yield + 1450e6 * (axial - yield_strain);
    EXPECT_NEAR(stress, expected, 1e-6 * 200e9 * 0.02) << "at strain " << axial;
  }
  EXPECT_GT(bar.state.alpha, 0.015);
}

TEST(HenckyJ2, UniaxialTensionFollowsEveryCurve) {
  for (const auto &[name, material] : test::steels()) {
    const HenckyJ2 law = HenckyJ2::from(material);
    PulledBar bar{law};
    double work = 0, before = 0;
    for (int n = 1; n <= 400; ++n) {
      const double axial = 0.15 * n / 400, stress = bar.pull(axial);
      if (bar.state.alpha > 0)
        EXPECT_NEAR(stress / law.hardening.stress(axial - stress / material.E), 1, 1e-6) << name << " at " << axial;
      work += 0.5 * (stress + before) * 0.15 / 400;
      before = stress;
    }
    EXPECT_GT(bar.state.alpha, 0.14);
    EXPECT_NEAR((bar.energy + law.hardening.work(bar.state.alpha)) / work, 1, 1e-3) << name;
  }
}

TEST(HenckyJ2, TangentOfEveryCurveAgreesWithDifferences) {
  for (const auto &[name, material] : test::steels())
    for (const auto model : {scene::RateModel::none, scene::RateModel::cowper_symonds}) {
      scene::Material steel_at_speed = material;
      steel_at_speed.rate.model = model;
      const HenckyJ2 law = HenckyJ2::from(steel_at_speed);
      test::expect_consistent_tangents(law, name);
    }
}

/// Closed form of the flow that a bar settles to, pulled at a constant rate: sigma = (sigma_y + H alpha) f with f of
/// the plastic rate, which is a constant: E (rate - rate_p) = H rate_p f(rate_p).
double settled_plastic_rate(const HenckyJ2 &law, double rate) {
  double plastic = rate;
  for (int k = 0; k < 200; ++k)
    plastic = steel.E * rate / (steel.E + law.hardening.slope(0) * (1 + law.rate.overstress(plastic)));
  return plastic;
}

TEST(HenckyJ2, ABarAtAConstantRateSettlesToTheClosedForm) {
  for (const auto model : rate_models)
    for (const double rate : {1e-3, 2.0, 20.0, 1e3}) {
      const HenckyJ2 law = with_rate(model);
      PulledBar bar{law};
      constexpr int steps = 400;
      constexpr double furthest = 0.04;
      const double plastic = settled_plastic_rate(law, rate);
      for (int n = 1; n <= steps; ++n) {
        const double axial = furthest * n / steps, stress = bar.pull(axial, furthest / steps / rate);
        if (axial < 0.02) continue; // it settles
        const double flow_stress = law.hardening.stress(axial - stress / steel.E);
        EXPECT_NEAR(stress / (flow_stress * (1 + law.rate.overstress(plastic))), 1, 1e-6) << rate << " at " << axial;
      }
    }
}

TEST(HenckyJ2, WorkOfABarIsStoredSpentAndSpentOnItsRate) {
  for (const auto model : rate_models) {
    const HenckyJ2 law = with_rate(model);
    PulledBar bar{law};
    double work = 0, before = 0, elastic = 0;
    for (int n = 1; n <= 600; ++n) { // out, back beyond yield the other way
      const double axial = n <= 300 ? 0.03 * n / 300 : 0.03 * (600 - n) / 300, stress = bar.pull(axial, 1e-5);
      work += 0.5 * (stress + before) * (n <= 300 ? 1 : -1) * 0.03 / 300;
      before = stress, elastic = bar.energy;
    }
    const double spent = law.hardening.work(bar.state.alpha), viscous = bar.state.viscous_work;
    EXPECT_GT(viscous, 0.02 * spent);
    EXPECT_NEAR(work, elastic + spent + viscous, 2e-3 * work);
  }
}

TEST(HenckyJ2, RateTangentAgreesWithDifferences) {
  for (const auto model : rate_models)
    for (const double dt : {1e-8, 1e-4, 1e-1, 1e4}) { // rates of 1e6 to 1e-6 1/s
      const HenckyJ2 law = with_rate(model);
      std::mt19937 generator(7);
      for (int sample = 0; sample < 10; ++sample) {
        const J2State history = law.step(J2State{}, random_gradient(generator, 0.02), dt).state;
        ASSERT_GT(history.alpha, 0);
        expect_consistent_tangent(law, history, random_gradient(generator, 0.02), dt);
      }
      expect_consistent_tangent(law, J2State{}, random_gradient(generator, 1e-4), dt); // elastic
    }
}

TEST(HenckyJ2, WithoutTimeOrALawNothingOfTheRateIsLeft) {
  std::mt19937 generator(13);
  for (int sample = 0; sample < 20; ++sample) {
    const Matrix3 F = random_gradient(generator, 0.03);
    const auto none = HenckyJ2::from(steel).step(J2State{}, F, 1e-4), ever = HenckyJ2::from(steel).step(J2State{}, F);
    EXPECT_EQ((none.response.stress - ever.response.stress).norm(), 0);
    EXPECT_EQ(none.state.viscous_work, 0);
    for (const auto model : rate_models) {
      const auto slow = with_rate(model).step(J2State{}, F);
      EXPECT_EQ((slow.response.stress - ever.response.stress).norm(), 0);
      EXPECT_EQ((slow.response.tangent - ever.response.tangent).norm(), 0);
      EXPECT_EQ(slow.state.alpha, ever.state.alpha);
      EXPECT_EQ(slow.state.viscous_work, 0);
    }
    HenckyJ2 hardly = with_rate(scene::RateModel::cowper_symonds);
    hardly.rate.data.D = 1e90;
    const auto fast = hardly.step(J2State{}, F, 1e-4);
    EXPECT_LT((fast.response.stress - ever.response.stress).norm(), 1e-12 * ever.response.stress.norm());
    EXPECT_LT((fast.response.tangent - ever.response.tangent).norm(), 1e-12 * ever.response.tangent.norm());
  }
}

TEST(HenckyJ2, OverstressRelaxesWhereItIsLeftAlone) {
  const HenckyJ2 law = with_rate(scene::RateModel::cowper_symonds);
  const Matrix3 F = Eigen::Vector3d(1.02, 0.99, 0.99).asDiagonal();
  const auto fast = law.step(J2State{}, F, 1e-3), held = law.step(fast.state, F, 10.0), rest = law.step(held.state, F);
  const auto equivalent = [](const IsochoricResult &r) { return std::sqrt(1.5) * to_matrix(r.response.stress).norm(); };
  EXPECT_GT(fast.state.overstress, 0.5 * *steel.yield);
  EXPECT_LT(held.state.overstress, 0.5 * fast.state.overstress);
  EXPECT_GT(held.state.alpha, fast.state.alpha);
  EXPECT_NEAR(equivalent(held), law.hardening.stress(held.state.alpha) + held.state.overstress, 1e-3);
  EXPECT_EQ(rest.state.overstress, 0); // infinitely slow
  EXPECT_NEAR(equivalent(rest), law.hardening.stress(rest.state.alpha), 1e-3);
}

TEST(HenckyJ2, TangentAgreesWithDifferences) {
  const HenckyJ2 law = HenckyJ2::from(steel);
  std::mt19937 generator(7);
  for (int sample = 0; sample < 20; ++sample) {
    const J2State history = law.step(J2State{}, random_gradient(generator, 0.02)).state;
    ASSERT_GT(history.alpha, 0);
    expect_consistent_tangent(law, history, random_gradient(generator, 0.02));
  }
  expect_consistent_tangent(law, J2State{}, random_gradient(generator, 1e-4));
}

TEST(HenckyJ2, TangentAtEqualStretchesIsTheLimit) {
  const HenckyJ2 law = HenckyJ2::from(steel);
  expect_consistent_tangent(law, J2State{}, Matrix3::Identity());
  expect_consistent_tangent(law, J2State{}, Eigen::Vector3d(1.0003, 1.0003, 0.9999).asDiagonal());
  Matrix3 plastic = Eigen::Vector3d(1.02, 0.99, 0.99).asDiagonal();
  expect_consistent_tangent(law, J2State{}, plastic);
}

TEST(HenckyJ2, QuarterTurnOnlyTurnsTheStress) {
  const HenckyJ2 law = HenckyJ2::from(steel);
  std::mt19937 generator(3);
  const Matrix3 F = random_gradient(generator, 0.01);
  const Matrix3 Q = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const auto straight = law.step(J2State{}, F), turned = law.step(J2State{}, Q * F);
  EXPECT_LT((to_matrix(turned.response.stress) - Q * to_matrix(straight.response.stress) * Q.transpose()).norm(), 1.0);
  EXPECT_NEAR(turned.state.alpha, straight.state.alpha, 1e-14);
  EXPECT_LT((turned.state.cp_inverse - straight.state.cp_inverse).norm(), 1e-12);
}

TEST(HenckyJ2, PlasticFlowIsIsochoricAndYieldIsMet) {
  const HenckyJ2 law = HenckyJ2::from(steel);
  std::mt19937 generator(11);
  const auto result = law.step(J2State{}, random_gradient(generator, 0.05));
  EXPECT_NEAR(to_matrix(result.state.cp_inverse).determinant(), 1.0, 1e-12);
  const Matrix3 s = to_matrix(result.response.stress);
  EXPECT_NEAR(std::sqrt(1.5) * s.norm(), law.hardening.stress(result.state.alpha), 1e-3);
  EXPECT_NEAR(s.trace(), 0.0, 1.0);
}

TEST(HenckyJ2, LodeParameterTellsTensionShearAndCompression) {
  const HenckyJ2 law = HenckyJ2::from(steel);
  const auto lode = [&](const Matrix3 &F) {
    const J2State state = law.step(J2State{}, F).state;
    return state.lode / state.alpha;
  };
  EXPECT_NEAR(lode(Eigen::Vector3d(1.02, 0.99, 0.99).asDiagonal()), 1, 1e-12);
  EXPECT_NEAR(lode(Eigen::Vector3d(0.98, 1.01, 1.01).asDiagonal()), -1, 1e-12);
  EXPECT_NEAR(lode(Eigen::Vector3d(1.02, 1.0 / 1.02, 1).asDiagonal()), 0, 1e-12); // pure shear
}

TEST(HenckyJ2, RepeatingAnAcceptedGradientChangesNothing) {
  const HenckyJ2 law = HenckyJ2::from(steel);
  std::mt19937 generator(5);
  const Matrix3 F = random_gradient(generator, 0.03);
  const auto once = law.step(J2State{}, F);
  const auto twice = law.step(once.state, F);
  EXPECT_NEAR(twice.state.alpha, once.state.alpha, 1e-12);
  EXPECT_LT((twice.response.stress - once.response.stress).norm(), 1e-6 * 360e6);
}

/// Strains from rounding to beyond the series; up to yield, beside it and beyond, on a state that has flowed.
TEST(HenckyJ2, WithoutItsTangentAStepAnswersTheSame) {
  const HenckyJ2 law = HenckyJ2::from(steel);
  std::mt19937 generator(11);
  const J2State flowed = law.step(J2State{}, random_gradient(generator, 0.01)).state;
  ASSERT_GT(flowed.alpha, 0);
  for (const J2State &old : {J2State{}, flowed})
    for (const HenckyJ2 &one : {law, law.at_rest()})
      for (const double size : {1e-15, 1e-9, 1e-5, 1e-4, 3e-4, 1e-3, 5e-3, 0.02, 0.1}) {
        const Matrix3 F = random_gradient(generator, size);
        const auto with = one.step(old, F), without = one.step(old, F, 0, false);
        EXPECT_LT((with.response.stress - without.response.stress).norm(), 1e-14 * law.shear_modulus) << size;
        EXPECT_NEAR(with.energy, without.energy, 1e-14 * (std::sqrt(law.shear_modulus * with.energy) + 1)) << size;
        EXPECT_NEAR(with.state.alpha, without.state.alpha, 1e-15);
      }
}

TEST(SmallLogarithm, IsThatOfTheEigenvaluesAsFarAsItGoes) {
  std::mt19937 generator(3);
  for (const double size : {1e-12, 1e-6, 1e-3, 0.01, 0.02}) {
    const Matrix3 F = random_gradient(generator, size), b = F * F.transpose();
    const Eigen::SelfAdjointEigenSolver<Matrix3> spectrum(b);
    const Matrix3 exact = spectrum.eigenvectors() * spectrum.eigenvalues().array().log().matrix().asDiagonal() *
                          spectrum.eigenvectors().transpose();
    const auto found = small_logarithm(b);
    EXPECT_EQ(found.has_value(), (b - Matrix3::Identity()).norm() < 0.05) << size;
    if (found) EXPECT_LT((*found - exact).norm(), 2e-15) << size;
  }
  EXPECT_FALSE(small_logarithm(1.1 * Matrix3::Identity()));
  EXPECT_FALSE(small_logarithm(Matrix3::Constant(std::nan(""))));
  EXPECT_EQ(small_logarithm(Matrix3::Identity())->norm(), 0);
}

TEST(HenckyJ2, InvertedPointIsInadmissibleNotNaN) {
  const HenckyJ2 law = HenckyJ2::from(steel);
  EXPECT_FALSE(law.step(J2State{}, Eigen::Vector3d(-1, 1, 1).asDiagonal()).admissible);
  EXPECT_FALSE(HenckyVolumetric::from(steel).at(0.0).admissible);
}

} // namespace
} // namespace rimpact::fe
