/// Laws of the rim for Python.
#pragma once
#include "python/core.h"

namespace rimpact::python {

void add_laws(pybind11::module_ &module); ///< Law, laws

} // namespace rimpact::python
