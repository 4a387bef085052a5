#include "scene/isolator_catalogue.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "scene/bearing_catalogue.h"
#include <array>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

/// The triple pendulum that Fenz and Constantinou tested, in mm: R 473 and 76, h 38 and 23, d 64 and 19, slide plates
/// of 102, inner slider of 51.
Isolator fenz_2008() {
  Isolator b;
  b.radius = 0.473, b.bottom_height = b.top_height = 0.038, b.travel = 0.064, b.slider_diameter = 0.102;
  b.inner = {.radius = 0.076, .bottom_height = 0.023, .top_height = 0.023, .diameter = 0.051, .travel = 0.019};
  b.mu_of = FrictionOf::loops;
  b.top_mu_fast = b.top_mu_slow = 0.10;
  b.inner.mu_fast = b.inner.mu_slow = 0.02;
  b.slider_mass = 1.5, b.inner.mass = 0.7, b.rim_height = 0.010;
  return b;
}

/// Configuration A of Kim and Constantinou: R_eff 3.7465 and 0.3937 m, travels of the pivot 0.5043 and 0.0716 m, slide
/// plates of 711 mm, inner slider of 508 mm. R = 156 and 22 inches are assumed; h = R - R_eff and d, the travel of the
/// pivot times R / R_eff, follow from them: 21 and 4 inches. With 20 inches the slide plates would lie in one another.
Isolator kim_2023() {
  Isolator b;
  b.radius = 3.9624, b.bottom_height = b.top_height = 0.2159, b.travel = 0.53336, b.slider_diameter = 0.711;
  b.inner = {.radius = 0.5588,
             .bottom_height = 0.1651,
             .top_height = 0.1651,
             .diameter = 0.508,
             .travel = 0.1016,
             .rim_height = 0.030,
             .mass = 350};
  b.mu_of = FrictionOf::loops;
  b.top_mu_fast = b.top_mu_slow = 0.08;
  b.inner.mu_fast = b.inner.mu_slow = 0.01;
  b.slider_mass = 320, b.rim_height = 0.040;
  b.contact_stiffness = 1.6e10;
  return b;
}

struct IsolatorEntry {
  const char *name, *source;
  Isolator (*make)();
};
// The catalogue: one line a bearing.
constexpr std::array isolators{
    IsolatorEntry{
        "tfp-fenz-2008",
        "tested by Fenz and Constantinou (2008): radii, heights, travels and diameters; friction, masses and rims are "
        "assumptions",
        fenz_2008},
    IsolatorEntry{
        "tfp-kim-2023",
        "configuration A of Kim and Constantinou (2023): effective radii, travels, diameters and friction; radii, "
        "masses, rims and contact stiffness are assumptions",
        kim_2023},
};

const IsolatorEntry &named_isolator(const std::string &name) {
  for (const auto &entry : isolators)
    if (name == entry.name) return entry;
  throw InputError("isolator " + unknown_word(name, builtin_isolator_names()));
}

/// Where its stops are bearings of the catalogue, their names.
std::string stops_of(const std::string &name) {
  std::string said;
  for (const auto &bearing : builtin_bearing_names())
    if (bearing.starts_with(name))
      said += (said.empty() ? "; as solids its stops are the bearings " : " and ") + bearing;
  return said;
}

} // namespace

std::vector<std::string> builtin_isolator_names() {
  std::vector<std::string> names;
  names.reserve(isolators.size());
  for (const auto &entry : isolators) names.emplace_back(entry.name);
  return names;
}

Isolator builtin_isolator(const std::string &name) {
  Isolator isolator = named_isolator(name).make();
  isolator.name = name;
  return isolator;
}

void refuse_isolator(const std::string &where) {
  for (const auto &entry : isolators)
    if (where == entry.name)
      throw InputError(fmt::format("{0} is a triple friction pendulum, which only a scene names: isolator.name = "
                                   "\"{0}\" beside reduced.model = \"tfp\", as in tfp-pulse{1}",
                                   where, stops_of(where)));
}

std::string isolator_source(const std::string &name) {
  return named_isolator(name).source;
}

} // namespace rimpact::scene
