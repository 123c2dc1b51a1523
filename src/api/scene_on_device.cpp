// SPDX-License-Identifier: MIT
#include "api/scene_on_device.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "base/core/hooks.h"
#include "base/core/warnings.h"
#include "render/passes/pixels/labels/labels.h"
#include "render/setup/preparation.h"

namespace dermis::api {
namespace {

// Adds the time until its end to that of an asset.
class UploadTime {
 public:
  explicit UploadTime(SharedAsset& asset) : asset_(&asset) {}
  UploadTime(const UploadTime&) = delete;
  UploadTime& operator=(const UploadTime&) = delete;
  ~UploadTime() {
    asset_->upload_ms +=
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  SharedAsset* asset_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void upload_asset(gpu::PipelineLibrary& library, SharedAsset& asset) {
  if (asset.gpu) return;
  const UploadTime time(asset);
  asset.gpu.emplace(library, *asset.data);
}

// Finds what each point of the skin sees of its surroundings.
void add_bent_normals(gpu::Device& device, SharedAsset& asset) {
  const std::size_t meshes = asset.data->skin.size();
  if (asset.bent_normal.size() == meshes) return;

  const UploadTime time(asset);
  const setup::Preparation& prepare = setup::preparation("the surroundings that skin sees");
  Steps steps("occlusion of the surroundings", meshes - asset.bent_normal.size());
  for (std::size_t i = asset.bent_normal.size(); i < meshes; ++i) {
    environment::Occlusion seen =
        prepare.occlusion(*asset.data, asset.data->skin[i], {.side = environment::occlusion_side(meshes)});
    asset.gpu->skin[i].bent_normal =
        passes::unwrap_map(device, asset.gpu->skin[i].name + " bent normal", seen.side, {&seen.values});
    // Free what the device has now; each new sky needs only the rest.
    seen.values = {};
    asset.bent_normal.push_back(std::move(seen));
    steps.done();
  }
}

// Finds the shape of the body at each vertex.
void add_shape(gpu::Device& device, SharedAsset& asset) {
  if (asset.has_shape) return;
  const UploadTime time(asset);
  const setup::Preparation& prepare = setup::preparation("the shape of the body");
  Steps steps("the shape of the body", asset.data->skin.size());
  for (std::size_t i = 0; i < asset.data->skin.size(); ++i) {
    const auto shape = prepare.body_shape(*asset.data, asset.data->skin[i]);
    asset.gpu->give_shape(device, i, asset.data->skin[i], shape);
    steps.done();
  }
  asset.has_shape = true;
}

// Finds nose, ears and the thickness of the body, for labels.
void add_label_vertices(gpu::Device& device, SharedAsset& asset) {
  if (asset.has_label_vertices) return;
  const UploadTime time(asset);
  const scene::AssetData& scene = *asset.data;
  const setup::LabelVertices found =
      setup::preparation("labels of the face").label_vertices(scene, asset.data->skin, asset.source);
  for (std::size_t i = 0; i < found.skin.size(); ++i)
    asset.gpu->skin[i].label_vertices = gpu::make_buffer(device, asset.gpu->skin[i].name + " label vertices",
                                                         std::span<const io::LabelVertexIo>(found.skin[i]),
                                                         VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);

  for (passes::GpuSurfaces::Page& page : asset.gpu->surfaces.pages) {
    std::vector<io::LabelVertexIo> vertices;
    for (const passes::GpuSurfaces::Page::Part& part : page.parts)
      vertices.insert(vertices.end(), found.surfaces[part.primitive].begin(),
                      found.surfaces[part.primitive].end());
    page.label_vertices =
        gpu::make_buffer(device, "surfaces label vertices", std::span<const io::LabelVertexIo>(vertices),
                         VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  }
  asset.has_label_vertices = true;
}

// Uploads what finds the curvature of its skin, unless it is there.
void add_welded(gpu::Device& device, SharedAsset& asset) {
  const UploadTime time(asset);
  for (std::size_t i = 0; i < asset.data->skin.size(); ++i)
    asset.gpu->make_welded(device, i, asset.data->skin[i]);
}

// Objects that instances share, by their common key: a scene may have thousands of either.
template <class Shared, class Key>
class SharedBy {
 public:
  using Pointer = std::shared_ptr<const Shared>;

  void add(const Key& key, const Pointer& one) { all_[key].push_back(one); }
  template <class Matches>
  Pointer find(const Key& key, const Matches& matches) const {
    const auto found = all_.find(key);
    if (found == all_.end()) return nullptr;
    for (const Pointer& one : found->second)
      if (matches(*one)) return one;
    return nullptr;
  }

 private:
  std::map<Key, std::vector<Pointer>> all_;
};

using LookKey = std::tuple<const SharedAsset*, std::optional<float>, float, float, float>;
LookKey key_of(const AssetPointer& asset, const passes::LookSettings& settings) {
  return {asset.get(), settings.mix, settings.tint.x, settings.tint.y, settings.tint.z};
}

using SkyKey = std::pair<const SharedAsset*, std::array<float, 9>>;
SkyKey key_of(const AssetPointer& asset, const glm::mat3& rotation) {
  SkyKey key{asset.get(), {}};
  for (glm::length_t i = 0; i < 9; ++i) key.second[static_cast<std::size_t>(i)] = rotation[i / 3][i % 3];
  return key;
}

}  // namespace

std::vector<AssetPointer> each_once(const std::vector<AssetPointer>& assets) {
  std::unordered_set<const SharedAsset*> known;
  std::vector<AssetPointer> different;
  for (const AssetPointer& asset : assets)
    if (known.insert(asset.get()).second) different.push_back(asset);
  return different;
}

std::vector<AssetPointer> SceneOnDevice::different_assets() const { return each_once(assets_); }

double SceneOnDevice::upload_ms() const {
  double sum = 0;
  for (const AssetPointer& asset : different_assets()) sum += asset->upload_ms;
  return sum;
}

void SceneOnDevice::upload(gpu::PipelineLibrary& library, const setup::PlacedScene& scene,
                           const RenderSettings& settings, const setup::FrameSetup& setup,
                           std::span<const passes::Head> heads,
                           const std::shared_ptr<const setup::EnvironmentLight>& environment,
                           const SceneOnDevice& before, const setup::HostSetup* host) {
  const WarningGroup group;
  gpu::Device& device = library.device();
  for (const AssetPointer& asset : different_assets()) {
    upload_asset(library, *asset);
    if (environment) add_bent_normals(device, *asset);
    if (passes::Labels::needs_body(setup.plan.labels)) add_label_vertices(device, *asset);
    if (setup.technique->curvature) add_welded(device, *asset);
  }

  for (std::size_t i = 0; i < setup.plan.skin.size(); ++i)
    if (setup.plan.skin[i].profile.shape) add_shape(device, *assets_[setup.meshes[i].instance]);

  make_looks(device, scene, settings, before, host);
  make_skies(device, scene, setup, settings, environment, before, host);

  const std::vector<techniques::GutterSize> sizes = setup.technique->gutters(setup.plan, heads);
  Steps steps("making gutters", sizes.size());
  for (const techniques::GutterSize& size : sizes) {
    const setup::MeshSource& source = setup.meshes[size.mesh];
    SharedAsset& asset = *assets_[source.instance];
    const UploadTime time(asset);
    asset.gpu->make_gutters(device, source.mesh, asset.data->skin[source.mesh], size.side, size.width_texels);
    steps.done();
  }
}

void SceneOnDevice::make_looks(gpu::Device& device, const setup::PlacedScene& scene,
                               const RenderSettings& settings, const SceneOnDevice& before,
                               const setup::HostSetup* host) {
  std::span<const setup::HostMapOfInstance> maps;
  if (host) maps = host->maps;
  SharedBy<SharedLook, LookKey> known;
  for (const auto& look : before.looks_)
    if (look) known.add(key_of(look->asset, look->settings), look);
  looks_.clear();
  for (std::size_t i = 0; i < assets_.size(); ++i) {
    passes::LookSettings wanted{.mix = scene.instances[i].mix, .tint = scene.instances[i].tint, .maps = {}};
    if (settings.skin.mix) wanted.mix = static_cast<float>(*settings.skin.mix);
    for (const setup::HostMapOfInstance& map : maps)
      if (map.instance == i) wanted.maps.push_back(map.map);
    const auto matches = [&](const SharedLook& look) {
      return look.asset == assets_[i] && look.settings == wanted;
    };

    const LookKey key = key_of(assets_[i], wanted);
    std::shared_ptr<const SharedLook> look = known.find(key, matches);
    if (!look) {
      look = std::make_shared<const SharedLook>(
          SharedLook{assets_[i], wanted, assets_[i]->gpu->make_look(device, wanted)});
      known.add(key, look);
    }
    looks_.push_back(std::move(look));
  }
}

void SceneOnDevice::make_skies(gpu::Device& device, const setup::PlacedScene& scene,
                               const setup::FrameSetup& setup, const RenderSettings& settings,
                               const std::shared_ptr<const setup::EnvironmentLight>& environment,
                               const SceneOnDevice& before, const setup::HostSetup* host) {
  skies_.assign(assets_.size(), nullptr);
  if (!environment) return;
  std::vector<bool> shown(assets_.size(), false);
  for (std::size_t i = 0; host && i < shown.size(); ++i) shown[i] = scene.instances[i].visible;
  for (const passes::Head& head : setup.heads) shown[head.instance] = shown[head.instance] || head.visible;

  const double rotation_deg = settings.lighting.environment_rotation_deg;
  SharedBy<SharedSky, SkyKey> known;
  for (const auto& sky : before.skies_)
    if (sky) known.add(key_of(sky->asset, sky->sky.world_from_asset), sky);
  for (std::size_t i = 0; i < assets_.size(); ++i) {
    if (!shown[i]) continue;
    const glm::mat3& rotation = scene.instances[i].world_from_asset.rotation;
    const auto matches = [&](const SharedSky& sky) {
      return sky.asset == assets_[i] && sky.sky.is_of(*environment, rotation_deg, rotation);
    };

    const SkyKey key = key_of(assets_[i], rotation);
    std::shared_ptr<const SharedSky> sky = known.find(key, matches);
    if (!sky) {
      sky = std::make_shared<const SharedSky>(SharedSky{
          assets_[i],
          setup::sky_on_skin(device, environment, rotation_deg, rotation, assets_[i]->bent_normal)});
      known.add(key, sky);
    }
    skies_[i] = std::move(sky);
  }
}

void SceneOnDevice::give(std::span<passes::Head> heads) const {
  for (passes::Head& head : heads) {
    head.asset = &*assets_[head.instance]->gpu;
    head.look = &looks_[head.instance]->look;
    if (const std::shared_ptr<const SharedSky>& sky = skies_[head.instance]) head.sky = sky->sky.maps;
  }
}

}  // namespace dermis::api
