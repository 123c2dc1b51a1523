// SPDX-License-Identifier: MIT
#include "truth/reference/checkpoint.h"

#include <cstring>
#include <string>

#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/hash.h"
#include "head/scene/import/material_source.h"

namespace dermis::reference {
namespace {

constexpr char magic[16] = "dermis sampled2";

struct Header {
  char name[16];
  std::uint64_t fingerprint;
  std::uint64_t check;  // of the state
  std::int32_t width, height;
};
static_assert(sizeof(Header) == 40);

/// Also of what scenes are made of.
class SceneHash : public Hash {
 public:
  using Hash::add;
  template <glm::length_t N, class T>
  void add(const glm::vec<N, T>& v) {
    for (glm::length_t i = 0; i < N; ++i) add(v[i]);
  }
  void add(const scene::MapRef& m) {
    add(m.image);
    add(m.uv_set);
    add(m.wrap_u);
    add(m.wrap_v);
    add(m.nearest);
    add(m.channel);
    add(m.scale);
    for (glm::length_t i = 0; i < 3; ++i) add(m.transform[i]);
  }
};

void add_material(SceneHash& h, const scene::Material& m) {
  h.add(m.skin);
  h.add(m.base_colour);
  h.add(m.metallic);
  h.add(m.roughness);
  h.add(m.emissive);
  h.add(m.ior);
  h.add(m.specular);
  h.add(m.specular_colour);
  h.add(m.alpha_mode);
  h.add(m.alpha_cutoff);
  h.add(m.double_sided);
  h.add(m.unlit);
  h.add(m.transmission);
  scene::for_each_map(m, [&](const scene::MapRef& map, bool) { h.add(map); });
  h.add(m.skin_settings.mix.value_or(-1.0f));
  h.add(m.skin_settings.displacement_mm);
  for (const scene::SpecularLobe& lobe : m.skin_settings.lobes) {
    h.add(lobe.roughness_factor);
    h.add(lobe.weight);
  }
}

void add_scene(SceneHash& h, const scene::AssetData& scene) {
  h.add(scene.mm_per_unit);
  for (const scene::Primitive& p : scene.primitives) {
    h.add(p.material);
    h.add(p.has_uv);
    h.bytes(p.vertices.data(), p.vertices.size() * sizeof(scene::Vertex));
    h.bytes(p.indices.data(), p.indices.size() * sizeof(std::uint32_t));
    for (const scene::Placement& placement : p.placements)
      h.bytes(&placement.world_from_mesh, sizeof placement.world_from_mesh);
  }
  for (const scene::Material& m : scene.materials) add_material(h, m);
  for (const scene::MapImage& image : scene.images) {
    h.add(image.pixels->width);
    h.add(image.pixels->height);
    h.bytes(image.pixels->rgba.data(), image.pixels->rgba.size());
  }
}

void add_setup(SceneHash& h, const RenderSetup& setup) {
  const scene::Camera& camera = setup.camera;
  for (glm::length_t i = 0; i < 4; ++i) h.add(camera.world_from_camera[i]);
  h.add(camera.fov_y_rad);
  h.add(camera.znear_m);
  h.add(camera.orthographic);
  h.add(camera.ymag_m);
  if (camera.aspect) h.add(*camera.aspect);
  if (camera.axis_at != glm::vec2(0)) h.add(camera.axis_at);
  h.add(setup.width);
  h.add(setup.height);
  h.add(setup.ambient);
  h.add(setup.radiance_scale);
  h.add(setup.specular);
  h.add(setup.white_albedo);
  h.add(setup.mix.value_or(-1));
  if (setup.environment) {
    const image::ImageF& picture = setup.environment->picture().radiance;
    h.add(setup.environment->intensity());
    h.add(setup.environment->rotation_rad());
    h.add(picture.width);
    h.bytes(picture.values.data(), picture.values.size() * sizeof(float));
  }
  for (const scene::Light& light : setup.lights) {
    h.add(light.type);
    h.add(light.colour);
    h.add(light.position_m);
    h.add(light.direction);
    h.add(light.range_m);
    h.add(light.inner_cone_rad);
    h.add(light.outer_cone_rad);
    h.add(light.radius);
  }
}

}  // namespace

std::uint64_t fingerprint(const scene::AssetData& scene, const Job& job, std::uint64_t seed) {
  SceneHash h;
  add_scene(h, scene);
  add_setup(h, job.setup);
  h.add(job.model);
  h.add(seed);
  for (const ScatterProfile& profile : job.profiles) {
    h.word(profile.terms.size());
    for (const Gaussian& g : profile.terms) {
      h.add(g.variance_mm2);
      for (const double w : g.weight) h.add(w);
    }
  }
  for (const optics::Medium& m : job.medium) {
    h.add(m.sigma_a_per_mm);
    h.add(m.sigma_s_per_mm);
    h.add(m.g);
    h.add(m.eta);
  }
  return h.value();
}

void save_checkpoint(const std::filesystem::path& path, const Film& film, std::uint64_t fingerprint) {
  const std::vector<std::byte> state = film.state();
  Hash check;
  check.bytes(state.data(), state.size());
  Header header{.name = {},
                .fingerprint = fingerprint,
                .check = check.value(),
                .width = film.width(),
                .height = film.height()};
  std::memcpy(header.name, magic, sizeof magic);
  std::vector<std::byte> bytes(sizeof header + state.size());
  std::memcpy(bytes.data(), &header, sizeof header);
  std::memcpy(bytes.data() + sizeof header, state.data(), state.size());
  write_file(path, bytes);
}

bool load_checkpoint(const std::filesystem::path& path, Film& film, std::uint64_t fingerprint) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return false;
  const std::vector<std::byte> bytes = read_file(path, std::uint64_t{1} << 40);

  Header header{};
  if (bytes.size() < sizeof header || std::memcmp(bytes.data(), magic, sizeof magic) != 0)
    throw input_error(path.string(), "is not a checkpoint of `dermis reference`");
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.fingerprint != fingerprint)
    throw input_error(path.string(),
                      "belongs to another picture: scene, camera, lights, model, size or seed differ; "
                      "without `resume` it is replaced");

  const std::span state = std::span(bytes).subspan(sizeof header);
  Hash check;
  check.bytes(state.data(), state.size());
  if (header.width != film.width() || header.height != film.height() || check.value() != header.check ||
      !film.restore(state))
    throw input_error(path.string(), "is damaged; without `resume` it is replaced");
  return true;
}

}  // namespace dermis::reference
