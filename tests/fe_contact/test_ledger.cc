// When a run's energies no longer balance it stops: beyond the bound, and only where energy was put in at all.
#include "fe_contact/drive/ledger.h"
#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

EnergyLedger with_loss(double initial, double lost) {
  EnergyLedger ledger;
  ledger.initial = ledger.largest_input = initial;
  ledger.kinetic = initial - lost;
  return ledger;
}

TEST(Ledger, ARunStopsWhereItsEnergiesDoNotBalance) {
  EXPECT_FALSE(loss_of_balance(with_loss(4000, 0.049 * 4000), 0.01));
  const auto sentence = loss_of_balance(with_loss(4000, 0.96 * 4000), 0.0123);
  ASSERT_TRUE(sentence);
  EXPECT_NE(sentence->find("96 %"), std::string::npos) << *sentence;
  EXPECT_NE(sentence->find("t = 0.0123 s"), std::string::npos) << *sentence;
  EXPECT_TRUE(loss_of_balance(with_loss(4000, -0.06 * 4000), 0)) << "energy made from nothing as well";
}

TEST(Ledger, WhereNothingIsPutInAShareMeansNothing) {
  EXPECT_FALSE(loss_of_balance(with_loss(0.5, 0.4), 0));
}

} // namespace
} // namespace rimpact::fe
