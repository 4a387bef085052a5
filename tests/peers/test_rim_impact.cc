// The material of examples/opensees/rim_impact against our own law on prescribed histories, without OpenSees.
#include "Channel.h"
#include "elementAPI.h"
#include "FEM_ObjectBroker.h"
#include "laws/impact/catalogue.h"
#include "OPS_Globals.h"
#include "RimImpact.h"
#include <gtest/gtest.h>
#include <memory>

void *OPS_RimImpact();

namespace rimpact::laws {
namespace {

constexpr double gap = 0.4;

LawNumbers numbers() {
  LawNumbers n;
  n.k_i = 1085.5e6, n.yield_force = 455.24e3, n.hardening = 0.38454, n.hardening_exponent = 0.39266;
  n.unloading_gain = 0.2928, n.unloading_exponent = 0.54265;
  return n;
}

std::unique_ptr<UniaxialMaterial> made(std::deque<std::string> more = {}, const std::string &at = "-0.4") {
  ::words = {"1", "1085.5e6", "455.24e3", "0.38454", "0.39266", "0.2928", "0.54265", at};
  ::words.insert(::words.end(), more.begin(), more.end());
  return std::unique_ptr<UniaxialMaterial>(static_cast<UniaxialMaterial *>(OPS_RimImpact()));
}

/// Our law at penetration d: never pulls, and knows the deepest.
class Law {
public:
  double force(double d) const {
    return d > 0 ? std::max(0.0, rim_.at({.d = d, .rate = 0, .deepest = deepest_}).force) : 0;
  }
  void accept(double d) { deepest_ = std::max(deepest_, d); }

private:
  RimElement rim_ = rim_element(impact_law("elastoplastic"), numbers(), 86952);
  double deepest_ = 0;
};

/// Hits of growing and of falling depth, each back to the middle: penetrations of one side.
std::vector<double> history() {
  std::vector<double> all;
  for (const double top : {0.5e-3, 3e-3, 2e-3, 12e-3, 12e-3, 24e-3, 5e-3})
    for (int i = 0; i <= 200; ++i) all.push_back(top * std::sin(M_PI * i / 100.0));
  return all;
}

TEST(RimImpact, IsOurLawOnPrescribedHistories) {
  const auto material = made();
  Law law;
  for (const double d : history()) {
    material->setTrialStrain(-(gap + d));
    ASSERT_NEAR(-material->getStress(), law.force(d), 1e-9 * 3e6) << d;
    material->commitState(), law.accept(d);
  }
}

TEST(RimImpact, ItsTangentIsThatOfItsForce) {
  const auto material = made();
  double deepest = 0;
  for (const double d : history()) {
    constexpr double h = 1e-8;
    material->setTrialStrain(-(gap + d + h));
    const double above = material->getStress();
    material->setTrialStrain(-(gap + d - h));
    const double below = material->getStress(), slope = (below - above) / (2 * h);
    material->setTrialStrain(-(gap + d));
    if (std::abs(material->getStress()) > 1 && std::abs(d - deepest) > h) { // it has a corner at the deepest
      EXPECT_NEAR(material->getTangent() / slope, 1, 1e-4) << d;
    }
    material->commitState(), deepest = std::max(deepest, d);
  }
}

TEST(RimImpact, ATrialLeavesNothingBehind) {
  const auto material = made();
  material->setTrialStrain(-0.403), material->commitState();
  material->setTrialStrain(-0.5); // an iteration that overshoots
  material->revertToLastCommit();
  material->setTrialStrain(-0.402);
  const double after = material->getStress();
  const auto other = made();
  other->setTrialStrain(-0.403), other->commitState(), other->setTrialStrain(-0.402);
  EXPECT_EQ(after, other->getStress());
  material->revertToStart(), material->setTrialStrain(-0.401);
  Law fresh;
  EXPECT_NEAR(-material->getStress(), fresh.force(0.001), 1e-3);
}

TEST(RimImpact, EachSideKeepsItsOwnDent) {
  const auto material = made({"-twoSided"}, "0.4");
  Law left, right;
  for (const double strain : {0.403, 0.3, -0.402, -0.3, 0.402, -0.4015, -0.404, 0.405}) {
    Law &law = strain > 0 ? right : left;
    const double d = std::abs(strain) - gap;
    material->setTrialStrain(strain);
    EXPECT_NEAR(std::abs(material->getStress()), law.force(d), 1e-3) << strain;
    EXPECT_GE(material->getStress() * strain, 0);
    material->commitState(), law.accept(d);
  }
}

TEST(RimImpact, WithoutDentsWhatLetsGoIsNew) {
  const auto material = made({"-noDents"}, "0.4");
  for (int hit = 0; hit < 2; ++hit)
    for (const double d : {0.001, 0.003, 0.0029, 0.0}) {
      material->setTrialStrain(gap + d);
      if (d == 0.001 || d == 0.003) {
        EXPECT_NEAR(material->getStress(), Law().force(d), 1e-3) << hit;
      }
      material->commitState();
    }
}

TEST(RimImpact, ACopyAndOneThatWasSentAreTheSame) {
  const auto material = made({"-twoSided"}, "0.4");
  for (const double strain : {0.403, -0.405, 0.3}) material->setTrialStrain(strain), material->commitState();
  const std::unique_ptr<UniaxialMaterial> copy(material->getCopy());
  Channel channel;
  FEM_ObjectBroker broker;
  RimImpact received;
  dynamic_cast<RimImpact &>(*material).sendSelf(0, channel), received.recvSelf(0, channel, broker);
  for (const double strain : {0.4025, -0.4045, 0.41}) {
    material->setTrialStrain(strain), copy->setTrialStrain(strain), received.setTrialStrain(strain);
    EXPECT_EQ(material->getStress(), copy->getStress());
    EXPECT_EQ(material->getStress(), received.getStress());
  }
}

TEST(RimImpact, BadWordsAreRefusedByName) {
  opserr.said.clear();
  EXPECT_EQ(made({"-round"}), nullptr);
  EXPECT_NE(opserr.said.find("-round"), std::string::npos);
  EXPECT_EQ(made({}, "0"), nullptr);
  ::words = {"1", "1e6"};
  EXPECT_EQ(OPS_RimImpact(), nullptr);
  EXPECT_NE(opserr.said.find("gap"), std::string::npos);
}

} // namespace
} // namespace rimpact::laws
