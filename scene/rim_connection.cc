#include "scene/rim_connection.h"

#include <fmt/format.h>
#include <numbers>

namespace rimpact::scene {
namespace {

struct Thread {
  double diameter, pitch; ///< [mm]
};

Thread thread(BoltSize size) {
  switch (size) {
  case BoltSize::M8:
    return {8, 1.25};
  case BoltSize::M10:
    return {10, 1.5};
  case BoltSize::M12:
    return {12, 1.75};
  case BoltSize::M16:
    return {16, 2};
  case BoltSize::M20:
    return {20, 2.5};
  case BoltSize::M24:
    return {24, 3};
  case BoltSize::M27:
    return {27, 3};
  case BoltSize::M30:
    return {30, 3.5};
  case BoltSize::M36:
    break;
  }
  return {36, 4};
}

} // namespace

double stress_area(BoltSize size) {
  const auto [d, pitch] = thread(size);
  const double core = 1e-3 * (d - 0.9382 * pitch);
  return std::numbers::pi / 4 * core * core;
}

double diameter(BoltSize size) {
  return 1e-3 * thread(size).diameter;
}

double ultimate_strength(BoltGrade grade) {
  switch (grade) {
  case BoltGrade::g4_6:
  case BoltGrade::g4_8:
    return 400e6;
  case BoltGrade::g5_6:
  case BoltGrade::g5_8:
    return 500e6;
  case BoltGrade::g6_8:
    return 600e6;
  case BoltGrade::g8_8:
    return 800e6;
  case BoltGrade::g10_9:
    break;
  }
  return 1000e6;
}

double shear_share(BoltGrade grade) {
  const bool tough = grade == BoltGrade::g4_6 || grade == BoltGrade::g5_6 || grade == BoltGrade::g8_8;
  return tough ? 0.6 : 0.5;
}

std::string in_words(const RimConnection &c) {
  switch (c.kind) {
  case ConnectionKind::monolithic:
    break;
  case ConnectionKind::fillet:
    return fmt::format("two fillet welds with a throat of {:g} mm", 1e3 * c.throat);
  case ConnectionKind::bolts:
    return fmt::format("{} bolts {} {} on a circle of {:g} mm", c.number, word(c.size), word(c.grade), 1e3 * c.circle);
  }
  return "one piece with the plate";
}

std::string strength_in_words(const RimConnection &c) {
  if (c.kind == ConnectionKind::monolithic) return {};
  const std::string factor = fmt::format(", gamma_M2 {:g}", c.partial_factor);
  if (c.kind == ConnectionKind::bolts) return in_words(c) + factor;
  return fmt::format("{}, f_u {:g} MPa, beta_w {:g}", in_words(c), c.strength / 1e6, c.correlation) + factor;
}

} // namespace rimpact::scene
