// SPDX-License-Identifier: MIT
/// dermis in a host that has a Vulkan device, images and command buffers of its own. The only public header
/// that needs Vulkan's. docs/embedding/ holds two complete programs.
///
///   dermis::Renderer renderer(host);                       // a vulkan::Host: instance, device, queue ...
///   dermis::vulkan::HostFrames frames(renderer, {.picture = dermis::vulkan::PictureTargets{}});
///   frames.update(scene, settings);                        // after edits; may take long
///   frames.record(commands, views, {.frame = n, .finished = n - 2});  // each frame; records, and no more
///
/// Ways in, each usable by itself:
///   (i)   record() draws the heads into the host's colour and depth;
///   (ii)  record_depth() draws them into its depth pre-pass and shadow maps;
///   (iii) the host shades heads itself, with the blurred light of Recorded and dermis/scattered.glsl;
///   (iv)  the light is the host's: irradiance that it draws, or its shadow maps;
///   (v)   the shape and the maps are the host's: vertices from its buffers, images for its materials.
///
/// Matrices are column-major, 4x4, as in dermis/settings.h. All handles are borrowed, and must outlive what
/// was made with them; those that a frame uses, until the device has finished the frame. Null is refused with
/// an InputError.
///
/// Commands of each call that records begin and end with a barrier for all memory, from ALL_COMMANDS to
/// ALL_COMMANDS. A host adds barriers for layouts alone, with ALL_COMMANDS as the stage on dermis's side.
#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "dermis/renderer.h"

