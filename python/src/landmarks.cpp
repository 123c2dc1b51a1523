// SPDX-License-Identifier: MIT
#include "dermis/landmarks.h"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <span>
#include <tuple>

#include "module.h"

namespace nb = nanobind;

namespace dermis::python {
namespace {

using Depth = nb::ndarray<const float, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using Place = std::tuple<int, std::array<std::uint32_t, 3>, std::array<double, 3>>;
using Marked = std::tuple<double, double, double, bool, std::array<double, 3>>;

std::vector<Place> places_of(const Landmarks& marks) {
  std::vector<Place> places;
  for (const LandmarkPlace& place : marks.places())
    places.emplace_back(place.mesh, place.vertices, place.weights);
  return places;
}

std::vector<Marked> in_picture(const Landmarks& marks, const Scene& scene, std::uint32_t id,
                               const ResolvedCamera& camera, const Depth& depth) {
  std::vector<Marked> found;
  for (const Landmark& mark :
       marks.in_picture(scene, InstanceId{id}, camera, std::span(depth.data(), depth.size())))
    found.emplace_back(mark.x, mark.y, mark.depth_m, mark.seen, mark.position_m);
  return found;
}

}  // namespace

void add_landmarks(nb::module_& m) {
  nb::class_<ResolvedCamera>(m, "ResolvedCamera")
      .def(nb::init<>())
      .def_rw("orthographic", &ResolvedCamera::orthographic)
      .def_rw("width", &ResolvedCamera::width)
      .def_rw("height", &ResolvedCamera::height)
      .def_rw("near_m", &ResolvedCamera::near_m)
      .def_rw("k", &ResolvedCamera::k)
      .def_rw("r", &ResolvedCamera::r)
      .def_rw("t_m", &ResolvedCamera::t_m);
  nb::class_<Landmarks>(m, "Landmarks")
      .def("places", places_of)
      .def("positions", [](const Landmarks& marks, const Scene& scene,
                           std::uint32_t id) { return marks.positions_m(scene, InstanceId{id}); })
      .def("in_picture", in_picture);
  m.def("landmarks_of", &Landmarks::of);
  m.def("load_landmarks",
        [](const Asset& asset, const std::string& file) { return Landmarks::load(asset, file); });
}

}  // namespace dermis::python
