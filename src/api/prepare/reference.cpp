// SPDX-License-Identifier: MIT
#include "dermis/reference.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "api/fingerprint.h"
#include "api/memory.h"
#include "api/prepare/reference_setup.h"
#include "api/scene_state.h"
#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/hooks.h"
#include "base/core/known_names.h"
#include "base/core/log.h"
#include "base/settings/check.h"
#include "head/scene/surface/topology.h"
#include "head/scene/surface/unwrap.h"
#include "image/codec.h"
#include "image/tone_map.h"
#include "render/setup/choose.h"
#include "render/setup/environment_light.h"
#include "tissue/gaussians/json.h"
#include "tissue/optics/presets.h"
#include "truth/reference/checkpoint.h"
#include "truth/reference/render.h"

namespace dermis {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

constexpr double checkpoint_seconds = 30;

int samples_of(const ReferenceSettings& r) {
  return r.samples.value_or(r.noise_percent ? std::numeric_limits<int>::max() : 64);
}

/// A profile that dermis made says what it was made of. In older files these are 1/sigma_t' and 1/sigma_tr,
/// with sigma_tr^2 = 3 sigma_a sigma_t': scattering is then the reduced one, isotropic, and the index the
/// material's.
optics::RgbMedium medium_of(const ScatterProfile& profile, double eta) {
  if (profile.medium) return optics::rgb_medium(*profile.medium);
  optics::RgbMedium medium;
  for (std::size_t c = 0; c < 3; ++c) {
    const double free = profile.mean_free_path_mm[c], diffuse = profile.diffuse_mean_free_path_mm[c];
    if (!(free > 0))
      throw input_error(
          profile.name,
          "this profile does not say what medium it stands for; model 'volume' needs a medium: a name, or "
          "'sigma_a=... sigma_s=...' (per mm), or a profile made by `dermis profile`");
    const double sigma_t = 1 / free, sigma_tr = diffuse > 0 ? 1 / diffuse : 0;
    const double sigma_a = std::min(sigma_tr * sigma_tr / (3 * sigma_t), sigma_t);
    medium[c] = {.sigma_a_per_mm = sigma_a, .sigma_s_per_mm = sigma_t - sigma_a, .g = 0, .eta = eta};
  }
  return medium;
}

optics::RgbMedium choose_medium(const std::string& text, const ScatterProfile& profile, double eta) {
  if (text.empty()) return medium_of(profile, eta);
  if (text.find('=') != std::string::npos) return optics::parse_coefficients(text, "medium");
  if (const optics::Material* material = optics::find_material(text)) return material->medium();
  std::vector<std::string_view> names;
  for (const optics::Material& material : optics::jensen_materials()) names.push_back(material.name);
  throw input_error("", "medium '{}' is neither coefficients nor the name of a material; {}", text,
                    listed_names(text, names));
}

/// The skin that light walks in should be closed.
void warn_if_open(const scene::AssetData& scene, const std::vector<scene::SkinMesh>& skin) {
  std::vector<scene::Vertex> vertices;
  std::vector<std::uint32_t> indices;
  for (const scene::SkinMesh& mesh : skin) {
    for (const std::uint32_t index : mesh.indices)
      indices.push_back(index + static_cast<std::uint32_t>(vertices.size()));
    vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
  }
  const std::vector<glm::vec2> no_uv(vertices.size());
  const scene::Topology topology = scene::mesh_topology(vertices, no_uv, indices);
  const auto open = std::count(topology.mate.begin(), topology.mate.end(), scene::no_edge);
  if (open > 0)
    warn("{}: the skin is not closed ({} open edges); light that walks out through a hole counts as absorbed",
         scene.name, open);
}

// Steps of the work before the first sample.
constexpr std::size_t tracer_steps = 4, set_up_steps = 3 + tracer_steps;

// `scene`: that of `placed`, flattened.
reference::Job set_up(const setup::PlacedScene& placed, const scene::AssetData& scene,
                      const std::optional<SceneEnvironment>& of_scene, const RenderSettings& s,
                      const ReferenceSettings& r, Steps& steps) {
  const std::vector<scene::SkinMesh>& skin = scene.skin;

  reference::Job job;
  job.model = r.model;
  job.setup = api::reference_setup(placed, s);
  if (const auto source = setup::choose_environment(s, of_scene)) {
    environment::Environment environment = setup::read_environment(*source);
    steps.done();
    job.setup.environment = std::make_shared<const reference::EnvironmentSampler>(
        std::move(environment), s.lighting.environment_intensity, s.lighting.environment_rotation_deg);
    steps.done();
  } else {
    steps.done(2);
  }

  const auto least = job.model == ReferenceModel::gaussians ? gaussians::LeastVariance::zero
                                                            : gaussians::LeastVariance::above_zero;
  job.profiles.resize(scene.materials.size());
  const std::size_t first_material =
      skin.empty() ? 0 : static_cast<std::size_t>(skin.front().triangle_material.front());
  for (const scene::SkinMesh& mesh : skin) {
    // One profile per mesh, that of its first triangle, as the renderer has it.
    const scene::Material& first = scene.materials[static_cast<std::size_t>(mesh.triangle_material.front())];
    const ScatterProfile profile = setup::choose_profile(first, s, {}, least);
    for (const int material : mesh.triangle_material) {
      ScatterProfile& of = job.profiles[static_cast<std::size_t>(material)];
      if (of.terms.empty()) of = profile;
    }

    if (job.model != ReferenceModel::volume) continue;
    const optics::RgbMedium medium = choose_medium(r.medium, profile, first.ior);
    if (&mesh == &skin.front())
      job.medium = medium;
    else if (r.medium.empty() && profile.terms != job.profiles[first_material].terms)
      throw input_error(placed.name,
                        "its skin has several profiles, and the model 'volume' follows light in one medium; "
                        "skin.profile or medium names one for all");
  }

  if (job.model == ReferenceModel::volume) {
    if (skin.empty())
      throw input_error(scene.name,
                        "has no skin for light to walk in; skin_material says which material is skin");
    optics::check(job.medium, "medium");
    warn_if_open(scene, skin);
  }
  steps.done();
  return job;
}

Picture picture_of(const reference::Film& film, ToneMap tone_map) {
  image::ImageF linear = film.picture();
  Picture picture;
  picture.width = picture.statistics.width = linear.width;
  picture.height = picture.statistics.height = linear.height;
  picture.display_rgba = image::to_display(linear, tone_map).rgba;
  for (std::size_t i = 3; i < picture.display_rgba.size(); i += 4) picture.display_rgba[i] = 255;
  picture.linear_rgba = std::move(linear.values);
  return picture;
}

/// Says how far the samples are, and keeps the checkpoint young.
class Watch {
 public:
  Watch(const ReferenceSettings& settings, const reference::Film& film, std::uint64_t fingerprint)
      : settings_(settings),
        film_(film),
        fingerprint_(fingerprint),
        before_(static_cast<int>(film.samples())),
        // Up to a noise, nobody knows how many samples it takes: these are shares of the work.
        count_(settings.noise_percent ? 1000 : static_cast<std::size_t>(samples_of(settings))),
        steps_("ground truth", count_) {
    tell(film.noise_percent());
  }

