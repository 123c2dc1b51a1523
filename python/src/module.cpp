// SPDX-License-Identifier: MIT
#include "module.h"

#include "process.h"
#include "work.h"

namespace nb = nanobind;

NB_MODULE(_core, m) {
  m.doc() = "What dermis is made of in C++; use the module dermis.";
  dermis::python::remember_process();
  dermis::python::add_errors(m);
  dermis::python::add_settings(m);
  dermis::python::add_profiles(m);
  dermis::python::add_scenes(m);
  dermis::python::add_landmarks(m);
  dermis::python::add_renderers(m);
  dermis::python::add_reference(m);
  dermis::python::add_compare(m);
  dermis::python::add_exchange(m);
  dermis::python::add_datasets(m);
  m.def("end_threads", &dermis::python::end_threads, "Waits for work that was left behind.");
}
