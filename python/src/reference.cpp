// SPDX-License-Identifier: MIT
#include "dermis/reference.h"

#include <nanobind/nanobind.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>

#include "array_over.h"
#include "callbacks.h"
#include "dermis/setting_rows.h"
#include "module.h"

namespace nb = nanobind;

namespace dermis::python {
namespace {

// `after_sample`: called as f(samples, most samples, noise in per cent, seconds left); False ends the work.
std::shared_ptr<ReferencePicture> render(const Scene& scene, const RenderSettings& settings,
                                         std::string_view json, const std::string& checkpoint, bool resume,
                                         const nb::object& after_sample, const nb::object& progress) {
  ReferenceSettings how;
  read_settings(json, how);
  how.checkpoint = checkpoint;
  how.resume = resume;
  const auto desk = std::make_shared<Desk>();
  if (const auto callback = callback_of(after_sample))
    how.after_sample = [callback, desk](const ReferenceProgress& p) {
      const nb::gil_scoped_acquire acquired;
      const nb::object goes_on =
          callback->function()(p.samples, p.most_samples, p.noise_percent, p.seconds_left);
      if (goes_on.is(nb::handle(Py_False))) desk->stop = true;
    };
  return run(desk, [=, callback = callback_of(progress)] {
    return std::make_shared<ReferencePicture>(
        render_reference(scene, settings, how, hooks_of(desk, callback)));
  });
}

}  // namespace

void add_reference(nb::module_& m) {
  nb::class_<ReferencePicture>(m, "ReferencePicture")
      .def_prop_ro(
          "picture",
          [](const std::shared_ptr<ReferencePicture>& p) { return std::shared_ptr<Picture>(p, &p->picture); })
      .def_prop_ro(
          "variance",
          [](const std::shared_ptr<ReferencePicture>& p) {
            return array_over(p->variance_rgba.data(), p->picture.width, p->picture.height, 4, keeper(p));
          },
          nb::rv_policy::automatic)
      .def_ro("samples", &ReferencePicture::samples)
      .def_ro("noise_percent", &ReferencePicture::noise_percent)
      .def_ro("complete", &ReferencePicture::complete);
  m.def("render_reference", render, nb::arg("scene"), nb::arg("settings"), nb::arg("reference"),
        nb::arg("checkpoint"), nb::arg("resume"), nb::arg("after_sample").none(), nb::arg("progress").none());
}

}  // namespace dermis::python
