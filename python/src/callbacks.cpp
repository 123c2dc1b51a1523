// SPDX-License-Identifier: MIT
#include "callbacks.h"

#include "process.h"

namespace nb = nanobind;

namespace dermis::python {

Callback::Callback(const nb::object& function) : function_(function.ptr()) { Py_INCREF(function_); }

Callback::~Callback() {
  if (!is_our_process()) return;
  const nb::gil_scoped_acquire acquired;
  Py_DECREF(function_);
}

std::shared_ptr<Callback> callback_of(const nb::object& function) {
  return function.is_none() ? nullptr : std::make_shared<Callback>(function);
}

Hooks hooks_of(const std::shared_ptr<Desk>& desk, const std::shared_ptr<Callback>& progress) {
  Hooks hooks{.log =
                  [](LogLevel level, const std::string& line) {
                    const nb::gil_scoped_acquire acquired;
                    const nb::object logger = nb::module_::import_("logging").attr("getLogger")("dermis");
                    logger.attr(level == LogLevel::warning ? "warning" : "info")("%s", line);
                  },
              .stop = &desk->stop};
  if (progress)
    hooks.progress = [progress](const WorkProgress& work) {
      const nb::gil_scoped_acquire acquired;
      const nb::object goes_on = progress->function()(work.what, work.share);
      return !goes_on.is(nb::handle(Py_False));
    };
  return hooks;
}

}  // namespace dermis::python
