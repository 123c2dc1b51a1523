// SPDX-License-Identifier: MIT
// A frame as data: what each pass reads and writes, in call order. Declaring does no GPU work and needs no
// device, so a graph can be printed and its barriers tested anywhere. frame/plan.h adds how passes record.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/core/assert.h"
#include "gpu/resources.h"
#include "gpu/vulkan.h"

namespace dermis::frame {

template <class Kind>
struct Id {
  std::uint32_t index = ~0u;
  bool valid() const { return index != ~0u; }
  bool operator==(const Id&) const = default;
};
using TextureId = Id<gpu::Texture>;
using BufferId = Id<gpu::Buffer>;

/// Use of a resource by a pass. Each access has one set of stages, access flags and (for textures) one
/// layout, but for one case: see row_of() and FrameGraph::layout_in().
enum class Access : std::uint8_t {
  sampled,        ///< texture read through a sampler
  storage_read,   ///< storage buffer or image, read only
  storage_write,  ///< storage buffer or image, written or read and written
  colour_target,  ///< rendered to, cleared or loaded
  depth_target,   ///< tested and written
  copy_source,
  copy_target,
  indirect_arguments,  ///< buffer
  indices,             ///< buffer
};

/// An access in the terms of Vulkan, and as printed.
struct AccessRow {
  std::string_view verb;             ///< "samples"
  VkPipelineStageFlags2 stages = 0;  ///< 0: the shader stages of the pass
  VkAccessFlags2 read = 0, written = 0;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  VkImageUsageFlags texture_usage = 0;
  VkBufferUsageFlags buffer_usage = 0;
};
const AccessRow& row_of(Access access);
inline bool writes(Access access) { return row_of(access).written != 0; }

enum class PassKind : std::uint8_t { compute, raster, copy };
/// transient: contents are lost after the frame. persistent: contents are kept between frames (undefined in
/// the first). of_host: a target of the host's, another one in each frame; it has its layout before the frame
/// and keeps it.
enum class Lifetime : std::uint8_t { transient, persistent, of_host };

template <class Desc>
struct Node {
  std::string name;
  Desc desc;  ///< usage is collected from the accesses
  Lifetime lifetime = Lifetime::transient;
};
using TextureNode = Node<gpu::TextureDesc>;
using BufferNode = Node<gpu::BufferDesc>;

struct Use {
  bool is_texture = true;
  std::uint32_t index = 0;  ///< index of the texture or buffer
  Access access{};
};

/// When a pass runs.
enum class Runs : std::uint8_t {
  every_frame,
  once,           ///< makes contents that last as long as the memory of the frame
  when_changed,   ///< makes contents that last until their sources change
  for_statistics  ///< counts; pictures do not depend on it
};

/// The passes that a frame has besides those of every frame.
struct FrameKind {
  bool first = false;       ///< the first with its memory: passes that run once
  bool changed = false;     ///< sources of persistent contents have changed: passes that run when_changed
  bool statistics = false;  ///< passes that run for_statistics
  bool has(Runs runs) const;
  auto operator<=>(const FrameKind&) const = default;
};
inline constexpr FrameKind whole_frame{.first = true, .changed = true, .statistics = true};

struct PassNode {
  std::string name;  ///< timer, debug label, row of the statistics
  PassKind kind{};
  std::vector<Use> uses;
  Runs runs = Runs::every_frame;
};

class FrameGraph;

/// The interface of a pass while it declares: it creates its outputs and states each use. The order of calls
/// within a pass does not matter.
class Declare {
 public:
  Declare(FrameGraph& graph, PassNode& pass) : graph_(&graph), pass_(&pass) {}
  void kind(PassKind kind) { pass_->kind = kind; }
  /// Sets when the pass runs; every frame by default.
  void runs(Runs runs) { pass_->runs = runs; }

  TextureId create(std::string name, const gpu::TextureDesc& desc, Lifetime lifetime = Lifetime::transient);
  BufferId create(std::string name, const gpu::BufferDesc& desc, Lifetime lifetime = Lifetime::transient);
  const gpu::TextureDesc& desc(TextureId id) const;

  // auto: TextureId or BufferId
  void read(auto id) { use(id, Access::storage_read); }
  void write(auto id) { use(id, Access::storage_write); }
  void copy_from(auto id) { use(id, Access::copy_source); }
  void copy_to(auto id) { use(id, Access::copy_target); }
  void sample(TextureId id) { use(id, Access::sampled); }
  void colour(TextureId id) { use(id, Access::colour_target); }
  void depth(TextureId id) { use(id, Access::depth_target); }
  void indirect(BufferId id) { use(id, Access::indirect_arguments); }
  void indices(BufferId id) { use(id, Access::indices); }

 private:
  void use(TextureId id, Access access) { use({.is_texture = true, .index = id.index, .access = access}); }
  void use(BufferId id, Access access) { use({.is_texture = false, .index = id.index, .access = access}); }
  void use(const Use& use);
  FrameGraph* graph_;
  PassNode* pass_;
};

/// Passes in order, with the resources that connect them.
class FrameGraph {
 public:
  /// A resource that no pass creates before its first use (a persistent target, a read-back buffer).
  TextureId texture(std::string name, const gpu::TextureDesc& desc, Lifetime lifetime = Lifetime::transient);
  BufferId buffer(std::string name, const gpu::BufferDesc& desc, Lifetime lifetime = Lifetime::transient);

  /// Allows to copy out the contents after the frame (gpu::read_back with final_layout()).
  void read_back(TextureId id);

  /// Returns the layout in which an access finds a texture. Transient textures that only shaders touch are in
  /// GENERAL always, so that no barrier changes a layout: on an H100 that costs 5 us, others 2.
  VkImageLayout layout_in(std::uint32_t texture, Access access) const;
  bool stays_general(std::uint32_t texture) const;

  const std::vector<TextureNode>& textures() const { return textures_; }
  const std::vector<BufferNode>& buffers() const { return buffers_; }
  const std::vector<PassNode>& passes() const { return passes_; }

 protected:
  void add_pass(PassNode pass) { passes_.push_back(std::move(pass)); }

 private:
  friend class Declare;
  std::vector<TextureNode> textures_;
  std::vector<BufferNode> buffers_;
  std::vector<PassNode> passes_;
};

/// The images that a pass writes, each counted whole and once.
struct WrittenImages {
  std::uint64_t texels = 0, bytes = 0;
};
WrittenImages written_images(const FrameGraph& graph, const PassNode& pass);

/// Returns one line per pass with what it reads and writes, then the resources with sizes.
std::string print_text(const FrameGraph& graph);
/// Returns the graph for Graphviz.
std::string print_dot(const FrameGraph& graph);

}  // namespace dermis::frame
