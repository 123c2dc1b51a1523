// SPDX-License-Identifier: MIT
#include "rays/ray_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <tuple>
#include <type_traits>

#include "base/core/error.h"
#include "base/core/hooks.h"
#include "head/scene/placement.h"
#include "rays/alpha_test.h"
#include "rays/embree.h"

namespace dermis::rays {
namespace {

// One copy of a primitive, by its Embree geometry number.
struct Copy {
  std::uint32_t primitive = 0, copy = 0;
};

// The thread sanitizer does not see how the threads of Embree wait for each other: there it has one.
#ifdef __SANITIZE_THREAD__
constexpr const char* device_settings = "threads=1,set_affinity=0";
#else
constexpr const char* device_settings = nullptr;
#endif

// A reference that is given back, whatever is thrown meanwhile.
struct Release {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using OwnScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, Release>;
using Geometry = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, Release>;

// A context that gathers hits. Embree passes the filter a pointer to the context, which is the first member.
struct Gather {
  embree::Context context;
  std::vector<Hit>* hits;
  const std::vector<Copy>* copies;
};

// Records each hit and rejects it, so that the search continues to the end of the ray.
void gather_hit(const RTCFilterFunctionNArguments* arguments) {
  const auto* gather = reinterpret_cast<const Gather*>(arguments->context);
  const auto* ray = reinterpret_cast<const RTCRay*>(arguments->ray);
  const auto* hit = reinterpret_cast<const RTCHit*>(arguments->hit);
  const Copy& copy = (*gather->copies)[hit->geomID];  // skin: it has no placements
  gather->hits->push_back({copy.primitive, hit->primID, hit->u, hit->v, ray->tfar, copy.copy});
  arguments->valid[0] = 0;
}

RTCRay embree_ray(const Ray& ray) {
  RTCRay r{};
  r.org_x = static_cast<float>(ray.origin_m.x);
  r.org_y = static_cast<float>(ray.origin_m.y);
  r.org_z = static_cast<float>(ray.origin_m.z);
  r.dir_x = static_cast<float>(ray.direction.x);
  r.dir_y = static_cast<float>(ray.direction.y);
  r.dir_z = static_cast<float>(ray.direction.z);
  r.tnear = static_cast<float>(ray.t_min_m);
  r.tfar = static_cast<float>(std::min(ray.t_max_m, 1e30));
  r.mask = 0xffffffffu;
  return r;
}

std::optional<Hit> nearest_in(RTCScene scene, const std::vector<Copy>& copies, const Ray& ray) {
  embree::Context context;
  embree::init(context);
  RTCRayHit query{};
  query.ray = embree_ray(ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  embree::intersect(scene, context, query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  // For a placed copy geomID counts within its mesh, and instID identifies the copy.
  const bool placed = query.hit.instID[0] != RTC_INVALID_GEOMETRY_ID;
  const Copy& copy = copies[placed ? query.hit.instID[0] : query.hit.geomID];
  return Hit{copy.primitive, query.hit.primID, query.hit.u, query.hit.v, query.ray.tfar, copy.copy};
}

}  // namespace

bool is_skin(const scene::AssetData& scene, const scene::Primitive& primitive) {
  return scene.materials[static_cast<std::size_t>(primitive.material)].skin;
}

struct RayScene::Scenes {
  RTCDevice device = nullptr;
  RTCScene all = nullptr, solid = nullptr, cut_out = nullptr, skin = nullptr, skin_gathered = nullptr;
  std::vector<Copy> copies;  // by geometry number, in all of these scenes

  Scenes() : device(rtcNewDevice(device_settings)) {
    if (!device)
      throw device_error("Embree could not start: error {}", static_cast<int>(rtcGetDeviceError(nullptr)));
    for (RTCScene* scene : {&all, &solid, &cut_out, &skin, &skin_gathered}) *scene = new_scene();
  }
  ~Scenes() {
    for (RTCScene scene : {all, solid, cut_out, skin, skin_gathered}) rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Scenes(const Scenes&) = delete;
  Scenes& operator=(const Scenes&) = delete;

  RTCScene new_scene() const {
    RTCScene scene = rtcNewScene(device);
    // Robust: no ray slips between two triangles. Medium quality splits no triangles, so none is gathered
    // twice.
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
    return scene;
  }

  // As in the shadow maps: blended parts cast no shadow.
  void attach(RTCGeometry g, AssetAlpha alpha, std::uint32_t number) const {
    rtcAttachGeometryByID(all, g, number);
    if (alpha == AssetAlpha::opaque) rtcAttachGeometryByID(solid, g, number);
    if (alpha == AssetAlpha::mask) rtcAttachGeometryByID(cut_out, g, number);
  }

  // Sorts the triangles of a scene into a tree. Embree asks from its own threads whether to go on.
  static void commit(RTCScene scene) {
    CallContext context = current_context();
    rtcSetSceneProgressMonitorFunction(
        scene, [](void* asked, double) { return !is_cancelled(*static_cast<const CallContext*>(asked)); },
        &context);
    rtcCommitScene(scene);
    rtcSetSceneProgressMonitorFunction(scene, nullptr, nullptr);
    stop_if_cancelled(context);
  }

  // Attaches one tree over the triangles of the mesh, and a matrix per placement.
  void attach_placed(RTCGeometry mesh, const scene::Primitive& primitive, AssetAlpha alpha,
                     std::uint32_t first_number) const {
    const OwnScene triangles(new_scene());
    rtcAttachGeometry(triangles.get(), mesh);
    commit(triangles.get());
    for (std::uint32_t i = 0; i < primitive.placements.size(); ++i) {
      const glm::mat4x3 matrix(primitive.placements[i].world_from_mesh);
      const Geometry g(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE));
      rtcSetGeometryInstancedScene(g.get(), triangles.get());
      rtcSetGeometryTransform(g.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, &matrix);
      rtcCommitGeometry(g.get());
      attach(g.get(), alpha, first_number + i);
    }
  }

  Geometry geometry(const scene::Primitive& primitive) const {
    Geometry g(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        g.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), primitive.vertices.size()));
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(g.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), primitive.indices.size() / 3));
    if (!vertices || !indices)
      throw device_error("Embree: too little memory for '{}' ({} vertices)", primitive.name,
                         primitive.vertices.size());
    for (std::size_t i = 0; i < primitive.vertices.size(); ++i)
      std::memcpy(vertices + 3 * i, &primitive.vertices[i].position_m, 12);
    std::copy(primitive.indices.begin(), primitive.indices.end(), indices);
    return g;
  }
};

