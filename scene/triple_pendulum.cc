#include "scene/triple_pendulum.h"
#include "io/files/error.h"
#include "scene/spherical_cap.h"
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rimpact::scene {

double TripleFace::edge_angle() const {
  return std::asin(half / radius);
}
double TripleFace::tilt() const {
  return std::asin(travel / radius);
}
double TripleFace::rim_radius() const {
  return radius * std::sin(tilt() + edge_angle());
}

std::array<TripleFace, 4> triple_faces(const Isolator &b) {
  const InnerSlider &in = b.inner;
  const double half = b.slider_diameter / 2, inner_half = in.diameter / 2;
  return {{{b.radius, b.bottom_height, half, b.travel, b.rim_height},
           {in.radius, in.bottom_height, inner_half, in.travel, in.rim_height},
           {in.upper_radius(), in.top_height, inner_half, in.upper_travel(), in.rim_height},
           {b.upper_radius(), b.top_height, half, b.upper_travel(), b.rim_height}}};
}

double triple_capacity(const Isolator &b) {
  const auto f = triple_faces(b);
  const double inner = std::min(f[0].tilt() + f[1].tilt(), f[2].tilt() + f[3].tilt());
  return (f[0].effective_radius() - f[1].effective_radius()) * std::sin(std::min(f[0].tilt(), inner + f[1].tilt())) +
         (f[1].effective_radius() + f[2].effective_radius()) * std::sin(inner) +
         (f[3].effective_radius() - f[2].effective_radius()) * std::sin(std::min(f[3].tilt(), inner + f[2].tilt()));
}

double triple_start_capacity(const Isolator &b) {
  const auto f = triple_faces(b);
  return b.effective_radius() * std::sin(std::min(f[0].tilt(), f[3].tilt()));
}

namespace {

/// The keys that a face is described by.
struct FaceKeys {
  const char *radius, *height, *diameter, *travel;
};

void demand(bool holds, const char *key, double value, const std::string &bound) {
  if (!holds) throw InputError(fmt::format("isolator.{} {:.6g} {}", key, value, bound));
}

void check_face(const TripleFace &f, const FaceKeys &key) {
  constexpr double mm = 1e3;
  demand(f.half < f.radius, key.diameter, 2 * mm * f.half,
         fmt::format("must be below 2 R = {:.6g} mm", 2 * mm * f.radius));
  const double sagitta = cap_height(f.radius, f.half);
  demand(f.height > sagitta, key.height, mm * f.height,
         fmt::format("must exceed {:.4g} mm, the depth of its curved face", mm * sagitta));
  demand(f.radius > f.height, key.radius, f.radius,
         fmt::format("must exceed the height {:.6g} m of its face", f.height));
  demand(f.travel < f.radius, key.travel, mm * f.travel, fmt::format("must be below R = {:.6g} mm", mm * f.radius));
  demand(f.tilt() + f.edge_angle() < std::numbers::pi / 2, key.travel, mm * f.travel,
         "takes the slider's edge past the sphere's equator");
}

/// What a slide plate must be to hold the inner slider.
void check_slide_plate(const TripleFace &outer, const TripleFace &inner, const FaceKeys &outer_key,
                       const FaceKeys &inner_key) {
  constexpr double mm = 1e3;
  demand(outer.height > inner.height, outer_key.height, mm * outer.height,
         fmt::format("must exceed isolator.{} {:.6g}: the slide plate between them is that thick", inner_key.height,
                     mm * inner.height));
  demand(outer.effective_radius() > inner.effective_radius(), outer_key.radius, outer.radius,
         fmt::format("less its height must exceed {:.4g} m, the effective radius of the inner face",
                     inner.effective_radius()));
  demand(inner.rim_radius() < outer.half, inner_key.travel, mm * inner.travel,
         fmt::format("puts the inner rim at a radius of {:.4g} mm, outside the slide plate's {:g} mm",
                     mm * inner.rim_radius(), mm * outer.half));
}

} // namespace

void validate_triple(const Isolator &b) {
  const auto f = triple_faces(b);
  const FaceKeys keys[] = {{"radius_m", "bottom_height_mm", "slider_diameter_mm", "travel_mm"},
                           {"inner.radius_m", "inner.bottom_height_mm", "inner.diameter_mm", "inner.travel_mm"},
                           {b.inner.top_radius ? "inner.top_radius_m" : "inner.radius_m", "inner.top_height_mm",
                            "inner.diameter_mm", b.inner.top_travel ? "inner.top_travel_mm" : "inner.travel_mm"},
                           {b.top_radius ? "top_radius_m" : "radius_m", "top_height_mm", "slider_diameter_mm",
                            b.top_travel ? "top_travel_mm" : "travel_mm"}};
  for (int i = 0; i < 4; ++i) check_face(f[i], keys[i]);
  check_slide_plate(f[0], f[1], keys[0], keys[1]);
  check_slide_plate(f[3], f[2], keys[3], keys[2]);
}

} // namespace rimpact::scene
