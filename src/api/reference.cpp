// SPDX-License-Identifier: MIT
#include "dermis/reference.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "api/memory.h"
#include "api/scene_state.h"
#include "core/error.h"
#include "core/hooks.h"
#include "core/log.h"
#include "image/codec.h"
#include "image/tone_map.h"
#include "optics/presets.h"
#include "reference/checkpoint.h"
#include "reference/render.h"
#include "scene/topology.h"
#include "scene/unwrap.h"
#include "settings/check.h"
#include "setup/choose.h"
#include "setup/environment_light.h"
#include "setup/reference_setup.h"

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

/// A profile that dermis made from a homogeneous medium says what it was made of: 1/sigma_t' and 1/sigma_tr,
/// and sigma_tr^2 = 3 sigma_a sigma_t'. Scattering is then the reduced one, isotropic.
optics::RgbMedium medium_of(const gaussians::SumOfGaussians& profile, double eta) {
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

optics::RgbMedium choose_medium(const std::string& text, const gaussians::SumOfGaussians& profile,
                                double eta) {
  if (text.empty()) return medium_of(profile, eta);
  if (text.find('=') != std::string::npos) return optics::parse_coefficients(text, "medium");
  if (const optics::Material* material = optics::find_material(text)) return material->medium();
  std::string names;
  for (const optics::Material& material : optics::jensen_materials())
    names += (names.empty() ? "" : ", ") + std::string(material.name);
  throw input_error("", "medium '{}' is neither coefficients nor one of: {}", text, names);
}

/// The skin that light walks in should be closed.
void warn_if_open(const scene::Scene& scene, const std::vector<scene::SkinMesh>& skin) {
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

// `scene`: that of `placed`, flattened.
reference::Job set_up(const setup::PlacedScene& placed, const scene::Scene& scene,
                      const std::optional<SceneEnvironment>& environment, const RenderSettings& s,
                      const ReferenceSettings& r) {
  const std::vector<scene::SkinMesh> skin = scene::skin_meshes(scene);
  reference::Job job;
  job.model = r.model == ReferenceModel::volume ? reference::Model::volume : reference::Model::bssrdf;
  job.setup = setup::reference_setup(placed, s);
  if (const auto source = setup::choose_environment(s, environment))
    job.setup.environment = std::make_shared<const reference::EnvironmentSampler>(
        setup::read_environment(*source), s.lighting.environment_intensity,
        s.lighting.environment_rotation_deg);

  job.profiles.resize(scene.materials.size());
  for (const scene::SkinMesh& mesh : skin) {
    // One profile per mesh, that of its first triangle, as the renderer has it.
    const scene::Material& first = scene.materials[static_cast<std::size_t>(mesh.triangle_material.front())];
    const gaussians::SumOfGaussians profile = setup::choose_profile(first, s);
    for (const int material : mesh.triangle_material) {
      gaussians::SumOfGaussians& of = job.profiles[static_cast<std::size_t>(material)];
      if (of.terms.empty()) of = profile;
    }

    if (job.model == reference::Model::volume && &mesh == &skin.front())
      job.medium = choose_medium(r.medium, profile, first.ior);
  }

  if (job.model == reference::Model::volume) {
    if (skin.empty())
      throw input_error(scene.name,
                        "has no skin for light to walk in; skin_material says which material is skin");
    optics::check(job.medium, "medium");
    warn_if_open(scene, skin);
  }
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

/// Says how far it is, and keeps the checkpoint young.
class Watch {
 public:
  Watch(const ReferenceSettings& settings, int samples_before, std::uint64_t fingerprint)
      : settings_(&settings), before_(samples_before), fingerprint_(fingerprint) {}

  void after_pass(const reference::Film& film) {
    if (settings_->progress) {
      const int samples = static_cast<int>(film.samples());
      const double noise = film.noise_percent(), seconds = seconds_since(start_);
      double most = samples_of(*settings_);
      // Noise falls with the square root of the samples.
      if (settings_->noise_percent)
        most = std::min(most, samples * std::pow(noise / *settings_->noise_percent, 2));
      const double left = std::max(0.0, most - samples) * seconds / std::max(1, samples - before_);
      settings_->progress({samples, samples_of(*settings_), noise, seconds, left});
    }
    if (!settings_->checkpoint.empty() && seconds_since(saved_) > checkpoint_seconds) {
      save_checkpoint(settings_->checkpoint, film, fingerprint_);
      saved_ = Clock::now();
    }
  }

 private:
  const ReferenceSettings* settings_;
  int before_;
  std::uint64_t fingerprint_;
  Clock::time_point start_ = Clock::now(), saved_ = start_;
};

ReferencePicture rendered(const Scene& scene, const RenderSettings& s, const ReferenceSettings& r) {
  check_ranges(r);
  if (!s.output.exposure_ev)
    throw input_error(
        "",
        "an automatic output.exposure_ev is of the renderer; give the reference the number that a "
        "picture with it reports");

  const ToneMap tone_map = s.output.tone_map;
  const setup::PlacedScene placed = api::placed_scene(scene);
  const std::shared_ptr<const scene::Scene> flat = setup::flattened(placed);
  const reference::Job job = set_up(placed, *flat, scene.environment(), s, r);
  reference::Film film(s.output.width, s.output.height);
  const std::uint64_t fingerprint = r.checkpoint.empty() ? 0 : reference::fingerprint(*flat, job, r.seed);
  if (r.resume && !r.checkpoint.empty() && !load_checkpoint(r.checkpoint, film, fingerprint))
    note("{}: no such file, so this run begins at the beginning", r.checkpoint.string());

  const reference::Tracer tracer(*flat, job);
  Watch watch(r, static_cast<int>(film.samples()), fingerprint);
  ReferencePicture out;
  out.complete = reference::render(tracer, film,
                                   {.samples = static_cast<std::uint32_t>(samples_of(r)),
                                    .noise_percent = r.noise_percent,
                                    .seed = r.seed,
                                    .threads = r.threads,
                                    .stop = r.stop},
                                   [&](const reference::Film& f) { watch.after_pass(f); });

  if (!out.complete && film.samples() > 0 && !r.checkpoint.empty())
    save_checkpoint(r.checkpoint, film, fingerprint);

  out.picture = picture_of(film, tone_map);
  out.variance_rgba = film.variance().values;
  out.samples = static_cast<int>(film.samples());
  out.noise_percent = film.noise_percent();
  const auto walks = tracer.walks();
  out.lost_percent = walks.all ? 100.0 * static_cast<double>(walks.lost) / static_cast<double>(walks.all) : 0;
  return out;
}

}  // namespace

ReferencePicture render_reference(const Scene& scene, const RenderSettings& s, const ReferenceSettings& r) {
  const HookScope scope(Hooks{.log = r.log});
  return api::naming_the_scene(scene, [&] { return rendered(scene, s, r); });
}

void ReferencePicture::save_variance(const std::filesystem::path& path) const {
  if (path.extension() != ".exr") throw input_error(path.string(), "the variance is written as .exr");
  image::save_exr(path,
                  {.width = picture.width, .height = picture.height, .channels = 4, .values = variance_rgba});
}

}  // namespace dermis
