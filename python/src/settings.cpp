// SPDX-License-Identifier: MIT
#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/vector.h>

#include "dermis/setting_rows.h"
#include "module.h"

namespace nb = nanobind;

namespace dermis::python {

void add_settings(nb::module_& m) {
  nb::enum_<SettingRow::Kind>(m, "Kind")
      .value("text", SettingRow::Kind::text)
      .value("texts", SettingRow::Kind::texts)
      .value("number", SettingRow::Kind::number)
      .value("whole", SettingRow::Kind::whole)
      .value("boolean", SettingRow::Kind::boolean)
      .value("choice", SettingRow::Kind::choice)
      .value("lights", SettingRow::Kind::lights);
  nb::class_<SettingRow>(m, "SettingRow")
      .def_ro("path", &SettingRow::path)
      .def_ro("option", &SettingRow::option)
      .def_ro("help", &SettingRow::help)
      .def_ro("kind", &SettingRow::kind)
      .def_ro("count", &SettingRow::count)
      .def_ro("optional", &SettingRow::optional)
      .def_ro("none", &SettingRow::none)
      .def_ro("unit", &SettingRow::unit)
      .def_ro("least", &SettingRow::least)
      .def_ro("most", &SettingRow::most)
      .def_ro("values", &SettingRow::values)
      .def_ro("choices", &SettingRow::choices)
      .def_ro("on", &SettingRow::on)
      .def_ro("off", &SettingRow::off)
      .def_ro("initial", &SettingRow::initial);

  nb::class_<RenderSettings>(m, "RenderSettings").def_prop_ro("json", [](const RenderSettings& s) {
    return settings_text(s);
  });
  m.def("setting_rows", [] { return rows_of(RenderSettings{}); });
  m.def("asset_rows", [] { return rows_of(SceneOptions{}); });
  m.def("reference_rows", [] { return rows_of(ReferenceSettings{}); });
  m.def("profile_rows", [] { return rows_of(ProfileOptions{}); });
  m.def("skin_rows", [] { return rows_of(SpectralSkin{}); });
  m.def(
      "render_settings",
      [](std::string_view json) {
        RenderSettings settings;
        read_settings(json, settings);
        return settings;
      },
      nb::arg("json"));
  m.def(
      "nearest",
      [](std::string_view word, const std::vector<std::string>& names) {
        return nearest_setting(word, names);
      },
      nb::arg("word"), nb::arg("names"));
}

}  // namespace dermis::python
