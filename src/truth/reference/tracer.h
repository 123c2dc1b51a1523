// SPDX-License-Identifier: MIT
// Computes one sample of one pixel: a camera ray, and the chosen model for the skin that it hits.
#pragma once

#include <atomic>
#include <vector>

#include "base/core/hooks.h"
#include "truth/reference/diffusion.h"
#include "truth/reference/shading.h"
#include "truth/reference/walk.h"

namespace dermis::reference {

class Tracer {
 public:
  /// Keeps a reference to the scene. Counts steps (base/core/hooks.h): may take seconds. Throws InputError
  /// for a medium whose channels differ in g or eta, DeviceError if Embree cannot start, and Cancelled if its
  /// caller ends it.
  Tracer(const scene::AssetData& scene, const Job& job) : Tracer(scene, job, Steps("sorting the scene", 3)) {}

  struct Sample {
    glm::dvec3 radiance{0};  ///< times radiance_scale
    double skin = 0;         ///< fraction of the ray that ends on skin
  };
  /// Returns a sample of pixel (x, y) at a random point of it. `scratch` only saves memory.
  Sample sample(int x, int y, Random& random, std::vector<rays::Hit>& scratch) const;

  int width() const { return job_.setup.width; }
  int height() const { return job_.setup.height; }
  const Shading& shading() const { return shading_; }

  /// Number of walks, and of those that left through a hole of the mesh.
  struct WalkCount {
    std::uint64_t all = 0, lost = 0;
  };
  WalkCount walks() const { return {walks_.load(), lost_.load()}; }

 private:
  Tracer(const scene::AssetData& scene, const Job& job, Steps steps);
  glm::dvec3 skin_radiance(rays::SurfacePoint& s, double side, const glm::dvec3& to_eye, Random& random,
                           std::vector<rays::Hit>& scratch) const;
  glm::dvec3 from_the_medium(const rays::SurfacePoint& s, const glm::dvec3& to_eye, Random& random) const;

  Job job_;
  rays::RayScene rays_;
  Shading shading_;
  std::vector<Diffusion> diffusion_;  // one per material
  WalkMedium medium_;
  glm::dvec3 medium_total_{1};  // diffuse total of the medium
  mutable std::atomic<std::uint64_t> walks_{0}, lost_{0};
};

/// Returns the part of diffuse light that a half-space of the medium returns after it entered, per channel, 0
/// to 1. Monte-Carlo with 4e5 photons per channel: within 0.2 per cent.
glm::dvec3 diffuse_total(const optics::RgbMedium& medium);

}  // namespace dermis::reference