namespace dermis::vulkan {

/// Features that a device must have been created with. Chain `features` into VkDeviceCreateInfo, or set the
/// same members in structures of your own: the chain is features, features11, features12, features13, whose
/// pNext is null and may be set. Not copyable: the structures point at each other.
struct RequiredFeatures {
  RequiredFeatures();
  RequiredFeatures(const RequiredFeatures&) = delete;
  RequiredFeatures& operator=(const RequiredFeatures&) = delete;
  static constexpr std::uint32_t api_version = VK_API_VERSION_1_3;  ///< of instance and device, at least
  static std::span<const char* const> extensions();                 ///< of the device, null-terminated names
  VkPhysicalDeviceFeatures2 features{};                             ///< first of the chain
  VkPhysicalDeviceVulkan11Features features11{};
  VkPhysicalDeviceVulkan12Features features12{};
  VkPhysicalDeviceVulkan13Features features13{};
};

/// Memory that dermis asks its host for, for one buffer or image.
struct MemoryRequest {
  VkMemoryRequirements requirements{};  ///< memoryTypeBits: the types that suit, of which any will do
  bool mapped = false;                  ///< dermis writes or reads it from the processor
  bool dedicated = false;               ///< the driver requires or prefers memory for this resource alone
  VkBuffer buffer = VK_NULL_HANDLE;     ///< the resource; the other is null
  VkImage image = VK_NULL_HANDLE;       ///< of optimal tiling
  const char* name = "";                ///< for messages and tools, until the call returns
};
struct MemoryRange {
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkDeviceSize offset = 0;  ///< aligned as the request says
  void* mapped = nullptr;   ///< address of `offset`, if the request says mapped
  void* user = nullptr;     ///< of the host, a VmaAllocation for instance
};
/// Both or none. Called from the thread that uses the renderer; must not call dermis.
struct MemoryCallbacks {
  /// Returns nothing if there is no memory: the call of dermis then throws DeviceError.
  std::function<std::optional<MemoryRange>(const MemoryRequest&)> allocate{};
  std::function<void(const MemoryRange&)> free{};  ///< must not throw
};

/// A host's Vulkan. Instance, device and queue outlive the renderer, its frames and sessions. Before these
/// are destroyed, the device must have finished what record() wrote.
struct Host {
  PFN_vkGetInstanceProcAddr get_instance_proc_addr = nullptr;
  VkInstance instance = VK_NULL_HANDLE;
  VkPhysicalDevice physical_device = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;  ///< created with RequiredFeatures
  VkQueue queue = VK_NULL_HANDLE;    ///< graphics and compute; also for uploads of dermis's own
  std::uint32_t queue_family = 0;
  bool sampler_anisotropy = false;  ///< the device was created with this feature too
  /// Locked around each submission of dermis, where other threads submit to the queue too; null: none do.
  std::mutex* queue_mutex = nullptr;
  VkPipelineCache pipeline_cache = VK_NULL_HANDLE;  ///< null: dermis keeps one in its cache folder
  MemoryCallbacks memory{};                         ///< empty: dermis allocates blocks of its own
  /// Returns SPIR-V in place of the shader of that name ("shade.comp"); empty: dermis's own. The words
  /// outlive the renderer. Bindings, push constants and specialisation constants must be those of dermis's
  /// shader: InputError.
  std::function<std::span<const std::uint32_t>(std::string_view name)> find_shader{};
};

/// Images that the heads are drawn into, over what they hold: both are loaded, not cleared, and stored. Fixed
/// for the life of HostFrames.
struct PictureTargets {
  VkFormat colour_format = VK_FORMAT_R16G16B16A16_SFLOAT;
  VkFormat depth_format = VK_FORMAT_D32_SFLOAT;  ///< with or without stencil, which stays as it is
  std::uint32_t samples = 1;                     ///< of both, 1 or 4
  /// Near is 1: depth passes if it is greater or equal; else near is 0, and less or equal passes. The
  /// cameras of the views must have the same: InputError.
  bool reversed_depth = true;
  /// Of the largest images that views will have, pixels; needed, because record() may not allocate. The skin
  /// of a pixel is shaded once for all its samples, in memory of dermis's own: 24 bytes per pixel, with four
  /// samples 84. Then it is written into these targets, at the depth of its triangles. Skin that the host has
  /// hidden is shaded, too.
  VkExtent2D largest{};
};

/// Images of depth alone, for record_depth().
struct DepthTargets {
  VkFormat format = VK_FORMAT_D32_SFLOAT;
  std::uint32_t samples = 1;   ///< 1 or 4
  bool reversed_depth = true;  ///< as PictureTargets has it; of the matrix that record_depth() is given
};

/// A camera and where its picture goes.
struct View {
  CameraMatrices camera{};  ///< its depth is what is written and tested
  /// 2D, one layer and level, of images with the usage COLOR_ATTACHMENT and DEPTH_STENCIL_ATTACHMENT. In
  /// COLOR_ATTACHMENT_OPTIMAL and DEPTH_ATTACHMENT_OPTIMAL when the commands run, and afterwards. Only with
  /// Options::picture.
  VkImageView colour = VK_NULL_HANDLE, depth = VK_NULL_HANDLE;
  VkExtent2D extent{};  ///< of these images, pixels
  VkRect2D area{};      ///< the part that is the picture; of no size: all
};

struct DepthView {
  std::uint32_t targets = 0;           ///< number in Options::depths
  VkImageView depth = VK_NULL_HANDLE;  ///< as View::depth; cleared by the host, or drawn over
  VkExtent2D extent{};
  VkRect2D area{};
  /// Clip y of the matrix grows downwards, as Vulkan has it. false: it grows upwards, and dermis turns the
  /// viewport over, so that the picture stands upright.
  bool y_down = true;
  /// Leaves out faces that the picture leaves out: those turned away from the eye, of materials that are not
  /// double-sided. For a pre-pass. false: draws all, for shadows.
  bool cull = false;
};

/// Frames are numbered by the host, from 1.
struct FrameNumbers {
  std::uint64_t frame = 0;     ///< above that of every record() before
  std::uint64_t finished = 0;  ///< the device has finished all frames up to this; never falls
};

/// Part of the host's buffer. 4-byte elements.
struct VertexStream {
  VkBuffer buffer = VK_NULL_HANDLE;  ///< with STORAGE_BUFFER usage; null: as the asset has it
  VkDeviceSize offset = 0;           ///< bytes of the first element, a multiple of 4
  std::uint32_t stride = 12;         ///< bytes from element to element, a multiple of 4
};

/// Positions of a mesh of an asset as the host has moved them, in the asset's coordinates.
struct DeformedMesh {
  std::uint32_t mesh = 0;      ///< of AssetArrays::meshes, or the primitive of a file
  std::uint32_t vertices = 0;  ///< in each stream: those of the arrays or the file
  VertexStream positions_m{};  ///< 3 floats, m
  VertexStream normals{};      ///< 3 floats, of any length but 0
  VertexStream tangents{};     ///< 3 floats, of any length; the handedness stays
};

/// An image of the host in place of a map of a material. Texture coordinates, samplers and factors stay those
/// of the material. In SHADER_READ_ONLY_OPTIMAL while commands of dermis run.
struct MaterialImage {
  enum class Map : std::uint8_t { base_colour, normal };
  InstanceId instance{};
  std::string material;  ///< of its asset
  Map map = Map::base_colour;
  /// 2D with all levels; linear when read: an sRGB format for colour, +Y up for normals
  VkImageView view = VK_NULL_HANDLE;
};

/// A shadow map of the host for a light of the scene, directional or a spot, in place of dermis's own. The
/// heads must be in it (record_depth()): their own shadows and the thickness of their ears come from its
/// depth, and without them light passes through the body. Depth does not say which side of a surface the
/// light meets: where the inside of an open mesh is lit, light may come through at its edges. Reads are
/// compared with the plane of the surface, so no depth bias of the host's is needed where quality.shadow_size
/// is the side of the map. On a head texels should not be much wider than 0.5 mm. Skin outside of the map is
/// lit. Contents may change in every frame; view, extent and matrix by update(), at the cost of a pose.
struct LightShadow {
  LightId light{};
  /// D32_SFLOAT or D16_UNORM, 2D, one sample, SAMPLED; in SHADER_READ_ONLY_OPTIMAL while commands of
  /// record() run.
  VkImageView depth = VK_NULL_HANDLE;
  VkExtent2D extent{};
  std::array<double, 16> clip_from_world{};  ///< depth from 0 to 1, or from 1 to 0
  bool reversed_depth = true;                ///< near is 1, as DepthTargets has it unless told
  bool y_down = true;  ///< as DepthView has it: false where the viewport was turned over
};

/// Where a host draws the irradiance of one head, in the light map of dermis.
struct IrradianceSquare {
  InstanceId instance{};
  std::uint32_t skin_mesh = 0;  ///< of the asset's, in their order
  VkRect2D area{};              ///< of the target: texture coordinates 0..1 after the fit of the record
  std::uint32_t record = 0;     ///< see Recorded
};
/// RGBA16F, in COLOR_ATTACHMENT_OPTIMAL, cleared to 0. The host begins and ends rendering; outputs linear
/// irradiance, W/m^2 in any unit, that enters the skin, and alpha 1.
struct IrradianceTarget {
  VkImageView view = VK_NULL_HANDLE;
  VkExtent2D extent{};
  std::span<const IrradianceSquare> squares{};
  VkBuffer records = VK_NULL_HANDLE;  ///< as of Recorded
  VkDeviceSize records_offset = 0, records_bytes = 0;
};

/// Inputs of a host besides scene and settings. Copied.
struct HostInputs {
  /// Heads that are lit, but not drawn by record(): the host does, by way (iii).
  std::vector<InstanceId> drawn_by_host{};
  std::vector<InstanceId> deformed{};  ///< those that record_deformation() moves
  std::vector<MaterialImage> images{};
  std::vector<LightShadow> shadows{};
  /// Draws irradiance in place of the scene's lights, while record() runs; may be called several times, each
  /// time for other heads. Light through the body is off then; reflections stay those of the scene's lights.
  /// That light is known in texels alone. So maps hold all terms, however far a head is, and have a texel for
  /// each pixel, up to quality.map_size. With way (iii) the rest is 0 then.
  std::function<void(VkCommandBuffer, const IrradianceTarget&)> draw_irradiance{};
};

/// Results of record(), for the commands that follow in this frame.
struct Recorded {
  // With Options::scattered: see dermis/scattered.glsl. Null if the scene has no skin.
  VkImageView scattered = VK_NULL_HANDLE;  ///< 2D array, RGBA16F, SHADER_READ_ONLY_OPTIMAL
  VkBuffer records = VK_NULL_HANDLE;       ///< storage buffer
  /// The offset is a multiple of minStorageBufferOffsetAlignment. View, buffer and offset may be others in
  /// each frame, and are valid until it has finished.
  VkDeviceSize records_offset = 0, records_bytes = 0;
};

/// The heads of a scene in the frames of a host. Keeps the renderer's device. One thread at a time may use a
/// renderer and its HostFrames; several HostFrames may take part in a frame, with the same numbers.
class HostFrames {
 public:
  struct Options {
    /// 1 to 8: memory for that many; record() refuses a frame more.
    std::uint32_t frames_in_flight = 2;
    std::optional<PictureTargets> picture{};  ///< way (i)
    std::vector<DepthTargets> depths{};       ///< way (ii)
    /// Way (iii); needs a technique with light maps. They hold the wide terms that pixels of the view tell
    /// from light that leaves where it entered; the others are the host's, in close-ups too. quality.depth
    /// false: they hold all.
    bool scattered = false;
  };

