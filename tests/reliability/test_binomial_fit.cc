// Curves through shares at levels, by maximum likelihood.
#include "studies/reliability/binomial_fit.h"
#include "ten_levels.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace rimpact::reliability;
using ten_levels::lognormal;

namespace {

std::vector<ShareAt> exact(double median, double beta, double weight = 30) {
  std::vector<ShareAt> shares;
  for (const double x : ten_levels::all) shares.push_back({x, lognormal(x, median, beta), weight});
  return shares;
}

} // namespace

TEST(BinomialFit, FindsTheCurveThatTheSharesLieOn) {
  for (const double median : {0.15, 0.5, 0.8, 1.2}) {
    const auto fit = fit_binomial(exact(median, 0.4), Link::probit);
    ASSERT_TRUE(fit) << median;
    EXPECT_NEAR(fit->median() / median, 1, 1e-9);
    EXPECT_NEAR(fit->deviation(), 0.4, 1e-9);
    EXPECT_NEAR(test_of_fit(*fit, exact(median, 0.4)), 1, 1e-9);
  }
  std::vector<ShareAt> logistic;
  for (const double x : ten_levels::all) logistic.push_back({x, 1 / (1 + std::exp(-(2 + 3 * std::log(x / 0.3)))), 5});
  const auto fit = fit_binomial(logistic, Link::logit);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->b, 3, 1e-9);
  EXPECT_NEAR(fit->at(0.3), 1 / (1 + std::exp(-2.0)), 1e-9);
}

// The log-likelihood has its peak there: no neighbour is larger.
TEST(BinomialFit, IsTheLargestLikelihood) {
  std::mt19937 random(5);
  for (const Link link : {Link::logit, Link::probit}) {
    std::vector<ShareAt> shares;
    for (const double x : ten_levels::all) {
      std::binomial_distribution<int> draw(30, lognormal(x, 0.3, 0.5));
      shares.push_back({x, draw(random) / 30.0, 30});
    }
    const auto fit = fit_binomial(shares, link);
    ASSERT_TRUE(fit);
    const auto likelihood = [&](const BinomialFit &f) {
      double sum = 0;
      for (const auto &s : shares)
        sum += s.weight * (s.share * std::log(f.at(s.intensity)) + (1 - s.share) * std::log1p(-f.at(s.intensity)));
      return sum;
    };
    for (const auto &[da, db] : {std::pair{1e-3, 0.0}, {-1e-3, 0.0}, {0.0, 1e-3}, {0.0, -1e-3}})
      EXPECT_LT(likelihood({link, fit->a + da, fit->b + db}), likelihood(*fit));
    EXPECT_GT(test_of_fit(*fit, shares), 0.01);
  }
}

TEST(BinomialFit, CountsRatiosOfWeightsAndNoOrder) {
  auto shares = exact(0.3, 0.5);
  for (std::size_t i = 0; i < shares.size(); ++i) shares[i].share = std::round(30 * shares[i].share) / 30;
  const auto once = fit_binomial(shares, Link::probit);
  for (auto &share : shares) share.weight *= 2;
  std::reverse(shares.begin(), shares.end());
  const auto twice = fit_binomial(shares, Link::probit);
  ASSERT_TRUE(once && twice);
  EXPECT_NEAR(twice->median() / once->median(), 1, 1e-13);
  EXPECT_NEAR(twice->deviation() / once->deviation(), 1, 1e-13);
}

TEST(BinomialFit, NoneWhereTheLikelihoodHasNoPeak) {
  EXPECT_FALSE(fit_binomial({{0.1, 0, 30}, {0.2, 0, 30}, {0.3, 0.2, 30}}, Link::probit)) << "any slope";
  EXPECT_FALSE(fit_binomial({{0.1, 0, 30}, {0.2, 1, 30}}, Link::logit));
  EXPECT_FALSE(fit_binomial({{0.1, 0.4, 30}}, Link::probit));
  EXPECT_FALSE(fit_binomial({{0.1, 0.5, 30}, {0.2, 0.2, 30}}, Link::probit)) << "falls";
}

TEST(BinomialFit, TestRefusesWhatLiesElsewhere) {
  auto shares = exact(0.3, 0.3);
  shares[8].share = 0.2; // where nine of ten exceed
  EXPECT_LT(test_of_fit(*fit_binomial(shares, Link::probit), shares), 1e-3);
}
