// SPDX-License-Identifier: MIT
// The parts of dermis._core; each adds its classes to the module.
#pragma once

#include <nanobind/nanobind.h>

namespace dermis::python {

void add_errors(nanobind::module_& m);
void add_settings(nanobind::module_& m);
void add_profiles(nanobind::module_& m);
void add_scenes(nanobind::module_& m);
void add_landmarks(nanobind::module_& m);
void add_renderers(nanobind::module_& m);
void add_reference(nanobind::module_& m);
void add_compare(nanobind::module_& m);
void add_exchange(nanobind::module_& m);
void add_datasets(nanobind::module_& m);

}  // namespace dermis::python
