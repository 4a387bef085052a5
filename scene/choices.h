/// The choices of [model] and [reduced], each with the words of its key. Those of bearing, motion, isolator and
/// superstructure stand beside them.
#pragma once
#include "io/files/choice.h"

namespace rimpact::scene {

/// Which parts deform by finite elements.
enum class Rung { rim, rigid_dish, full };
constexpr auto choices(Rung) {
  using enum Rung;
  return choices_of<Rung>({{rim, "rim"}, {rigid_dish, "rigid-dish"}, {full, "full"}});
}

/// The solids stand on the dish: pad and foot are among them, and the dish carries the weight.
constexpr bool has_dish(Rung rung) {
  return rung != Rung::rim;
}
/// The dish is a law: between impacts the reduced model moves the mass, and the solids are there while the walls touch.
constexpr bool flies_reduced(Rung rung) {
  return !has_dish(rung);
}

/// Whether half of the bearing is meshed.
enum class Symmetry { by_plan, half, whole };
constexpr auto choices(Symmetry) {
  using enum Symmetry;
  return choices_of<Symmetry>({{by_plan, "auto"}, {half, "half"}, {whole, "whole"}});
}

/// A mass on one dish; a double concave bearing, without or with an interface in its slider; a triple pendulum.
enum class ModelKind { physical, dcfp, lir_dcfp, tfp };
constexpr auto choices(ModelKind) {
  using enum ModelKind;
  return choices_of<ModelKind>({{physical, "physical"}, {dcfp, "dcfp"}, {lir_dcfp, "lir-dcfp"}, {tfp, "tfp"}});
}

enum class Friction { coulomb, park_wen };
constexpr auto choices(Friction) {
  using enum Friction;
  return choices_of<Friction>({{coulomb, "coulomb"}, {park_wen, "park-wen"}});
}

/// What the normal force follows (reduced_models/bearings/dynamics.h).
enum class NormalForce { inertia, statics, constant, pad };
constexpr auto choices(NormalForce) {
  using enum NormalForce;
  return choices_of<NormalForce>({{inertia, "inertia"}, {statics, "static"}, {constant, "constant"}, {pad, "pad"}});
}

/// Who moves a mass on one dish: our own steps by events, or SUNDIALS CVODE as an independent check of them.
enum class Integrator { own, cvode };
constexpr auto choices(Integrator) {
  using enum Integrator;
  return choices_of<Integrator>({{own, "own"}, {cvode, "cvode"}});
}

} // namespace rimpact::scene
