#include "scene/face_friction.h"
#include "io/files/error.h"
#include "scene/scene.h"
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

/// What is given of a face, for the coefficients `other` that it has where nothing is. A fast one alone is both.
FaceCoefficients own_or(const FaceCoefficients &other, const char *slow_key, const char *fast_key,
                        const std::optional<double> &slow, const std::optional<double> &fast) {
  FaceCoefficients face = other;
  if (fast) face = {fast_key, fast_key, *fast, *fast};
  if (slow) face.slow_key = slow_key, face.slow = *slow;
  return face;
}

} // namespace

std::vector<FaceCoefficients> face_coefficients(const Scene &scene) {
  const auto &r = scene.reduced;
  const auto &b = scene.isolator;
  const FaceCoefficients bottom{"reduced.mu_slow", "reduced.mu_fast", r.mu_slow, r.mu_fast};
  if (!scene.rigid_bodies()) return {bottom};
  const auto top = own_or(bottom, "isolator.top_mu_slow", "isolator.top_mu_fast", b.top_mu_slow, b.top_mu_fast);
  if (!scene.triple()) return {bottom, top};
  const FaceCoefficients inner{"isolator.inner.mu_slow", "isolator.inner.mu_fast", b.inner.mu_slow, b.inner.mu_fast};
  return {bottom, inner,
          own_or(inner, "isolator.inner.top_mu_slow", "isolator.inner.top_mu_fast", b.inner.top_mu_slow,
                 b.inner.top_mu_fast),
          top};
}

void check_face_friction(const Scene &scene) {
  const double rate = scene.reduced.rate;
  for (const auto &face : face_coefficients(scene)) {
    if (face.slow > face.fast)
      throw InputError(fmt::format("{} {} exceeds {} {}", face.slow_key, face.slow, face.fast_key, face.fast));
    if (face.slow != face.fast && !(rate > 0))
      throw InputError(fmt::format("reduced.rate_s_per_m {} must be > 0 when {} {} differs from {} {}", rate,
                                   face.slow_key, face.slow, face.fast_key, face.fast));
  }
}

} // namespace rimpact::scene
