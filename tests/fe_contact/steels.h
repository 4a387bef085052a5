/// Steels of every law of hardening, E = 200 GPa, nu = 0.3.
#pragma once
#include "scene/flow_curve.h"
#include <map>
#include <string>

namespace rimpact::test {

inline scene::Material steel_with(scene::HardeningLaw law) {
  scene::Material steel{200e9, 0.30, 7850.0, 360e6};
  steel.hardening.law = law;
  return steel;
}
inline scene::Material bilinear() {
  scene::Material steel = steel_with(scene::HardeningLaw::bilinear);
  steel.tangent_modulus = 1450e6;
  return steel;
}
/// A plateau, a steep piece, a flat one.
inline scene::Material table() {
  scene::Material steel = steel_with(scene::HardeningLaw::table);
  steel.hardening.curve.values = {{0, 360e6}, {0.02, 360e6}, {0.10, 520e6}, {0.50, 560e6}};
  return steel;
}
inline scene::Material swift() {
  scene::Material steel = steel_with(scene::HardeningLaw::swift);
  steel.hardening.K = 800e6, steel.hardening.e0 = 0.01, steel.hardening.n = 0.2;
  steel.yield = scene::yield_of_curve(steel);
  return steel;
}
inline scene::Material voce() {
  scene::Material steel = steel_with(scene::HardeningLaw::voce);
  steel.hardening.Q = 200e6, steel.hardening.b = 15;
  return steel;
}
inline scene::Material ludwik() {
  scene::Material steel = steel_with(scene::HardeningLaw::ludwik);
  steel.hardening.K = 700e6, steel.hardening.n = 0.6;
  return steel;
}
inline std::map<std::string, scene::Material> steels() {
  return {{"bilinear", bilinear()}, {"table", table()}, {"swift", swift()}, {"voce", voce()}, {"ludwik", ludwik()}};
}

} // namespace rimpact::test
