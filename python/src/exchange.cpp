// SPDX-License-Identifier: MIT
// Profiles from and for other systems.
#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <tuple>

#include "callbacks.h"
#include "dermis/profile_exchange.h"
#include "dermis/setting_rows.h"
#include "module.h"

namespace nb = nanobind;

namespace dermis::python {
namespace {

using Rows = std::vector<std::array<double, 3>>;

// Calls make(options, hooks) in a thread of its own.
template <class Make>
ScatterProfile made(std::string_view json, const nb::object& progress, Make make) {
  ProfileOptions options;
  read_settings(json, options);
  const auto desk = std::make_shared<Desk>();
  const auto callback = callback_of(progress);
  return run(desk, [=] { return make(options, hooks_of(desk, callback)); });
}

ScatterProfile profile_of(const std::string& name, const std::vector<double>& r_mm, const Rows& reflectance,
                          std::string_view options, const nb::object& progress) {
  return made(options, progress, [=](const ProfileOptions& how, const Hooks& hooks) {
    return profile_of_table(name, r_mm, reflectance, how, hooks);
  });
}

ScatterProfile imported(const std::string& text, std::string_view options, const nb::object& progress) {
  return made(options, progress, [=](const ProfileOptions& how, const Hooks& hooks) {
    return profile_of_import(text, how, hooks);
  });
}

// Members of spectral skin in the order of SpectralSkin, and the distance from the colour.
std::pair<std::array<double, 5>, double> skin_near(const std::string& colour) {
  const auto desk = std::make_shared<Desk>();
  return run(desk, [=] {
    double delta_e = 0;
    const SpectralSkin skin = skin_of_colour(colour, &delta_e, hooks_of(desk, nullptr));
    return std::pair(
        std::array{skin.melanin, skin.blend, skin.haemoglobin, skin.oxygenation, skin.epidermis_mm}, delta_e);
  });
}

std::tuple<std::vector<double>, Rows, Rows> table_of(const ScatterProfile& profile) {
  const auto desk = std::make_shared<Desk>();
  return run(desk, [=] {
    const ProfileTable table = model_table(profile, hooks_of(desk, nullptr));
    return std::tuple(table.r_mm, table.reflectance_per_mm2, table.standard_error_per_mm2);
  });
}

}  // namespace

void add_exchange(nb::module_& m) {
  m.def("exchange_systems", &exchange_systems);
  m.def("kernel_names", &kernel_names);
  m.def("export_profile", &export_profile, nb::arg("profile"), nb::arg("system"));
  m.def(
      "export_kernel",
      [](const ScatterProfile& profile, const std::string& name, std::optional<int> taps) {
        const ProfileKernel kernel = export_kernel(profile, name, taps);
        return std::tuple(kernel.json, kernel.c, kernel.glsl);
      },
      nb::arg("profile"), nb::arg("name"), nb::arg("taps").none());
  m.def("profile_of_table", profile_of, nb::arg("name"), nb::arg("r_mm"), nb::arg("reflectance"),
        nb::arg("options"), nb::arg("progress").none());
  m.def("profile_of_import", imported, nb::arg("text"), nb::arg("options"), nb::arg("progress").none());
  m.def("skin_of_colour", skin_near, nb::arg("colour"));
  m.def("model_table", table_of, nb::arg("profile"));
}

}  // namespace dermis::python
