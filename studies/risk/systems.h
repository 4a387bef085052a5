/// The systems of a study and the runs of each.
#pragma once
#include "studies/risk/motions.h"

namespace rimpact::risk {

struct System {
  std::vector<Cell> values;           ///< of Systems::keys
  std::vector<std::string> overrides; ///< KEY=VALUE for load_scene, those of the study's [set] first
};

struct Systems {
  std::vector<std::string> keys; ///< of [[case]], [[device]], [grid] and what is [linked] to them only; may be none
  std::vector<System> all;
  std::size_t size() const { return all.size(); }
};

/// Every combination of cases, devices and grid. Throws InputError as fleets::combine.
Systems systems_of(const Study &study);

/// Every motion with every sample, for one system: columns record, variable.level_g and variable.motion_scale beside
/// what the samples set. A [linked] key of a sample and a system's key takes the system's value.
fleets::Sweep runs_of(const Study &study, const Systems &systems, std::size_t system, const Motions &motions);

} // namespace rimpact::risk
