/// What summary.json says in words: how a run ended, and what solved it.
#pragma once
#include "scene/choices.h"

namespace rimpact {

enum class RunStatus { done, stopped, interrupted };
constexpr auto choices(RunStatus) {
  using enum RunStatus;
  return choices_of<RunStatus>({{done, "done"}, {stopped, "stopped"}, {interrupted, "interrupted"}});
}

/// The reduced model, or a rung of finite elements; the key is `rung`. From the cheapest to the most expensive.
enum class SolvedBy { reduced, rim, rigid_dish, full };
constexpr auto choices(SolvedBy) {
  using enum SolvedBy;
  return choices_of<SolvedBy>({{reduced, "reduced"}, {rim, "rim"}, {rigid_dish, "rigid-dish"}, {full, "full"}});
}
constexpr SolvedBy solved_by(scene::Rung rung) {
  switch (rung) {
  case scene::Rung::rim:
    return SolvedBy::rim;
  case scene::Rung::rigid_dish:
    return SolvedBy::rigid_dish;
  case scene::Rung::full:
    return SolvedBy::full;
  }
  return SolvedBy::rim;
}
/// None: the reduced model.
constexpr std::optional<scene::Rung> rung_of(SolvedBy solver) {
  for (const auto &rung : choices(scene::Rung{}))
    if (solved_by(rung.value) == solver) return rung.value;
  return std::nullopt;
}

} // namespace rimpact
