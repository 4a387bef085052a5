#include "buildings/axial_bending.h"

namespace rimpact::buildings {

AxialBending::Factor AxialBending::factor(double axial) const {
  const double pressed = -axial, block = depth / (2 * plain);
  Factor f{1 + pressed * block * (1 - pressed / crush), -block * (1 - 2 * pressed / crush)};
  if (pressed < 0) f = {1 + pressed / pull(), -1 / pull()};
  if (pressed > crush) f = {1 - (pressed - crush) / pull(), 1 / pull()};
  if (f.value < least) f = {least, 0};
  return f;
}

double AxialBending::largest() const {
  return factor(-crush / 2).value;
}

} // namespace rimpact::buildings
