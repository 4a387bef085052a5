// Laws of the rim for Python: the force over penetration, its rate and the deepest penetration before, element by
// element.
#include "python/core_laws.h"

#include "io/files/error.h"
#include "laws/impact/catalogue.h"
#include <cmath>

namespace py = pybind11;

namespace rimpact::python {
namespace {

using laws::RimElement;

RimElement element_of(const SceneHandle &handle) {
  const auto &settings = handle.scene->reduced;
  if (settings.impact_law->pushed)
    throw InputError("impact_law \"curve\" has no formula to call; its curve.h5 holds the samples");
  return settings.element(handle.scene->load.mass);
}

/// Force [N] of the rim, zero where it is not touched, NaN of a NaN.
double force(const RimElement &rim, double penetration, double rate, double deepest) {
  if (const double all = penetration + rate + deepest; std::isnan(all)) return all;
  if (!(penetration > 0)) return 0;
  return rim.at({.d = penetration, .rate = rate, .speed = std::abs(rate), .deepest = std::max(deepest, penetration)})
      .force;
}

/// Element by element, numbers and arrays mixed as numpy does.
py::object forces(const RimElement &rim, const py::array_t<double> &penetration, const py::array_t<double> &rate,
                  const py::array_t<double> &deepest) {
  const auto one = [&rim](double d, double speed, double before) { return force(rim, d, speed, before); };
  return py::vectorize(one)(penetration, rate, deepest);
}

py::dict numbers_of(const RimElement &rim) {
  py::dict numbers;
  for (const auto &[name, value] : rim.law->numbers(rim)) numbers[name.c_str()] = value;
  return numbers;
}

py::list laws() {
  py::list list;
  for (const auto *law : laws::impact_laws()) list.append(py::make_tuple(law->name, law->description));
  return list;
}

} // namespace

void add_laws(py::module_ &module) {
  py::class_<RimElement>(module, "Law")
      .def(py::init(&element_of), py::arg("scene"))
      .def_property_readonly("name", [](const RimElement &rim) { return rim.law->name; })
      .def_property_readonly("description", [](const RimElement &rim) { return rim.law->description; })
      .def_property_readonly("yields", [](const RimElement &rim) { return rim.law->yields; })
      .def_property_readonly("numbers", &numbers_of)
      .def("force", &forces, py::arg("penetration"), py::arg("rate"), py::arg("deepest"));
  module.def("laws", &laws);
}

} // namespace rimpact::python
