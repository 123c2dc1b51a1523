// SPDX-License-Identifier: MIT
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/vector.h>

#include "callbacks.h"
#include "dermis/profile.h"
#include "dermis/setting_rows.h"
#include "module.h"

namespace nb = nanobind;

namespace dermis::python {
namespace {

template <class Settings>
Settings read(std::string_view json) {
  Settings settings;
  read_settings(json, settings);
  return settings;
}

// Calls make(hooks) in a thread of its own.
template <class Make>
ScatterProfile made(const nb::object& progress, Make make) {
  const auto desk = std::make_shared<Desk>();
  const auto callback = callback_of(progress);
  return run(desk, [=] { return make(hooks_of(desk, callback)); });
}

}  // namespace

void add_profiles(nb::module_& m) {
  nb::class_<ScatterProfile>(m, "Profile")
      .def_ro("name", &ScatterProfile::name)
      .def_ro("model", &ScatterProfile::model)
      .def_prop_ro("variances_mm2",
                   [](const ScatterProfile& p) {
                     std::vector<double> variances_mm2;
                     for (const Gaussian& term : p.terms) variances_mm2.push_back(term.variance_mm2);
                     return variances_mm2;
                   })
      .def_prop_ro("weights",
                   [](const ScatterProfile& p) {
                     std::vector<std::array<double, 3>> weights;
                     for (const Gaussian& term : p.terms) weights.push_back(term.weight);
                     return weights;
                   })
      .def_ro("error_percent", &ScatterProfile::error_percent)
      .def_ro("total_reflectance", &ScatterProfile::total_reflectance)
      .def_ro("mean_free_path_mm", &ScatterProfile::mean_free_path_mm)
      .def_ro("diffuse_mean_free_path_mm", &ScatterProfile::diffuse_mean_free_path_mm)
      .def_prop_ro("has_curves", [](const ScatterProfile& p) { return p.model_curves != nullptr; })
      .def("reflectance",
           [](const ScatterProfile& profile, double r_mm) { return reflectance(profile, r_mm); })
      .def("save",
           [](const ScatterProfile& profile, const std::string& path) { write_profile(profile, path); });

  m.def("load_profile",
        [](const std::string& name, bool normalise) { return load_profile(name, normalise); });
  m.def(
      "profile_of_preset",
      [](const std::string& name, std::string_view options, const nb::object& progress) {
        return made(progress, [name, options = read<ProfileOptions>(options)](const Hooks& hooks) {
          return profile_of_preset(name, options, hooks);
        });
      },
      nb::arg("name"), nb::arg("options"), nb::arg("progress").none());
  m.def(
      "profile_of_skin",
      [](std::string_view skin, std::string_view options, const nb::object& progress) {
        return made(progress, [skin = read<SpectralSkin>(skin), options = read<ProfileOptions>(options)](
                                  const Hooks& hooks) { return profile_of_skin(skin, options, hooks); });
      },
      nb::arg("skin"), nb::arg("options"), nb::arg("progress").none());
  m.def(
      "profile_of_coefficients",
      [](const std::array<double, 3>& sigma_a_per_mm, const std::array<double, 3>& sigma_s_per_mm, double g,
         double eta, std::string_view options, const nb::object& progress) {
        const Coefficients coefficients{
            .sigma_a_per_mm = sigma_a_per_mm, .sigma_s_per_mm = sigma_s_per_mm, .g = g, .eta = eta};
        return made(progress, [coefficients, options = read<ProfileOptions>(options)](const Hooks& hooks) {
          return profile_of_coefficients(coefficients, options, hooks);
        });
      },
      nb::arg("sigma_a_per_mm"), nb::arg("sigma_s_per_mm"), nb::arg("g"), nb::arg("eta"), nb::arg("options"),
      nb::arg("progress").none());
}

}  // namespace dermis::python
