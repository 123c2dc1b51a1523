// SPDX-License-Identifier: MIT
// Implements compare_scene() of include/dermis/compare.h.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <random>
#include <tuple>

#include "api/asset_state.h"
#include "api/compare/quality_settings.h"
#include "api/compare/turns.h"
#include "api/output.h"
#include "api/scene_state.h"
#include "base/core/error.h"
#include "base/core/hooks.h"
#include "base/core/known_names.h"
#include "base/core/log.h"
#include "base/settings/check.h"
#include "base/settings/names.h"
#include "dermis/cancelled.h"
#include "dermis/compare.h"
#include "image/codec.h"
#include "image/compare_flip.h"
#include "image/metrics.h"
#include "image/resize.h"
#include "image/tone_map.h"
#include "render/setup/choose.h"
#include "render/techniques/technique.h"
#include "tissue/gaussians/one.h"

namespace dermis {
namespace {

using Clock = std::chrono::steady_clock;

/// Linear light as the errors see it: three channels.
image::ImageF without_alpha(const std::vector<float>& rgba, int width, int height) {
  image::ImageF out{.width = width, .height = height, .channels = 3, .values = {}};
  out.values.reserve(rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < rgba.size(); i += 4)
    out.values.insert(out.values.end(), {rgba[i], rgba[i + 1], rgba[i + 2]});
  return out;
}

struct Truth {
  image::ImageF linear, variance;  // variance: no values if it is not known
  image::Image8 shown;
};

/// The picture with as much Gaussian noise again as it has; the same every time.
image::ImageF noisier(const image::ImageF& picture, const image::ImageF& variance) {
  image::ImageF out = picture;
  std::mt19937_64 random(1);
  const auto uniform = [&] { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; };
  for (std::size_t i = 0; i < out.values.size(); ++i) {
    const double normal = std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform());
    out.values[i] += static_cast<float>(std::sqrt(std::max(variance.values[i], 0.0f)) * normal);
  }
  return out;
}

class Comparer {
 public:
  Comparer(const std::vector<PictureRegion>& regions, const Truth& truth)
      : regions_(regions), truth_(truth) {}

  std::vector<std::optional<RegionError>> errors(const image::ImageF& linear, const image::Image8& shown,
                                                 image::ImageF& flip_map) const {
    flip_map = image::flip_map(truth_.shown, shown);
    const image::ImageF hdr_map = image::hdr_flip(truth_.linear, linear).map;
    const auto sum = [](const PictureRegion& r, double mean) { return mean * static_cast<double>(r.pixels); };

    std::vector<std::optional<RegionError>> out;
    double skin = 0;
    for (const PictureRegion& region : regions_) {
      out.emplace_back();
      if (region.pixels == 0) continue;
      RegionError e = error(linear, shown, region);
      e.flip = image::summarise_flip(flip_map, region.mask).mean;
      e.hdr_flip = image::summarise_flip(hdr_map, region.mask).mean;
      if (out.size() == 1) skin = sum(region, e.flip);
      e.share = skin > 0 ? sum(region, e.flip) / skin : 0;
      out.back() = e;
    }
    return out;
  }

  /// Over skin alone.
  RegionError over_skin(const image::ImageF& linear, const image::Image8& shown) const {
    const PictureRegion& skin = regions_.front();
    RegionError e = error(linear, shown, skin);
    e.flip = image::summarise_flip(image::flip_map(truth_.shown, shown), skin.mask).mean;
    e.hdr_flip = image::summarise_flip(image::hdr_flip(truth_.linear, linear).map, skin.mask).mean;
    e.share = 1;
    return e;
  }

 private:
  // Without FLIP.
  RegionError error(const image::ImageF& linear, const image::Image8& shown,
                    const PictureRegion& region) const {
    RegionError e;
    e.psnr_db = image::psnr_db(truth_.shown, shown, region.mask);
    e.rel_mse = image::rel_mse(truth_.linear, linear, region.mask);
    if (!truth_.variance.values.empty())
      e.rel_mse_unbiased = image::rel_mse_less_noise(truth_.linear, truth_.variance, linear, region.mask,
                                                     regions_.front().mask);
    return e;
  }

