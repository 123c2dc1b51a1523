// SPDX-License-Identifier: MIT
#include "dermis/error.h"

#include "dermis/cancelled.h"
#include "module.h"

namespace nb = nanobind;

namespace dermis::python {
namespace {

template <class Error>
void add(nb::module_& m, const char* name, PyObject* base, const char* doc) {
  nb::exception<Error> type(m, name, base);
  type.attr("__doc__") = doc;
}

}  // namespace

void add_errors(nb::module_& m) {
  add<InputError>(m, "InputError", PyExc_ValueError,
                  "A file, a setting or an array cannot be used. One line: where, and what was expected.");
  add<DeviceError>(m, "DeviceError", PyExc_RuntimeError,
                   "The device, its driver or its memory cannot do what is asked. One line.");
  add<Cancelled>(m, "Cancelled", PyExc_RuntimeError, "A progress function has ended the work.");
  add<InternalError>(m, "InternalError", PyExc_RuntimeError,
                     "dermis has made a mistake. The renderer that raised it can only be thrown away.");
}

}  // namespace dermis::python
