// SPDX-License-Identifier: MIT
// Assets and scenes. A scene is edited by one thread at a time, with the GIL.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "arrays.h"
#include "callbacks.h"
#include "dermis/camera.h"
#include "dermis/scene.h"
#include "dermis/setting_rows.h"
#include "module.h"
#include "process.h"

namespace nb = nanobind;

namespace dermis::python {
namespace {

using Matrix = std::array<double, 16>;
using NamedTransform = std::tuple<std::string, std::optional<std::array<double, 3>>,
                                  std::optional<std::array<double, 4>>, std::optional<std::array<double, 3>>>;
using Clip = std::tuple<std::string, double>;

SceneOptions options_of(std::string_view json) {
  SceneOptions options;
  read_settings(json, options);
  return options;
}

Asset load_asset(const std::string& path, std::string_view json, const nb::object& progress) {
  const auto desk = std::make_shared<Desk>();
  return run(desk, [=, options = options_of(json), callback = callback_of(progress)] {
    return Asset::load(path, options, hooks_of(desk, callback));
  });
}

Scene load_scene(const std::string& path, std::string_view json, const nb::object& progress) {
  const auto desk = std::make_shared<Desk>();
  return run(desk, [=, options = options_of(json), callback = callback_of(progress)] {
    return Scene::load(path, options, hooks_of(desk, callback));
  });
}

std::optional<RigPose> pose_of(const std::optional<Clip>& clip, const std::optional<Clip>& second,
                               double blend, const std::vector<std::tuple<std::string, double>>& weights,
                               const std::vector<NamedTransform>& joints) {
  const auto time_of = [](const std::optional<Clip>& c) {
    return c ? std::optional(ClipTime{std::get<0>(*c), std::get<1>(*c)}) : std::nullopt;
  };
  RigPose pose{.clip = time_of(clip), .second = time_of(second), .blend = blend};
  for (const auto& [name, weight] : weights) pose.weights.push_back({name, weight});
  for (const auto& [name, translation, rotation, scale] : joints)
    pose.joints.push_back({.name = name, .translation = translation, .rotation = rotation, .scale = scale});
  return pose;
}

nb::ndarray<nb::numpy, double, nb::ndim<2>> positions_of(const Scene& scene, std::uint32_t id, int mesh,
                                                         const Whole& vertices) {
  const auto positions_m =
      scene.positions_m(InstanceId{id}, mesh, std::span(vertices.data(), vertices.shape(0)));
  auto* const values = new std::vector<std::array<double, 3>>(positions_m);
  const nb::capsule owner(
      values, [](void* p) noexcept { delete static_cast<std::vector<std::array<double, 3>>*>(p); });
  const std::size_t shape[] = {values->size(), 3};
  return {values->data(), 2, shape, owner};
}

void set_environment(Scene& scene, const std::optional<std::string>& file, const std::optional<Pixels>& rgb) {
  if (!file && !rgb) return scene.set_environment({});
  SceneEnvironment environment;
  if (file) environment.file = *file;
  if (rgb) {
    environment.height = static_cast<int>(rgb->shape(0));
    environment.width = static_cast<int>(rgb->shape(1));
    environment.rgb = std::make_shared<const std::vector<float>>(rgb->data(), rgb->data() + rgb->size());
  }
  scene.set_environment(environment);
}

void add_lights(nb::module_& m) {
  nb::class_<Light>(m, "Light")
      .def(nb::init<>())
      .def_rw("name", &Light::name)
      .def_prop_rw(
          "type", [](const Light& light) { return static_cast<int>(light.type); },
          [](Light& light, int type) { light.type = static_cast<LightType>(type); })
      .def_rw("colour", &Light::colour)
      .def_rw("position_m", &Light::position_m)
      .def_rw("direction", &Light::direction)
      .def_rw("range_m", &Light::range_m)
      .def_rw("inner_cone_deg", &Light::inner_cone_deg)
      .def_rw("outer_cone_deg", &Light::outer_cone_deg)
      .def_rw("radius", &Light::radius);
}

void add_assets(nb::module_& m) {
  nb::class_<Asset>(m, "Asset")
      .def_prop_ro("name", &Asset::name)
      .def_prop_ro("materials", &Asset::materials)
      .def_prop_ro("cameras", &Asset::cameras)
      .def_prop_ro("clips", &Asset::clips)
      .def_prop_ro("joints", &Asset::joints)
      .def_prop_ro("morph_weights", &Asset::morph_weights)
      .def("clip_end_s", &Asset::clip_end_s)
      .def("lights", &Asset::lights)
      .def("bounds",
           [](const Asset& asset) {
             const AssetBounds b = asset.bounds();
             return std::tuple(b.low_m, b.high_m, b.centre_m, b.radius_m);
           })
      .def("same", [](const Asset& asset, const Asset& other) { return asset == other; });
  m.def("load_asset", load_asset, nb::arg("path"), nb::arg("options"), nb::arg("progress").none());

  nb::class_<ArrayAsset>(m, "ArrayAsset")
      .def(nb::init<std::string>())
      .def("add_image", &ArrayAsset::add_image)
      .def("add_material", &ArrayAsset::add_material)
      .def("add_mesh", &ArrayAsset::add_mesh, nb::arg("name"), nb::arg("material"), nb::arg("positions"),
           nb::arg("indices").none(), nb::arg("normals").none(), nb::arg("uv").none(),
           nb::arg("colours").none())
      .def(
          "make",
          [](const ArrayAsset& arrays, std::string_view json, const nb::object& progress) {
            const auto desk = std::make_shared<Desk>();
            const auto kept = std::make_shared<const ArrayAsset>(arrays);
            return run(desk, [=, options = options_of(json), callback = callback_of(progress)] {
              return Asset::from_arrays(kept->arrays(), options, hooks_of(desk, callback));
            });
          },
          nb::arg("options"), nb::arg("progress").none());
}

void add_instances(nb::class_<Scene>& scene) {
  scene
      .def("add",
           [](Scene& scene, const Asset& asset, const std::string& name) {
             return static_cast<std::uint32_t>(scene.add({.asset = asset, .name = name}));
           })
      .def("remove", [](Scene& scene, std::uint32_t id) { scene.remove(InstanceId{id}); })
      .def("instances",
           [](const Scene& scene) {
             std::vector<std::uint32_t> ids;
             for (const InstanceId id : scene.instances()) ids.push_back(static_cast<std::uint32_t>(id));
             return ids;
           })
      .def("asset", [](const Scene& s, std::uint32_t id) { return s.instance(InstanceId{id}).asset; })
      .def("instance_name", [](const Scene& s, std::uint32_t id) { return s.instance(InstanceId{id}).name; })
      .def("transform",
           [](const Scene& s, std::uint32_t id) { return s.instance(InstanceId{id}).world_from_asset; })
      .def("visible", [](const Scene& s, std::uint32_t id) { return s.instance(InstanceId{id}).visible; })
      .def("tint", [](const Scene& s, std::uint32_t id) { return s.instance(InstanceId{id}).tint; })
      .def("mix", [](const Scene& s, std::uint32_t id) { return s.instance(InstanceId{id}).mix; })
      .def("profile", [](const Scene& s, std::uint32_t id) { return s.instance(InstanceId{id}).profile; })
      .def("set_transform",
           [](Scene& s, std::uint32_t id, const Matrix& m16) { s.set_transform(InstanceId{id}, m16); })
      .def("set_visible",
           [](Scene& s, std::uint32_t id, bool visible) { s.set_visible(InstanceId{id}, visible); })
      .def("set_tint", [](Scene& s, std::uint32_t id,
                          const std::array<double, 3>& tint) { s.set_tint(InstanceId{id}, tint); })
      .def(
          "set_mix",
          [](Scene& s, std::uint32_t id, std::optional<double> mix) { s.set_mix(InstanceId{id}, mix); },
          nb::arg("id"), nb::arg("mix").none())
      .def(
          "set_profile",
          [](Scene& s, std::uint32_t id, const std::optional<ScatterProfile>& profile) {
            s.set_profile(InstanceId{id}, profile);
          },
          nb::arg("id"), nb::arg("profile").none())
      .def(
          "set_pose",
          [](Scene& s, std::uint32_t id, const std::optional<Clip>& clip, const std::optional<Clip>& second,
             double blend, const std::vector<std::tuple<std::string, double>>& weights,
             const std::vector<NamedTransform>& joints) {
            s.set_pose(InstanceId{id}, pose_of(clip, second, blend, weights, joints));
          },
          nb::arg("id"), nb::arg("clip").none(), nb::arg("second").none(), nb::arg("blend"),
          nb::arg("weights"), nb::arg("joints"))
      .def("clear_pose", [](Scene& s, std::uint32_t id) { s.set_pose(InstanceId{id}, {}); })
      .def("positions", positions_of);
}

}  // namespace

void add_scenes(nb::module_& m) {
  add_lights(m);
  add_assets(m);

  nb::class_<Scene> scene(m, "Scene");
  add_instances(scene);
  scene.def(nb::init<>())
      .def(nb::init<const Asset&>())
      .def("copy", [](const Scene& scene) { return Scene(scene); })
      .def("save", [](const Scene& scene, const std::string& path) { scene.save(path); })
      .def_prop_ro("name", &Scene::name)
      .def("lights",
           [](const Scene& s) {
             std::vector<std::uint32_t> ids;
             for (const LightId id : s.lights()) ids.push_back(static_cast<std::uint32_t>(id));
             return ids;
           })
      .def("light", [](const Scene& s, std::uint32_t id) { return s.light(LightId{id}).light; })
      .def("add_light",
           [](Scene& s, const Light& light) {
             return static_cast<std::uint32_t>(s.add_light({.light = light}));
           })
      .def("set_light",
           [](Scene& s, std::uint32_t id, const Light& light) {
             SceneLight placed = s.light(LightId{id});
             placed.light = light;
             s.set_light(LightId{id}, placed);
           })
      .def("remove_light", [](Scene& s, std::uint32_t id) { s.remove_light(LightId{id}); })
      .def("set_environment", set_environment, nb::arg("file").none(), nb::arg("rgb").none())
      .def("camera", [](const Scene& scene, const RenderSettings& settings) {
        const ResolvedCamera c = resolved_camera(scene, settings);
        return std::tuple(c.k, c.r, c.t_m, c.width, c.height, c.near_m, c.orthographic);
      });
  m.def("load_scene", load_scene, nb::arg("path"), nb::arg("options"), nb::arg("progress").none());
}

}  // namespace dermis::python
