// Measured friction: between rows, beyond them, and what is wrong with a file.
#include "../scene/temporary_folder.h"
#include "io/files/error.h"
#include "laws/friction/friction_law.h"
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::friction;

namespace {

FrictionTable read(const std::string &text) {
  const TemporaryFolder folder;
  return read_friction_table(folder.write("friction_table.csv", text));
}
std::string refusal(const std::string &text) {
  try {
    read(text);
  } catch (const DataError &error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST(FrictionTable, IsLinearBetweenAndConstantBeyond) {
  const auto table = read("# a test\nmu,speed_mm_per_s,pressure_MPa\n0.04,0,10\n0.03,0,50\n0.08,100,10\n0.06,100,50\n");
  EXPECT_DOUBLE_EQ(table.at(0.1, 50e6).value, 0.06);
  EXPECT_DOUBLE_EQ(table.at(0.05, 30e6).value, (0.04 + 0.03 + 0.08 + 0.06) / 4);
  EXPECT_DOUBLE_EQ(table.at(0.05, 30e6).d_speed, 0.35); // (0.07 - 0.035) / 0.1
  EXPECT_NEAR(table.at(0.05, 30e6).d_pressure, -0.015 / 40e6, 1e-18);
  EXPECT_DOUBLE_EQ(table.at(3, 1e9).value, 0.06);
  EXPECT_EQ(table.at(3, 1e9).d_speed, 0);
  EXPECT_TRUE(table.by_speed() && table.by_pressure());
  const auto over_speed = read("speed_m_per_s,mu\n0,0.04\n0.2,0.08\n");
  EXPECT_FALSE(over_speed.by_pressure());
  EXPECT_DOUBLE_EQ(over_speed.at(0.1, 7e6).value, 0.06);
}

TEST(FrictionTable, RefusalsNameLineAndValue) {
  EXPECT_NE(refusal("speed_m_per_s,mu\n0,2.5\n").find(":2: mu 2.5 must be in 0..2"), std::string::npos);
  EXPECT_NE(refusal("speed_m_per_s,friction\n0,0.1\n").find("column \"friction\" is not known"), std::string::npos);
  EXPECT_NE(refusal("mu\n0.1\n").find("no column speed_m_per_s"), std::string::npos);
  EXPECT_NE(refusal("speed_m_per_s,mu\n0,0.1\n0,0.2\n").find(":3: speed 0 m/s"), std::string::npos);
  EXPECT_NE(refusal("speed_m_per_s,pressure_MPa,mu\n0,1,0.1\n1,2,0.1\n").find("every speed needs every pressure"),
            std::string::npos);
  EXPECT_NE(refusal("speed_m_per_s,mu\n").find("no row"), std::string::npos);
  EXPECT_NE(refusal("speed_m_per_s,mu\n0\n").find("1 of 2 columns"), std::string::npos);
}
