// SPDX-License-Identifier: MIT
/// Sessions: frames of a scene that changes while it is looked at.
///
///   dermis::Session session(renderer);
///   for (;;) {
///     scene.set_transform(head, pose);
///     const dermis::Ticket ticket = session.draw(scene, settings);
///     ...                                         // the device draws
///     show(session.picture(ticket));
///   }
///
/// draw() returns before the device has drawn. Camera, lights, transforms, exposure and the rotation of an
/// environment change from frame to frame without waiting for the device, without an allocation on it and
/// with one submission. What makes a new plan (RenderSettings of the structure, a number of instances, a
/// profile or a scale that no instance had) or needs new maps costs that once. A picture is the same to the
/// bit as that of Renderer::render(). Labels say for each pixel what it shows, if the session is asked for
/// them.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "dermis/renderer.h"

namespace dermis {

/// What one frame shows: a camera. Its target has the size that OutputSettings have.
struct View {
  CameraSettings camera{};
};

/// Names a frame of a session.
enum class Ticket : std::uint64_t {};

/// What each pixel of a frame shows, unfiltered: one sample at its middle, never averaged over several and
/// never blended, so that a number is always one that the scene has. Of the opaque and cut-out parts of all
/// visible instances, culled and cut out as in the picture. Blended parts (lashes, brows) leave no label:
/// what lies behind them does. Rows from top to bottom, without padding; the size of the picture.
struct Labels {
  int width = 0, height = 0;  ///< pixels

  /// 0: nothing is there. Else 1 + the number of the instance in Scene::instances(), hidden ones counted. In
  /// a row of camera.heads, 1 + the number of the head, from that which stands farthest towards -X.
  std::vector<std::uint32_t> instance;
  /// 0: nothing is there. Else 1 + the number of the material in Asset::materials() of the instance's asset,
  /// which are the names.
  std::vector<std::uint32_t> material;
  /// Metres from the eye, along the direction in which the camera looks, not along the ray; under an
  /// orthographic camera from the plane through its eye. At least the distance of the near plane. Infinity:
  /// nothing is there.
  std::vector<float> depth_m;
  /// Three values per pixel: the vertices' normals, interpolated, without normal maps. Of unit length, in the
  /// world, on the side of the surface that is seen: as everywhere, interpolated ones may lean away from the
  /// eye by a little near an outline. 0 0 0: nothing is there.
  std::vector<float> normal;
  /// Two values per pixel: the asset's first set of texture coordinates as they are in the file, v down,
  /// before the transform of a map; any number. 0 0 where nothing is, and where the mesh has none.
  std::vector<float> uv;
  /// Two values per pixel: by how many pixels that point of the surface has moved in the picture since the
  /// frame that the session drew before, to the right and down, by camera, instance and pose together. So it
  /// was at the middle of the pixel minus these. 0 0 where nothing is, in the first frame, and for an
  /// instance that the frame before had not; infinity where the point lay behind the camera. An instance that
  /// was outside the picture counts from the pose in which it was drawn last; one whose pose has just been
  /// taken off, from its rest.
  std::vector<float> motion_px;
  enum Region : std::uint8_t { no_region, nose, ear, other_skin };
  /// A Region: nose and ears of a head that looks along +Z in its asset's coordinates, found from its shape
  /// as picture_regions() finds them (docs/methodology.md), at the vertices of the skin. `other_skin` is the
  /// rest of the skin, and all skin that is no such head; `no_region` is nothing, or no skin.
  std::vector<std::uint8_t> region;
  /// 0: no skin is there. Else 1 + the number of the skin mesh in the asset: parts of it that share a light
  /// map.
  std::vector<std::uint32_t> skin_mesh;
  /// Two values per pixel: the texture coordinates of the light map of that skin mesh, 0 to 1, v down, which
  /// the map of `output.show` "irradiance" has, too. 0 0 where no skin is.
  std::vector<float> unwrap;
  /// Thickness of the body below the skin, millimetres, as light that follows its shape takes it: the mean of
  /// rays into a cone around the inward normal, in the rest pose, times the scale of the instance. What is
  /// thicker than 50 mm times that scale, or does not close, has that. 0 where no skin is.
  std::vector<float> thickness_mm;
};

/// One thread at a time may use a session and its renderer. A session keeps the device alive.
class Session {
 public:
  struct Options {
    /// Frames that may be on their way at a time, 1 to 3: draw() waits for the one before these. Each takes
    /// memory for its picture and for what changes per frame, but not for maps.
    int frames_in_flight = 2;
    bool statistics = false;  ///< counts what each frame computes: Statistics of its picture; costs time
    /// Draws labels() with each frame: one more pass, which is one more time all visible triangles. Takes 60
    /// bytes of memory per pixel, and 56 for each frame in flight. Nose, ears and thickness of an asset are
    /// found at its first use: a second for 20,000 triangles; the thickness is kept in the cache.
    bool labels = false;
  };

  explicit Session(const Renderer& renderer) : Session(renderer, Options{}) {}
  /// Throws InputError: a number out of range.
  Session(const Renderer& renderer, const Options& options);
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  ~Session();

  /// Draws the scene as it is now. `settings.output.exposure_ev` must be given, and `output.show` be
  /// "picture". Throws as Renderer::render() does; after an InputError the session is as before.
  Ticket draw(const Scene& scene, const RenderSettings& settings);
  /// Likewise, as these views see it in place of settings.camera; camera.heads stays that of the settings.
  /// One view per frame so far: throws InputError for another number.
  Ticket draw(const Scene& scene, const RenderSettings& settings, std::span<const View> views);

  /// Returns whether picture() would not wait. Throws InputError: see picture().
  bool is_ready(Ticket ticket) const;

  /// Returns the frame; waits for it, but not for later ones. May be called again, until as many frames have
  /// been drawn after it as may be in flight. Throws InputError: a ticket of an earlier frame or of another
  /// session.
  Picture picture(Ticket ticket) const;

  /// Returns the labels of the frame, as picture() returns its picture. They do not depend on technique,
  /// samples and light. Throws InputError as picture() does, and if Options::labels was not set.
  Labels labels(Ticket ticket) const;

  struct State;  // of the library

 private:
  std::unique_ptr<State> state_;
};

}  // namespace dermis