  void after_pass() {
    if (!settings_.checkpoint.empty() && seconds_since(saved_) > checkpoint_seconds) {
      save();
      saved_ = Clock::now();
    }

    const int samples = static_cast<int>(film_.samples());
    const double noise = settings_.noise_percent || settings_.after_sample ? film_.noise_percent() : 0;
    if (settings_.after_sample) {
      const double seconds = seconds_since(start_);
      const double left = std::max(0.0, most(noise) - samples) * seconds / std::max(1, samples - before_);
      settings_.after_sample({samples, samples_of(settings_), noise, seconds, left});
    }
    tell(noise);
  }

  /// Writes the checkpoint, if there is something to keep. A disk that is full must not cost the picture.
  void save() const {
    if (settings_.checkpoint.empty() || film_.samples() == 0) return;
    try {
      save_checkpoint(settings_.checkpoint, film_, fingerprint_);
    } catch (const InputError& error) {
      warn_once("checkpoint", fmt::format("no checkpoint to resume from: {}", error.what()));
    }
  }

 private:
  /// Returns an estimate of the samples at the end: noise falls with their square root.
  double most(double noise_percent) const {
    double most = samples_of(settings_);
    if (settings_.noise_percent)
      most = std::min(most, film_.samples() * std::pow(noise_percent / *settings_.noise_percent, 2));
    return most;
  }

  void tell(double noise_percent) {
    const double share = std::min(1.0, film_.samples() / std::max(1.0, most(noise_percent)));
    const auto reached = static_cast<std::size_t>(std::lround(share * static_cast<double>(count_)));
    const std::size_t more = reached - std::min(reached, told_);
    told_ += more;
    steps_.done(more);
  }

