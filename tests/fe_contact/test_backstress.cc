// A yield surface that is moved by a backstress: cycles of a bar against their closed form, the tangent by differences,
// turned bodies, the work, and what it must be without a backstress.
#include "one_point.h"
#include "steels.h"
#include <Eigen/Geometry>

namespace rimpact::fe {
namespace {

using test::expect_consistent_tangent, test::PulledBar, test::random_gradient;

struct Term {
  double C, gamma;
};
const std::vector<Term> two_terms{{40e9, 400}, {3e9, 12}};

scene::Material steel_with(const std::vector<Term> &terms) {
  scene::Material steel = test::voce();
  steel.yield = 250e6, steel.hardening.Q = 40e6, steel.hardening.b = 10;
  for (const auto &[C, gamma] : terms) steel.hardening.chaboche.values.push_back({C, gamma});
  return steel;
}

/// Backstress of a bar in closed form: over a monotonic plastic strain from `from` to `to`, sign nu,
///   X = nu C / gamma + (X_from - nu C / gamma) exp(-gamma |to - from|).
double moved(double X, const Term &term, double from, double to) {
  const double nu = to >= from ? 1 : -1;
  if (term.gamma == 0) return X + term.C * (to - from);
  const double saturated = nu * term.C / term.gamma;
  return saturated + (X - saturated) * std::exp(-term.gamma * std::abs(to - from));
}

/// A bar pulled to and fro: the largest difference of its stress from the closed form at its own plastic strain [Pa].
double error_of_cycles(const std::vector<Term> &terms, int steps_a_branch, double amplitude) {
  const scene::Material steel = steel_with(terms);
  const HenckyJ2 law = HenckyJ2::from(steel);
  PulledBar bar{law};
  std::vector<double> X(terms.size(), 0.0);
  double plastic = 0, alpha = 0, largest = 0;
  int n_plastic = 0;
  for (int branch = 0; branch < 5; ++branch)
    for (int n = 1; n <= steps_a_branch; ++n) {
      const double to = branch % 2 == 0 ? amplitude : -amplitude, from = branch == 0 ? 0 : -to;
      const double stress = bar.pull(from + (to - from) * n / steps_a_branch);
      const double now = from + (to - from) * n / steps_a_branch - stress / steel.E;
      if (!(bar.state.alpha > alpha)) continue;
      double expected = (branch % 2 == 0 ? 1 : -1) * law.hardening.stress(bar.state.alpha);
      for (std::size_t k = 0; k < terms.size(); ++k) {
        X[k] = moved(X[k], terms[k], plastic, now);
        expected += X[k];
      }
      plastic = now, alpha = bar.state.alpha, ++n_plastic;
      largest = std::max(largest, std::abs(stress - expected));
    }
  EXPECT_GT(n_plastic, 3 * steps_a_branch);
  EXPECT_GT(alpha, 6 * amplitude);
  return largest;
}

TEST(Backstress, CyclesOfABarFollowTheClosedForm) {
  EXPECT_LT(error_of_cycles({{2e9, 0}}, 100, 0.02), 1e-6 * 250e6); // Prager: backward Euler is exact
  for (const auto &terms : {std::vector{two_terms[0]}, two_terms}) {
    const double coarse = error_of_cycles(terms, 400, 0.02), fine = error_of_cycles(terms, 1600, 0.02);
    EXPECT_LT(fine, 0.01 * 250e6);
    EXPECT_NEAR(coarse / fine, 4, 0.8); // first order
  }
}

TEST(Backstress, YieldsSoonerOnTheWayBack) {
  const HenckyJ2 law = HenckyJ2::from(steel_with(two_terms));
  PulledBar bar{law};
  double top = 0;
  for (int n = 1; n <= 200; ++n) top = bar.pull(0.03 * n / 200);
  const double alpha = bar.state.alpha;
  double back = 0, axial = 0.03;
  while (bar.state.alpha == alpha) back = bar.pull(axial -= 2e-6);
  EXPECT_NEAR(top - back, 2 * law.hardening.stress(alpha), 0.01 * top); // Bauschinger's effect, the elastic range
  EXPECT_GT(back, -0.6 * top);
}

TEST(Backstress, TangentAgreesWithDifferences) {
  for (const auto model : {scene::RateModel::none, scene::RateModel::cowper_symonds})
    for (const auto &[name, steel] : test::steels()) {
      scene::Material material = steel;
      material.rate.model = model;
      for (const auto &[C, gamma] : two_terms) material.hardening.chaboche.values.push_back({C, gamma});
      const HenckyJ2 law = HenckyJ2::from(material);
      test::expect_consistent_tangents(law, name);
      expect_consistent_tangent(law, J2State{}, Matrix3::Identity());
      expect_consistent_tangent(law, J2State{}, Eigen::Vector3d(1.02, 0.99, 0.99).asDiagonal());
    }
}

TEST(Backstress, ATurnedBodyHasATurnedStress) {
  const HenckyJ2 law = HenckyJ2::from(steel_with(two_terms));
  std::mt19937 generator(3);
  const Matrix3 first = random_gradient(generator, 0.02), second = random_gradient(generator, 0.02);
  const Matrix3 Q = Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const auto once = law.step(J2State{}, first), turned_once = law.step(J2State{}, Q * first);
  EXPECT_LT((once.state.backstress[0] - turned_once.state.backstress[0]).norm(), 1e-9 * 250e6);
  const auto straight = law.step(once.state, second), turned = law.step(turned_once.state, Q * second);
  EXPECT_LT((to_matrix(turned.response.stress) - Q * to_matrix(straight.response.stress) * Q.transpose()).norm(), 10.0);
  EXPECT_NEAR(turned.state.alpha, straight.state.alpha, 1e-13);
}

TEST(Backstress, RepeatingAnAcceptedGradientChangesNothing) {
  const HenckyJ2 law = HenckyJ2::from(steel_with(two_terms));
  std::mt19937 generator(5);
  J2State state;
  for (int sample = 0; sample < 20; ++sample) {
    const Matrix3 F = random_gradient(generator, 0.03);
    const auto once = law.step(state, F), twice = law.step(once.state, F), rest = law.at_rest().step(once.state, F);
    EXPECT_NEAR(twice.state.alpha, once.state.alpha, 1e-10);
    EXPECT_LT((twice.response.stress - once.response.stress).norm(), 1e-6 * 250e6);
    EXPECT_LT((rest.response.stress - once.response.stress).norm(), 1e-6 * 250e6);
    EXPECT_NEAR(to_matrix(once.state.cp_inverse).determinant(), 1.0, 1e-10);
    state = once.state;
  }
}

/// Straight lines of stress and strain alike over a closed path: without a backstress the step must be that of the
/// isotropic law, whatever turns.
TEST(Backstress, OneThatIsHardlyThereMakesNoDifference) {
  const HenckyJ2 none = HenckyJ2::from(steel_with({})), hardly = HenckyJ2::from(steel_with({{1.0, 1}}));
  ASSERT_TRUE(none.backstress.none());
  std::mt19937 generator(11);
  J2State a, b;
  for (int sample = 0; sample < 20; ++sample) {
    const Matrix3 F = random_gradient(generator, 0.05);
    const auto isotropic = none.step(a, F, 1e-4), kinematic = hardly.step(b, F, 1e-4);
    EXPECT_LT((isotropic.response.stress - kinematic.response.stress).norm(), 1e-8 * 250e6);
    EXPECT_LT((isotropic.response.tangent - kinematic.response.tangent).norm(), 1e-7 * 200e9);
    EXPECT_NEAR(isotropic.state.alpha, kinematic.state.alpha, 1e-11);
    EXPECT_NEAR(isotropic.state.lode, kinematic.state.lode, 1e-9);
    EXPECT_NEAR(isotropic.mises / kinematic.mises, 1, 1e-9);
    a = isotropic.state, b = kinematic.state;
  }
}

/// Pulled until the backstress is the yield radius R, a bar flows back at any stress, zero too: triaxiality and Lode
/// parameter divide by R there, by the stress beyond R, and nothing jumps. By Prager's rule the stress is X - R.
TEST(Backstress, TriaxialityIsBoundedWhereTheStressIsNothing) {
  constexpr double C = 20e9, dp = 2e-5;
  scene::Material steel = steel_with({{C, 0}});
  steel.hardening.Q = 1; // R as good as constant
  const HenckyJ2 law = HenckyJ2::from(steel);
  PulledBar bar{law};
  const double R = *steel.yield, top = R / C + 2 * R / steel.E; // X = R, and the elastic strain of X + R
  const int n_out = static_cast<int>(std::ceil(top / dp));
  double axial = 0, smallest = R, before = 0, last = 0;
  for (int n = 1; n <= n_out; ++n) bar.pull(axial = top * n / n_out);
  EXPECT_NEAR(bar.mises / (2 * R), 1, 2e-3) << "monotonic: the equivalent stress";
  for (double back = dp; back < 3 * R / C + 2 * R / steel.E; back += dp) {
    const J2State old = bar.state;
    const double stress = bar.pull(axial - back);
    if (!(bar.state.alpha > old.alpha)) continue;
    smallest = std::min(smallest, std::abs(stress)), last = stress;
    EXPECT_NEAR(bar.mises / std::max(R, std::abs(stress)), 1, 1e-6);
    if (before > 0) EXPECT_LT(std::abs(bar.mises - before), 1.01 * C * dp) << "no jump";
    before = bar.mises;
    const double lode = (bar.state.lode - old.lode) / (bar.state.alpha - old.alpha);
    EXPECT_NEAR(lode, std::pow(stress / bar.mises, 3), 1e-4) << "a bar's, less where the stress is less than R";
  }
  EXPECT_LT(smallest, 0.01 * R);
  EXPECT_LT(last, -1.2 * R);
}

TEST(Backstress, WorkOfABarIsStoredAndSpent) {
  const HenckyJ2 law = HenckyJ2::from(steel_with(two_terms));
  PulledBar bar{law};
  double work = 0, before = 0;
  for (int n = 1; n <= 3000; ++n) { // out, back beyond yield the other way
    const double axial = n <= 1500 ? 0.03 * n / 1500 : 0.03 * (3000 - n) / 1500, stress = bar.pull(axial);
    work += 0.5 * (stress + before) * (n <= 1500 ? 1 : -1) * 0.03 / 1500;
    before = stress;
  }
  EXPECT_GT(bar.state.back_work, 0.1 * work);
  EXPECT_NEAR(bar.energy + law.hardening.work(bar.state.alpha) + bar.state.back_work, work, 2e-3 * work);
}

} // namespace
} // namespace rimpact::fe