RayScene::RayScene(const scene::AssetData& scene) : scene_(&scene), scenes_(std::make_unique<Scenes>()) {
  const std::array trees{scenes_->all, scenes_->solid, scenes_->cut_out, scenes_->skin,
                         scenes_->skin_gathered};
  Steps steps("sorting the triangles", scene.primitives.size() + trees.size());
  for (std::uint32_t i = 0; i < scene.primitives.size(); ++i) {
    const scene::Primitive& primitive = scene.primitives[i];
    if (primitive.indices.empty()) continue;
    const AssetAlpha alpha = scene.materials[static_cast<std::size_t>(primitive.material)].alpha_mode;
    const auto number = static_cast<std::uint32_t>(scenes_->copies.size());
    for (std::uint32_t copy = 0; copy < scene::copies_of(primitive); ++copy)
      scenes_->copies.push_back({i, copy});
    has_cut_outs_ = has_cut_outs_ || alpha == AssetAlpha::mask;

    const Geometry g = scenes_->geometry(primitive);
    rtcCommitGeometry(g.get());
    if (primitive.placements.empty())
      scenes_->attach(g.get(), alpha, number);
    else
      scenes_->attach_placed(g.get(), primitive, alpha, number);
    if (is_skin(scene, primitive)) {
      for (const std::uint32_t index : primitive.indices) {
        const glm::dvec3 p(primitive.vertices[index].position_m);
        low_m_ = glm::min(low_m_, p);
        high_m_ = glm::max(high_m_, p);
      }
      rtcAttachGeometryByID(scenes_->skin, g.get(), number);
      const Geometry gathered = scenes_->geometry(primitive);
      rtcSetGeometryIntersectFilterFunction(gathered.get(), gather_hit);
      rtcCommitGeometry(gathered.get());
      rtcAttachGeometryByID(scenes_->skin_gathered, gathered.get(), number);
    }
    steps.done();
  }
  for (RTCScene tree : trees) {
    Scenes::commit(tree);
    steps.done();
  }
  if (const RTCError error = rtcGetDeviceError(scenes_->device); error != RTC_ERROR_NONE)
    throw device_error("Embree: error {} while it sorted the triangles of '{}'", static_cast<int>(error),
                       scene.name);
}

RayScene::~RayScene() = default;

std::optional<Hit> RayScene::nearest(const Ray& ray) const {
  return nearest_in(scenes_->all, scenes_->copies, ray);
}
std::optional<Hit> RayScene::nearest_skin(const Ray& ray) const {
  return nearest_in(scenes_->skin, scenes_->copies, ray);
}

// Skips triangles that the alpha test cuts away where the ray meets them.
std::optional<Hit> RayScene::nearest_cut_out(Ray ray) const {
  while (const std::optional<Hit> hit = nearest_in(scenes_->cut_out, scenes_->copies, ray)) {
    if (!is_cut_away(*scene_, surface_point(*scene_, *hit))) return hit;
    ray.t_min_m = std::nextafter(static_cast<float>(hit->t_m), 1e30f);
  }
  return std::nullopt;
}

std::optional<Hit> RayScene::nearest_solid(const Ray& ray) const {
  const std::optional<Hit> opaque = nearest_in(scenes_->solid, scenes_->copies, ray);
  if (!has_cut_outs_) return opaque;
  Ray before = ray;
  if (opaque) before.t_max_m = opaque->t_m;
  const std::optional<Hit> left = nearest_cut_out(before);
  return left ? left : opaque;
}

bool RayScene::solid_between(const Ray& ray) const {
  embree::Context context;
  embree::init(context);
  RTCRay r = embree_ray(ray);
  embree::occluded(scenes_->solid, context, r);
  return r.tfar < 0 || (has_cut_outs_ && nearest_cut_out(ray));
}

void RayScene::all_skin(const Ray& ray, std::vector<Hit>& hits) const {
  hits.clear();
  Gather gather{};
  embree::init(gather.context);
  gather.hits = &hits;
  gather.copies = &scenes_->copies;
  RTCRayHit query{};
  query.ray = embree_ray(ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  embree::intersect(scenes_->skin_gathered, gather.context, query);
  // The order of hits depends on the tree, which threads may build differently.
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
    return std::tie(a.t_m, a.primitive, a.triangle) < std::tie(b.t_m, b.primitive, b.triangle);
  });
}

}  // namespace dermis::rays