  const ReferenceSettings& settings_;
  const reference::Film& film_;
  std::uint64_t fingerprint_;
  int before_;
  std::size_t count_, told_ = 0;
  Steps steps_;
  Clock::time_point start_ = Clock::now(), saved_ = start_;
};

/// Samples until the limit is reached or a hook ends it. Returns whether the limit was reached.
bool sample(const reference::Tracer& tracer, const ReferenceSettings& r, std::uint64_t fingerprint,
            reference::Film& film) {
  Watch watch(r, film, fingerprint);
  bool complete = false;
  try {
    complete = reference::render(tracer, film,
                                 {.samples = static_cast<std::uint32_t>(samples_of(r)),
                                  .noise_percent = r.noise_percent,
                                  .seed = r.seed,
                                  .threads = r.threads},
                                 [&](const reference::Film&) { watch.after_pass(); });
  } catch (...) {
    watch.save();
    throw;
  }

  if (!complete) watch.save();
  if (!complete && film.samples() == 0) throw Cancelled("stopped before every pixel had a sample");
  return complete;
}

ReferencePicture rendered(const Scene& scene, const RenderSettings& s, const ReferenceSettings& r) {
  check_ranges(r);
  if (!s.output.exposure_ev)
    throw input_error(
        "",
        "an automatic output.exposure_ev is of the renderer; give the reference the number that a "
        "picture with it reports");

  const setup::PlacedScene placed = api::placed_scene(scene);
  const std::shared_ptr<const scene::AssetData> flat = setup::flattened(placed);
  std::optional<Steps> steps(std::in_place, "preparing the ground truth", set_up_steps);
  const reference::Job job = set_up(placed, *flat, scene.environment(), s, r, *steps);
  reference::Film film(s.output.width, s.output.height);
  const std::uint64_t fingerprint = r.checkpoint.empty() ? 0 : reference::fingerprint(*flat, job, r.seed);
  if (r.resume && !r.checkpoint.empty() && !load_checkpoint(r.checkpoint, film, fingerprint))
    note("{}: no such file, so this run begins at the beginning", r.checkpoint.string());

  std::optional<Steps> tracer_step(std::in_place, "tracer", 1, tracer_steps);
  const reference::Tracer tracer(*flat, job);
  tracer_step.reset();
  steps->done(tracer_steps);
  steps.reset();

  ReferencePicture out;
  out.model = r.model;
  out.complete = sample(tracer, r, fingerprint, film);

  // The call may have been ended: what it has is still to be handed over.
  const HookScope outside{CallContext{}};
  out.picture = picture_of(film, s.output.tone_map);
  out.variance_rgba = film.variance().values;
  out.samples = static_cast<int>(film.samples());
  out.noise_percent = film.noise_percent();
  const auto walks = tracer.walks();
  out.lost_percent = walks.all ? 100.0 * static_cast<double>(walks.lost) / static_cast<double>(walks.all) : 0;
  return out;
}

}  // namespace

std::uint64_t api::picture_fingerprint(const Scene& scene, const RenderSettings& settings,
                                       const Hooks& hooks) {
  const HookScope scope(hooks);
  return naming_the_scene(scene, [&] {
    // The caller adds settings that the reference does not know, or would refuse.
    RenderSettings s = settings;
    s.camera.heads = 1;
    s.output = {.width = 16, .height = 9};

    const setup::PlacedScene placed = placed_scene(scene);
    const std::shared_ptr<const scene::AssetData> flat = setup::flattened(placed);
    Steps steps("reading what the pictures are made of", set_up_steps);
    return reference::fingerprint(*flat, set_up(placed, *flat, scene.environment(), s, {}, steps), 0);
  });
}

ReferencePicture render_reference(const Scene& scene, const RenderSettings& s, const ReferenceSettings& r,
                                  const Hooks& hooks) {
  const HookScope scope(hooks);
  return api::naming_the_scene(scene, [&] { return rendered(scene, s, r); });
}

void ReferencePicture::save_variance(const std::filesystem::path& path) const {
  if (ending_of(path) != ".exr") throw input_error(path.string(), "the variance is written as .exr");
  image::save_exr(path,
                  {.width = picture.width, .height = picture.height, .channels = 4, .values = variance_rgba});
}

}  // namespace dermis
