// SPDX-License-Identifier: MIT
// Data sets. Each call has a desk of its own: workers may be threads of one process.
#include "dermis/dataset.h"

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <tuple>

#include "callbacks.h"
#include "module.h"
#include "process.h"

namespace nb = nanobind;

namespace dermis::python {
namespace {

using Numbers = std::vector<std::uint64_t>;

// Calls work(options) while the calling thread answers signals.
template <class Work>
auto run_with_options(const std::string& device, int threads, const nb::object& progress, Work work) {
  check_process();
  const auto desk = std::make_shared<Desk>();
  return run(desk, [=, callback = callback_of(progress)] {
    return work(dataset::Options{.device = device, .threads = threads, .hooks = hooks_of(desk, callback)});
  });
}

void prepare(const std::string& recipe, const std::string& folder, bool one_device, const std::string& device,
             const nb::object& progress) {
  run_with_options(device, 0, progress, [=](const dataset::Options& options) {
    dataset::prepare(recipe, folder, one_device, options);
  });
}

std::tuple<std::uint64_t, std::uint64_t, std::uint64_t, std::uint64_t> write(const std::string& folder,
                                                                             const Numbers& shards,
                                                                             const std::string& device,
                                                                             int threads,
                                                                             const nb::object& progress) {
  const dataset::Written w = run_with_options(
      device, threads, progress,
      [=](const dataset::Options& options) { return dataset::write(folder, shards, options); });
  return {w.shards, w.samples, w.there, w.elsewhere};
}

void add_results(nb::module_& m) {
  nb::class_<dataset::Verified>(m, "DatasetVerified")
      .def_ro("faults", &dataset::Verified::faults)
      .def_ro("warnings", &dataset::Verified::warnings)
      .def_ro("shards", &dataset::Verified::shards)
      .def_ro("samples", &dataset::Verified::samples)
      .def_ro("redrawn", &dataset::Verified::redrawn)
      .def_ro("parameters_sha256", &dataset::Verified::parameters_sha256)
      .def_ro("pictures_sha256", &dataset::Verified::pictures_sha256);
  nb::class_<dataset::Benchmark>(m, "DatasetBenchmark")
      .def_ro("samples", &dataset::Benchmark::samples)
      .def_ro("total_s", &dataset::Benchmark::total_s)
      .def_ro("setting_s", &dataset::Benchmark::setting_s)
      .def_ro("drawing_s", &dataset::Benchmark::drawing_s)
      .def_ro("encoding_s", &dataset::Benchmark::encoding_s)
      .def_ro("writing_s", &dataset::Benchmark::writing_s)
      .def_ro("waiting_s", &dataset::Benchmark::waiting_s)
      .def_ro("bare_s", &dataset::Benchmark::bare_s)
      .def_ro("bytes", &dataset::Benchmark::bytes)
      .def_ro("heads", &dataset::Benchmark::heads);
  nb::class_<dataset::Recipe>(m, "DatasetRecipe")
      .def_prop_ro("name", &dataset::Recipe::name)
      .def_prop_ro("samples", &dataset::Recipe::samples)
      .def_prop_ro("identities", &dataset::Recipe::identities)
      .def_prop_ro("shards", &dataset::Recipe::shards)
      .def_prop_ro("sha256", &dataset::Recipe::sha256)
      .def_prop_ro("text", &dataset::Recipe::text)
      .def("file_of", &dataset::Recipe::file_of)
      .def("samples_of",
           [](const dataset::Recipe& recipe, std::uint64_t shard) {
             const dataset::Recipe::Range range = recipe.samples_of(shard);
             return std::tuple(range.first, range.count);
           })
      .def("parameters", &dataset::Recipe::parameters);
}

}  // namespace

void add_datasets(nb::module_& m) {
  nb::exception<dataset::TryAgain> try_again(m, "TryAgain", PyExc_RuntimeError);
  try_again.attr("__doc__") =
      "The work may succeed elsewhere or later: a full disk, a lost device. No shard is half-written.";

  add_results(m);
  m.def("dataset_recipe", [](const std::string& path) { return dataset::Recipe::load(path); });
  m.def("dataset_recipe_of", [](const std::string& folder) { return dataset::recipe_of(folder); });
  m.def("dataset_prepare", prepare, nb::arg("recipe"), nb::arg("folder"), nb::arg("one_device"),
        nb::arg("device"), nb::arg("progress").none());
  m.def("dataset_write", write, nb::arg("folder"), nb::arg("shards"), nb::arg("device"), nb::arg("threads"),
        nb::arg("progress").none());
  m.def("dataset_missing", [](const std::string& folder) { return dataset::missing(folder); });

  m.def(
      "dataset_verify",
      [](const std::string& folder, double redraw, const std::string& device, const nb::object& progress) {
        return run_with_options(device, 0, progress, [=](const dataset::Options& options) {
          return dataset::verify(folder, redraw, options);
        });
      },
      nb::arg("folder"), nb::arg("redraw"), nb::arg("device"), nb::arg("progress").none());

  m.def("dataset_slurm",
        [](const std::string& folder, const std::string& program, const std::string& partition, int minutes,
           std::uint64_t tasks, const std::string& device) {
          return dataset::slurm_script(folder, {.program = program,
                                                .partition = partition,
                                                .minutes = minutes,
                                                .most_tasks = tasks,
                                                .device = device});
        });

  m.def("dataset_sheet", [](const std::string& folder, std::size_t samples) {
    return run([=] { return dataset::sheet(folder, samples); });
  });
  m.def("dataset_datasheet",
        [](const std::string& folder) { return run([=] { return dataset::datasheet(folder); }); });
  m.def("dataset_coco", [](const std::string& folder) { return run([=] { return dataset::coco(folder); }); });

  m.def(
      "dataset_bench",
      [](const std::string& recipe, std::uint64_t samples, const std::string& device, int threads,
         const nb::object& progress) {
        return run_with_options(device, threads, progress, [=](const dataset::Options& options) {
          return dataset::bench(recipe, samples, options);
        });
      },
      nb::arg("recipe"), nb::arg("samples"), nb::arg("device"), nb::arg("threads"),
      nb::arg("progress").none());
}

}  // namespace dermis::python
