// SPDX-License-Identifier: MIT
// Renderers, their sessions, and what they give: arrays over memory that their objects keep.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "array_over.h"
#include "callbacks.h"
#include "dermis/outputs.h"
#include "dermis/session.h"
#include "dermis/setting_rows.h"
#include "module.h"
#include "process.h"

namespace nb = nanobind;

namespace dermis::python {
namespace {

/// A renderer with its desk; `renderer` is null once it is closed.
struct Engine {
  std::shared_ptr<Desk> desk;
  std::shared_ptr<Callback> progress;
  std::shared_ptr<Renderer> renderer;
};

/// The last draw of a session. A frame of the same settings, assets and surroundings makes nothing anew.
struct Drawn {
  const RenderSettings* settings = nullptr;
  std::vector<Asset> assets;
  std::uint64_t environment_changes = 0;

  Drawn() = default;
  Drawn(const Scene& scene, const RenderSettings& of)
      : settings(&of), environment_changes(scene.environment_changes()) {
    for (const InstanceId id : scene.instances()) assets.push_back(scene.instance(id).asset);
  }
  bool operator==(const Drawn&) const = default;
};

struct DrawingSession {
  Engine engine;
  std::shared_ptr<Session> session;
  Drawn last;
  // Of the last frame: draw() and results(), each.
  std::chrono::steady_clock::duration took = std::chrono::hours(1);
};

// Below this a frame is drawn in the calling thread: Ctrl-C waits no longer.
constexpr std::chrono::milliseconds short_time{100};

nb::object array_of(const std::shared_ptr<Results>& results, Output output) {
  const OutputRow& row = output_rows()[static_cast<std::size_t>(output)];
  const std::span<std::byte> bytes = results->bytes(output);
  if (bytes.empty()) return nb::none();
  const nb::capsule owner = keeper(results);
  switch (row.type) {
    case OutputRow::Type::uint8:
      return nb::cast(array_over(reinterpret_cast<std::uint8_t*>(bytes.data()), results->width,
                                 results->height, row.channels, owner));
    case OutputRow::Type::uint32:
      return nb::cast(array_over(reinterpret_cast<std::uint32_t*>(bytes.data()), results->width,
                                 results->height, row.channels, owner));
    case OutputRow::Type::float32: break;
  }
  return nb::cast(array_over(reinterpret_cast<float*>(bytes.data()), results->width, results->height,
                             row.channels, owner));
}

std::shared_ptr<Engine> make_engine(const std::string& device, bool validate, const nb::object& progress) {
  const auto engine = make_owned<Engine>();
  engine->desk = std::make_shared<Desk>();
  engine->progress = callback_of(progress);
  engine->renderer = run(engine->desk, [device, validate, desk = engine->desk, progress = engine->progress] {
    return make_owned<Renderer>(
        Renderer::Options{.device = device, .validate = validate, .hooks = hooks_of(desk, progress)});
  });
  return engine;
}

void check_open(const Engine& engine) {
  check_process();
  if (!engine.renderer) throw std::runtime_error("this renderer is closed");
}

std::shared_ptr<Picture> render(const Engine& engine, const Scene& scene, const RenderSettings& settings) {
  check_open(engine);
  return run(engine.desk, [renderer = engine.renderer, scene, settings] {
    return std::make_shared<Picture>(renderer->render(scene, settings));
  });
}

std::shared_ptr<DrawingSession> make_session(const Engine& engine, const std::vector<int>& outputs,
                                             int frames_in_flight, bool statistics) {
  check_open(engine);
  Session::Options options{.frames_in_flight = frames_in_flight, .statistics = statistics, .wanted = {}};
  for (const int output : outputs) options.wanted = options.wanted | Outputs{static_cast<Output>(output)};
  const auto session = make_owned<DrawingSession>();
  session->engine = engine;
  session->session = run(
      engine.desk, [renderer = engine.renderer, options] { return make_owned<Session>(*renderer, options); });
  return session;
}

std::uint64_t draw(DrawingSession& s, const Scene& scene, const RenderSettings& settings) {
  const auto start = std::chrono::steady_clock::now();
  Drawn now(scene, settings);
  std::uint64_t ticket = 0;
  if (s.took < short_time && now == s.last)
    run_here(s.engine.desk, [&] { ticket = static_cast<std::uint64_t>(s.session->draw(scene, settings)); });
  else
    ticket = run(s.engine.desk, [session = s.session, scene, settings] {
      return static_cast<std::uint64_t>(session->draw(scene, settings));
    });
  s.last = std::move(now);
  s.took = std::chrono::steady_clock::now() - start;
  return ticket;
}

std::shared_ptr<Results> results(DrawingSession& s, std::uint64_t ticket) {
  const auto start = std::chrono::steady_clock::now();
  std::shared_ptr<Results> found;
  if (s.took < short_time)
    run_here(s.engine.desk, [&] { found = make_owned<Results>(s.session->results(Ticket{ticket})); });
  else
    found = run(s.engine.desk, [session = s.session, ticket] {
      return make_owned<Results>(session->results(Ticket{ticket}));
    });
  s.took = std::max(s.took, std::chrono::steady_clock::now() - start);
  return found;
}

std::string statistics(const DrawingSession& s, std::uint64_t ticket) {
  return run(s.engine.desk,
             [session = s.session, ticket] { return session->statistics(Ticket{ticket}).json(); });
}

std::pair<std::uint64_t, std::uint64_t> bytes(const DrawingSession& s, std::uint64_t ticket) {
  return run(s.engine.desk, [session = s.session, ticket] {
    const Statistics statistics = session->statistics(Ticket{ticket});
    return std::pair(statistics.read_back_bytes, statistics.copied_bytes);
  });
}

void add_pictures(nb::module_& m) {
  nb::class_<Picture>(m, "Picture")
      .def_ro("width", &Picture::width)
      .def_ro("height", &Picture::height)
      .def_prop_ro(
          "display",
          [](const std::shared_ptr<Picture>& p) {
            return array_over(p->display_rgba.data(), p->width, p->height, 4, keeper(p));
          },
          nb::rv_policy::automatic)
      .def_prop_ro(
          "linear",
          [](const std::shared_ptr<Picture>& p) {
            return array_over(p->linear_rgba.data(), p->width, p->height, 4, keeper(p));
          },
          nb::rv_policy::automatic)
      .def_prop_ro("statistics", [](const Picture& p) { return p.statistics.json(); })
      .def("save", [](const Picture& p, const std::string& path) { p.save(path); });

  nb::class_<Results>(m, "Results")
      .def_ro("width", &Results::width)
      .def_ro("height", &Results::height)
      .def("array", [](const std::shared_ptr<Results>& results, int output) {
        return array_of(results, static_cast<Output>(output));
      });

  using Row = std::tuple<std::string, int, int, std::string, std::string>;
  m.def("output_rows", [] {
    std::vector<Row> rows;
    for (const OutputRow& row : output_rows())
      rows.emplace_back(row.name, static_cast<int>(row.type), row.channels, row.unit, row.help);
    return rows;
  });
  m.def("part_rows", [] {
    std::vector<std::tuple<std::string, int, int>> rows;
    for (const PartRow& row : part_rows())
      rows.emplace_back(row.name, row.face_synthetics, row.celeba_mask_hq);
    return rows;
  });
}

void add_devices(nb::module_& m) {
  nb::class_<DeviceInfo>(m, "DeviceInfo")
      .def_ro("name", &DeviceInfo::name)
      .def_ro("driver", &DeviceInfo::driver)
      .def_ro("type", &DeviceInfo::type)
      .def_ro("api", &DeviceInfo::api)
      .def_ro("memory_bytes", &DeviceInfo::memory_bytes)
      .def_ro("missing", &DeviceInfo::missing);
  m.def("list_devices", [] { return run([] { return list_devices(); }); });
  m.def("technique_names", &technique_names);
}

}  // namespace

void add_renderers(nb::module_& m) {
  add_pictures(m);
  add_devices(m);
  nb::class_<Engine>(m, "Engine")
      .def("render", render)
      .def("session", make_session)
      .def("validation_messages",
           [](const Engine& engine) {
             check_open(engine);
             return run(engine.desk,
                        [renderer = engine.renderer] { return renderer->validation_messages(); });
           })
      .def("close", [](Engine& engine) {
        check_process();
        engine.renderer.reset();
      });
  nb::class_<DrawingSession>(m, "Session")
      .def("draw", draw)
      .def("results", results)
      .def("statistics", statistics)
      .def("bytes", bytes);
  m.def("make_engine", make_engine, nb::arg("device"), nb::arg("validate"), nb::arg("progress").none());
}

}  // namespace dermis::python
