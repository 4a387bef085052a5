/// What holds the rim's wall on its plate. Solids are always one piece there; whether a joint bears what they carry is
/// judged by its strength (responses/foot_strength.h).
#pragma once
#include "io/files/choice.h"
#include <string>

namespace rimpact::scene {

enum class ConnectionKind { monolithic, fillet, bolts };
constexpr auto choices(ConnectionKind) {
  using enum ConnectionKind;
  return choices_of<ConnectionKind>({{monolithic, "monolithic", "one piece with the plate, or a weld through the wall"},
                                     {fillet, "fillet", "two fillet welds, one on each face of the wall"},
                                     {bolts, "bolts", "bolts through the wall from above"}});
}

/// Coarse metric threads (ISO 262).
enum class BoltSize { M8, M10, M12, M16, M20, M24, M27, M30, M36 };
constexpr auto choices(BoltSize) {
  using enum BoltSize;
  return choices_of<BoltSize>({{M8, "M8"},
                               {M10, "M10"},
                               {M12, "M12"},
                               {M16, "M16"},
                               {M20, "M20"},
                               {M24, "M24"},
                               {M27, "M27"},
                               {M30, "M30"},
                               {M36, "M36"}});
}
/// Classes of EN 1993-1-8, table 3.1.
enum class BoltGrade { g4_6, g4_8, g5_6, g5_8, g6_8, g8_8, g10_9 };
constexpr auto choices(BoltGrade) {
  using enum BoltGrade;
  return choices_of<BoltGrade>(
      {{g4_6, "4.6"}, {g4_8, "4.8"}, {g5_6, "5.6"}, {g5_8, "5.8"}, {g6_8, "6.8"}, {g8_8, "8.8"}, {g10_9, "10.9"}});
}

/// The kind at hand reads its own numbers. Factors are those of EN 1993-1-8 for S355; the partial factor is that of
/// static design, and an assumption under impact.
struct RimConnection {
  ConnectionKind kind = ConnectionKind::monolithic;
  double throat = 0;        ///< of each fillet [m], > 0
  double strength = 470e6;  ///< f_u of the weaker part that the welds join [Pa], > 0
  double correlation = 0.9; ///< beta_w of table 4.1 [-], > 0
  int number = 0;           ///< of bolts around the whole rim, >= 3
  BoltSize size = BoltSize::M20;
  BoltGrade grade = BoltGrade::g8_8;
  double circle = 0;            ///< diameter on which the bolts stand [m]
  double partial_factor = 1.25; ///< gamma_M2 of welds and bolts [-], >= 1
  bool operator==(const RimConnection &) const = default;
};

/// Stress area A_s = pi / 4 (d - 0.9382 P)^2 of the thread [m^2] (ISO 898-1), and its nominal diameter d [m].
double stress_area(BoltSize size);
double diameter(BoltSize size);
/// f_ub [Pa], and the share of it in shear through the thread, alpha_v of table 3.4 [-].
double ultimate_strength(BoltGrade grade);
double shear_share(BoltGrade grade);

/// "two fillet welds with a throat of 10 mm", "24 bolts M20 8.8 on 1128 mm", "one piece with the plate".
std::string in_words(const RimConnection &connection);
/// All that its use depends on; empty: one piece.
std::string strength_in_words(const RimConnection &connection);

} // namespace rimpact::scene