  const std::vector<PictureRegion>& regions_;
  const Truth& truth_;
};

/// The same scene, its skin with one Gaussian.
Scene with_one_gaussian(const Scene& scene, const RenderSettings& s) {
  Scene::State state = scene.state();
  for (Scene::State::Entry& entry : state.instances) {
    // Profiles change nothing of what is measured.
    auto copy = std::make_shared<scene::AssetData>(*Asset::State::of(entry.instance.asset));
    for (scene::Material& material : copy->materials)
      if (material.skin)
        material.skin_settings.profile =
            gaussians::one_gaussian(setup::choose_profile(material, s, entry.placed.profile));
    entry.instance.asset = Asset::State::make(std::move(copy));
    entry.placed.profile.reset();
  }
  return Scene::State::make(std::move(state));
}

class Run {
 public:
  Run(const Scene& scene, const SceneComparisonSettings& settings)
      : scene_(scene),
        settings_(settings),
        tone_map_(settings.render.output.tone_map),
        renderer_({.device = settings.device, .validate = false, .hooks = settings.hooks}) {
    all_.scene = scene.name();
    all_.tone_map = name_of(settings.render.output.tone_map);
    all_.width = settings.render.output.width, all_.height = settings.render.output.height;
    all_.supersample = settings.supersample;

    // The profile over the surface is that of a flat half-space: what is compared is how it is blurred.
    const bool is_of_profile = settings_.truth ? settings_.truth->model == ReferenceModel::bssrdf
                                               : settings_.reference_file.empty() &&
                                                     settings_.reference.model == ReferenceModel::bssrdf;
    if (is_of_profile && !settings_.render.skin.shape_aware) settings_.render.skin.shape_aware = false;
  }

  SceneComparison result() {
    const std::vector<std::string> names = drawn_techniques();
    all_.regions = picture_regions(scene_, settings_.render, settings_.hooks);
    if (all_.regions.front().pixels == 0)
      throw input_error(scene_.name(), "shows no skin from this camera: nothing to compare");
    choose_exposure();
    if (settings_.truth)
      take_truth(*settings_.truth);
    else
      settings_.reference_file.empty() ? render_truth() : load_truth();
    truth_.shown = image::to_display(truth_.linear, tone_map_);
    all_.reference_display = truth_.shown.rgba;
    if (!truth_.variance.values.empty()) {
      const image::ImageF noisy = noisier(truth_.linear, truth_.variance);
      image::ImageF map;
      all_.noise = Comparer(all_.regions, truth_).errors(noisy, image::to_display(noisy, tone_map_), map);
    }
    {
      Steps steps("techniques", names.size() * (settings_.curves ? 2 : 1));
      for (const std::string& name : names) add_technique(name), steps.done();
      if (settings_.curves)
        for (const std::string& name : names) add_curves(name), steps.done();
    }
    take_times();
    return std::move(all_);
  }

 private:
  void check_stopped() const {
    if (settings_.hooks.stop && *settings_.hooks.stop)
      throw Cancelled("stopped before all techniques were compared");
  }

  // Refuses now, not after the reference has taken its hours. Of all techniques those that cannot draw this
  // picture are left out.
  std::vector<std::string> drawn_techniques() const {
    if (!settings_.techniques.empty()) {
      for (const std::string& name : settings_.techniques) check_technique(name);
      return settings_.techniques;
    }

    std::vector<std::string> names;
    for (const std::string& name : technique_names()) {
      try {
        check_technique(name);
        names.push_back(name);
      } catch (const InputError& why) { warn("technique '{}' is left out: {}", name, why.what()); }
    }
    if (names.empty()) check_technique(technique_names().front());
    return names;
  }

  void check_technique(const std::string& name) const {
    RenderSettings s = settings_.render;
    s.technique = name;
    describe_plan(scene_, s, false, settings_.hooks);
    s.output.width *= all_.supersample, s.output.height *= all_.supersample;
    describe_plan(scene_, s, false, settings_.hooks);
  }

