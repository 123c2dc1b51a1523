// SPDX-License-Identifier: MIT
// Pictures against pictures, techniques against ground truth. dermis/compare.py has made the arrays
// contiguous, of the right type and shape.
#include "dermis/compare.h"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/vector.h>

#include <memory>
#include <optional>

#include "array_over.h"
#include "arrays.h"
#include "callbacks.h"
#include "dermis/setting_rows.h"
#include "module.h"

namespace nb = nanobind;

namespace dermis::python {
namespace {

using MaskArray = nb::ndarray<const std::uint8_t, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

/// A copy of an array: work in another thread may outlive the call that gave it.
template <class Value>
struct Kept {
  std::vector<Value> values;
  int width = 0, height = 0, channels = 1;

  template <class Array>
  explicit Kept(const Array& array)
      : values(array.data(), array.data() + array.size()),
        width(static_cast<int>(array.shape(1))),
        height(static_cast<int>(array.shape(0))),
        channels(array.ndim() == 3 ? static_cast<int>(array.shape(2)) : 1) {}
  dermis::Pixels<Value> pixels() const { return {values, width, height, channels}; }
};
using KeptMask = std::optional<Kept<std::uint8_t>>;

KeptMask kept(const std::optional<MaskArray>& mask) { return mask ? KeptMask(*mask) : std::nullopt; }

// A mask of another shape may have as many values.
PixelMask mask_of(const KeptMask& mask, int width, int height) {
  if (!mask) return {};
  if (mask->width != width || mask->height != height)
    throw InputError("mask", "has the shape (" + std::to_string(mask->height) + ", " +
                                 std::to_string(mask->width) + "), pictures have (" + std::to_string(height) +
                                 ", " + std::to_string(width) + ")");
  return mask->values;
}

struct FlipOf {
  Flip flip;
  int width = 0, height = 0;
};

template <class Value, class Array>
std::shared_ptr<FlipOf> flip_of(const Array& reference, const Array& test,
                                const std::optional<MaskArray>& mask) {
  return run([a = Kept<Value>(reference), b = Kept<Value>(test), m = kept(mask)] {
    return std::make_shared<FlipOf>(
        FlipOf{flip(a.pixels(), b.pixels(), mask_of(m, a.width, a.height)), a.width, a.height});
  });
}

double relative_mse_of(const Pixels& reference, const Pixels& test, const std::optional<Pixels>& variance,
                       const std::optional<MaskArray>& mask) {
  using Floats = Kept<float>;
  const std::optional<Floats> noise = variance ? std::optional<Floats>(*variance) : std::nullopt;
  return run([a = Floats(reference), b = Floats(test), noise, m = kept(mask)] {
    const PixelMask counted = mask_of(m, a.width, a.height);
    return noise ? relative_mse_less_noise(a.pixels(), noise->pixels(), b.pixels(), counted)
                 : relative_mse(a.pixels(), b.pixels(), counted);
  });
}

std::vector<std::shared_ptr<PictureRegion>> regions_of(const Scene& scene, const RenderSettings& settings,
                                                       const nb::object& progress) {
  const auto desk = std::make_shared<Desk>();
  const auto regions = run(desk, [=, callback = callback_of(progress)] {
    return picture_regions(scene, settings, hooks_of(desk, callback));
  });
  std::vector<std::shared_ptr<PictureRegion>> out;
  for (const PictureRegion& region : regions) out.push_back(std::make_shared<PictureRegion>(region));
  return out;
}

std::shared_ptr<SceneComparison> compared(const Scene& scene, const RenderSettings& render,
                                          std::string_view reference,
                                          const std::vector<std::string>& techniques, int supersample,
                                          bool one_gaussian, bool each_optimisation, bool curves,
                                          const std::shared_ptr<ReferencePicture>& truth,
                                          const std::string& device, const nb::object& progress) {
  SceneComparisonSettings settings{.render = render,
                                   .reference = {},
                                   .techniques = techniques,
                                   .each_optimisation = each_optimisation,
                                   .one_gaussian = one_gaussian,
                                   .curves = curves,
                                   .supersample = supersample,
                                   .truth = truth.get(),
                                   .device = device};
  read_settings(reference, settings.reference);
  const auto desk = std::make_shared<Desk>();
  return run(desk, [scene, settings, truth, desk, callback = callback_of(progress)]() mutable {
    settings.hooks = hooks_of(desk, callback);
    return std::make_shared<SceneComparison>(compare_scene(scene, settings));
  });
}

template <class Of>
auto bytes_over(const std::shared_ptr<Of>& owner, const std::vector<std::uint8_t>& values, int width,
                int height, int channels) {
  return array_over(const_cast<std::uint8_t*>(values.data()), width, height, channels, keeper(owner));
}

void add_comparison(nb::module_& m) {
  nb::class_<RegionError>(m, "RegionError")
      .def_ro("flip", &RegionError::flip)
      .def_ro("hdr_flip", &RegionError::hdr_flip)
      .def_ro("psnr_db", &RegionError::psnr_db)
      .def_ro("rel_mse", &RegionError::rel_mse)
      .def_ro("rel_mse_unbiased", &RegionError::rel_mse_unbiased)
      .def_ro("share", &RegionError::share);
  nb::class_<QualityPoint>(m, "QualityPoint")
      .def_ro("curve", &QualityPoint::curve)
      .def_ro("label", &QualityPoint::label)
      .def_ro("ms", &QualityPoint::ms)
      .def_ro("taps_per_pixel", &QualityPoint::taps_per_pixel)
      .def_ro("error", &QualityPoint::error)
      .def_ro("at_size", &QualityPoint::at_size);

  using Comparison = std::shared_ptr<SceneComparison>;
  const auto row = [](const Comparison& c, std::size_t i) -> const ComparedTechnique& {
    return c->techniques.at(i);
  };
  nb::class_<SceneComparison>(m, "SceneComparison")
      .def_ro("width", &SceneComparison::width)
      .def_ro("height", &SceneComparison::height)
      .def_ro("exposure_ev", &SceneComparison::exposure_ev)
      .def_ro("model", &SceneComparison::model)
      .def_ro("samples", &SceneComparison::samples)
      .def_ro("noise_percent", &SceneComparison::noise_percent)
      .def_ro("curves", &SceneComparison::curves)
      .def_ro("noise", &SceneComparison::noise)

      .def("region_count", [](const Comparison& c) { return c->regions.size(); })
      .def("region_name", [](const Comparison& c, std::size_t i) { return c->regions.at(i).name; })
      .def("region_mask",
           [](const Comparison& c, std::size_t i) {
             return bytes_over(c, c->regions.at(i).mask, c->width, c->height, 1);
           })
      .def("reference_display",
           [](const Comparison& c) { return bytes_over(c, c->reference_display, c->width, c->height, 4); })

      .def("technique_count", [](const Comparison& c) { return c->techniques.size(); })
      .def("technique_name", [row](const Comparison& c, std::size_t i) { return row(c, i).name; })
      .def("technique_errors", [row](const Comparison& c, std::size_t i) { return row(c, i).errors; })
      .def("technique_at_size", [row](const Comparison& c, std::size_t i) { return row(c, i).at_size; })
      .def("technique_statistics",
           [row](const Comparison& c, std::size_t i) { return row(c, i).statistics.json(); })
      .def("technique_ms", [row](const Comparison& c, std::size_t i) { return row(c, i).ms(); })
      .def("technique_display",
           [row](const Comparison& c, std::size_t i) {
             return bytes_over(c, row(c, i).display_rgba, c->width, c->height, 4);
           })
      .def("technique_flip", [row](const Comparison& c, std::size_t i) {
        return array_over(const_cast<float*>(row(c, i).flip.data()), c->width, c->height, 1, keeper(c));
      });

  m.def("compare_scene", compared, nb::arg("scene"), nb::arg("settings"), nb::arg("reference"),
        nb::arg("techniques"), nb::arg("supersample"), nb::arg("one_gaussian"), nb::arg("each_optimisation"),
        nb::arg("curves"), nb::arg("truth").none(), nb::arg("device"), nb::arg("progress").none());
}

}  // namespace

void add_compare(nb::module_& m) {
  nb::class_<FlipOf>(m, "Flip")
      .def_prop_ro("mean", [](const FlipOf& f) { return f.flip.mean; })
      .def_prop_ro("start_exposure", [](const FlipOf& f) { return f.flip.start_exposure; })
      .def_prop_ro("stop_exposure", [](const FlipOf& f) { return f.flip.stop_exposure; })
      .def_prop_ro("exposures", [](const FlipOf& f) { return f.flip.exposures; })
      .def("map", [](const std::shared_ptr<FlipOf>& f) {
        return array_over(f->flip.map.data(), f->width, f->height, 1, keeper(f));
      });
  m.def("flip_display", flip_of<std::uint8_t, Bytes>, nb::arg("reference"), nb::arg("test"),
        nb::arg("mask").none());
  m.def("flip_linear", flip_of<float, Pixels>, nb::arg("reference"), nb::arg("test"), nb::arg("mask").none());
  m.def(
      "psnr_db",
      [](const Bytes& reference, const Bytes& test, const std::optional<MaskArray>& mask) {
        return run([a = Kept<std::uint8_t>(reference), b = Kept<std::uint8_t>(test), m = kept(mask)] {
          return psnr_db(a.pixels(), b.pixels(), mask_of(m, a.width, a.height));
        });
      },
      nb::arg("reference"), nb::arg("test"), nb::arg("mask").none());
  m.def("relative_mse", relative_mse_of, nb::arg("reference"), nb::arg("test"), nb::arg("variance").none(),
        nb::arg("mask").none());

  nb::class_<PictureRegion>(m, "PictureRegion")
      .def_ro("name", &PictureRegion::name)
      .def_ro("pixels", &PictureRegion::pixels)
      .def("mask", [](const std::shared_ptr<PictureRegion>& r, int width, int height) {
        return bytes_over(r, r->mask, width, height, 1);
      });
  m.def("picture_regions", regions_of, nb::arg("scene"), nb::arg("settings"), nb::arg("progress").none());
  add_comparison(m);
}

}  // namespace dermis::python
