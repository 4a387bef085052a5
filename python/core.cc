// rimpact._core: reduced runs in this process. The interpreter's lock is released while a model flies, so threads run
// side by side.
#include "python/core.h"

#include "python/core_laws.h"
#include "python/core_scene.h"

#include "io/files/error.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/record/run_doubts.h"
#include "reduced_models/simulate.h"
#include "responses/run_folder.h"
#include "responses/summary.h"

namespace py = pybind11;

namespace rimpact::python {

py::array_t<double> array_of(std::vector<double> values) {
  auto kept = std::make_unique<std::vector<double>>(std::move(values));
  const py::capsule owner(kept.get(), [](void *data) { delete static_cast<std::vector<double> *>(data); });
  const auto *numbers = kept.release();
  return py::array_t<double>(static_cast<py::ssize_t>(numbers->size()), numbers->data(), owner);
}

namespace {

using reduced::ReducedRun;

ReducedRun run(const SceneHandle &handle) {
  ReducedRun result = reduced::simulate(*handle.scene);
  reduced::add_doubts(*handle.scene, result.response, result.summary);
  return result;
}

Summary summarise(const SceneHandle &handle) {
  Summary summary = reduced::simulate_summary(*handle.scene);
  reduced::add_doubts(*handle.scene, {}, summary);
  return summary;
}

py::dict signals_of(const ReducedRun &run) {
  py::dict table;
  for (const auto &info : known_signals())
    if (run.response.has(info.name)) table[info.name.c_str()] = array_of(run.response.series(info.name));
  return table;
}

std::string json_of(const Summary &summary) {
  return to_json(summary).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

py::list known() {
  py::list list;
  for (const auto &info : known_signals()) list.append(py::make_tuple(info.name, info.units, info.description));
  return list;
}

/// One exception for each kind of failure; rimpact/errors.py has the classes.
void translate_errors() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error &error) {
      const py::module_ errors = py::module_::import("rimpact.errors");
      const py::object kind = errors.attr("of_code")(static_cast<int>(error.code()));
      PyErr_SetString(kind.ptr(), error.what());
    }
  });
}

} // namespace

void add_runs(py::module_ &module) {
  py::class_<ReducedRun>(module, "Run")
      .def("signals", &signals_of)
      .def("summary_json", [](const ReducedRun &run) { return json_of(run.summary); })
      .def(
          "save",
          [](const ReducedRun &run, const SceneHandle &handle, const std::string &folder) {
            write_run_folder(folder, *handle.scene, run.response, run.summary);
          },
          py::arg("scene"), py::arg("folder"), py::call_guard<py::gil_scoped_release>());
  module.def("run", &run, py::arg("scene"), py::call_guard<py::gil_scoped_release>());
  module.def(
      "summarise", [](const SceneHandle &handle) { return json_of(summarise(handle)); }, py::arg("scene"),
      py::call_guard<py::gil_scoped_release>());
  module.def("known_signals", &known);
}

} // namespace rimpact::python

PYBIND11_MODULE(_core, module) {
  module.doc() = "Reduced models, scenes and laws of rimpact, compiled. Use the package rimpact.";
  module.attr("__version__") = RIMPACT_VERSION;
  module.attr("knows_numpy_2") = PYBIND11_VERSION_HEX >= 0x020C0000; // before 2.12 its arrays would have no strides
  rimpact::python::translate_errors();
  rimpact::python::add_scene(module);
  rimpact::python::add_runs(module);
  rimpact::python::add_laws(module);
}