  // One for all pictures, the reference too.
  void choose_exposure() {
    if (!settings_.render.output.exposure_ev) {
      RenderSettings one = settings_.render;
      one.technique = "texture-space";
      settings_.render.output.exposure_ev = renderer_.prepare(scene_, one).picture().statistics.exposure_ev;
    }
    all_.exposure_ev = *settings_.render.output.exposure_ev;
  }

  void render_truth() {
    const ReferenceSettings& r = settings_.reference;
    const auto start = Clock::now();
    const ReferencePicture picture = render_reference(scene_, settings_.render, r, settings_.hooks);
    check_stopped();
    all_.reference_seconds = std::chrono::duration<double>(Clock::now() - start).count();
    take_truth(picture);
  }

  void take_truth(const ReferencePicture& picture) {
    if (picture.picture.width != all_.width || picture.picture.height != all_.height)
      throw input_error("truth", "is {} x {} pixels, output.width and output.height say {} x {}",
                        picture.picture.width, picture.picture.height, all_.width, all_.height);
    all_.model = name_of(picture.model);
    all_.samples = picture.samples;
    all_.noise_percent = picture.noise_percent;
    truth_.linear = without_alpha(picture.picture.linear_rgba, all_.width, all_.height);
    truth_.variance = without_alpha(picture.variance_rgba, all_.width, all_.height);
  }

  image::ImageF load(const std::string& file) const {
    image::ImageF picture = image::load_image_f(file);
    if (picture.width != all_.width || picture.height != all_.height)
      throw input_error(file, "is {} x {} pixels, output.width and output.height say {} x {}", picture.width,
                        picture.height, all_.width, all_.height);
    return picture;
  }

  void load_truth() {
    all_.reference_file = settings_.reference_file;
    truth_.linear = load(settings_.reference_file);
    if (settings_.variance_file.empty()) return;
    truth_.variance = load(settings_.variance_file);
    for (const float value : truth_.variance.values)
      if (value < 0) throw input_error(settings_.variance_file, "holds {}; variances are 0 or more", value);
  }

  // Rows that equal the first, which has the settings of the caller, are left out.
  void add_each_optimisation(const std::string& name, const RenderSettings& s) {
    static constexpr struct {
      const char* name;
      bool cull, depth, clip;
    } switches[] = {{"none", false, false, false},
                    {"cull", true, false, false},
                    {"depth", false, true, false},
                    {"clip", false, false, true},
                    {"all", true, true, true}};
    for (const auto& on : switches) {
      RenderSettings one = s;
      one.quality.cull = on.cull, one.quality.depth = on.depth, one.quality.clip = on.clip;
      if (!same_switches(one.quality, s.quality))
        add(fmt::format("{}, optimise {}", name, on.name), scene_, one);
    }
  }

  static bool same_switches(const QualitySettings& a, const QualitySettings& b) {
    return std::tuple(a.cull, a.depth, a.clip) == std::tuple(b.cull, b.depth, b.clip);
  }

  void add_technique(const std::string& name) {
    RenderSettings s = settings_.render;
    s.technique = name;
    const Statistics first = add(name, scene_, s);
    if (!techniques::find_technique(name).has_light_maps) return;  // the rows below are about these
    if (settings_.each_optimisation) add_each_optimisation(name, s);
    if (first.shape_aware) {
      s.skin.shape_aware = false;
      add(name + ", shape_aware off", scene_, s);
      s.skin.shape_aware = settings_.render.skin.shape_aware;
    }
    if (first.gaussians == 1 || !settings_.one_gaussian) return;
    const Scene one = with_one_gaussian(scene_, s);
    s.skin.profile.clear();
    add(name + ", one Gaussian", one, s);
  }

  void add_curves(const std::string& name) {
    for (const api::QualitySetting& one : api::quality_settings(scene_, settings_.render, name)) {
      const Drawn drawn = draw(scene_, one.settings);
      QualityPoint point{.curve = one.curve, .label = one.label, .error = {}, .at_size = {}};
      point.taps_per_pixel = taps_per_pixel(drawn.statistics);
      point.at_size = Comparer(all_.regions, truth_).over_skin(drawn.at_size, drawn.at_size_shown);
      point.error = all_.supersample > 1 ? Comparer(all_.regions, truth_).over_skin(drawn.linear, drawn.shown)
                                         : point.at_size;
      all_.curves.push_back(std::move(point));
    }
  }