  /// Throws InputError: a number out of range, or a format that the device cannot draw to.
  HostFrames(const Renderer& renderer, const Options& options);
  HostFrames(HostFrames&&) noexcept;
  HostFrames& operator=(HostFrames&&) noexcept;
  ~HostFrames();

  /// Takes the scene and the settings for the frames that follow. Costs what changed: poses, lights, exposure
  /// and the like a little processor time. Changes that need memory, maps or pipelines (the first call,
  /// another asset, another number of instances) are uploaded by submissions of dermis to the host's queue.
  /// The call waits for these; frames in flight may go on.
  ///
  /// Of the settings, camera and size of the picture are those of the views; output.exposure_ev must be
  /// given; tone map, bloom and samples have no meaning. Instances with a pose (Scene::set_pose()) are
  /// moved by the first record_depth() or record() that follows, in that command buffer; they cannot be
  /// HostInputs::deformed, too. Throws as Renderer::render() does: after an InputError all is as before,
  /// after anything else record() refuses until an update() succeeds.
  void update(const Scene& scene, const RenderSettings& settings, const HostInputs& inputs = {});

  /// Records the frame. Submits nothing, waits for nothing, allocates no device memory and makes no
  /// pipeline. `commands`: of the queue's family, outside of rendering; must be submitted once, in the order
  /// of the frames. One view so far. All that was recorded before is visible to these commands, and what they
  /// write to all after: barriers of the host's are for layouts alone.
  ///
  /// Colour is linear radiance times 2^exposure_ev, premultiplied; alpha 1 where there is skin, 0 on other
  /// opaque parts. Afterwards pipelines, descriptor set 0, push constants, viewport, scissor and cull
  /// mode of the command buffer are undefined, graphics and compute; all other state is as before.
  ///
  /// Throws InputError, and records nothing: null, a matrix that is not a camera, numbers that run back, more
  /// frames than may be in flight, a view larger than PictureTargets::largest.
  Recorded record(VkCommandBuffer commands, std::span<const View> views, const FrameNumbers& numbers);

