/// What every rung's checkpoint holds: the run's record, and the arrays of a state.
#pragma once
#include "fe_contact/model/solid.h"
#include "fe_contact/runner/checkpoint.h"
#include "fe_contact/runner/run_record.h"

namespace rimpact::fe {

std::vector<double> list(const Eigen::VectorXd &v);
Eigen::VectorXd vector(const std::vector<double> &v);
std::vector<double> list(const SolidHistory &history); ///< 7 numbers a point
/// Throws DataError when the sizes differ: another mesh.
void restore(const std::vector<double> &numbers, SolidHistory &history);
/// An array of the file; throws DataError naming it when absent.
const std::vector<double> &numbers(const Checkpoint &file, const std::string &name);

std::vector<double> list(const scene::Impact &impact);
scene::Impact impact_from(const std::vector<double> &numbers);

/// Marks the file with version and scene, and stores the record.
void put(Checkpoint &file, const scene::Scene &scene, const RunRecord &record);
/// Reads the record back. Throws DataError when the file is of another version or scene.
void get(const Checkpoint &file, const std::string &path, const scene::Scene &scene, RunRecord &record);

} // namespace rimpact::fe
