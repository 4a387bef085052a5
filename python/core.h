/// The parts of the compiled module rimpact._core. Python's own names and types stand in rimpact/_core.pyi.
#pragma once
#include "scene/scene.h"
#include <memory>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <vector>

namespace rimpact::python {

/// A resolved scene; no copy is made when it is run.
struct SceneHandle {
  std::shared_ptr<const scene::Scene> scene;
};

/// The values as a numpy array that owns them: nothing is copied.
pybind11::array_t<double> array_of(std::vector<double> values);

void add_runs(pybind11::module_ &module); ///< Run, run, summarise, signals

} // namespace rimpact::python