  /// Draws the depth of the heads that the scene of the last update() shows, skin and all other opaque parts,
  /// those of HostInputs::drawn_by_host too. Takes nothing of a frame: may come before record(), and without
  /// one. For depth equal to the bit to that of record(), give clip_from_world() of the same camera, y_down
  /// as its projection has it, and `cull`. Same contract for state and errors. Parts that are blended have no
  /// depth.
  void record_depth(VkCommandBuffer commands, const std::array<double, 16>& clip_from_world,
                    const DepthView& view);

  /// Takes moved vertices of an instance named in HostInputs::deformed; they stay until the next call. Before
  /// record_depth() and record() of the frame. Skin that stretches on its map blurs as in the asset's rest
  /// shape. Vertices that leave the asset's bounding sphere may lose their shadow.
  void record_deformation(VkCommandBuffer commands, InstanceId instance,
                          std::span<const DeformedMesh> meshes);

  /// Returns the index of a head in Recorded::records. Throws InputError: no such instance or mesh.
  std::uint32_t record_of(InstanceId instance, std::uint32_t skin_mesh = 0) const;

  struct State;  // of the library

 private:
  std::unique_ptr<State> state_;
};

/// Returns clip_from_camera * camera_from_world as dermis rounds it.
std::array<double, 16> clip_from_world(const CameraMatrices& camera);

}  // namespace dermis::vulkan