  struct Drawn {
    Statistics statistics;
    image::ImageF linear, at_size;  // averaged down, and the picture itself
    image::Image8 shown, at_size_shown;
  };

  // Error at as many samples per pixel as wanted, of light maps of the same size.
  Drawn draw(const Scene& scene, RenderSettings s) {
    check_stopped();
    turns_.push_back({.scene = scene, .settings = s});
    s.output.frames = 1;
    Picture picture = renderer_.render(scene, s);
    Drawn out{
        .statistics = picture.statistics, .linear = {}, .at_size = {}, .shown = {}, .at_size_shown = {}};
    out.at_size = without_alpha(picture.linear_rgba, picture.width, picture.height);
    out.at_size_shown = image::to_display(out.at_size, tone_map_);
    if (all_.supersample == 1) {
      out.linear = out.at_size;
      out.shown = out.at_size_shown;
      return out;
    }

    s.output.width *= all_.supersample, s.output.height *= all_.supersample;
    s.quality.samples = 1;
    if (!s.quality.d_ref && picture.statistics.d_ref > 0) s.quality.d_ref = picture.statistics.d_ref;
    picture = renderer_.render(scene, s);
    out.linear = image::downsample_box(without_alpha(picture.linear_rgba, picture.width, picture.height),
                                       all_.supersample);
    out.shown = image::to_display(out.linear, tone_map_);
    return out;
  }

  Statistics add(const std::string& name, const Scene& scene, const RenderSettings& s) {
    Drawn drawn = draw(scene, s);
    const Comparer comparer(all_.regions, truth_);
    ComparedTechnique row;
    row.name = name;
    row.statistics = drawn.statistics;
    image::ImageF flip;
    row.errors = comparer.errors(drawn.linear, drawn.shown, flip);
    row.flip = std::move(flip.values);
    if (all_.supersample > 1) row.at_size = comparer.over_skin(drawn.at_size, drawn.at_size_shown);
    row.display_rgba = std::move(drawn.shown.rgba);
    all_.techniques.push_back(std::move(row));
    return all_.techniques.back().statistics;
  }

  // Draws all rows and points in turns.
  void take_times() {
    const std::vector<std::vector<double>> ms =
        api::draw_in_turns(renderer_, turns_, settings_.render.output.frames, settings_.hooks.stop);
    for (std::size_t i = 0; i < ms.size(); ++i) {
      if (i >= all_.techniques.size()) {
        all_.curves[i - all_.techniques.size()].ms = api::median(ms[i]);
        continue;
      }
      Statistics& s = all_.techniques[i].statistics;
      const auto [least, most] = std::minmax_element(ms[i].begin(), ms[i].end());
      s.frame_ms_median = api::median(ms[i]), s.frame_ms_min = *least, s.frame_ms_max = *most;
      s.frames = settings_.render.output.frames;
    }
  }

  const Scene& scene_;
  SceneComparisonSettings settings_;
  ToneMap tone_map_;
  Renderer renderer_;
  SceneComparison all_;
  Truth truth_;
  std::vector<api::Turn> turns_;  // of the rows, then of the points of curves
};

}  // namespace

void check_comparison(const SceneComparisonSettings& s) {
  std::vector<std::string> known = technique_names();
  for (const std::string& name : s.techniques)
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw input_error("techniques", "{}", unknown_name(name, known));
    }
  check_ranges(s);
  if (!s.render.output.exposure_ev && (s.truth || !s.reference_file.empty()))
    throw input_error("",
                      "output.exposure_ev cannot be chosen for {}, which was exposed before; give the number",
                      s.truth ? "a truth that is given" : s.reference_file);
  const std::int64_t side = std::max(s.render.output.width, s.render.output.height);
  if (s.supersample * side > 65536)
    throw input_error("", "supersample must be at most {} for pictures of {} pixels per side, got {}",
                      65536 / side, side, s.supersample);
}

SceneComparison compare_scene(const Scene& scene, const SceneComparisonSettings& settings) {
  const HookScope scope(settings.hooks);
  check_comparison(settings);
  return Run(scene, settings).result();
}

}  // namespace dermis
