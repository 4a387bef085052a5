/// Coefficients of friction of each sliding face, with the keys they come from.
#pragma once
#include <vector>

namespace rimpact::scene {

struct Scene;

struct FaceCoefficients {
  const char *slow_key, *fast_key; ///< of the numbers; a face without keys of its own has those of another
  double slow, fast;               ///< [-], >= 0
};

/// From the ground up. One dish: its own; double concave: both plates; triple pendulum: bottom plate, inner slider's
/// lower and upper face, top plate.
std::vector<FaceCoefficients> face_coefficients(const Scene &scene);

/// Throws InputError naming keys and values where a slow coefficient exceeds its fast one, or differs from it without a
/// rate.
void check_face_friction(const Scene &scene);

} // namespace rimpact::scene
