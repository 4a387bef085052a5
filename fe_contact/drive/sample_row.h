/// One instant of a finite-element run as the response stores it, whatever the rung. SI units.
#pragma once
#include "fe_contact/drive/run_record.h"
#include "fe_contact/rungs/rim_foot.h"
#include <Eigen/Core>
#include <optional>

namespace rimpact::fe {

struct SampleRow {
  double time;          ///< [s], or the load parameter
  Eigen::Vector3d u, v; ///< of the slider, from rest on the vertex
  /// Of the bearing on the mass [N]; `total` is their sum. Of the parts only the plane is stored.
  Eigen::Vector3d total, pendular, friction, impact;
  std::optional<double> normal_force; ///< of the dish; empty: not stored
  double gap, surface_gap;
  double plastic_strain, contact_pressure; ///< largest
  int newton_iterations;
  double step;                             ///< taken [s], or of the load parameter
  std::optional<double> pad_pressure = {}; ///< largest of the pad on the dish [Pa]; empty: there is no pad
  /// Of a frictional pad in its recess: largest pressures [Pa], and what friction took there over the step [J].
  struct Seat {
    double bottom, wall, friction_work;
  };
  std::optional<Seat> seat = {};
  std::optional<FootForces> foot = {};      ///< empty: the mesh has no foot
  std::optional<Eigen::Vector2d> slip = {}; ///< of the slider's upper half past the lower one; empty: it is one piece
};
/// The foot's signals by name; `rim_foot_use` is there where the joint has one.
std::vector<std::pair<const char *, double>> foot_signals(const FootForces &foot);
/// The ledger's signals by name.
std::vector<std::pair<const char *, double>> energy_signals(const EnergyLedger &ledger);
/// With the energies of the record's ledger as it stands.
void append(RunRecord &record, const SampleRow &row);

} // namespace rimpact::fe
