#include "scene/bearing_catalogue.h"

#include "io/files/error.h"
#include "io/files/text.h"
#include "scene/assumptions.h"
#include "scene/edge_middle.h"
#include "scene/isolator_catalogue.h"
#include "scene/triple_pendulum.h"
#include <array>
#include <cmath>

namespace rimpact::scene {
namespace {

/// The thesis's SH-FPS: R0 = 2.25 m, a = R0/4.
Bearing shfps_225() {
  return {};
}

/// The same on a foot whose friction in the socket has the shortest arm that the pad's 853 kN at 60 MPa leave: a pad
/// without a hole, the smallest of that area, thin, so that the cap passes close above its seat; its face has the
/// dish's radius along a meridian at the capacity, (1 + z'^2)^(3/2)/z'' = 858 mm. With it the point model that knows
/// pad and socket meets the rim under Sylmar x 0.86, as the thesis's solid does; shfps-225 stops 4 mm short.
Bearing shfps_225_b() {
  Bearing b;
  b.name = "shfps-225-b";
  b.pad = {.inner_radius = 0, .outer_radius = 0.06727, .thickness = 0.012, .recess = 0.005, .shape_radius = 0.858};
  b.foot = {.radius = 0.0688, .bottom = 0.007, .shoulder = 0.015, .cap_radius = 0.070};
  return b;
}

/// shfps-225 with a sphere (a = R0): same capacity, slider, foot and pad. The dish's edge lies lower, so the
/// rim is higher for the same overlap with the slider's wall, and the pad is shaped to the dish.
Bearing fps_225() {
  Bearing b;
  b.name = "fps-225";
  b.surface.kind = SurfaceKind::sphere;
  b.surface.a = b.surface.R0;
  b.rim.height = 0.080;
  b.pad.shape_radius = b.surface.R0;
  return b;
}

/// One of the two like dishes of the tested SH-FPS (thesis appendix A: a = 180 mm, b = 43.2 mm, 90 kN). Its slider is
/// point-symmetric, so each dish sees half the travel: 90 mm for the test's 180. The ring of the pad carries 90 kN at
/// 60 MPa; all but the dish is assumed.
Bearing shfps_appendix_a() {
  Bearing b;
  b.name = "shfps-appendix-a";
  b.surface.R0 = 0.75;
  b.surface.a = 0.18;
  b.surface.planar_radius = 0.135;
  b.slider.diameter = 0.080, b.slider.bottom = 0.019, b.slider.top = 0.060, b.slider.edge_radius = 0.002;
  b.rim.height = 0.025;
  b.rim.thickness = 0.020;
  b.plate.base = 0.025;
  b.pad.inner_radius = 0.008;
  b.pad.outer_radius = 0.0233;
  b.pad.thickness = 0.016;
  b.pad.recess = 0.008;
  b.pad.shape_radius = 0.5;
  b.foot = {.radius = 0.028, .bottom = 0.008, .shoulder = 0.013, .cap_radius = 0.0308};
  return b;
}

/// Two dishes face to face with the thesis's radius, slider and capacity of 300 mm (section 3.4; scene::Isolator).
/// It draws neither the plates nor what is behind the rims' faces: those dimensions and the steel are assumed.
Bearing dcfp_155() {
  Bearing b;
  b.name = "dcfp-155";
  b.surface = {.kind = SurfaceKind::sphere, .concave = Concave::twice, .R0 = 1.55, .a = 1.55, .planar_radius = 0.30335};
  b.slider.diameter = 0.300;
  b.slider.height = 0.100;
  b.rim.height = 0.020;
  b.rim.thickness = 0.020;
  b.plate.base = 0.040;
  b.contact.steel_ertalyte = 0.05;
  b.assumed.keys = {"material.steel.yield_MPa"};
  return b;
}

/// dcfp-155 whose slider is two halves that slide on one another, with the friction of section 3.4.
Bearing lir_dcfp_155() {
  Bearing b = dcfp_155();
  b.name = "lir-dcfp-155";
  b.slider.mu_interface = 0.15;
  return b;
}

/// [m], as a drawing gives it.
double to_the_micrometre(double metres) {
  return std::round(1e6 * metres) / 1e6;
}

/// Two like faces of a triple pendulum with all that lies between them as one slider. Its rims' thickness, what is
/// below the dish and the rounding of the edge are assumed, and so are R and h, which share the published R_eff.
Bearing stop_of(const TripleFace &face, double mu, double rim_thickness, double base) {
  Bearing b = dcfp_155();
  b.slider.diameter = 2 * face.half, b.slider.height = 2 * face.height, b.slider.edge_radius = 0.005;
  b.surface.R0 = b.surface.a = face.radius;
  const EdgeMiddle edge(b);
  const double theta = face.tilt(), // where the edge is tangent to the wall
      wall = edge.out * std::cos(theta) + edge.down * std::sin(theta) + b.slider.edge_radius;
  b.surface.planar_radius = to_the_micrometre(wall);
  b.rim.height = face.rim_height, b.rim.thickness = rim_thickness, b.plate.base = base;
  b.contact.steel_ertalyte = mu;
  b.assumed.keys.insert({"surface.R0_m", "surface.planar_radius_mm", "slider.height_mm"});
  return b;
}

/// The stops of tfp-kim-2023: slide plates against the plates' rims.
Bearing kim_outer() {
  Bearing b = stop_of(triple_faces(builtin_isolator("tfp-kim-2023"))[0], 0.04, 0.040, 0.060);
  b.name = "tfp-kim-2023-outer";
  return b;
}

/// The inner slider against the rims of the slide plates, which reach to the slide plates' edges.
Bearing kim_inner() {
  const auto faces = triple_faces(builtin_isolator("tfp-kim-2023"));
  Bearing b = stop_of(faces[1], 0.01, 0.015, to_the_micrometre(faces[0].height - faces[1].height));
  b.name = "tfp-kim-2023-inner";
  return b;
}

struct Entry {
  const char *name;
  Bearing (*make)();
};
// The catalogue: one line a bearing.
constexpr std::array catalogue{
    Entry{"shfps-225", shfps_225},
    Entry{"shfps-225-b", shfps_225_b},
    Entry{"fps-225", fps_225},
    Entry{"shfps-appendix-a", shfps_appendix_a},
    Entry{"dcfp-155", dcfp_155},
    Entry{"lir-dcfp-155", lir_dcfp_155},
    Entry{"tfp-kim-2023-outer", kim_outer},
    Entry{"tfp-kim-2023-inner", kim_inner},
};

} // namespace

std::vector<std::string> builtin_bearing_names() {
  std::vector<std::string> names;
  names.reserve(catalogue.size());
  for (const auto &entry : catalogue) names.emplace_back(entry.name);
  return names;
}

Bearing builtin_bearing(const std::string &name) {
  for (const auto &entry : catalogue)
    if (name == entry.name) {
      Bearing bearing = entry.make();
      bearing.assumed.keys.merge(catalogue_marks().keys);
      return bearing;
    }
  throw InputError("bearing " + unknown_word(name, builtin_bearing_names()));
}

} // namespace rimpact::scene
