// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "frame/plan.h"

namespace dermis::frame {
namespace {

std::string_view name_of(Access access) {
  switch (access) {
    case Access::sampled: return "samples";
    case Access::storage_read: return "reads";
    case Access::storage_write: return "writes";
    case Access::colour_target: return "renders to";
    case Access::depth_target: return "depth";
    case Access::copy_source: return "copies from";
    case Access::copy_target: return "copies to";
    case Access::indirect_arguments: return "arguments from";
  }
  return "";
}

std::string_view name_of(PassKind kind) { return kind == PassKind::compute ? "compute" : kind == PassKind::raster ? "raster" : "copy"; }

std::string_view name_of(VkFormat format) {
  switch (format) {
    case VK_FORMAT_R16G16B16A16_SFLOAT: return "rgba16f";
    case VK_FORMAT_R32G32B32A32_SFLOAT: return "rgba32f";
    case VK_FORMAT_R8G8B8A8_UNORM: return "rgba8";
    case VK_FORMAT_R8G8B8A8_SRGB: return "rgba8 srgb";
    case VK_FORMAT_D32_SFLOAT: return "d32";
    default: return "format?";
  }
}

const std::string& resource_name(const FramePlan& plan, const Use& use) {
  return use.is_texture ? plan.textures()[use.index].name : plan.buffers()[use.index].name;
}

std::string size_of(const gpu::TextureDesc& desc) {
  std::string text = fmt::format("{}x{}", desc.width, desc.height);
  if (desc.layers > 1) text += fmt::format("x{}", desc.layers);
  if (desc.samples > 1) text += fmt::format(" {} samples", desc.samples);
  return text;
}

}  // namespace

std::string print_text(const FramePlan& plan) {
  std::string text = "passes\n";
  for (const PassNode& pass : plan.passes()) {
    text += fmt::format("  {:<28} {:<8}", pass.name, name_of(pass.kind));
    for (const Use& use : pass.uses) text += fmt::format(" {} '{}';", name_of(use.access), resource_name(plan, use));
    text += '\n';
  }
  text += "textures\n";
  for (const TextureNode& t : plan.textures())
    text += fmt::format("  {:<28} {:<20} {:<10} {:>9.2f} MB {}\n", t.name, size_of(t.desc), name_of(t.desc.format),
                        static_cast<double>(gpu::bytes_of(t.desc)) / 1e6, t.lifetime == Lifetime::persistent ? "persistent" : "transient");
  if (!plan.buffers().empty()) text += "buffers\n";
  for (const BufferNode& b : plan.buffers())
    text += fmt::format("  {:<28} {:>9} bytes {}\n", b.name, b.desc.bytes, b.lifetime == Lifetime::persistent ? "persistent" : "transient");
  return text;
}

std::string print_dot(const FramePlan& plan) {
  std::string text = "digraph frame {\n  rankdir=LR;\n  node [fontname=\"sans-serif\"];\n";
  for (std::size_t p = 0; p < plan.passes().size(); ++p) {
    const PassNode& pass = plan.passes()[p];
    text += fmt::format("  p{} [shape=box, style=filled, fillcolor=\"#f2d6c9\", label=\"{}\"];\n", p, pass.name);
    for (const Use& use : pass.uses) {
      const std::string resource = fmt::format("{}{}", use.is_texture ? 't' : 'b', use.index);
      text += writes(use.access) ? fmt::format("  p{} -> {};\n", p, resource) : fmt::format("  {} -> p{};\n", resource, p);
    }
  }
  for (std::size_t t = 0; t < plan.textures().size(); ++t)
    text += fmt::format("  t{} [shape=ellipse, label=\"{}\\n{} {}\"];\n", t, plan.textures()[t].name, size_of(plan.textures()[t].desc),
                        name_of(plan.textures()[t].desc.format));
  for (std::size_t b = 0; b < plan.buffers().size(); ++b)
    text += fmt::format("  b{} [shape=ellipse, style=dashed, label=\"{}\\n{} bytes\"];\n", b, plan.buffers()[b].name, plan.buffers()[b].desc.bytes);
  return text + "}\n";
}

}  // namespace dermis::frame
